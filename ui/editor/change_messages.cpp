#include "ui/editor/change_messages.h"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

#include "scenarios/format/keys.h"
#include "scenarios/format/ranges.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/specimen_form.h"
#include "ui/modules.h"
#include "ui/text/language.h"
#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct ChangeText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Changes)
};

/// A place of scenario.json by the start of its path, and its name; the first that fits counts. %1: the item of a list.
struct Named {
  const char* path;
  const char* name;
};
constexpr Named kNames[] = {
    {"/target/depth_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Depth")},
    {"/target/width_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Width")},
    {"/target/top_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Measured from height")},
    {"/target/corner_radius_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Corner radius")},
    {"/target/box_size_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Length and width of the box")},
    {"/target/taper_deg", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Lean of a wall")},
    {"/target/paths", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Points of the outline")},
    {"/target", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Shape of the target")},
    {"/leeway/floor_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Tolerance zone, floor")},
    {"/leeway/side_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Tolerance zone, sides")},
    {"/leeway", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Tolerance zone of single faces")},
    {"/rubric/pass", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Pass mark, of 100")},
    {"/rubric/criteria/*/weight", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Points for %1")},
    {"/rubric/criteria/*/bands", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Bands of %1")},
    {"/rubric/criteria/*", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Criterion %1")},
    {"/rubric/criteria", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Order of the criteria")},
    {"/rubric/critical/*", QT_TRANSLATE_NOOP("cusp::ui::Changes", "“%1” fails the attempt")},
    {"/instruments/*/radius_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Radius of bur %1")},
    {"/instruments/*/", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Shape of bur %1")},
    {"/instruments/*", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Bur %1")},
    {"/instruments", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Order of the burs")},
    {"/tissues/*/stiffness_n_per_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Stiffness of %1")},
    {"/tissues/*/speed_mm_s", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Removal speed of %1")},
    {"/tissues/*", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Tissue %1")},
    {"/tissues", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Order of the tissues")},
    {"/protected", QT_TRANSLATE_NOOP("cusp::ui::Changes", "What is protected")},
    {"/specimen/voxel_mm", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Fineness")},
    {"/specimen/seed", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Natural variation of the tooth")},
    {"/specimen/lesions", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Carious lesions")},
    {"/specimen/around", QT_TRANSLATE_NOOP("cusp::ui::Changes", "What stands about the tooth")},
    {"/specimen/landmarks", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Landmarks of the tooth")},
    {"/specimen", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Tooth")},
    {"/limits/time_s", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Time limit")},
    {"/expected_time_s", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Expected time")},
    {"/self_assessment", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Own assessment before the result")},
    {"/template", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Template and its values")},
    {"/level", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Level")},
    {"/title/*", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Title, %1")},
    {"/briefing/*", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Briefing, %1")},
    {"/method", QT_TRANSLATE_NOOP("cusp::ui::Changes", "How forces are computed")},
    {"/phenomena", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Handpiece, vibration, sound, water and heat")},
    {"/tolerance", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Change of the score that an audit accepts")},
    {"/device/full_force_n", QT_TRANSLATE_NOOP("cusp::ui::Changes", "The force at which cutting is fastest")},
    {"/device/tool_tilt_deg", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Tilt of the handpiece")},
    {"/device/tool_turn_deg", QT_TRANSLATE_NOOP("cusp::ui::Changes", "Turn of the handpiece")},
    {"/device", QT_TRANSLATE_NOOP("cusp::ui::Changes", "What the device has to do")},
};

/// The item of a list, by the name that people read.
QString part_name(const Change& c, const Region* whole, const TissueNames& own) {
  const QString key = QString::fromStdString(c.part);
  if (c.path.starts_with("/rubric/criteria")) return metric_name(c.part, whole, own);
  if (c.path.starts_with("/rubric/critical")) return critical_name(c.part);
  if (c.path.starts_with("/tissues")) {
    const auto tissue = scenario_tissue_from_key(c.part);
    return tissue ? tissue_name(*tissue, own) : key;
  }
  if (c.path.starts_with("/title") || c.path.starts_with("/briefing")) {
    return language_name(key);
  }
  return key;
}

QString place_name(const Change& c, const Region* whole, const TissueNames& own) {
  const auto* at = std::ranges::find_if(kNames, [&](const Named& n) { return c.path.starts_with(n.path); });
  if (at == std::end(kNames)) return isolate(QString::fromStdString(c.path));
  const QString name = ChangeText::tr(at->name);
  return name.contains(u"%1") ? name.arg(isolate(part_name(c, whole, own))) : name;
}

/// With the unit that the table of ranges gives the place. Zero where it means none.
QString value_text(const Change& c, double value) {
  const auto ranges = number_ranges();
  const auto range = std::ranges::find(ranges, std::string_view(c.path), &NumberRange::path);
  if (range == ranges.end()) return isolate(installed_locale().toString(value, 'g', 6));
  if (range->or_zero && value == 0 && range->unit == "s") return ChangeText::tr("none");
  const QString unit = QString::fromUtf8(range->unit.data(), static_cast<qsizetype>(range->unit.size()));
  if (unit == u"mm" || unit == u"N") return format({value, {}, unit, 2});
  return isolate(installed_locale().toString(value, 'g', 6) + (unit.isEmpty() ? QString() : QChar(0x00A0) + unit_text(unit)));
}

QString wanted_in(const Rubric& rubric, const std::string& metric) {
  const auto at = std::ranges::find(rubric.criteria, metric, &Criterion::metric);
  return at == rubric.criteria.end() ? QString() : wanted_text(*at);
}

/// What earns full points, now and before; empty if that is the same.
QString bands_message(const std::string& metric, const Scenario& before, const Scenario& after, const TissueNames& own) {
  const QString was = wanted_in(before.rubric, metric), is = wanted_in(after.rubric, metric);
  if (was == is) return {};
  const QString full = ChangeText::tr("Full points for %1").arg(isolate(metric_name(metric, &after.target, own)));
  return ChangeText::tr("%1: %2, was %3").arg(full, isolate(is), isolate(was));
}

/// settle_on_floor() moves the points with depth and height, which have lines of their own.
bool moved_with_floor_alone(const Region& before, const Region& after) {
  Outline moved = before.outline;
  if (moved.depth_mm == after.outline.depth_mm && moved.top_mm == after.outline.top_mm) return false;
  moved.depth_mm = after.outline.depth_mm;
  moved.top_mm = after.outline.top_mm;
  settle_on_floor(moved);
  return moved.paths == after.outline.paths;
}

}  // namespace

QString change_message(const Change& c, const Region* whole, const TissueNames& own) {
  const QString name = place_name(c, whole, own);
  if (c.before && c.after) {
    //: %1: what changed ("Depth"), %2: its value now, %3: its value before
    return ChangeText::tr("%1: %2, was %3").arg(name, value_text(c, *c.after), value_text(c, *c.before));
  }
  switch (c.kind) {
    //: %1: what changed ("Points of the outline")
    case ChangeKind::changed: return ChangeText::tr("%1: changed").arg(name);
    case ChangeKind::added: return ChangeText::tr("%1: new").arg(name);
    case ChangeKind::removed: return ChangeText::tr("%1: removed").arg(name);
  }
  return name;
}

QStringList change_messages(const Scenario& before, const Scenario& after, const TissueNames& own) {
  QStringList out;
  for (const Change& change : compare(before, after)) {
    if (change.path == "/target/paths" && moved_with_floor_alone(before.target, after.target)) continue;
    const QString bands = change.path == "/rubric/criteria/*/bands" ? bands_message(change.part, before, after, own) : QString();
    const bool gone = change.kind == ChangeKind::removed;
    out << (bands.isEmpty() ? change_message(change, gone ? &before.target : &after.target, gone ? TissueNames{} : own) : bands);
  }
  out.removeDuplicates();
  return out;
}

}  // namespace cusp::ui
