#include "engine/contact/cut_surface.h"

#include <algorithm>
#include <bit>

#include "engine/volume/sharp_edge.h"

namespace cusp {

namespace {
/// Features kept at once: a cavity of 60 mm2 at 0.04 mm voxels has about 60,000, and pages are two thirds full.
constexpr std::size_t kPages = 12000;
/// A cell has a few points and edges at most, and those with more than one are few.
constexpr std::size_t kMostFeatures = 4 * static_cast<std::size_t>(kBrickVoxels);
/// Two cuts make the larger of two distances, without rounding: what differs more is no ridge of two.
constexpr double kMostOff = 0.3;
/// Voxels: another surface this far from a point does not end its plane, which is believed 0.8 beside it.
constexpr double kBeside = 1.6;
const std::uint16_t kDeep = solid_from_distance(-kBeside);
/// s of the specimen so far out that none of it is in a cell whose corners all are: half a voxel.
const std::uint16_t kAir = solid_from_distance(0.5);
/// Voxels: a scratch up to this deep holds a cutting burr though no cell of the cut has it.
constexpr double kShallow = 0.15;
/// s beyond which no surface crosses the cells that touch the voxel (1.8 voxels).
constexpr std::uint16_t kLeast = 11000, kMost = 54500;
}  // namespace

void base_feature(const BaseSurface& surface, const BasePoints& points, int i, double voxel_mm,
                  CutFeature& out) noexcept {
  const BaseNormal& normal = points.normal[i];
  out.normal = normal.unit();
  out.field = Field::base;
  out.tissue = points.tissue[i];
  out.cell = static_cast<std::uint16_t>(normal.cell());
  out.edge = normal.edge();
  if (!normal.edge() && !normal.beside_edge()) return;
  const BaseSurface::Sharp& sharp = surface.sharp(points, i);
  out.other_normal = sharp.vector;
  if (normal.edge()) {
    out.other_normal /= static_cast<float>(voxel_mm);
    out.third_d_mm = static_cast<float>(StrokeCells::kHalfEdge * voxel_mm);
    out.other_d_mm = -out.third_d_mm;
  } else {
    out.others = 1;
    out.other_d_mm = static_cast<float>(sharp.other_d * voxel_mm);
  }
}

namespace {
/// Another surface ends the plane of a point: of more than two, the nearest two.
void add_beside(CutFeature& point, double d_mm, Vec3f normal) noexcept {
  const auto d = static_cast<float>(d_mm);
  if (point.others == 0 || (point.others == 2 && point.other_d_mm <= point.third_d_mm && d > point.other_d_mm)) {
    point.other_d_mm = d;
    point.other_normal = normal;
    point.others = point.others == 0 ? 1 : 2;
  } else if (point.others == 1 || d > point.third_d_mm) {
    point.third_d_mm = d;
    point.third_normal = normal;
    point.others = 2;
  }
}

/// The tissue at a place of a cell (voxels), else of one of its corners.
Tissue tissue_under(const Volume& volume, IVec3 cell, Vec3 place) noexcept {
  Tissue tissue = volume.tissue(cell_of_voxels(Vec3(cell) + place + 0.5));
  for (int i = 0; i < 8 && tissue == Tissue::empty; ++i)
    tissue = volume.tissue(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
  return tissue;
}
}  // namespace

CutSurface::CutSurface(const Volume& volume, const CutMemory* strokes)
    : slots_(volume.cut_capacity()),
      made_(kMostFeatures),
      merged_(kMostFeatures),
      strokes_(strokes),
      kept_pages_(std::min(kPages, volume.cut_capacity() * 8)) {
  pages_.resize(kept_pages_ + kMostFeatures / kPage);
  free_.reserve(kept_pages_);
  forget();
}

void CutSurface::forget() noexcept {
  for (Slot& slot : slots_) {
    for (std::uint64_t& word : slot.stale) word = ~std::uint64_t{0};
    for (std::uint64_t& word : slot.creased) word = 0;
    slot.first = -1;
  }
  free_.clear();
  for (std::size_t i = kept_pages_; i-- > 0;) free_.push_back(static_cast<std::int32_t>(i));
}

void CutSurface::changed(const Volume& volume, IVec3 low, IVec3 high) noexcept {
  const Specimen& specimen = volume.specimen();
  // A cell reads the voxels one below to two above its own; a creased one those of the cells two away, too.
  const IVec3 near_low = low - 2, near_high = high + 1;
  const IVec3 far_low = low - 4, far_high = high + 3;
  const auto slices = [](IVec3 a, IVec3 b) {
    std::uint64_t row = 0;
    for (int x = a.x; x <= b.x; ++x) row |= std::uint64_t{1} << x;
    std::uint64_t slice = 0;
    for (int y = a.y; y <= b.y; ++y) slice |= row << (8 * y);
    return slice;
  };
  for (int bz = far_low.z >> 3; bz <= far_high.z >> 3; ++bz)
    for (int by = far_low.y >> 3; by <= far_high.y >> 3; ++by)
      for (int bx = far_low.x >> 3; bx <= far_high.x >> 3; ++bx) {
        const int brick = specimen.brick_index({bx, by, bz});
        if (brick < 0 || volume.cut_slot(brick) < 0) continue;
        Slot& slot = slots_[static_cast<std::size_t>(volume.cut_slot(brick))];
        const IVec3 corner = IVec3(bx, by, bz) * kBrickEdge;
        IVec3 a = glm::max(far_low - corner, IVec3(0)), b = glm::min(far_high - corner, IVec3(7));
        std::uint64_t slice = slices(a, b);
        for (int z = a.z; z <= b.z; ++z) slot.stale[z] |= slice & slot.creased[z];
        a = glm::max(near_low - corner, IVec3(0));
        b = glm::min(near_high - corner, IVec3(7));
        slice = slices(a, b);
        for (int z = a.z; z <= b.z; ++z) slot.stale[z] |= slice;
      }
}

void CutSurface::sharpen(const Volume& volume, bool on) noexcept {
  if (on == sharp_) return;
  sharp_ = on;
  for (std::size_t i = 0; i < volume.cut_bricks().size(); ++i)
    for (int z = 0; z < 8; ++z) slots_[i].stale[z] |= slots_[i].creased[z];
}

std::int32_t CutSurface::first(const Volume& volume, int brick) noexcept {
  Slot& slot = slots_[static_cast<std::size_t>(volume.cut_slot(brick))];
  std::uint64_t any = 0;
  for (const std::uint64_t word : slot.stale) any |= word;
  if (any != 0) refresh(volume, brick, slot);
  return slot.first;
}

void CutSurface::decode(const Volume& volume, IVec3 brick) noexcept {
  const Specimen& specimen = volume.specimen();
  const auto values_of = [&](IVec3 at) {
    const int b = specimen.brick_index(at);
    return b < 0 ? nullptr : volume.cut_of(b);
  };
  for (int nz = -1; nz <= 1; ++nz)
    for (int ny = -1; ny <= 1; ++ny)
      for (int nx = -1; nx <= 1; ++nx) {
        const std::uint16_t* values = values_of(brick + IVec3(nx, ny, nz));
        const IVec3 from(nx < 0 ? 7 : 0, ny < 0 ? 7 : 0, nz < 0 ? 7 : 0);
        const IVec3 to(nx > 0 ? 1 : 7, ny > 0 ? 1 : 7, nz > 0 ? 1 : 7);
        for (int z = from.z; z <= to.z; ++z)
          for (int y = from.y; y <= to.y; ++y) {
            double* row = &samples_[(nx * 8 + 1) + kSide * ((ny * 8 + y + 1) + kSide * (nz * 8 + z + 1))];
            if (values != nullptr) {
              const std::uint16_t* s = values + (y << 3 | z << 6);
              for (int x = from.x; x <= to.x; ++x) row[x] = distance_from_solid(s[x]);
            } else {
              for (int x = from.x; x <= to.x; ++x) row[x] = -kBandVoxels;
            }
          }
      }
}

void CutSurface::refresh(const Volume& volume, int brick, Slot& slot) noexcept {
  const IVec3 at = volume.specimen().brick_at(brick);
  const IVec3 corner = at * kBrickEdge;
  const std::uint16_t* values = volume.cut_of(brick);
  const auto is_stale = [&slot](int o) { return slot.stale[o >> 6] >> (o & 63) & 1; };

  // What is still true, in cell order; its pages are free for the new list.
  std::size_t old = 0;
  for (std::int32_t p = slot.first; p >= 0;) {
    const Page& page = pages_[static_cast<std::size_t>(p)];
    for (int i = 0; i < page.count; ++i)
      if (!is_stale(page.feature[i].cell)) made_[old++] = {{page.x[i], page.y[i], page.z[i]}, page.feature[i]};
    if (p < static_cast<std::int32_t>(kept_pages_)) free_.push_back(p);
    p = page.next;
  }
  made_count_ = old;

  // The cells that are not, in cell order.
  if (strokes_ != nullptr) stroke_cells_.turn_to(*strokes_, volume.grid(), corner);
  bool decoded = false;
  const BasePoints points = volume.specimen().surface().in(brick);
  int next_point = 0;
  for (int z = 0; z < 8; ++z) {
    for (std::uint64_t left = slot.stale[z]; left != 0; left &= left - 1) {
      const int o = z << 6 | std::countr_zero(left);
      slot.creased[z] &= ~(std::uint64_t{1} << (o & 63));
      while (next_point < points.count && points.normal[next_point].cell() < o) ++next_point;
      while (next_point < points.count && points.normal[next_point].cell() == o) {
        if (!decoded) decode(volume, at);
        decoded = true;
        if (make_base(volume, points, next_point)) slot.creased[z] |= std::uint64_t{1} << (o & 63);
        ++next_point;
      }
      if (values[o] < kLeast || values[o] > kMost) continue;
      if (!decoded) decode(volume, at);
      decoded = true;
      if (make_cell(volume, corner, o)) slot.creased[z] |= std::uint64_t{1} << (o & 63);
    }
    slot.stale[z] = 0;
  }

  // Both in cell order: merge.
  std::size_t a = 0, b = old, n = 0;
  while (a < old || b < made_count_) {
    const bool take_old = b >= made_count_ || (a < old && made_[a].feature.cell < made_[b].feature.cell);
    merged_[n++] = take_old ? made_[a++] : made_[b++];
  }

  // Into pages; where no room is left, into those that serve one brick until the next is asked.
  const std::size_t needed = (n + kPage - 1) / kPage;
  const bool room = needed <= free_.size();
  slot.first = -1;
  std::int32_t* link = &slot.first;
  for (std::size_t i = 0, k = 0; i < n; i += kPage, ++k) {
    std::int32_t p = static_cast<std::int32_t>(kept_pages_ + k);
    if (room) {
      p = free_.back();
      free_.pop_back();
    }
    Page& page = pages_[static_cast<std::size_t>(p)];
    page.count = static_cast<std::int32_t>(std::min<std::size_t>(kPage, n - i));
    page.next = -1;
    for (int j = 0; j < page.count; ++j) {
      const Made& m = merged_[i + static_cast<std::size_t>(j)];
      page.x[j] = m.at.x;
      page.y[j] = m.at.y;
      page.z[j] = m.at.z;
      page.feature[j] = m.feature;
    }
    *link = p;
    link = &page.next;
  }
  if (!room)
    for (std::uint64_t& word : slot.stale) word = ~std::uint64_t{0};
}

bool CutSurface::make_base(const Volume& volume, const BasePoints& points, int i) noexcept {
  if (made_count_ == made_.size()) return true;
  const int o = points.normal[i].cell();
  const IVec3 local(o & 7, o >> 3 & 7, o >> 6);
  const Vec3f place(points.x[i], points.y[i], points.z[i]);
  Made& made = made_[made_count_];
  made = Made{};
  made.at = place;
  base_feature(volume.specimen().surface(), points, i, volume.grid().voxel_mm, made.feature);
  CellField cut;
  cut.load(&samples_[local.x + kSide * (local.y + kSide * local.z)], kSide, kSide * kSide);
  Vec3 g;
  const double d = cut.eval(Vec3(place) - Vec3(local), g);
  if (sharp_ && cut.crease_near() && !made.feature.edge && strokes_ != nullptr && stroke_cells_.explain(local, cut, 2)) {
    // More than one cut may end it here.
    Beside beside[2];
    int count = 0;
    if (!stroke_cells_.beside(Vec3(place) - Vec3(local), Vec3(made.feature.normal), beside, count)) return true;
    for (int k = 0; k < count; ++k) add_beside(made.feature, beside[k].d * volume.grid().voxel_mm, Vec3f(beside[k].normal));
    ++made_count_;
    return true;
  }
  const double length = std::sqrt(glm::dot(g, g));
  if (d > 0.0) {
    // The cut has taken it. A scratch so shallow that it takes no voxel's centre shows in no cell of the cut, and most of
    // the face about the point still stands: a burr that cuts on is held by the face as deep as the scratch has it there.
    if (!sharp_ && d < kShallow && length > 0.25 && !made.feature.edge) {
      made.at = Vec3f(Vec3(place) - Vec3(made.feature.normal) * (d / length));
      ++made_count_;
    }
    return cut.crease_near();
  }
  if (d > -kBeside && length > 0.25 && !made.feature.edge)
    add_beside(made.feature, d * volume.grid().voxel_mm / length, Vec3f(g / length));
  ++made_count_;
  return cut.crease_near();
}

void CutSurface::make_from_strokes(const Volume& volume, IVec3 cell, int offset, const CellField* base) noexcept {
  const double voxel = volume.grid().voxel_mm;
  const Vec3 local(offset & 7, offset >> 3 & 7, offset >> 6);
  for (const StrokeFeature& f : stroke_cells_.features(base)) {
    if (made_count_ == made_.size()) return;
    Made& made = made_[made_count_++];
    made = Made{};
    made.at = Vec3f(local + f.at);
    made.feature.normal = Vec3f(f.normal);
    made.feature.cell = static_cast<std::uint16_t>(offset);
    made.feature.tissue = tissue_under(volume, cell, f.edge ? f.at : f.at - 0.5 * f.normal);
    if (f.edge) {
      made.feature.edge = true;
      made.feature.other_normal = Vec3f(f.bend / voxel);
      made.feature.third_normal = Vec3f(f.twist / (voxel * voxel));
      made.feature.fourth = Vec3f(f.fourth / (voxel * voxel * voxel));
      made.feature.other_d_mm = static_cast<float>(f.from * voxel);
      made.feature.third_d_mm = static_cast<float>(f.to * voxel);
    } else {
      for (int k = 0; k < f.besides; ++k) add_beside(made.feature, f.beside[k].d * voxel, Vec3f(f.beside[k].normal));
    }
  }
}

bool CutSurface::make_cell(const Volume& volume, IVec3 corner, int offset) noexcept {
  if (made_count_ + 3 > made_.size()) return true;  // room for an edge, a point and the mouth
  const IVec3 local(offset & 7, offset >> 3 & 7, offset >> 6);
  const IVec3 cell = corner + local;
  const double* low = &samples_[local.x + kSide * (local.y + kSide * local.z)];
  const double* first = low + 1 + kSide + kSide * kSide;
  const bool inside = *first > 0.0;
  bool crossed = false;
  for (int i = 1; i < 8; ++i)
    crossed = crossed || (first[(i & 1) + (i >> 1 & 1) * kSide + (i >> 2) * kSide * kSide] > 0.0) != inside;
  // A thin ridge may pass between corners that are all in the void.
  if (!crossed && !(sharp_ && inside && strokes_ != nullptr && stroke_cells_.several())) return false;
  // Deep in the specimen its own surface is so far from all corners that it ends no plane: nothing of it to keep. Out in the
  // air there is nothing that a cut could have left.
  const Specimen& specimen = volume.specimen();
  bool deep = true, air = true;
  const int brick = specimen.brick_index({cell.x >> 3, cell.y >> 3, cell.z >> 3});
  const bool solid = local.x < 7 && local.y < 7 && local.z < 7 && specimen.s_of(brick) == nullptr && specimen.s_in(brick, 0) == kSolid;
  for (int i = 0; i < 8 && (deep || air) && !solid; ++i) {
    const std::uint16_t s = specimen.s(cell + IVec3(i & 1, i >> 1 & 1, i >> 2));
    deep = deep && s >= kDeep;
    air = air && s <= kAir;
  }
  if (air && !solid) return false;
  CellField cut;
  cut.load(low, kSide, kSide * kSide);
  if (!crossed && !cut.crease_near()) return false;
  CellField base;
  if (!deep) base.load(volume, Field::base, cell);
  const double voxel = volume.grid().voxel_mm;
  const bool mouth = !deep && base.crossed();  // the cut meets the specimen's own surface
  const auto add_edge = [&](const SharpEdge& edge) {
    Made& made = made_[made_count_++];
    made = Made{};
    made.at = Vec3f(Vec3(local) + edge.at);
    made.feature.normal = Vec3f(edge.tangent);
    made.feature.other_normal = Vec3f(edge.bend / voxel);
    made.feature.third_normal = Vec3f(edge.twist / (voxel * voxel));
    made.feature.edge = true;
    made.feature.third_d_mm = static_cast<float>(StrokeCells::kHalfEdge * voxel);
    made.feature.other_d_mm = -made.feature.third_d_mm;
    made.feature.cell = static_cast<std::uint16_t>(offset);
    made.feature.tissue = tissue_under(volume, cell, edge.at);
  };
  // The cut's distance is positive in the void: its gradient points into the void, as a normal should.
  if (sharp_ && strokes_ != nullptr && stroke_cells_.explain(local, cut, mouth ? 1 : 2)) {
    make_from_strokes(volume, cell, offset, deep ? nullptr : &base);
    return true;
  }
  if (!crossed) return true;
  Vec3 f, n;
  SharpEdge edge;
  const Creased crease = creased(cut, sharp_ ? kMostOff : 0.0, [&](IVec3 o, CellField& to) {
    const IVec3 there = cell + o;
    const bool empty = volume.cut(there) < kHalf;
    bool apart = false;
    for (int i = 1; i < 8 && !apart; ++i)
      apart = (volume.cut(there + IVec3(i & 1, i >> 1 & 1, i >> 2)) < kHalf) != empty;
    if (apart) to.load(volume, Field::cut, there);
    return apart;
  });
  Vec3 gradient(0.0);
  if (crease.kind == Creased::Kind::edge) {
    // A ridge between two cuts, where the specimen is solid.
    if (deep || base.eval(crease.edge.at, gradient) <= 0.0) add_edge(crease.edge);
  } else if (crease.kind == Creased::Kind::face) {
    if (deep || base.eval(crease.point, gradient) <= 0.0) {
      Made& made = made_[made_count_++];
      made = Made{};
      made.at = Vec3f(Vec3(local) + crease.point);
      made.feature.normal = Vec3f(crease.normal);
      made.feature.cell = static_cast<std::uint16_t>(offset);
      made.feature.tissue = tissue_under(volume, cell, crease.point - 0.5 * crease.normal);
      add_beside(made.feature, crease.other_d * voxel, Vec3f(crease.other_normal));
    }
  } else if (crease.kind == Creased::Kind::no && cell_point(cut, f, n)) {
    Vec3 g(0.0);
    const double other = deep ? -kBandVoxels : base.eval(f, g);
    if (other <= 0.0) {
      Made& made = made_[made_count_++];
      made = Made{};
      made.at = Vec3f(Vec3(local) + f);
      made.feature.normal = Vec3f(n);
      made.feature.cell = static_cast<std::uint16_t>(offset);
      made.feature.tissue = tissue_under(volume, cell, f - 0.5 * n);
      const double length = std::sqrt(glm::dot(g, g));
      if (other > -kBeside && length > 0.25) add_beside(made.feature, other * voxel / length, Vec3f(g / length));
    }
  }
  // Rounded as it is now, several strokes may shape it when the burr no longer cuts.
  const bool rounded = !sharp_ && strokes_ != nullptr && stroke_cells_.several();
  if (!mouth) return crease.looked || rounded;
  if (edge_of([&](Vec3 p, Vec3& g) { return base.eval(p, g); }, [&](Vec3 p, Vec3& g) { return cut.eval(p, g); }, Vec3(0.5),
              edge))
    add_edge(edge);
  return true;
}

}  // namespace cusp
