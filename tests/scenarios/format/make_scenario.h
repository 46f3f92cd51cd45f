/// A seeded generator of scenarios that are well formed, with every list at every length that matters.
#pragma once

#include <random>

#include "scenarios/burs/bur_catalogue.h"
#include "scenarios/format/keys.h"
#include "scenarios/format/scenario.h"
#include "tests/modules.h"

namespace cusp::test {

class ScenarioMaker {
 public:
  explicit ScenarioMaker(std::uint64_t seed) : random_(seed) {}

  Scenario make() {
    Scenario s;
    for (auto& byte : s.id.uuid.bytes) byte = static_cast<std::uint8_t>(random_());
    s.version = 1 + pick(1000);
    if (coin()) s.key = "made-" + std::to_string(pick(1000));
    s.title = texts();
    s.briefing = texts();
    if (pick(4) == 0) s.level = static_cast<Level>(pick(static_cast<int>(kLevelKeys.size())));
    if (pick(4) == 0) s.expected_time_s = between(10, 86400);
    s.self_assessment = pick(4) == 0;
    if (pick(4) == 0) s.made_with = {"class-1-adhesive", {{"depth", between(-1000, 1000)}, {"width", 1.25}}};
    s.specimen = specimen();
    for (std::size_t code = 1; code < kTissueCodes; ++code) {
      if (code >= kTissueKeys.size() && code < 16) continue;
      if (pick(4) == 0) s.tissues.push_back({static_cast<Tissue>(code), between(0.05, 20), between(0.01, 100)});
    }
    for (int i = pick(4); i > 0; --i) {
      s.instruments.push_back(
          {std::to_string(i) + text(), between(0.05, 5), between(0.05, 5), between(0, 50), between(0.05, 5), between(0, 100), {}});
      if (coin()) continue;
      const std::vector<CatalogueBur>& all = bur_catalogue();
      const Bur& one = all[static_cast<std::size_t>(pick(static_cast<int>(all.size())))].bur;
      s.instruments.back().radius_mm = one.radius_mm;
      s.instruments.back().head = one.head;
    }
    s.device.needs_dof = 3 + pick(4);
    if (coin()) s.device.admitted = {"pointer", "falcon"};
    s.device.full_force_n = between(0.1, 20);
    s.tool_tilt_deg = between(-80, 80);
    if (coin()) s.tool_turn_deg = between(0, 60);
    s.method = kMethods[static_cast<std::size_t>(pick(static_cast<int>(kMethods.size())))];
    if (coin()) s.phenomena = {"friction"};
    s.target.outline.shape = kShapeKeys[static_cast<std::size_t>(pick(static_cast<int>(kShapeKeys.size())))];
    for (int i = 1 + pick(4); i > 0; --i) {
      auto& path = s.target.outline.paths.emplace_back();
      for (int k = 1 + pick(6); k > 0; --k) path.push_back(point());
    }
    s.target.outline.width_mm = between(0.1, 100);
    s.target.outline.depth_mm = between(0.1, 100);
    s.target.outline.top_mm = between(-1000, 1000);
    s.target.outline.corner_radius_mm = between(0, 5);
    s.target.outline.box_size_mm = {between(0, 1000), between(0, 1000), between(0, 1000)};
    if (pick(4) == 0) {
      Region lone = s.target;
      s.target = region(2);
      s.target.parts.push_back(std::move(lone));
    }
    s.leeway = {between(0, 5), between(0, 5)};
    if (pick(4) == 0) s.leeway.faces[static_cast<FaceName>(pick(static_cast<int>(kFaceNames)))] = between(0, 5);
    if (coin()) s.protected_parts = {Tissue::pulp, static_cast<Tissue>(16 + pick(16))};
    s.time_limit_s = coin() ? 0 : between(10, 86400);
    s.rubric.pass = between(1, 100);
    for (const MetricKey& metric : kMetricKeys) {
      if (coin()) s.rubric.criteria.push_back({std::string(metric.key), between(0.1, 1000), bands()});
    }
    if (coin()) s.rubric.criteria.push_back({"removed_carious_dentine", between(0.1, 1000), bands()});
    if (coin()) s.rubric.critical = {"pulp_exposure"};
    s.tolerance_points = between(0, 20);
    return s;
  }

 private:
  int pick(int count) { return static_cast<int>(random_() % static_cast<std::uint64_t>(count)); }
  bool coin() { return pick(2) == 0; }
  /// Often a round number, as people write; else any double in the range.
  double between(double low, double high) {
    if (coin()) return low + std::floor((high - low) * pick(1000) / 1000);
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 point() { return {between(-1000, 1000), between(-1000, 1000), between(-1000, 1000)}; }
  /// A union of boxes, balls and unions.
  Region region(int depth) {
    Region out;
    out.kind = RegionKind::joined;
    out.rounding_mm = coin() ? 0 : between(0, 5);
    for (int i = 2 + pick(3); i > 0; --i) {
      if (depth > 0 && coin()) {
        out.parts.push_back(region(depth - 1));
        continue;
      }
      Region& leaf = out.parts.emplace_back();
      if (pick(4) == 0) {
        leaf.kind = coin() ? RegionKind::tissue : RegionKind::lesion;
        if (leaf.kind == RegionKind::tissue) leaf.tissue = coin() ? Tissue::pulp : Tissue{31};
        else leaf.down_to = coin() ? Hardness::soft : Hardness::firm;
        continue;
      }
      leaf.kind = coin() ? RegionKind::box : RegionKind::sphere;
      leaf.from_mm = point();
      if (leaf.kind == RegionKind::box) leaf.size_mm = {between(1, 100), between(1, 100), between(1, 100)};
      else leaf.radius_mm = between(1, 100);
      if (leaf.kind == RegionKind::box && coin()) leaf.faces["z_low"] = FaceName::gingival_floor;
    }
    return out;
  }
  Bands bands() {
    return {between(-100, 100), between(-1e6, 1e6), between(0, 1e-6), between(0, 1), between(0, 1e6), between(-1, 1)};
  }
  std::string text() {
    static const std::string parts[] = {"a", "Ü", "\"",  "\\", "\n", "/", "<b>", "\xe4\xb8\xad", "\xf0\x9f\xa6\xb7",
                                        " ", "~", "\x01"};
    std::string out;
    for (int i = 1 + pick(8); i > 0; --i) out += parts[pick(12)];
    return out;
  }
  LocalText texts() {
    LocalText out{{"en", text()}};
    if (coin()) out["de"] = text();
    if (coin()) out["pt_BR"] = text();
    return out;
  }
  SpecimenSource specimen() {
    SpecimenSource out;
    out.voxel_mm = std::uniform_real_distribution<double>(0.04, 1)(random_);
    switch (pick(4)) {
      case 0:
        out.generator = "paper-block";
        break;
      case 1:
        out.generator = "block";
        break;
      case 2:
        out.volume = "tooth.nrrd";
        if (coin()) out.landmarks = landmarks();
        break;
      default:
        out.generator = "tooth";
        out.fdi = 10 * (1 + pick(4)) + 1 + pick(8);
        out.seed = coin() ? 0 : random_() >> 11;
    }
    return out;
  }

  SpecimenLandmarks landmarks() {
    SpecimenLandmarks out;
    if (coin()) out.fdi = 10 * (1 + pick(4)) + 1 + pick(8);
    for (std::size_t kind = 0; kind < kMarkKeys.size(); ++kind) {
      if (coin()) continue;
      Landmark& mark = out.marks.emplace_back();
      mark.kind = static_cast<MarkKind>(kind);
      if (coin()) mark.name = text();
      mark.state = coin() ? MarkState::set : MarkState::proposed;
      const PointCount count = point_count(mark.kind);
      const int more = count.most > count.least ? pick(5) : 0;
      for (int i = static_cast<int>(count.least) + more; i > 0; --i) mark.points_mm.push_back(point());
      if (mark.kind == MarkKind::cej) mark.points_mm.back() = mark.points_mm.front();
    }
    return out;
  }

  std::mt19937_64 random_;
};

/// A small scenario without a single finding, to break one thing at a time.
inline Scenario sound_scenario() {
  Scenario s;
  s.id = *ScenarioId::parse("019a9f3c-6a00-7c41-9b1e-5d0f6a3c2eff");
  s.title = {{"en", "Channel"}, {"de", "Rinne"}};
  s.briefing = {{"en", "Cut."}, {"de", "Schleifen."}};
  s.specimen.generator = "block";
  s.tissues = {{Tissue::plastic, 2, 2}};
  s.instruments = {{.name = "4", .radius_mm = 0.7, .neck_radius_mm = 0.4}};
  s.target.outline.paths = {{Vec3(-4, 0, -2), Vec3(4, 0, -2)}};
  s.target.outline.width_mm = 1.6;
  s.target.outline.corner_radius_mm = 0.7;
  s.rubric.criteria = {{"target_removed", 60, {80, 90, 97, 100, 100, 100}},
                       {"depth_mean", 40, {1, 1.5, 1.8, 2.2, 2.5, 3}}};
  return s;
}

/// The sound scenario on a tooth from a file, with a landmark of each kind.
inline Scenario marked_scenario() {
  Scenario s = sound_scenario();
  s.specimen.generator.clear();
  s.specimen.volume = "tooth.nrrd";
  s.specimen.landmarks.fdi = 36;
  for (std::size_t kind = 0; kind < kMarkKeys.size(); ++kind) {
    Landmark& mark = s.specimen.landmarks.marks.emplace_back();
    mark.kind = static_cast<MarkKind>(kind);
    mark.state = kind % 2 == 0 ? MarkState::proposed : MarkState::set;
    if (mark.kind == MarkKind::pit) mark.name = "central";
    for (std::size_t i = 0; i < point_count(mark.kind).least; ++i) {
      const double along = static_cast<double>(i);
      mark.points_mm.push_back(mark.kind == MarkKind::mesial_axis ? Vec3(along, 0, 0) : Vec3(0, 0, along));
    }
    if (mark.kind == MarkKind::cej) mark.points_mm.back() = mark.points_mm.front();
  }
  return s;
}

/// Every kind of region, in the order of kRegionKeys, under a rounded union.
inline Region region_with_every_kind() {
  Region out;
  out.kind = RegionKind::joined;
  out.rounding_mm = 0.2;
  for (std::size_t kind = 0; kind < kRegionKeys.size(); ++kind) {
    Region part;
    part.kind = static_cast<RegionKind>(kind);
    const bool ends = part.kind == RegionKind::cylinder || part.kind == RegionKind::cone || part.kind == RegionKind::capsule;
    if (ends) part.to_mm = {0, 0, 1};
    if (ends || part.kind == RegionKind::sphere) part.radius_mm = 1;
    if (part.kind == RegionKind::cone) part.end_radius_mm = 1;
    if (part.kind == RegionKind::box || part.kind == RegionKind::ellipsoid) part.size_mm = {1, 1, 1};
    if (part.kind == RegionKind::offset) part.by_mm = 0.5;
    if (part.kind == RegionKind::tissue) part.tissue = Tissue::plastic;
    if (part.kind == RegionKind::lesion) part.down_to = Hardness::soft;
    if (part.kind == RegionKind::outline) {
      part.outline = sound_scenario().target.outline;
      part.outline.taper_deg = {1, 2, 3, 4};
    }
    if (is_node(part.kind)) part.parts.resize(part.kind == RegionKind::offset ? 1 : 2, out.parts[1]);
    out.parts.push_back(std::move(part));
  }
  return out;
}

}  // namespace cusp::test
