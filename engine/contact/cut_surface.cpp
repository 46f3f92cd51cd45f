#include "engine/contact/cut_surface.h"

#include <algorithm>

#include "engine/volume/cell_field.h"

namespace cusp {

namespace {
/// Crossing cells kept at once: a cavity of 60 mm2 at 0.04 mm voxels has about 60,000.
constexpr std::size_t kPool = 120000;
/// The cut's surface passes between the eight corners.
bool crossed(const Volume& volume, int brick, int offset) noexcept {
  const std::uint16_t* values = volume.cut_of(brick);
  const bool first = values[offset] >= kHalf;
  if ((offset & 7) != 7 && (offset >> 3 & 7) != 7 && offset >> 6 != 7) {
    for (int i = 1; i < 8; ++i)
      if ((values[offset + (i & 1) + (i >> 1 & 1) * 8 + (i >> 2) * 64] >= kHalf) != first) return true;
    return false;
  }
  const IVec3 cell =
      volume.specimen().brick_at(brick) * kBrickEdge + IVec3(offset & 7, offset >> 3 & 7, offset >> 6);
  for (int i = 1; i < 8; ++i)
    if ((volume.cut(cell + IVec3(i & 1, i >> 1 & 1, i >> 2)) >= kHalf) != first) return true;
  return false;
}

}  // namespace

CutSurface::CutSurface(const Volume& volume)
    : entry_(volume.cut_capacity() * kBrickVoxels, kStale | kNoEntry),
      pool_(std::min(kPool, volume.cut_capacity() * kBrickVoxels)) {}

void CutSurface::forget() noexcept {
  std::fill(entry_.begin(), entry_.end(), kStale | kNoEntry);
  used_ = 0;
}

void CutSurface::changed(const Volume& volume, IVec3 low, IVec3 high) noexcept {
  const Specimen& specimen = volume.specimen();
  low -= 2;
  high += 1;
  for (int bz = low.z >> 3; bz <= high.z >> 3; ++bz)
    for (int by = low.y >> 3; by <= high.y >> 3; ++by)
      for (int bx = low.x >> 3; bx <= high.x >> 3; ++bx) {
        const int brick = specimen.brick_index({bx, by, bz});
        if (brick < 0 || volume.cut_slot(brick) < 0) continue;
        std::uint32_t* entry = &entry_[static_cast<std::size_t>(volume.cut_slot(brick)) * kBrickVoxels];
        const IVec3 corner = IVec3(bx, by, bz) * kBrickEdge;
        const IVec3 a = glm::max(low - corner, IVec3(0));
        const IVec3 b = glm::min(high - corner, IVec3(7));
        for (int z = a.z; z <= b.z; ++z)
          for (int y = a.y; y <= b.y; ++y)
            for (int x = a.x; x <= b.x; ++x) entry[brick_offset(x, y, z)] |= kStale;
      }
}

const CutFeature* CutSurface::at(const Volume& volume, int brick, int offset) noexcept {
  const std::size_t i =
      static_cast<std::size_t>(volume.cut_slot(brick)) * kBrickVoxels + static_cast<std::size_t>(offset);
  std::uint32_t& entry = entry_[i];
  if (entry & kStale) {
    CutFeature fresh;
    if (crossed(volume, brick, offset))
      fresh = compute(volume, volume.specimen().brick_at(brick) * kBrickEdge +
                                  IVec3(offset & 7, offset >> 3 & 7, offset >> 6));
    std::uint32_t place = entry & ~kStale;
    if (place == kNoEntry) {
      if (!fresh.has_point && !fresh.has_edge) {
        entry = kNoEntry;
        return nullptr;
      }
      if (used_ == pool_.size()) {  // no room to keep it: answered all the same, and asked again next time
        scratch_at_ ^= 1;
        scratch_[scratch_at_] = fresh;
        return &scratch_[scratch_at_];
      }
      place = used_++;
    }
    pool_[place] = fresh;
    entry = place;
  }
  if (entry == kNoEntry) return nullptr;
  const CutFeature& f = pool_[entry];
  return f.has_point || f.has_edge ? &f : nullptr;
}

CutFeature CutSurface::compute(const Volume& volume, IVec3 cell) noexcept {
  CutFeature out;
  CellField cut;
  cut.load(volume, Field::cut, cell);
  // Deep in the specimen its own surface is further than 2.5 voxels: nothing of it to keep.
  bool deep = true;
  for (int i = 0; i < 8 && deep; ++i)
    deep = volume.specimen().s(cell + IVec3(i & 1, i >> 1 & 1, i >> 2)) == kSolid;
  CellField base;
  if (!deep) base.load(volume, Field::base, cell);
  const double voxel = volume.grid().voxel_mm;
  // The cut's distance is positive in the void: its gradient points into the void, as a normal should.
  Vec3 f, n;
  if (cell_point(cut, f, n)) {
    Vec3 g(0.0);
    const double other = deep ? -kBandVoxels : base.eval(f, g);
    if (other <= 0.0) {
      out.has_point = true;
      out.point = Vec3f(f);
      out.normal = Vec3f(n);
      const double length = std::sqrt(glm::dot(g, g));
      if (other > -2.5 && length > 0.25) {
        out.near_other = true;
        out.other_d_mm = static_cast<float>(other * voxel / length);
        out.other_normal = Vec3f(g / length);
      }
    }
    const Vec3 under = Vec3(cell) + f - 0.5 * n;
    const IVec3 v(static_cast<int>(std::floor(under.x + 0.5)), static_cast<int>(std::floor(under.y + 0.5)),
                  static_cast<int>(std::floor(under.z + 0.5)));
    out.tissue = volume.tissue(v);
    if (out.tissue == Tissue::empty) {
      for (int i = 0; i < 8 && out.tissue == Tissue::empty; ++i)
        out.tissue = volume.tissue(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
    }
  }
  if (!deep && base.crossed()) {
    Vec3 e(0.5), gb(0.0), gc(0.0);
    bool good = true;
    for (int pass = 0; pass < 5 && good; ++pass) {
      const double db = base.eval(e, gb);
      const double dc = cut.eval(e, gc);
      const double bb = glm::dot(gb, gb), cc = glm::dot(gc, gc), bc = glm::dot(gb, gc);
      const double det = bb * cc - bc * bc;
      if (!(det > 1e-3)) {
        good = false;
        break;
      }
      e -= gb * ((db * cc - dc * bc) / det) + gc * ((dc * bb - db * bc) / det);
      for (int a = 0; a < 3; ++a) good = good && e[a] > -0.1 && e[a] < 1.1;
    }
    if (good) {
      const Vec3 t = glm::cross(gb, gc);
      const double length = std::sqrt(glm::dot(t, t));
      if (length > 1e-3) {
        out.has_edge = true;
        out.edge = Vec3f(e);
        out.tangent = Vec3f(t / length);
        if (out.tissue == Tissue::empty) {
          for (int i = 0; i < 8 && out.tissue == Tissue::empty; ++i)
            out.tissue = volume.tissue(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
        }
      }
    }
  }
  return out;
}

}  // namespace cusp
