// Burs, directions and combinations of the removal runs.
#include <fmt/core.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "scenarios/burs/bur_catalogue.h"
#include "tests/bench/frame.h"
#include "tests/bench/removal.h"
#include "tests/bench/removal_pairs.h"
#include "tests/modules.h"

namespace cusp::bench {

namespace {

const std::vector<double> kVoxelsMm = {0.04, kPaperVoxelMm, 0.1, 0.2};
const std::vector<double> kTicksMs = {0.25, 1.0, 4.0};
const std::vector<double> kAlphas = {0.1, 0.25, 0.5, 1.0};
constexpr double kFullVoxelMm = 0.1, kFullBurMm = 1.0;

}  // namespace

DrillRun run_in(Method method, const Cutter& cutter, double voxel_mm, const RemovalTissue& material, double alpha) {
  DrillRun run;
  run.method = method;
  run.cutter = cutter;
  run.voxel_mm = voxel_mm;
  run.alpha = alpha;
  run.tissue = [tissue = material.tissue](Vec3) { return tissue; };
  for (const RemovalTissue& m : kRemovalMaterials) run.speed_mm_s[index_of(m.tissue)] = m.speed_mm_s;
  run.target_mm_s = alpha * material.speed_mm_s;
  return run;
}

const std::vector<Direction>& directions() {
  static const std::vector<Direction> all = [] {
    std::vector<Direction> out;
    for (int i = 0; i < 27; ++i) {
      const IVec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
      if (i == 13) continue;
      Direction one;
      one.axes = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
      for (int a = 0; a < 3; ++a)
        if (d[a] != 0) one.name += std::string(d[a] > 0 ? "+" : "-") + "xyz"[a];
      one.unit = unit(Vec3(d));
      out.push_back(std::move(one));
    }
    return out;
  }();
  return all;
}

std::vector<std::string> direction_names() {
  std::vector<std::string> out;
  for (const Direction& d : directions()) out.push_back(d.name);
  return out;
}

std::vector<Cutter> removal_cutters() {
  return {round_cutter(0.5), round_cutter(1.0), round_cutter(kLargestBurMm), fissure_cutter(1.0, Feed::tip_first),
          fissure_cutter(1.0, Feed::sideways)};
}

std::vector<Cutter> ridge_cutters() {
  std::set<double> diameters;
  for (const CatalogueBur& entry : bur_catalogue())
    if (entry.bur.head.ball()) diameters.insert(2.0 * entry.bur.radius_mm);
  std::vector<Cutter> out;
  for (const double diameter : diameters) out.push_back(round_cutter(diameter));
  return out;
}

std::vector<Cutter> shape_cutters(BurSet burs) {
  const bool every = burs == BurSet::whole_catalogue;
  std::vector<Cutter> out;
  if (!every)
    for (const Cutter& cutter : removal_cutters())
      if (cutter.bur.head.ball()) out.push_back(cutter);
  std::map<std::string_view, std::vector<const CatalogueBur*>> by_shape;
  for (const CatalogueBur& entry : bur_catalogue())
    if (every || !entry.bur.head.ball()) by_shape[entry.shape].push_back(&entry);
  for (const auto& [shape, entries] : by_shape)
    for (std::size_t i = every ? 0 : entries.size() / 2; i < entries.size(); ++i) {
      Bur bur = entries[i]->bur;
      // A thin neck does not touch the mouth when a ball leans.
      if (bur.head.ball()) bur.neck_radius_mm = bur.shank_radius_mm = kThinNeckMm;
      out.push_back({fmt::format("{} {} {:.1f}", bur.name, shape, 2.0 * bur.radius_mm), bur});
      if (!every) break;
    }
  return out;
}

std::vector<DrillRun> speed_runs(const Options& options, Method method) {
  const std::vector<double> voxels = chosen(options.voxels_mm, options.full ? std::vector{kFullVoxelMm} : kVoxelsMm);
  const std::vector<double> ticks = chosen(options.ticks_ms, kTicksMs), alphas = chosen(options.alphas, kAlphas);
  std::vector<Cutter> cutters = options.full ? std::vector{round_cutter(kFullBurMm)} : removal_cutters();
  // The paper's method has ball burs only.
  if (reading_of(method) == Reading::filled) std::erase_if(cutters, [](const Cutter& c) { return !c.bur.head.ball(); });
  if (!options.bur_radii_mm.empty()) {
    cutters.clear();
    for (const double radius : options.bur_radii_mm) cutters.push_back(round_cutter(2.0 * radius));
  }
  std::vector<Direction> ways;
  for (const Direction& d : directions())
    if (asked(options.directions, d.name)) ways.push_back(d);
  std::vector<RemovalTissue> materials;
  for (std::size_t i = 0; i < kRemovalMaterials.size(); ++i)
    if (asked(options.tissues, kRemovalTissues[i])) materials.push_back(kRemovalMaterials[i]);

  const std::vector<int> levels = {static_cast<int>(ways.size()),  static_cast<int>(voxels.size()),
                                   static_cast<int>(ticks.size()), static_cast<int>(materials.size()),
                                   static_cast<int>(alphas.size()), static_cast<int>(cutters.size())};
  std::vector<std::vector<int>> choices;
  if (options.full) {
    std::vector<int> at(levels.size(), 0);
    for (bool more = true; more;) {
      choices.push_back(at);
      std::size_t f = 0;
      while (f < at.size() && ++at[f] == levels[f]) at[f++] = 0;
      more = f < at.size();
    }
  } else {
    choices = all_pairs(levels);
  }
  std::vector<DrillRun> runs;
  for (const std::vector<int>& c : choices) {
    const auto pick = [&c](std::size_t f) { return static_cast<std::size_t>(c[f]); };
    DrillRun run = run_in(method, cutters[pick(5)], voxels[pick(1)], materials[pick(3)], alphas[pick(4)]);
    run.tick_ms = ticks[pick(2)];
    run.direction = ways[pick(0)].unit;
    runs.push_back(std::move(run));
  }
  return runs;
}

}  // namespace cusp::bench
