#include "scenarios/audit/model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/volume/specimen.h"
#include "scenarios/format/keys.h"
#include "scenarios/shapes/target.h"

namespace cusp::scenarios {
namespace {

void drop(std::vector<std::string>& keys, std::string_view key) { std::erase(keys, std::string(key)); }

/// The tissue that each left-out tissue becomes: the one that most of its faces touch. A tissue that touches no other
/// stays.
std::array<Tissue, kTissueCodes> heirs(const VoxelVolume& v, const std::vector<Tissue>& left_out) {
  std::array<Tissue, kTissueCodes> heir;
  for (std::size_t t = 0; t < kTissueCodes; ++t) heir[t] = static_cast<Tissue>(t);
  std::array<bool, kTissueCodes> leaves{};
  for (const Tissue t : left_out) leaves[index_of(t)] = true;
  std::array<std::array<std::uint64_t, kTissueCodes>, kTissueCodes> faces{};
  const IVec3 n = v.grid.size;
  const std::size_t row = static_cast<std::size_t>(n.x), slice = row * static_cast<std::size_t>(n.y);
  const auto meet = [&](std::size_t a, std::size_t b) {
    if (v.s[a] < kHalf || v.s[b] < kHalf || v.tissue[a] == v.tissue[b]) return;
    ++faces[index_of(v.tissue[a])][index_of(v.tissue[b])];
    ++faces[index_of(v.tissue[b])][index_of(v.tissue[a])];
  };
  std::size_t at = 0;
  for (int z = 0; z < n.z; ++z) {
    for (int y = 0; y < n.y; ++y) {
      for (int x = 0; x < n.x; ++x, ++at) {
        if (x + 1 < n.x) meet(at, at + 1);
        if (y + 1 < n.y) meet(at, at + row);
        if (z + 1 < n.z) meet(at, at + slice);
      }
    }
  }
  for (const Tissue t : left_out) {
    std::uint64_t most = 0;
    for (std::size_t other = 1; other < kTissueCodes; ++other) {
      if (!leaves[other] && faces[index_of(t)][other] > most) {
        most = faces[index_of(t)][other];
        heir[index_of(t)] = static_cast<Tissue>(other);
      }
    }
  }
  return heir;
}

VoxelVolume cropped(const VoxelVolume& v, const Scenario& scenario) {
  // A lesion's or a tissue's shape is of these voxels.
  const bool of_voxels = needs_voxels(scenario.target);
  const TargetShape shape(scenario.target, of_voxels ? Specimen::build(v, reading_of(scenario.method)) : nullptr);
  if (shape.empty()) return v;
  double radius = 0;
  for (const Bur& bur : scenario.instruments) radius = std::max(radius, bur.radius_mm);
  const double side = scenario.leeway.most() + radius + kReachMm;
  const double down = scenario.leeway.most() + radius + kReachMm;
  const Vec3 low(shape.low().x - side, shape.low().y - side, shape.floor_mm() - down);
  const Vec3 high(shape.high().x + side, shape.high().y + side, v.grid.centre_mm(v.grid.size).z);
  IVec3 from, to;  // `to` is the first beyond
  for (int i = 0; i < 3; ++i) {
    from[i] = std::clamp(static_cast<int>(std::floor((low[i] - v.grid.origin_mm[i]) / v.grid.voxel_mm)), 0, v.grid.size[i] - 1);
    to[i] = std::clamp(static_cast<int>(std::ceil((high[i] - v.grid.origin_mm[i]) / v.grid.voxel_mm)) + 1, from[i] + 1,
                       v.grid.size[i]);
  }
  Grid grid = v.grid;
  grid.origin_mm = v.grid.centre_mm(from);
  grid.size = to - from;
  VoxelVolume out(grid);
  out.names = v.names;
  std::size_t at = 0;
  for (int z = from.z; z < to.z; ++z) {
    for (int y = from.y; y < to.y; ++y) {
      const std::size_t begin = v.grid.index({from.x, y, z});
      for (int x = 0; x < grid.size.x; ++x, ++at) {
        out.s[at] = v.s[begin + static_cast<std::size_t>(x)];
        out.tissue[at] = v.tissue[begin + static_cast<std::size_t>(x)];
      }
    }
  }
  return out;
}

}  // namespace

std::string_view key_of(Aspect aspect) noexcept {
  switch (aspect) {
    case Aspect::voxel: return "voxel";
    case Aspect::band: return "band";
    case Aspect::region: return "region";
    case Aspect::around: return "around";
    case Aspect::tissue: return "tissue";
    case Aspect::friction: return "friction";
    case Aspect::spindle: return "spindle";
    case Aspect::vibration: return "vibration";
    case Aspect::heat: return "heat";
    case Aspect::tilt: return "tilt";
  }
  return "voxel";
}

Model with(Model model, const Choice& choice) {
  Scenario& s = model.scenario;
  switch (choice.aspect) {
    case Aspect::voxel: s.specimen.voxel_mm = choice.instead; break;
    case Aspect::band: model.band_voxels = choice.instead; break;
    case Aspect::region: model.near_target_only = true; break;
    case Aspect::around: drop(s.specimen.around, choice.subject); break;
    case Aspect::tissue:
      if (const auto tissue = scenario_tissue_from_key(choice.subject)) model.left_out.push_back(*tissue);
      break;
    case Aspect::friction: drop(s.phenomena, "friction"); break;
    case Aspect::spindle:
      for (const std::string_view key : {std::string_view(choice.subject), std::string_view("vibration"), std::string_view("sound")})
        drop(s.phenomena, key);
      break;
    case Aspect::vibration: drop(s.phenomena, "vibration"); break;
    case Aspect::heat: drop(s.phenomena, "heat"); break;
    case Aspect::tilt: s.tool_turn_deg = choice.instead; break;
  }
  return model;
}

VoxelVolume prepared(VoxelVolume volume, const Model& model) {
  if (!model.left_out.empty()) {
    const auto heir = heirs(volume, model.left_out);
    for (Tissue& t : volume.tissue) t = heir[index_of(t)];
  }
  if (model.band_voxels < kBandVoxels) {
    const std::uint16_t in = solid_from_distance(-model.band_voxels), out = solid_from_distance(model.band_voxels);
    for (std::size_t i = 0; i < volume.s.size(); ++i) {
      if (volume.s[i] >= in) volume.s[i] = kSolid;
      if (volume.s[i] <= out) {
        volume.s[i] = 0;
        volume.tissue[i] = Tissue::empty;
      }
    }
  }
  if (model.near_target_only) volume = cropped(volume, model.scenario);
  return volume;
}

}  // namespace cusp::scenarios
