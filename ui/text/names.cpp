#include "ui/text/names.h"

#include <QCollator>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "device/catalogue.h"
#include "scenarios/operators/single_fault.h"
#include "scenarios/teeth/own_tissues.h"
#include "ui/modules.h"
#include "ui/text/language.h"
#include "ui/text/text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {

QString local(const LocalText& texts) {
  for (const QString& code : {exercise_language(), current_language()})
    if (const auto it = texts.find(code.toStdString()); it != texts.end()) return text(it->second);
  if (const auto it = texts.find("en"); it != texts.end()) return text(it->second);
  return texts.empty() ? QString() : text(texts.begin()->second);
}

QString briefing_text(const Scenario& scenario) {
  static const QRegularExpression figure(QStringLiteral("(?<=\\d) (?=(?:mm|N|s|min|°|%)(?:\\W|$))"));
  return local(scenario.briefing).replace(figure, QString(QChar::Nbsp));
}

QString role_name(Role role) {
  switch (role) {
    case Role::student: return Text::tr("Student");
    case Role::instructor: return Text::tr("Instructor");
    case Role::administrator: return Text::tr("Administrator");
  }
  return {};
}

QString state_name(SessionState state) {
  switch (state) {
    case SessionState::running: return Text::tr("Running");
    case SessionState::interrupted: return Text::tr("Interrupted");
    case SessionState::finished: return Text::tr("Not graded");
    case SessionState::graded: return Text::tr("Graded");
    case SessionState::closed: return Text::tr("Closed");
  }
  return {};
}

QString kind_name(SessionKind kind) {
  switch (kind) {
    case SessionKind::practice: return Text::tr("Practice");
    case SessionKind::assessment: return Text::tr("Assessment");
    case SessionKind::try_it: return Text::tr("Try it");
    case SessionKind::try_out: return Text::tr("Try-out");
  }
  return {};
}

QString level_name(Level level) {
  switch (level) {
    case Level::beginner: return Text::tr("Beginner", "level of an exercise");
    case Level::intermediate: return Text::tr("Intermediate", "level of an exercise");
    case Level::advanced: return Text::tr("Advanced", "level of an exercise");
  }
  return {};
}

QString expected_time_text(double seconds) { return format({std::max(1.0, std::round(seconds / 60)), std::nullopt, u"min"_qs, 0}); }

QString duration_text(double seconds) {
  // format_clock() begins with the hours from an hour on.
  return (seconds < 3600 ? Text::tr("%1 min") : Text::tr("%1 h")).arg(format_clock(seconds));
}

QString level_and_time_text(const Scenario& scenario) {
  const QString time = scenario.expected_time_s > 0 ? expected_time_text(scenario.expected_time_s) : QString();
  if (!scenario.level) return time;
  const QString level = level_name(*scenario.level);
  //: %1: level of an exercise, %2: time that it takes.
  return time.isEmpty() ? level : Text::tr("%1, %2").arg(level, time);
}

namespace {

QString fault_name(SingleFault fault) {
  switch (fault) {
    case SingleFault::too_deep: return Text::tr("too deep");
    case SingleFault::too_shallow: return Text::tr("too shallow");
    case SingleFault::too_wide: return Text::tr("too wide");
    case SingleFault::tilted_wall: return Text::tr("a tilted wall");
    case SingleFault::undermined: return Text::tr("undermined enamel");
    case SingleFault::rough_floor: return Text::tr("a rough floor");
    case SingleFault::thin_ridge: return Text::tr("a thin marginal ridge");
    case SingleFault::exposed_pulp: return Text::tr("an opened pulp");
    case SingleFault::nicked_neighbour: return Text::tr("a nicked neighbour");
    case SingleFault::contact_closed: return Text::tr("a contact left closed");
    case SingleFault::caries_left: return Text::tr("caries left at the periphery");
    case SingleFault::over_excavated: return Text::tr("sound tissue excavated");
    case SingleFault::wrong_bur: return Text::tr("the wrong bur");
    case SingleFault::tremor: return Text::tr("a trembling hand");
    case SingleFault::dry_cutting: return Text::tr("cutting without water");
  }
  return {};
}

/// "0.90 mm", "16°", "12 s".
QString amount_text(const SizedFault& fault) {
  const SingleFaultRow& row = single_faults()[static_cast<std::size_t>(fault.fault)];
  return format({fault.amount(), std::nullopt, text(std::string(row.unit)), row.unit == "mm" ? 2 : 0});
}

}  // namespace

QString operator_name(const std::string& key) {
  if (const auto fault = sized_fault_by_name(key)) {
    //: %1: a fault ("too deep"), %2: its size ("0.9 mm")
    return Text::tr("Reference operator with one fault: %1, %2").arg(fault_name(fault->fault), amount_text(*fault));
  }
  if (key == "reference" || key == "expert") return Text::tr("Reference operator");
  if (key == "competent") return Text::tr("Competent operator");
  if (key == "novice") return Text::tr("Novice operator");
  return QString::fromStdString(key);
}

QString device_name(const std::string& device_class) {
  if (device_class == "pointer") return Text::tr("Mouse and keys");
  if (device_class == "falcon") return QStringLiteral("Falcon");
  if (device_class == "emulated-falcon") return Text::tr("Emulated Falcon");
  if (device_class == "inverse3") return QStringLiteral("Inverse3");
  if (device_class == "scripted") return Text::tr("Scripted operator");
  return text(device_class);
}

QString device_names(const std::vector<std::string>& device_classes) {
  QStringList names;
  for (const std::string& one : device_classes) names += device_name(one);
  return names.join(Text::tr(", "));
}

QString self_test_age(int days) { return Text::tr("self-test at most %n day(s) old", nullptr, days); }

bool stands_before(const std::string& name, const std::string& other) {
  static QCollator order;  // the window's thread; making one takes longer than many comparisons
  if (order.locale() != installed_locale() || !order.numericMode()) {
    order.setLocale(installed_locale());
    order.setNumericMode(true);
    order.setCaseSensitivity(Qt::CaseInsensitive);
  }
  return order.compare(QString::fromStdString(name), QString::fromStdString(other)) < 0;
}

QString drawn_tooth_text() { return Text::tr("another tooth for each candidate"); }

QString self_test_advice(const std::string& device_class) {
  const DeviceKind* kind = device::device_kind(device_class);
  if (kind && kind->self_test) return Text::tr("Ask the staff for a self-test of the %1 on the page Device.").arg(device_name(device_class));
  return Text::tr("%1: there is no self-test. Ask the staff to choose another device on the page Device.").arg(device_name(device_class));
}

QString tissue_name(Tissue tissue) {
  switch (tissue) {
    case Tissue::empty: return Text::tr("Nothing");
    case Tissue::enamel: return Text::tr("Enamel");
    case Tissue::dentine: return Text::tr("Dentine");
    case Tissue::carious_dentine: return Text::tr("Carious dentine");
    case Tissue::cementum: return Text::tr("Cementum");
    case Tissue::pulp: return Text::tr("Pulp");
    case Tissue::bone: return Text::tr("Bone");
    case Tissue::gingiva: return Text::tr("Gingiva");
    case Tissue::ligament: return Text::tr("Ligament");
    case Tissue::amalgam: return Text::tr("Amalgam");
    case Tissue::composite: return Text::tr("Composite");
    case Tissue::plastic: return Text::tr("Plastic");
    case Tissue::carious_enamel: return Text::tr("Carious enamel");
  }
  if (tissue == kNeighbourEnamel) return Text::tr("Neighbour enamel");
  if (tissue == kNeighbourDentine) return Text::tr("Neighbour dentine");
  if (tissue == kFirmCariousDentine) return Text::tr("Firm carious dentine");
  return Text::tr("Material %1").arg(static_cast<int>(tissue) - 15);
}

QString tissue_name(Tissue tissue, const TissueNames& own) {
  const auto code = static_cast<std::uint8_t>(index_of(tissue));
  const auto named = own.find(code);
  if (named == own.end() || named->second.empty()) return tissue_name(tissue);
  const auto grown = own_tissue_names().find(code);
  return grown != own_tissue_names().end() && grown->second == named->second ? tissue_name(tissue) : QString::fromStdString(named->second);
}

}  // namespace cusp::ui
