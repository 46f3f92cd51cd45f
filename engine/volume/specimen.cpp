#include "engine/volume/specimen.h"

#include <algorithm>
#include <cmath>

#include "engine/volume/hash.h"

namespace cusp::engine {

namespace {

/// Normalises a brick: s = 0 outside the grid, tissue exactly where s > 0, s of a filled reading 0 or 1.
void normalise(BrickVoxels& voxels, const Grid& grid, IVec3 corner, Reading reading) {
  const IVec3 end = grid.size - corner;
  const bool inside = end.x >= kBrickEdge && end.y >= kBrickEdge && end.z >= kBrickEdge;
  for (int o = 0; o < kBrickVoxels; ++o) {
    const auto at = static_cast<std::size_t>(o);
    std::uint16_t& s = voxels.s[at];
    Tissue& t = voxels.tissue[at];
    if (!inside && ((o & 7) >= end.x || (o >> 3 & 7) >= end.y || o >> 6 >= end.z)) s = 0;
    if (reading == Reading::filled) s = s >= kHalf ? kSolid : std::uint16_t{0};
    if (s == 0) t = Tissue::empty;
    if (t == Tissue::empty) s = 0;
  }
}

bool all_alike(const BrickVoxels& voxels) {
  const auto& [s, tissue] = voxels;
  if (s[0] != 0 && s[0] != kSolid) return false;
  return std::all_of(s.begin(), s.end(), [&s](std::uint16_t v) { return v == s[0]; }) &&
         std::all_of(tissue.begin(), tissue.end(), [&tissue](Tissue t) { return t == tissue[0]; });
}

/// The tissue of a brick with one tissue; empty for a brick with several.
Tissue only_tissue_of(const BrickVoxels& voxels) {
  Tissue only = Tissue::empty;
  for (const Tissue t : voxels.tissue) {
    if (t == Tissue::empty || t == only) continue;
    if (only != Tissue::empty) return Tissue::empty;
    only = t;
  }
  return only;
}

/// True if an outermost voxel of the volume holds tissue.
bool reaches_edge(const VoxelVolume& dense) {
  const IVec3 n = dense.grid.size;
  IVec3 v;
  for (v.z = 0; v.z < n.z; ++v.z)
    for (v.y = 0; v.y < n.y; ++v.y) {
      const bool face = v.z == 0 || v.z == n.z - 1 || v.y == 0 || v.y == n.y - 1;
      for (v.x = 0; v.x < n.x; v.x += face ? 1 : std::max(n.x - 1, 1))
        if (dense.s[dense.grid.index(v)] > 0) return true;
    }
  return false;
}

/// The volume padded by kRoomVoxels. s is of the larger of two distances: to the tissue and to the volume's own box.
VoxelVolume with_room(const VoxelVolume& dense) {
  const IVec3 n = dense.grid.size;
  Grid grid = dense.grid;
  grid.size += 2 * Specimen::kRoomVoxels;
  grid.origin_mm -= Vec3(Specimen::kRoomVoxels * grid.voxel_mm);
  VoxelVolume out(grid);
  out.names = dense.names;
  IVec3 v;
  for (v.z = 0; v.z < grid.size.z; ++v.z)
    for (v.y = 0; v.y < grid.size.y; ++v.y)
      for (v.x = 0; v.x < grid.size.x; ++v.x) {
        const IVec3 at = v - Specimen::kRoomVoxels;
        const std::size_t from = dense.grid.index(glm::clamp(at, IVec3(0), n - 1));
        if (dense.s[from] == 0) continue;
        const Vec3 beyond = glm::abs(Vec3(at) - 0.5 * Vec3(n - 1)) - 0.5 * Vec3(n);
        const Vec3 outside = glm::max(beyond, Vec3(0.0));
        const double box = std::sqrt(glm::dot(outside, outside)) + std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0);
        const std::size_t i = grid.index(v);
        out.s[i] = box <= -kBandVoxels ? dense.s[from] : solid_from_distance(std::max(distance_from_solid(dense.s[from]), box));
        if (out.s[i] > 0) out.tissue[i] = dense.tissue[from];
      }
  return out;
}

/// The tissue of a uniform brick, or nothing: then its 512 voxels stand in `voxels`, normalised.
std::optional<Tissue> read_brick(const BrickSource& source, const Grid& grid, Reading reading, IVec3 brick,
                                 BrickVoxels& voxels) {
  const IVec3 corner = brick * kBrickEdge;
  const IVec3 end = grid.size - corner;
  std::optional<Tissue> uniform = source(brick, voxels);
  if (uniform && *uniform != Tissue::empty && (end.x < kBrickEdge || end.y < kBrickEdge || end.z < kBrickEdge)) {
    voxels.s.fill(kSolid);  // solid as far as the grid goes
    voxels.tissue.fill(*uniform);
    uniform.reset();
  }
  if (!uniform) {
    normalise(voxels, grid, corner, reading);
    if (all_alike(voxels)) uniform = voxels.tissue[0];
  }
  return uniform;
}

void hash_grid(const Grid& grid, Reading reading, Hash64& hash) {
  for (int i = 0; i < 3; ++i) hash.add(static_cast<std::uint64_t>(grid.size[i]));
  hash.add_double(grid.voxel_mm);
  for (int i = 0; i < 3; ++i) hash.add_double(grid.origin_mm[i]);
  hash.add(static_cast<std::uint64_t>(reading));
}

void hash_uniform(int brick, Tissue tissue, Hash64& hash) {
  if (tissue == Tissue::empty) return;
  hash.add(static_cast<std::uint64_t>(brick));
  hash.add(0x10000u | static_cast<std::uint64_t>(tissue));
}

void hash_voxels(int brick, const BrickVoxels& voxels, Hash64& hash) {
  hash.add(static_cast<std::uint64_t>(brick));
  hash.add_u16(voxels.s);
  for (std::size_t i = 0; i < voxels.tissue.size(); i += 8) {
    std::uint64_t word = 0;
    for (std::size_t j = 0; j < 8; ++j) word |= static_cast<std::uint64_t>(voxels.tissue[i + j]) << (8 * j);
    hash.add(word);
  }
}

}  // namespace

std::int32_t Specimen::append(const BrickVoxels& voxels) {
  const auto place = static_cast<std::int32_t>(tissues_.size());
  s_.insert(s_.end(), voxels.s.begin(), voxels.s.end());
  Tissues& tissues = tissues_.emplace_back();
  tissues.only = only_tissue_of(voxels);
  if (tissues.only == Tissue::empty) {
    tissues.mixed = static_cast<std::int32_t>(tissue_.size() / kBrickVoxels);
    tissue_.insert(tissue_.end(), voxels.tissue.begin(), voxels.tissue.end());
  }
  return place;
}

std::shared_ptr<const Specimen> Specimen::build(const Grid& grid, Reading reading, const BrickSource& source,
                                                std::map<std::uint8_t, std::string> names) {
  auto specimen = std::make_shared<Specimen>();
  Specimen& out = *specimen;
  out.grid_ = grid;
  out.reading_ = reading;
  out.names_ = std::move(names);
  out.bricks_ = (grid.size + 7) / 8;
  out.place_.resize(static_cast<std::size_t>(out.bricks_.x) * static_cast<std::size_t>(out.bricks_.y) *
                    static_cast<std::size_t>(out.bricks_.z));
  Hash64 hash;
  hash_grid(grid, reading, hash);
  BrickVoxels voxels;
  for (int b = 0; b < static_cast<int>(out.place_.size()); ++b) {
    std::int32_t& place = out.place_[static_cast<std::size_t>(b)];
    if (const std::optional<Tissue> uniform = read_brick(source, grid, reading, out.brick_at(b), voxels)) {
      place = place_of(*uniform);
      hash_uniform(b, *uniform, hash);
    } else {
      place = out.append(voxels);
      hash_voxels(b, voxels, hash);
    }
  }
  out.s_.shrink_to_fit();
  out.tissues_.shrink_to_fit();
  out.tissue_.shrink_to_fit();
  out.hash_ = hash.value();
  if (reading == Reading::banded) out.surface_ = BaseSurface::of(out);
  return specimen;
}

std::shared_ptr<const Specimen> Specimen::build(const VoxelVolume& dense, Reading reading) {
  if (reading == Reading::banded && reaches_edge(dense)) return build(with_room(dense), reading);
  const Grid& grid = dense.grid;
  const auto brick_of = [&dense, &grid](IVec3 brick, BrickVoxels& voxels) -> std::optional<Tissue> {
    const IVec3 corner = brick * kBrickEdge;
    const IVec3 end = glm::min(grid.size - corner, IVec3(kBrickEdge));
    for (int z = 0; z < end.z; ++z)
      for (int y = 0; y < end.y; ++y) {
        const std::size_t from = grid.index(corner + IVec3(0, y, z));
        const auto to = static_cast<std::size_t>(brick_offset(0, y, z));
        const auto count = static_cast<std::size_t>(end.x);
        std::copy_n(&dense.s[from], count, &voxels.s[to]);
        std::copy_n(&dense.tissue[from], count, &voxels.tissue[to]);
      }
    return std::nullopt;
  };
  return build(grid, reading, brick_of, dense.names);
}

std::size_t Specimen::bytes() const noexcept {
  return place_.size() * sizeof(std::int32_t) + s_.size() * sizeof(std::uint16_t) + tissues_.size() * sizeof(Tissues) +
         tissue_.size() * sizeof(Tissue) + surface_.bytes();
}

VoxelVolume Specimen::dense() const {
  VoxelVolume out(grid_);
  out.names = names_;
  IVec3 v;
  for (v.z = 0; v.z < grid_.size.z; ++v.z)
    for (v.y = 0; v.y < grid_.size.y; ++v.y)
      for (v.x = 0; v.x < grid_.size.x; ++v.x) {
        const std::size_t i = grid_.index(v);
        out.s[i] = s(v);
        out.tissue[i] = tissue(v);
      }
  return out;
}

}  // namespace cusp::engine
