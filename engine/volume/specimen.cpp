#include "engine/volume/specimen.h"

#include <array>

#include "engine/volume/hash.h"

namespace cusp {

std::shared_ptr<const Specimen> Specimen::build(const VoxelVolume& dense, Reading reading) {
  auto specimen = std::make_shared<Specimen>();
  Specimen& out = *specimen;
  out.grid_ = dense.grid;
  out.reading_ = reading;
  out.names_ = dense.names;
  out.bricks_ = (dense.grid.size + 7) / 8;
  out.table_.resize(static_cast<std::size_t>(out.bricks_.x) * static_cast<std::size_t>(out.bricks_.y) *
                    static_cast<std::size_t>(out.bricks_.z));

  std::array<std::uint16_t, kBrickVoxels> s{};
  std::array<Tissue, kBrickVoxels> tissue{};
  Hash64 hash;
  for (int i = 0; i < 3; ++i) hash.add(static_cast<std::uint64_t>(dense.grid.size[i]));
  hash.add_double(dense.grid.voxel_mm);
  for (int i = 0; i < 3; ++i) hash.add_double(dense.grid.origin_mm[i]);
  hash.add(static_cast<std::uint64_t>(reading));

  for (int b = 0; b < static_cast<int>(out.table_.size()); ++b) {
    const IVec3 corner = out.brick_at(b) * kBrickEdge;
    for (int z = 0; z < 8; ++z)
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
          const auto at = static_cast<std::size_t>(brick_offset(x, y, z));
          const IVec3 v = corner + IVec3(x, y, z);
          std::uint16_t value = 0;
          Tissue t = Tissue::empty;
          if (dense.grid.contains(v)) {
            const std::size_t i = dense.grid.index(v);
            value = dense.s[i];
            if (reading == Reading::filled) value = value >= kHalf ? kSolid : std::uint16_t{0};
            t = value == 0 ? Tissue::empty : dense.tissue[i];
            if (t == Tissue::empty) value = 0;
          }
          s[at] = value;
          tissue[at] = t;
        }
    bool uniform = s[0] == 0 || s[0] == kSolid;
    for (std::size_t i = 1; uniform && i < s.size(); ++i) uniform = s[i] == s[0] && tissue[i] == tissue[0];
    Entry& entry = out.table_[static_cast<std::size_t>(b)];
    if (uniform) {
      entry = {-1, s[0], tissue[0]};
      if (s[0] != 0) {
        hash.add(static_cast<std::uint64_t>(b));
        hash.add(0x10000u | static_cast<std::uint64_t>(tissue[0]));
      }
    } else {
      entry.slot = static_cast<std::int32_t>(out.s_.size() / kBrickVoxels);
      out.s_.insert(out.s_.end(), s.begin(), s.end());
      out.tissue_.insert(out.tissue_.end(), tissue.begin(), tissue.end());
      hash.add(static_cast<std::uint64_t>(b));
      hash.add_u16(s);
      for (std::size_t i = 0; i < tissue.size(); i += 8) {
        std::uint64_t word = 0;
        for (std::size_t j = 0; j < 8; ++j) word |= static_cast<std::uint64_t>(tissue[i + j]) << (8 * j);
        hash.add(word);
      }
    }
  }
  out.s_.shrink_to_fit();
  out.tissue_.shrink_to_fit();
  out.hash_ = hash.value();
  if (reading == Reading::banded) out.surface_ = BaseSurface::of(out);
  return specimen;
}

std::size_t Specimen::bytes() const noexcept {
  return table_.size() * sizeof(Entry) + s_.size() * sizeof(std::uint16_t) + tissue_.size() * sizeof(Tissue) +
         surface_.bytes();
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

}  // namespace cusp
