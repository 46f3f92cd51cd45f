#include "tests/scenarios/operators/fault_matrix.h"

#include <algorithm>

#include "scenarios/format/keys.h"
#include "scenarios/grading/bands.h"
#include "scenarios/grading/default_bands.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/operators/fast_cut.h"

namespace cusp::test {

namespace {

// A criterion of one of several targets is its metric's.
bool in(std::span<const std::string_view> patterns, std::string_view criterion) {
  const std::string_view key = split_metric(criterion).metric;
  return std::ranges::any_of(patterns, [key](std::string_view one) {
    return one.ends_with('*') ? key.starts_with(one.substr(0, one.size() - 1)) : key == one;
  });
}

// A critical event counts as a criterion with all its points, or none.
constexpr std::array<std::string_view, 2> kEvents = {"pulp_exposure", "protected_damage"};

/// Points that a criterion loses at each size; one that is not measured any more loses none.
std::array<double, 3> losses_of(std::string_view metric, const CriterionShare& before, const std::array<Graded, 3>& after) {
  std::array<double, 3> out{};
  for (std::size_t size = 0; size < out.size(); ++size) {
    const auto now = after[size].criteria.find(metric);
    if (now != after[size].criteria.end()) out[size] = before.share - now->second.share;
  }
  return out;
}

}  // namespace

std::span<const FaultRules> fault_rules() {
  // Over-cut outside the tolerance zone is sound tissue lost.
  static const std::vector<FaultRules> rules = {
      {SingleFault::too_deep, {"depth_*", "overcut_leeway_floor", "overcut_beyond_floor"},
       {"remaining_over_pulp", "box_height", "gingival_above_cej", "axial_*", "unsupported_enamel", "surface_within_*", "sound_lost"},
       "the floor comes nearer to the pulp and the gingival floor, takes the upper part of the axial wall and dentine beneath enamel, and "
       "leaves the target's surface"},
      {SingleFault::too_shallow, {"depth_*", "target_removed"}, {"box_height", "axial_*", "surface_within_*", "caries_left_*"},
       "the floor stands further from the gingival floor, the axial wall below it reaches up into enamel, the target's surface is not met, "
       "and caries stays under what is left of the access"},
      {SingleFault::too_wide, {"overcut_leeway_side", "overcut_beyond_side", "isthmus_width"},
       {"ridge_*", "surface_within_*", "clearance_*", "cavosurface_*", "unsupported_enamel", "axial_*", "remaining_over_pulp", "sound_lost"},
       "walls come nearer to ridges, pulp horns and the neighbour, meet the surface elsewhere, cut rods of the cusps, and a straight axial "
       "wall reaches enamel at both ends"},
      {SingleFault::tilted_wall, {"wall_angle_buccal", "wall_angle_lingual", "convergence_buccolingual", "overcut_leeway_side", "overcut_beyond_side"},
       {"cavosurface_*", "isthmus_width", "surface_within_*", "clearance_*", "sound_lost"},
       "a wall that opens is wider at the top, and meets the surface at another angle"},
      {SingleFault::undermined, {"unsupported_enamel", "wall_angle_*", "convergence_*", "overcut_leeway_side", "overcut_beyond_side"},
       {"surface_within_*", "sound_lost", "ridge_*", "remaining_over_pulp", "clearance_*", "isthmus_width"},
       "the hollow leaves the target's surface, widens the isthmus, comes nearer to ridges and pulp horns, and reaches the margin beside "
       "the neighbour"},
      {SingleFault::rough_floor, {"floor_flatness", "depth_most"},
       {"depth_mean", "overcut_leeway_floor", "overcut_beyond_floor", "remaining_over_pulp", "floor_tilt", "wall_angle_*",
        "convergence_*", "box_height", "axial_*", "surface_within_*", "sound_lost"},
       "pits are over-cut below the floor and lower it; those beside a wall lengthen it, one at the axiopulpal line angle stands in the "
       "axial wall, unequal ones lean the plane"},
      {SingleFault::thin_ridge, {"ridge_*", "overcut_beyond_side", "overcut_leeway_side"},
       {"unsupported_enamel", "surface_within_*", "sound_lost"}, "the end leaves the target's surface and cuts rods of the ridge"},
      {SingleFault::exposed_pulp, {"remaining_over_pulp", "pulp_exposure", "protected_removed", "protected_damage"},
       {"depth_*", "floor_*", "overcut_*", "isthmus_width", "wall_angle_*", "surface_within_*", "sound_lost"},
       "the way there goes through floor and wall"},
      {SingleFault::nicked_neighbour, {"protected_removed", "protected_damage"}, {"overcut_*"},
       "the neighbour's tissue is over-cut too"},
      {SingleFault::contact_closed, {"contact_broken", "target_removed", "gingival_floor_mesiodistal"},
       {"clearance_*", "surface_within_*", "cavosurface_*", "unsupported_enamel", "box_height", "caries_left_enamel"},
       "the shell bounds floor and walls, the margin moves to it, its enamel has no dentine beneath it, and may be carious"},
      {SingleFault::caries_left, {"caries_left_*", "target_removed"}, {"surface_within_*", "floor_*", "wall_angle_*", "clearance_*", "contact_broken"},
       "what is left is a ledge, at a contact in enamel"},
      {SingleFault::over_excavated, {"sound_lost", "overcut_*"},
       {"remaining_over_pulp", "depth_*", "floor_*", "wall_angle_*", "convergence_*", "surface_within_*", "unsupported_enamel", "gingival_above_cej"},
       "the lesion's bed is floor and walls, dentine goes beneath enamel, and the bed reaches below a gingival floor"},
      {SingleFault::wrong_bur, {"overcut_leeway_side", "overcut_beyond_side", "isthmus_width"},
       {"ridge_*", "surface_within_*", "clearance_*", "cavosurface_*", "wall_angle_*", "convergence_*", "target_removed",
        "unsupported_enamel", "remaining_over_pulp", "protected_*", "sound_lost"},
       "a wide bur does as too_wide, rounds the edges, and reaches the neighbour of a box"},
      {SingleFault::tremor, {"overcut_*", "surface_within_*", "floor_*"},
       {"depth_*", "isthmus_width", "wall_angle_*", "convergence_*", "cavosurface_*", "remaining_over_pulp", "target_removed",
        "ridge_*", "clearance_*", "gingival_*", "axial_*", "box_height", "unsupported_enamel", "protected_*", "sound_lost"},
       "a hand shakes along all axes"},
      {SingleFault::dry_cutting, {"dry_cutting_time"}, {}, "none"},
  };
  return rules;
}

namespace {

struct Known {
  SingleFault fault;
  std::string_view exercise, what, reason;
};

constexpr std::string_view kNoWalls = "no wall angle is measured on a block, and the tolerance zone holds the wedge";

constexpr std::string_view kWideZone = "the tolerance zone holds a tremor of 0.2 mm; the large one is found";

constexpr std::string_view kBelowBisector = "over-cut below the bisector of wall and floor is the floor's: 0.7 to 1.4 mm3 about a deep channel";

constexpr std::string_view kInLesion = "access and lesion go anyway: nothing beyond target and tolerance zone is cut, and no sound tissue";

constexpr std::array kKnown = {
    Known{SingleFault::undermined, "caries-46", kNotInOrder,
          "without a pulpal floor the hollow lies beside the gingival one and moves one wall's angle by 0.4 to 0.9 degrees"},
    Known{SingleFault::too_deep, "caries-26", kNotFound, kInLesion},
    Known{SingleFault::tilted_wall, "caries-26", kNotFound, "the tolerance zone holds the wedge: 0.02 mm3 lie beyond it"},
    Known{SingleFault::undermined, "caries-26", kNotFound, kInLesion},
    Known{SingleFault::wrong_bur, "caries-26", kNotFound, "the tolerance zone holds 0.2 mm: 0.03 mm3 lie beyond it; the large one is found"},
    Known{SingleFault::too_wide, "caries-26", "overcut_beyond_floor", "over-cut below the bisector of wall and floor is the floor's: 0.4 mm3"},
    Known{SingleFault::undermined, "class-*", kNotInOrder,
          "a hollow of 0.3 mm leans by more than 45 degrees at its ends, which are no wall: wall angles fall from 6.3 to 5.5 degrees; "
          "unsupported_enamel and over-cut go on growing"},
    Known{SingleFault::tilted_wall, "channel-*", kNotFound, kNoWalls},
    Known{SingleFault::tilted_wall, "line-*", kNotFound, kNoWalls},
    Known{SingleFault::tilted_wall, "cross-*", kNotFound, kNoWalls},
    Known{SingleFault::tilted_wall, "circle-*", kNotFound, kNoWalls},
    Known{SingleFault::tilted_wall, "ring-*", kNotFound, kNoWalls},
    Known{SingleFault::too_wide, "channel-3", "overcut_leeway_floor", kBelowBisector},
    Known{SingleFault::too_wide, "cross-3", "overcut_leeway_floor", kBelowBisector},
    Known{SingleFault::too_wide, "ring-3", "overcut_leeway_floor", kBelowBisector},
    Known{SingleFault::tremor, "line-1", kNotFound, kWideZone},
    Known{SingleFault::tremor, "cross-1", kNotFound, kWideZone},
    Known{SingleFault::tremor, "circle-1", kNotFound, kWideZone},
    Known{SingleFault::tremor, "class-1-37", kNotFound, kWideZone},
    Known{SingleFault::tremor, "paper-block", kNotFound, kWideZone},
    Known{SingleFault::rough_floor, "paper-block", kNotFound, "a filled volume has no flatness; the mean depth and the over-cut find the pits"},
    Known{SingleFault::wrong_bur, "class-2-*", "overcut_leeway_floor",
          "over-cut below the bisector of wall and floor is the floor's: 0.14 to 0.16 mm3 beside a floor of 2.0 to 2.5 mm2"},
    Known{SingleFault::exposed_pulp, "class-2-*", "axial_past_junction_most", "the way to the pulp goes through the axial wall: 0.44 mm become 2.1 and 2.4"},
    Known{SingleFault::wrong_bur, "class-2-*", "axial_past_junction_most", "the wider bur sets the axial wall back by 0.8 of its excess: 0.44 mm become 0.52, 0.60 and 0.78"},
};

}  // namespace

std::optional<std::string_view> reason_known(SingleFault fault, std::string_view exercise, std::string_view what) {
  for (const Known& known : kKnown)
    if (known.fault == fault && in({&known.exercise, 1}, exercise) && in({&known.what, 1}, what)) return known.reason;
  return std::nullopt;
}

FaultMatrix::FaultMatrix(Scenario scenario, std::shared_ptr<const Specimen> specimen)
    : scenario_(std::move(scenario)), specimen_(std::move(specimen)), criteria_(scenario_.rubric.criteria) {
  for (const MetricKey& metric : kMetricKeys) {
    const bool named = std::ranges::any_of(criteria_, [&](const Criterion& c) { return c.metric == metric.key; });
    const auto bands = default_bands(metric.key, scenario_.specimen.fdi);
    if (!named && bands) criteria_.push_back({std::string(metric.key), 1.0, *bands});
  }
  Scenario asked = scenario_;
  asked.rubric.criteria = criteria_;
  against_ = std::make_unique<Reference>(asked, specimen_);
  plan_ = plan_target(scenario_, *specimen_);
  if (!plan_.strokes.empty()) reference_ = graded({{{plan_, scenario_.instruments[plan_.bur]}}, 0.0});
}

Graded FaultMatrix::graded(const FaultCut& cut) const {
  Volume volume(specimen_);
  if (!cut_along(cut, volume)) return {};
  const std::vector<Measure> measures = measure(*against_, volume, Process::lasting(1.0 + cut.dry_s, cut.dry_s));
  Graded out;
  out.score = grade(scenario_, measures).score;
  for (const Measure& one : measures) {
    if (!one.measured) continue;
    for (std::size_t i = 0; i < criteria_.size(); ++i)
      if (criteria_[i].metric == one.metric)
        out.criteria[one.metric] = {one.value, share_of_points(criteria_[i].bands, one.value), i < scenario_.rubric.criteria.size()};
    if (std::ranges::count(kEvents, one.metric) > 0)
      out.criteria[one.metric] = {one.value, one.value > 0.0 ? 0.0 : 1.0, std::ranges::count(scenario_.rubric.critical, one.metric) > 0};
  }
  return out;
}

FaultRow judge(SingleFault fault, const Graded& reference, std::array<Graded, 3> sizes) {
  FaultRow out;
  out.sizes = std::move(sizes);
  const FaultRules& rules = fault_rules()[static_cast<std::size_t>(fault)];
  int own = 0;
  double most = 0.0;
  for (const auto& [metric, at] : reference.criteria) {
    const std::array<double, 3> loss = losses_of(metric, at, out.sizes);
    const auto largest = std::ranges::max_element(loss);
    if (in(rules.own, metric)) {
      if (*largest < kFoundLoss) continue;
      for (std::size_t size = 0; size < loss.size(); ++size) out.own[size] += loss[size];
      ++own;
      out.by_rubric = out.by_rubric || at.of_rubric;
      if (*largest > most) out.own_metric = metric;
      most = std::max(most, *largest);
    } else if (!in(rules.cross_talk, metric) && *largest > kForeignLoss && (at.of_rubric || at.share >= 1.0)) {
      // No rubric would ask for what the reference preparation itself has not.
      out.foreign.push_back({metric, *largest, static_cast<FaultSize>(largest - loss.begin())});
    }
  }
  for (double& loss : out.own) loss /= std::max(own, 1);
  return out;
}

std::optional<FaultRow> FaultMatrix::row(SingleFault fault) const {
  std::array<Graded, 3> sizes;
  for (std::size_t size = 0; size < sizes.size(); ++size) {
    const auto cut = fault_cut({fault, static_cast<FaultSize>(size)}, scenario_, *specimen_, plan_);
    if (!cut) return std::nullopt;
    sizes[size] = graded(*cut);
  }
  return judge(fault, reference_, std::move(sizes));
}

}  // namespace cusp::test
