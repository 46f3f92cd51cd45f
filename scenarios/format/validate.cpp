#include "scenarios/format/validate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include <nlohmann/json.hpp>

#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/json_text.h"
#include "scenarios/format/keys.h"
#include "scenarios/format/migrate.h"
#include "scenarios/format/ranges.h"
#include "scenarios/format/read.h"
#include "scenarios/format/schema.h"
#include "scenarios/format/validate_region.h"
#include "scenarios/format/write_document.h"

namespace cusp::scenarios {
namespace {

/// Below this a bur is not resolved by the voxels (contact trials: a cut of the band is not distinct from its noise).
constexpr double kLeastRadiusVoxels = 3.0;
/// Points of 100: a criterion of less does not show (scenarios/grading/maxima.h).
constexpr double kLeastShare = 0.05;
/// Points: 100 times a sum of weights by that sum may lie 1.4e-14 below 100.
constexpr double kRounding = 1e-9;
/// A landmark lies on the tooth; one placed by eye misses it by less, mm [M].
constexpr double kBesideMm = 1.0;
/// What no measure exceeds, by its unit: no tooth is larger, no attempt lasts longer and no hand pushes harder [M].
double beyond_any(const MetricKey& metric) noexcept {
  return std::min(metric.most, metric.unit == "s" ? 86400.0 : metric.unit == "mm3" ? 1000.0 : 100.0);
}
/// Two voxel sizes nearer than this are one, mm: a file may state 0.1 as the nearest 32-bit number, 1.5e-9 more.
constexpr double kSameVoxelMm = 1e-6;

void errors_first(std::vector<Finding>& findings) {
  std::ranges::stable_sort(findings, [](const Finding& a, const Finding& b) {
    return a.severity == Severity::error && b.severity == Severity::warning;
  });
}

class Checks {
 public:
  explicit Checks(const Scenario& scenario, const SpecimenFacts* specimen) : s_(scenario), facts_(specimen) {}

  std::vector<Finding> run() {
    ranges(document_of(s_), "");
    texts();
    tissues();
    phenomena();
    instruments();
    check_target(s_, facts_, out_);
    leeway();
    landmarks();
    critical_events();
    ridges();
    rubric();
    if (facts_ != nullptr) specimen();
    errors_first(out_);
    return std::move(out_);
  }

 private:
  void error(std::string path, std::string code, std::map<std::string, double> args = {}, std::string detail = {}) {
    out_.push_back({Severity::error, std::move(path), std::move(code), std::move(args), std::move(detail)});
  }
  void warn(std::string path, std::string code, std::map<std::string, double> args = {}, std::string detail = {}) {
    out_.push_back({Severity::warning, std::move(path), std::move(code), std::move(args), std::move(detail)});
  }
  static std::string at(const char* list, std::size_t i, const char* rest = "") {
    return std::string(list) + "/" + std::to_string(i) + rest;
  }
  bool has_tissue(Tissue tissue) const {
    return std::ranges::any_of(s_.tissues, [&](const ScenarioTissue& t) { return t.tissue == tissue; });
  }

  /// Every number of the document against the one table (ranges.h).
  void ranges(const nlohmann::json& node, const std::string& pointer) {
    if (node.is_object()) {
      for (auto it = node.begin(); it != node.end(); ++it) ranges(it.value(), pointer + json_text::pointer_step(it.key()));
    } else if (node.is_array()) {
      for (std::size_t i = 0; i < node.size(); ++i) ranges(node[i], pointer + "/" + std::to_string(i));
    } else if (node.is_number()) {
      const double value = node.get<double>();
      const NumberRange* range = range_of(pointer);
      if (!std::isfinite(value)) {
        error(pointer, std::string(key_of(FormatError::not_finite)));
      } else if (range != nullptr && !range->holds(value)) {
        error(pointer, std::string(key_of(FormatError::out_of_range)),
              {{"value", value}, {"least", range->least}, {"most", range->most}}, range->text());
      }
    }
  }

  void texts() {
    std::set<std::string> languages;
    for (const auto& [language, text] : s_.title) languages.insert(language);
    for (const auto& [language, text] : s_.briefing) languages.insert(language);
    for (const std::string& language : languages) {
      if (!s_.title.contains(language)) warn("/title", "language_missing", {}, language);
      if (!s_.briefing.contains(language)) warn("/briefing", "language_missing", {}, language);
      for (std::size_t i = 0; i < s_.target.parts.size(); ++i)
        if (const auto& title = s_.target.parts[i].title; !title.empty() && !title.contains(language))
          warn(at("/target/parts", i, "/title"), "language_missing", {}, language);
    }
    if (s_.time_limit_s > 0 && s_.expected_time_s > s_.time_limit_s)
      warn("/expected_time_s", "expected_beyond_limit", {{"value", s_.expected_time_s}, {"limit", s_.time_limit_s}});
  }

  void tissues() {
    for (std::size_t i = 0; i < s_.protected_parts.size(); ++i) {
      const auto tissue = s_.protected_parts[i].tissue;
      if (tissue && !has_tissue(*tissue))
        error(at("/protected", i), "protected_missing", {}, std::string(key_of_scenario_tissue(*tissue)));
      const auto whole = whole_tissue(s_.protected_parts[i]);
      const auto same = [&](const Protected& other) { return whole ? whole_tissue(other) == whole : other == s_.protected_parts[i]; };
      if (std::ranges::find_if(s_.protected_parts, same) < s_.protected_parts.begin() + static_cast<std::ptrdiff_t>(i))
        warn(at("/protected", i), "protected_twice", {}, whole ? std::string(key_of_scenario_tissue(*whole)) : "region");
    }
    if (std::ranges::none_of(s_.tissues, [](const ScenarioTissue& t) { return t.speed_mm_s > 0; })) warn("/tissues", "nothing_can_be_cut");
    for (const std::string& event : s_.rubric.critical) {
      if (event == "protected_damage" && s_.protected_parts.empty()) error("/rubric/critical", "nothing_protected");
      const bool guarded = is_protected(s_, Tissue::pulp);
      if (event == "pulp_exposure" && !guarded) error("/rubric/critical", "protected_missing", {}, "pulp");
    }
  }

  void phenomena() {
    const auto spindles = std::ranges::count_if(s_.phenomena, [](const std::string& k) { return k.starts_with("spindle-"); });
    if (spindles > 1) error("/phenomena", "two_spindles");
    for (std::size_t i = 0; i < s_.phenomena.size(); ++i) {
      const std::string& key = s_.phenomena[i];
      if ((key == "vibration" || key == "sound") && spindles == 0) error(at("/phenomena", i), "spindle_missing", {}, key);
    }
    if (has_phenomenon(s_.phenomena, "heat")) return;
    for (std::size_t i = 0; i < s_.rubric.criteria.size(); ++i) {
      const std::string& metric = s_.rubric.criteria[i].metric;
      if (needs_heat(metric)) error(at("/rubric/criteria", i, "/metric"), "heat_missing", {}, metric);
    }
    for (std::size_t i = 0; i < s_.rubric.critical.size(); ++i) {
      if (needs_heat(s_.rubric.critical[i])) error(at("/rubric/critical", i), "heat_missing", {}, s_.rubric.critical[i]);
    }
  }

  void instruments() {
    if (s_.instruments.empty()) error("/instruments", "no_instrument");
    for (std::size_t i = 0; i < s_.instruments.size(); ++i) {
      const Bur& bur = s_.instruments[i];
      if (!fits_its_number(bur)) {
        warn(at("/instruments", i, "/name"), "bur_not_of_number",
             {{"value", 2 * bur.radius_mm}, {"limit", 2 * catalogue_bur(bur.name)->bur.radius_mm}}, bur.name);
      }
      const double least = kLeastRadiusVoxels * s_.specimen.voxel_mm;
      if (below(bur.radius_mm, least)) {
        warn(at("/instruments", i, "/radius_mm"), "bur_small", {{"value", bur.radius_mm}, {"limit", least}},
             bur.name);
      }
      const double length = bur.head.ball() ? 2 * bur.radius_mm : bur.head.high() - bur.head.low();
      if (!bur.head.ball() && below(length, 2 * least)) {
        warn(at("/instruments", i, "/head"), "head_short", {{"value", length}, {"limit", 2 * least}}, bur.name);
      }
      // The neck runs from the pivot: where it is wider than the head it would touch before the head does.
      OnHalf gradient;
      const bool wider = bur.head.ball() ? bur.neck_radius_mm > bur.radius_mm
                                          : bur.head.distance({0.0, bur.neck_radius_mm}, gradient) > 1e-9;
      if (wider) {
        warn(at("/instruments", i, "/neck_radius_mm"), "neck_wider_than_ball",
             {{"value", bur.neck_radius_mm}, {"limit", bur.radius_mm}}, bur.name);
      }
    }
  }

  void leeway() {
    const double voxel_mm = s_.specimen.voxel_mm, floor_mm = s_.leeway.floor_mm, side_mm = s_.leeway.side_mm;
    if (below(floor_mm, voxel_mm)) warn("/leeway/floor_mm", "leeway_below_voxel", {{"value", floor_mm}, {"limit", voxel_mm}});
    if (below(side_mm, voxel_mm)) warn("/leeway/side_mm", "leeway_below_voxel", {{"value", side_mm}, {"limit", voxel_mm}});
  }

  /// A proposal for another file, or a tooth that lies askew in its own.
  void landmarks() {
    const SpecimenLandmarks& all = s_.specimen.landmarks;
    const double turned = std::abs(turn_deg(all).value_or(0.0)), tilted = tilt_deg(all).value_or(0.0);
    if (turned > kMostTurnedDeg) warn("/specimen/landmarks", "tooth_turned", {{"value", turned}, {"limit", kMostTurnedDeg}});
    if (tilted > kMostTiltedDeg) warn("/specimen/landmarks", "tooth_tilted", {{"value", tilted}, {"limit", kMostTiltedDeg}});
    if (facts_ == nullptr) return;
    for (std::size_t i = 0; i < all.marks.size(); ++i) {
      const Landmark& mark = all.marks[i];
      if (mark.kind == MarkKind::long_axis || mark.kind == MarkKind::mesial_axis) continue;
      const bool inside = std::ranges::all_of(mark.points_mm, [&](Vec3 p) {
        return glm::all(glm::greaterThan(p, facts_->low_mm - kBesideMm)) && glm::all(glm::lessThan(p, facts_->high_mm + kBesideMm));
      });
      if (!inside) error(at("/specimen/landmarks/marks", i), "landmark_outside", {}, std::string(key_of(mark.kind)));
    }
  }

  /// The target of that name, the whole one for none; nullptr where the exercise has no such target.
  const Region* target_of(std::string_view name) const {
    if (name.empty()) return &s_.target;
    for (const Region* one : named_targets(s_.target))
      if (one->name == name) return one;
    return nullptr;
  }

  /// What this metric reads when the target is met exactly; nullopt if the target does not determine it.
  std::optional<double> perfect(std::string_view key) const {
    const auto [metric, name] = split_metric(key);
    if (metric == "target_removed") return 100.0;
    if (metric == "uncut_remainder" || metric.starts_with("overcut_")) return 0.0;
    // A lone outline with upright walls is straight and has a level floor; of other targets nothing more is known here.
    const Region* target = target_of(name);
    const bool upright = target != nullptr && target->kind == RegionKind::outline && target->outline.taper_deg == std::array<double, 4>{};
    if (!upright) return std::nullopt;
    if (metric.starts_with("depth_")) return target->outline.depth_mm;
    if (metric.starts_with("wall_angle_") || metric.starts_with("convergence_") || metric.starts_with("floor_")) return 0.0;
    return std::nullopt;
  }

  /// Share of full points: 1 in the ideal band, 1/2 at acc, 0 at fail; coinciding edges are a step.
  static double share(const Bands& b, double v) {
    if (v >= b.ideal_lo && v <= b.ideal_hi) return 1;
    const bool low = v < b.ideal_lo;
    const double ideal = low ? b.ideal_lo : -b.ideal_hi;
    const double acc = low ? b.acc_lo : -b.acc_hi;
    const double none = low ? b.fail_lo : -b.fail_hi;
    const double x = low ? v : -v;
    if (x >= acc) return acc < ideal ? 0.5 + 0.5 * (x - acc) / (ideal - acc) : 0.5;
    if (x <= none) return 0;
    return 0.5 * (x - none) / (acc - none);
  }

  void ridges() {
    if (!s_.specimen.is_one_with_neighbours()) return;
    for (std::size_t i = 0; i < s_.rubric.criteria.size(); ++i)
      if (const std::string& metric = s_.rubric.criteria[i].metric; metric.starts_with("ridge_"))
        error(at("/rubric/criteria", i, "/metric"), "ridge_of_plastic", {}, metric);
  }

  void critical_events() {
    const std::vector<std::string>& all = s_.rubric.critical;
    for (std::size_t i = 1; i < all.size(); ++i)
      if (std::ranges::find(all, all[i]) < all.begin() + static_cast<std::ptrdiff_t>(i))
        error(at("/rubric/critical", i), "critical_twice", {}, all[i]);
  }

  void rubric() {
    const Rubric& r = s_.rubric;
    if (r.criteria.empty()) {
      error("/rubric/criteria", "no_criteria");
      return;
    }
    double weights = 0, reachable = 0;
    double simplest_weights = 0, simplest_reachable = 0;  // of what the simplest admitted device expresses (grader.h)
    bool ordered = true;
    for (std::size_t i = 0; i < r.criteria.size(); ++i) {
      const Criterion& c = r.criteria[i];
      const Bands& b = c.bands;
      weights += c.weight;
      if (target_of(split_metric(c.metric).target) == nullptr) error(at("/rubric/criteria", i, "/metric"), "target_missing", {}, c.metric);
      if (c.weight == 0) error(at("/rubric/criteria", i, "/weight"), "weight_zero", {}, c.metric);
      const std::array edges = {b.fail_lo, b.acc_lo, b.ideal_lo, b.ideal_hi, b.acc_hi, b.fail_hi};
      if (!std::ranges::is_sorted(edges)) {
        error(at("/rubric/criteria", i, "/bands"), "bands_not_ordered", {}, c.metric);
        ordered = false;
        continue;
      }
      const auto metric = metric_from_key(c.metric);
      if (metric && share(b, metric->least) == 1 && share(b, beyond_any(*metric)) == 1)
        warn(at("/rubric/criteria", i, "/bands"), "bands_without_edge", {}, c.metric);
      double best = 1;
      if (const auto v = perfect(c.metric)) {
        best = share(b, *v);
        if (best < 1) {
          warn(at("/rubric/criteria", i, "/bands"), "target_scores_less",
               {{"value", *v}, {"lost", c.weight * (1 - best)}}, c.metric);
        }
      } else if (metric && (b.ideal_hi < metric->least || b.ideal_lo > metric->most)) {
        best = std::max(share(b, metric->least), share(b, metric->most));
      }
      reachable += best * c.weight;
      if (c.needs_dof > s_.device.needs_dof) continue;
      simplest_weights += c.weight;
      simplest_reachable += best * c.weight;
    }
    for (std::size_t i = 0; i < r.criteria.size(); ++i) {
      const double share = 100 * r.criteria[i].weight / weights;
      if (share > 0 && share < kLeastShare)
        warn(at("/rubric/criteria", i, "/weight"), "weight_vanishes", {{"value", share}, {"limit", kLeastShare}}, r.criteria[i].metric);
    }
    if (ordered && weights > 0) {
      const double on_simplest = simplest_weights > 0 ? 100 * simplest_reachable / simplest_weights : 0.0;
      const double most = std::min(100 * reachable / weights, on_simplest);
      if (r.pass > most + kRounding) error("/rubric/pass", "pass_unreachable", {{"value", r.pass}, {"limit", most}});
    }
  }

  void specimen() {
    const SpecimenFacts& f = *facts_;
    if (std::abs(f.voxel_mm - s_.specimen.voxel_mm) > kSameVoxelMm) {
      error("/specimen/voxel_mm", "voxel_mismatch", {{"value", s_.specimen.voxel_mm}, {"limit", f.voxel_mm}});
    }
    for (const Tissue tissue : f.tissues) {
      if (!has_tissue(tissue)) error("/tissues", "tissue_missing", {}, std::string(key_of_scenario_tissue(tissue)));
    }
    const auto occurs = [&](Tissue t) { return std::ranges::find(f.tissues, t) != f.tissues.end(); };
    for (std::size_t i = 0; i < s_.protected_parts.size(); ++i) {
      const auto tissue = s_.protected_parts[i].tissue;
      if (tissue && has_tissue(*tissue) && !occurs(*tissue))
        error(at("/protected", i), "protected_missing", {}, std::string(key_of_scenario_tissue(*tissue)));
    }
    for (std::size_t i = 0; i < s_.tissues.size(); ++i) {
      if (!occurs(s_.tissues[i].tissue)) {
        warn(at("/tissues", i), "tissue_unused", {}, std::string(key_of_scenario_tissue(s_.tissues[i].tissue)));
      }
    }
  }

  const Scenario& s_;
  const SpecimenFacts* facts_;
  std::vector<Finding> out_;
};

}  // namespace

SpecimenFacts facts_of(const VoxelVolume& volume) {
  SpecimenFacts facts;
  facts.voxel_mm = volume.grid.voxel_mm;
  std::array<bool, kTissueCodes> seen{};
  IVec3 low = volume.grid.size;
  IVec3 high(-1);
  std::size_t at = 0;
  for (int z = 0; z < volume.grid.size.z; ++z) {
    for (int y = 0; y < volume.grid.size.y; ++y) {
      for (int x = 0; x < volume.grid.size.x; ++x, ++at) {
        if (volume.s[at] < kHalf) continue;
        seen[index_of(volume.tissue[at])] = true;
        low = glm::min(low, IVec3(x, y, z));
        high = glm::max(high, IVec3(x, y, z));
      }
    }
  }
  for (std::size_t code = 1; code < seen.size(); ++code) {
    if (seen[code]) facts.tissues.push_back(static_cast<Tissue>(code));
  }
  if (high.x >= 0) {
    const Vec3 half(volume.grid.voxel_mm / 2);
    facts.low_mm = volume.grid.centre_mm(low) - half;
    facts.high_mm = volume.grid.centre_mm(high) + half;
  }
  return facts;
}

std::vector<Finding> validate(const Scenario& scenario, const SpecimenFacts* specimen) {
  return Checks(scenario, specimen).run();
}

namespace {

/// What the schema is to see: a document of an older format as the present one says it.
std::string in_present_format(std::string_view text) {
  auto document = json_text::parse(text);
  if (!document || !document->is_object() || !migrate(*document)) return std::string(text);
  return document->dump();
}

}  // namespace

std::vector<Finding> validate_text(std::string_view text, const SpecimenFacts* specimen) {
  const auto scenario = read_scenario(text);
  if (scenario) {
    std::vector<Finding> out = validate(*scenario, specimen);
    const std::size_t own = out.size();
    for (Finding& finding : check_schema(in_present_format(text))) {
      const auto reported = [&](const Finding& f) { return f.severity == Severity::error && f.path == finding.path; };
      if (std::none_of(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(own), reported)) out.push_back(std::move(finding));
    }
    errors_first(out);
    return out;
  }
  const FormatFailure& failure = scenario.error();
  std::vector<Finding> out;
  out.push_back({Severity::error, failure.where, std::string(key_of(failure.code)), {}, failure.detail});
  for (Finding& finding : check_schema(in_present_format(text))) out.push_back(std::move(finding));
  return out;
}

std::optional<double> stated_voxel_mm(double voxel_mm) noexcept {
  const NumberRange& edge = *range_of("/specimen/voxel_mm");
  const double within = std::clamp(voxel_mm, edge.least, edge.most);
  return std::abs(within - voxel_mm) <= kSameVoxelMm ? std::optional(within) : std::nullopt;
}

bool has_error(const std::vector<Finding>& findings) noexcept {
  return std::ranges::any_of(findings, [](const Finding& f) { return f.severity == Severity::error; });
}

}  // namespace cusp::scenarios
