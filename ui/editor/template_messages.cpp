#include "ui/editor/template_messages.h"

#include <algorithm>
#include <cmath>

#include "ui/editor/template_dialog.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"

namespace cusp::ui {
namespace {

constexpr std::string_view kUnverified = "[M]";
constexpr std::string_view kNotes = "dental.md ";  // a file that no instructor has

/// At most two decimals, and one at least of a length: "1.0", "0.45"; "3" degrees.
QString bare_number(double value, const std::string& unit) {
  const double hundredths = std::round(value * 100);
  const int needed = std::fmod(hundredths, 100) == 0 ? 0 : std::fmod(hundredths, 10) == 0 ? 1 : 2;
  return format_number(hundredths / 100, std::max(needed, unit == "mm" ? 1 : 0));
}

QString with_unit(const QString& number, const std::string& unit) {
  return isolate(unit.empty() ? number : number + QChar(0x00A0) + unit_text(QString::fromStdString(unit)));
}

QString range_text(const TemplateParameter& p) {
  return TemplateDialog::tr("%1 to %2").arg(isolate(bare_number(p.least, p.unit)), with_unit(bare_number(p.most, p.unit), p.unit));
}

/// "dental.md 2.2; figure [M]": where the rule stands, and that nobody verified its figure.
QString source_text(const std::string& source) {
  if (source == "choice") return TemplateDialog::tr("Source: free choice");
  const bool unverified = source.find(kUnverified) != std::string::npos;
  QString from = QString::fromStdString(source.substr(0, source.find(';')));
  if (source.starts_with(kNotes)) from = TemplateDialog::tr("the authors’ notes, section %1").arg(from.mid(static_cast<qsizetype>(kNotes.size())));
  if (!unverified) return TemplateDialog::tr("Source: %1").arg(isolate(from));
  if (source == kUnverified) return TemplateDialog::tr("Source: general knowledge, not verified [M]");
  return TemplateDialog::tr("Source: %1; the figure is not verified [M]").arg(isolate(from));
}

}  // namespace

bool is_choice(const TemplateParameter& p) { return p.unit.empty() && p.least == 0 && p.most == 1; }

QString parameter_note(const TemplateParameter& p, double usual) {
  const QString source = source_text(p.source);
  if (is_choice(p)) return (usual > 0.5 ? TemplateDialog::tr("Default: yes") : TemplateDialog::tr("Default: no")) + u'\n' + source;
  return TemplateDialog::tr("%1, default %2").arg(range_text(p), with_unit(bare_number(usual, p.unit), p.unit)) + u'\n' + source;
}

QString outside_message(const TemplateParameter& p, const QString& typed) {
  const QString name = local(p.name);
  if (typed.isEmpty()) return TemplateDialog::tr("%1: a number is needed here, %2.").arg(name, range_text(p));
  if (!read_number(typed)) return TemplateDialog::tr("%1: “%2” is no number. Possible: %3.").arg(name, isolate(typed), range_text(p));
  return TemplateDialog::tr("%1: %2 is outside %3.").arg(name, with_unit(typed, p.unit), range_text(p));
}

QString fit_message(const ExerciseTemplate& chosen, const FitFailure& failure) {
  const QString where = QString::fromStdString(failure.where);
  switch (failure.code) {
    case FitError::out_of_range: {
      const auto p = std::ranges::find(chosen.parameters, failure.where, &TemplateParameter::key);
      if (p == chosen.parameters.end()) break;
      return TemplateDialog::tr("%1 has to lie within %2.").arg(local(p->name), range_text(*p));
    }
    case FitError::unsuitable_tooth: return TemplateDialog::tr("Tooth %1 is no premolar or molar.").arg(where);
    case FitError::missing_landmark:
      return TemplateDialog::tr("With these values nothing is left of the fissures that the preparation follows. A narrower marginal ridge leaves more.");
    case FitError::does_not_fit:
      if (failure.where == "/target/paths") return TemplateDialog::tr("With these values nothing is left of the preparation.");
      return TemplateDialog::tr("These values together make no exercise. Values nearer to their defaults do.");
    case FitError::unmet_need: {
      const auto need = std::ranges::find(chosen.needs, failure.where, &TemplateNeed::key);
      if (need == chosen.needs.end()) break;
      return local(need->text);
    }
    case FitError::unknown_template:
    case FitError::unknown_parameter:
    case FitError::missing_tissue:  // of a tooth from a file, which this dialog does not offer
    case FitError::turned_tooth:
    case FitError::bad_template: break;
  }
  return TemplateDialog::tr("The template cannot be used: it is broken at %1.").arg(isolate(where));
}

}  // namespace cusp::ui
