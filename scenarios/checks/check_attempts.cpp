#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "scenarios/checks/checks.h"
#include "scenarios/format/keys.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"

namespace cusp::scenarios {
namespace {

constexpr double kTokenShare = 0.05;
/// Points that such a cut may earn at most (dentistry.md, "Templates and library").
constexpr double kMostTokenPoints = 5.0;
/// Points: rounding of a sum, not a merit.
constexpr double kNoPoints = 1e-9;
/// Duration of the idle attempt: time counts, force does not.
constexpr std::uint64_t kIdleUs = 10'000'000;

Process idle() {
  StepOutput nothing;
  nothing.elapsed_us = kIdleUs;
  Process process;
  process.add(nothing);
  return process;
}

/// A half space that bounds a token cut: from the top down, or round the target's first place.
struct Bound {
  bool shaft;
  Vec2 at;
  double from(Vec3 p) const noexcept { return shaft ? glm::length(Vec2(p.x, p.y) - at) : -p.z; }
};

/// Every voxel that stands within the target.
template <class Visit>
void each_in_target(const Reference& reference, double out_to_mm, Visit&& visit) {
  const Specimen& specimen = reference.specimen();
  const TargetShape& shape = reference.shape();
  const Grid& grid = specimen.grid();
  const auto voxel = [&](Vec3 p) { return IVec3(glm::floor((p - grid.origin_mm) / grid.voxel_mm)); };
  const IVec3 low =
      glm::max(voxel({shape.low().x - out_to_mm, shape.low().y - out_to_mm, shape.floor_mm() - out_to_mm}), IVec3(0));
  const IVec3 high = glm::min(voxel({shape.high().x + out_to_mm, shape.high().y + out_to_mm, 0.0}) + 1, grid.size - 1);
  IVec3 v;
  for (v.z = low.z; v.z < grid.size.z; ++v.z)
    for (v.y = low.y; v.y <= high.y; ++v.y)
      for (v.x = low.x; v.x <= high.x; ++v.x) {
        const double d = shape.distance_mm(grid.centre_mm(v));
        if (d <= out_to_mm) visit(v, d);
      }
}

/// The specimen without what lies in the target and within the bound: bound.from() is at most limit_mm.
Volume without_target(const Reference& reference, const std::shared_ptr<const Specimen>& specimen, const Bound& bound, double limit_mm) {
  const Grid& grid = specimen->grid();
  Volume out(specimen);
  const bool filled = specimen->reading() == Reading::filled;
  std::vector<int> touched;
  each_in_target(reference, (kBandVoxels + 1.0) * grid.voxel_mm, [&](IVec3 v, double target_mm) {
    const double d = std::max(target_mm, bound.from(grid.centre_mm(v)) - limit_mm) / grid.voxel_mm;
    const std::uint16_t value = filled ? (d > 0.0 ? kSolid : std::uint16_t{0}) : solid_from_distance(-d);
    if (value == kSolid) return;
    const int brick = specimen->brick_index({v.x >> 3, v.y >> 3, v.z >> 3});
    std::uint16_t* cut = out.cut_for_writing(brick);
    if (cut == nullptr) return;
    cut[brick_offset(v.x & 7, v.y & 7, v.z & 7)] = value;
    touched.push_back(brick);
  });
  std::ranges::sort(touched);
  touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
  for (const int brick : touched) out.touched(brick);
  return out;
}

/// The specimen without the twentieth of the target that lies nearest to the bound's origin.
Volume token(const Reference& reference, const std::shared_ptr<const Specimen>& specimen, const Bound& bound) {
  std::vector<double> places;
  each_in_target(reference, 0.0, [&](IVec3 v, double) {
    if (specimen->s(v) >= kHalf) places.push_back(bound.from(specimen->grid().centre_mm(v)));
  });
  if (places.empty()) return Volume(specimen);
  const auto at = places.begin() + static_cast<std::ptrdiff_t>(kTokenShare * static_cast<double>(places.size() - 1));
  std::nth_element(places.begin(), at, places.end());
  return without_target(reference, specimen, bound, *at);
}

/// Of the way, not of the tooth: an attempt that is not played has none.
bool is_of_process(std::string_view metric) { return metric == "time" || metric.starts_with("force_") || needs_heat(metric); }

/// Whether an attempt that cuts the whole target and nothing else passes, on the simplest admitted device and on one that expresses every
/// criterion, within what a model's own error may change. What only a played attempt has is of no account.
std::optional<Finding> check_pass(const Scenario& scenario, const std::vector<Measure>& measures) {
  Scenario cut = scenario;
  std::erase_if(cut.rubric.criteria, [](const Criterion& c) { return is_of_process(c.metric); });
  for (const int axes : {scenario.device.needs_dof, kAllAxes}) {
    const Grade exact = grade(cut, measures, axes);
    if (std::ranges::none_of(exact.criteria, [](const CriterionGrade& c) { return c.points_max > 0.0; })) continue;
    if (exact.critical.empty() && reaches(exact.score + scenario.tolerance_points, exact.pass_mark)) continue;
    return Finding{Severity::error, "/rubric/pass", "target_fails", {{"value", exact.score}, {"limit", exact.pass_mark}},
                   exact.critical.empty() ? std::string() : exact.critical.front()};
  }
  return std::nullopt;
}

/// The tooth without the whole target: criteria that not even this lets be measured drop out of every grade.
std::vector<Finding> check_finished(const Scenario& scenario, const Reference& reference, const std::shared_ptr<const Specimen>& specimen,
                                    const Process& process) {
  constexpr double kAll = 1e9;
  const auto measures = measure(reference, without_target(reference, specimen, {false, {}}, kAll), process);
  std::vector<Finding> out;
  for (std::size_t i = 0; i < scenario.rubric.criteria.size(); ++i) {
    const std::string& metric = scenario.rubric.criteria[i].metric;
    const auto found = std::ranges::find(measures, metric, &Measure::metric);
    if (is_of_process(metric) || (found != measures.end() && found->measured)) continue;
    out.push_back({Severity::error, "/rubric/criteria/" + std::to_string(i) + "/metric", "criterion_unmeasured", {}, metric});
  }
  if (auto fails = check_pass(scenario, measures)) out.push_back(std::move(*fails));
  return out;
}

}  // namespace

std::vector<Finding> check_attempts(const Scenario& scenario, std::shared_ptr<const Specimen> specimen) {
  std::vector<Finding> out;
  const Reference reference(scenario, specimen);
  const Process process = idle();
  const Grade untouched = grade(scenario, measure(reference, Volume(specimen), process));
  if (untouched.score > kNoPoints || untouched.passed)
    out.push_back({Severity::error, "/rubric/criteria", "idle_earns", {{"value", untouched.score}}, {}});
  const auto outlines = outlines_of(scenario.target);
  const Vec2 middle = 0.5 * (reference.shape().low() + reference.shape().high());
  if (reference.shape().empty()) return out;
  for (Finding& finding : check_finished(scenario, reference, specimen, process)) out.push_back(std::move(finding));
  // A tree without outlines is touched at its middle.
  const bool drawn = !outlines.empty() && !outlines.front()->paths.empty() && !outlines.front()->paths.front().empty();
  const Vec3 first = drawn ? outlines.front()->paths.front().front() : Vec3(middle, 0.0);
  double passes = -1.0, earns = 0.0;
  for (const bool shaft : {false, true}) {
    const Volume volume = token(reference, specimen, {shaft, {first.x, first.y}});
    const Grade token_grade = grade(scenario, measure(reference, volume, process));
    if (token_grade.passed) passes = std::max(passes, token_grade.score);
    earns = std::max(earns, token_grade.score);
  }
  if (passes >= 0.0)
    out.push_back({Severity::error, "/rubric/criteria", "token_passes", {{"value", passes}, {"limit", scenario.rubric.pass}}, {}});
  else if (earns > kMostTokenPoints + kNoPoints)
    out.push_back({Severity::warning, "/rubric/criteria", "token_earns", {{"value", earns}, {"limit", kMostTokenPoints}}, {}});
  return out;
}

std::vector<Finding> check_exercise(const Scenario& scenario, std::shared_ptr<const Specimen> specimen) {
  std::vector<Finding> out = check_regions(scenario, *specimen);
  for (Finding& finding : check_attempts(scenario, std::move(specimen))) out.push_back(std::move(finding));
  for (Finding& finding : check_texts(scenario, library_patterns())) out.push_back(std::move(finding));
  std::ranges::stable_sort(out, [](const Finding& a, const Finding& b) {
    return a.severity == Severity::error && b.severity == Severity::warning;
  });
  return out;
}

}  // namespace cusp::scenarios
