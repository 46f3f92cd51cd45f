#include "ui/text/critical_events.h"

#include <algorithm>

#include "scenarios/landmarks/landmarks.h"
#include "scenarios/teeth/landmarks.h"
#include "ui/modules.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/text/text.h"

namespace cusp::ui {
namespace {

constexpr double kMiddleMm = 0.7;  // from the tooth's axis; nearer than that no side is named
constexpr double kMostOblique = 2.4142;  // 1 / tan(22.5°): beyond it one direction alone names the side

/// The end of the first second in which pulp was removed. A pulp that was only laid bare lost none: not known.
std::optional<double> first_pulp_s(Store& store, const SessionId& session) {
  const auto seconds = store.metrics.over_time(session);
  if (!seconds) return std::nullopt;
  for (const MetricsRow& row : *seconds) {
    for (const RemovedTissue& removed : row.metrics.removed) {
      if (removed.tissue == Tissue::pulp && removed.voxels > 0) return static_cast<double>(row.elapsed_us) * 1e-6;
    }
  }
  return std::nullopt;
}

/// Of the criteria alone, which a stored attempt keeps: a report names the same place when it is opened again. Where the cut
/// came nearest to the pulp, it opened it. What is removed of protected parts has the place of the damage (scenarios/metrics/protected_parts.h).
std::optional<Vec3> place_of(const std::string& key, const Grade& grade) {
  const std::string criterion = key == "pulp_exposure" ? "remaining_over_pulp" : key == "protected_damage" ? "protected_removed" : key;
  for (const CriterionGrade& c : grade.criteria) {
    if (c.id == criterion && c.measure.measured) return c.measure.where_mm;
  }
  return std::nullopt;
}

/// The pair of ways that the side names begin with: "mesio" and "disto" have no sense of their own in other languages.
struct Side {
  bool mesial, buccal, upper;  // else distal, oral, lower
};
QString oblique(const Side& at) {
  if (at.mesial) return at.buccal ? Text::tr("mesiobuccal") : at.upper ? Text::tr("mesiopalatal") : Text::tr("mesiolingual");
  return at.buccal ? Text::tr("distobuccal") : at.upper ? Text::tr("distopalatal") : Text::tr("distolingual");
}

}  // namespace

std::vector<CriticalEvent> critical_events(const Grade& grade, Store* store, const SessionId& session) {
  std::vector<CriticalEvent> events;
  for (const std::string& key : grade.critical) {
    CriticalEvent event{key, std::nullopt, place_of(key, grade)};
    if (key == "pulp_exposure" && store != nullptr && !session.is_nil()) event.at_s = first_pulp_s(*store, session);
    events.push_back(std::move(event));
  }
  std::ranges::stable_partition(events, [](const CriticalEvent& e) { return e.key == "pulp_exposure"; });
  return events;
}

QString critical_text(const CriticalEvent& event, const SpecimenSource& specimen) {
  QString text = critical_name(event.key);
  //: A critical event, and when it happened in the attempt: "The pulp was exposed after 1:12 min".
  if (event.at_s) text = Text::tr("%1 after %2").arg(text, duration_text(*event.at_s));
  const QString side = event.place_mm ? side_text(specimen, *event.place_mm) : QString();
  return side.isEmpty() ? text : text + Text::tr(", ") + side;
}

QString critical_advice(const std::string& key) {
  if (key == "pulp_exposure") return Text::tr("Read the depth before each stroke, and stop at the required depth.");
  if (key == "protected_damage") return Text::tr("Look where the protected part lies before you begin, and keep the bur off it.");
  if (key == "dry_cutting") return Text::tr("Run the coolant before the bur touches the tooth.");
  return {};
}

QString side_text(const SpecimenSource& specimen, Vec3 place_mm) {
  const int fdi = sided_fdi(specimen);
  if (fdi == 0) return {};
  // A grown tooth stands about the frame's z, a tooth of a file where its mesial axis begins.
  const Landmark* axis = specimen.landmarks.find(MarkKind::mesial_axis);
  if (axis != nullptr) place_mm -= axis->points_mm.front();
  const double mesial = mesial_x(fdi) * place_mm.x, buccal = place_mm.y;
  if (std::hypot(mesial, buccal) < kMiddleMm) return {};
  const bool upper = fdi < 30;
  if (std::abs(mesial) > kMostOblique * std::abs(buccal)) return mesial > 0 ? Text::tr("mesial") : Text::tr("distal");
  if (std::abs(buccal) > kMostOblique * std::abs(mesial)) {
    return buccal > 0 ? Text::tr("buccal") : upper ? Text::tr("palatal") : Text::tr("lingual");
  }
  return oblique({.mesial = mesial > 0, .buccal = buccal > 0, .upper = upper});
}

}  // namespace cusp::ui
