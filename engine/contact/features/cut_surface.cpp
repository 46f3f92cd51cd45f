#include "engine/contact/features/cut_surface.h"

#include <bit>
#include <utility>

#include "engine/contact/cavity/swept_void.h"
#include "engine/contact/features/field_readers.h"

namespace cusp::engine {

namespace {
/// Features kept at once: a cavity of 60 mm2 at 0.04 mm voxels has about 60,000, and pages are two thirds full.
constexpr std::size_t kPages = 12000;
/// A cell has a few points and edges at most, and those with more than one are few.
constexpr std::size_t kMostFeatures = 4 * static_cast<std::size_t>(kBrickVoxels);
/// s beyond which no surface crosses the cells that touch the voxel (1.8 voxels).
constexpr std::uint16_t kLeast = 11000, kMost = 54500;
/// s between which the surface passes within half a voxel.
const std::uint16_t kInside = solid_from_distance(-0.5), kOutside = solid_from_distance(0.5);

auto cut_values(const Volume& volume) noexcept {
  return [&volume](int b) { return std::pair<const std::uint16_t*, double>(b < 0 ? nullptr : volume.cut_of(b), -kBandVoxels); };
}
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
  const BaseSurface::EdgeDetails sharp = surface.edge_details(points, i);
  out.other_normal = sharp.first->vector;
  if (normal.edge()) {
    out.other_normal /= static_cast<float>(voxel_mm);
    out.third_d_mm = static_cast<float>(kHalfEdge * voxel_mm);
    out.other_d_mm = -out.third_d_mm;
    return;
  }
  out.others = 1;
  out.other_d_mm = static_cast<float>(sharp.first->other_d * voxel_mm);
  if (sharp.second == nullptr) return;
  out.others = 2;
  out.third_normal = sharp.second->vector;
  out.third_d_mm = static_cast<float>(sharp.second->other_d * voxel_mm);
}

CutSurface::CutSurface(const Volume& volume)
    : slots_(volume.cut_capacity()),
      slots_resolved_(volume.cut_capacity(), kAllParts),
      made_(kMostFeatures),
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

void CutSurface::changed(const Volume& volume, const ChangedVoxels& voxels) noexcept {
  const Specimen& specimen = volume.specimen();
  const IVec3 corner((voxels.low >> 3) * kBrickEdge);
  const FieldReaders readers(voxels);
  // A creased cell reads the voxels of the cells two away, too.
  for_bricks_of(voxels.low - 4, voxels.high + 3, [&](const ChangedVoxels& far) {
    const IVec3 at = far.low >> 3;
    const int brick = specimen.brick_index(at);
    if (brick < 0 || !volume.has_cut(brick)) return;
    Slot& slot = slots_[static_cast<std::size_t>(volume.cut_slot(brick))];
    for (int z = 0; z < kBrickEdge; ++z) slot.stale[z] |= readers.in(at * kBrickEdge - corner, z) | (far.slice[z] & slot.creased[z]);
  });
}

void CutSurface::changed_unresolved(const Volume& volume, IVec3 low, IVec3 high) noexcept {
  // As far as a creased cell reads.
  for_bricks_of(low - 4, high + 3, [&](const ChangedVoxels& far) {
    const int brick = volume.specimen().brick_index(far.low >> 3);
    if (brick < 0 || !volume.has_cut(brick)) return;
    const auto place = static_cast<std::size_t>(volume.cut_slot(brick));
    for (int z = far.low.z & 7; z <= (far.high.z & 7); ++z) {
      const Parts were = slots_resolved_[place] & parts_of_slice(z);
      unresolved_parts_ += static_cast<std::size_t>(std::popcount(were));
      slots_resolved_[place] = static_cast<Parts>(slots_resolved_[place] & ~were);
      slots_[place].stale[z] |= slots_[place].creased[z] & cells_of(were, z);
    }
  });
  for_bricks_of(low, high, [&](const ChangedVoxels& voxels) { changed(volume, voxels); });
}

void CutSurface::resolve(const Volume& volume, Resolving resolving) noexcept {
  const bool on = resolving == Resolving::on;
  if (on == on_) return;
  on_ = on;
  const std::size_t used = volume.cut_bricks().size();
  if (on) {
    std::fill(slots_resolved_.begin() + static_cast<std::ptrdiff_t>(used), slots_resolved_.end(), kAllParts);
    count_unresolved();
    return;
  }
  for (std::size_t i = 0; i < used; ++i)
    for (int z = 0; z < kBrickEdge; ++z)
      slots_[i].stale[z] |= slots_[i].creased[z] & cells_of(slots_resolved_[i], z);
  std::fill(slots_resolved_.begin(), slots_resolved_.end(), Parts{0});
}

void CutSurface::count_unresolved() noexcept {
  unresolved_parts_ = 0;
  for (const Parts resolved : slots_resolved_) unresolved_parts_ += static_cast<std::size_t>(2 * kBrickEdge - std::popcount(resolved));
}

CutSurface::Parts CutSurface::unresolved(const Volume& volume, int brick) const noexcept {
  return static_cast<Parts>(~slots_resolved_[static_cast<std::size_t>(volume.cut_slot(brick))]);
}

int CutSurface::resolve_parts(const Volume& volume, int brick, Parts parts, int budget) noexcept {
  const auto place = static_cast<std::size_t>(volume.cut_slot(brick));
  const std::uint16_t* values = volume.cut_of(brick);
  const BasePoints points = volume.specimen().surface().in(brick);
  int point = 0;
  CellsNear made{};
  for (int part = 0; part < 2 * kBrickEdge && budget > 0; ++part) {
    const int first_cell = part << 5, end = first_cell + 32;
    int cost = 0;
    for (; point < points.count && points.normal[point].cell() < end; ++point) cost += points.normal[point].cell() >= first_cell;
    if ((parts >> part & 1) == 0 || (slots_resolved_[place] >> part & 1) != 0) continue;
    for (int o = first_cell; o < end; ++o) cost += values[o] <= kInside && values[o] >= kOutside;
    if (cost > budget && budget < kResolvePerTick) {
      budget = 0;
      break;
    }
    slots_resolved_[place] = static_cast<Parts>(slots_resolved_[place] | 1u << part);
    --unresolved_parts_;
    // An unresolved cell that is not creased may be a resolved one that is.
    made.slice[part >> 1] |= cells_of(static_cast<Parts>(1u << part), part >> 1);
    budget -= cost;
  }
  for (std::size_t z = 0; z < kBrickEdge; ++z) slots_[place].stale[z] |= made.slice[z];
  refresh(volume, brick, made);
  return budget;
}

int CutSurface::prepare(const Volume& volume, int brick, const CellsNear& cells, int budget) noexcept {
  const Slot& slot = slots_[static_cast<std::size_t>(volume.cut_slot(brick))];
  CellsNear made{};
  for (int z = 0; z < kBrickEdge && budget >= 0; ++z) {
    made.slice[z] = slot.stale[z] & cells.slice[z];
    budget -= std::popcount(made.slice[z]);
  }
  refresh(volume, brick, made);
  return budget;
}

/// The samples of a brick's cells and so many below and above, of it and its neighbours: source(brick) gives 512 values, or
/// nullptr and what stands for all of them.
template <int kBelow, int kAbove, class Source>
void CutSurface::decode(const Specimen& specimen, IVec3 brick, Rows cells, double* samples, Source&& source) noexcept {
  constexpr int kRow = kBelow + kBrickEdge + kAbove, kFirst = kBrickEdge - kBelow;
  for (int nz = -1; nz <= 1; ++nz)
    for (int ny = -1; ny <= 1; ++ny)
      for (int nx = -1; nx <= 1; ++nx) {
        const auto [values, uniform] = source(specimen.brick_index(brick + IVec3(nx, ny, nz)));
        const IVec3 from(nx < 0 ? kFirst : 0, std::max(ny < 0 ? kFirst : 0, cells.first_y - kBelow - ny * 8),
                         std::max(nz < 0 ? kFirst : 0, cells.first_z - kBelow - nz * 8));
        const IVec3 to(nx > 0 ? kAbove - 1 : 7, std::min(ny > 0 ? kAbove - 1 : 7, cells.last_y + kAbove - ny * 8),
                       std::min(nz > 0 ? kAbove - 1 : 7, cells.last_z + kAbove - nz * 8));
        for (int z = from.z; z <= to.z; ++z)
          for (int y = from.y; y <= to.y; ++y) {
            double* row = &samples[(nx * 8 + from.x + kBelow) + kRow * ((ny * 8 + y + kBelow) + kRow * (nz * 8 + z + kBelow))];
            const int count = to.x - from.x + 1;
            if (values != nullptr) {
              const std::uint16_t* s = values + (from.x | y << 3 | z << 6);
              for (int x = 0; x < count; ++x) row[x] = distance_from_solid(s[x]);
            } else {
              for (int x = 0; x < count; ++x) row[x] = uniform;
            }
          }
      }
}

void CutSurface::decode_cut(const Volume& volume, IVec3 brick) noexcept { decode<1, 2>(volume.specimen(), brick, asked_, samples_, cut_values(volume)); }

void CutSurface::decode_base(const Specimen& specimen, IVec3 brick) noexcept {
  base_ready_ = true;
  decode<1, 2>(specimen, brick, asked_, base_, [&specimen](int b) {
    return std::pair<const std::uint16_t*, double>(b < 0 ? nullptr : specimen.s_of(b),
                                                   distance_from_solid(b < 0 ? std::uint16_t{0} : specimen.s_in(b, 0)));
  });
}

void CutSurface::decode_wide(const Volume& volume, IVec3 brick) noexcept {
  wide_ready_ = true;
  decode<3, 4>(volume.specimen(), brick, asked_, wide_, cut_values(volume));
}

void CutSurface::refresh(const Volume& volume, int brick, const CellsNear& cells) noexcept {
  Slot& slot = slots_[static_cast<std::size_t>(volume.cut_slot(brick))];
  asked_ = {kBrickEdge, -1, kBrickEdge, -1};
  for (int z = 0; z < kBrickEdge; ++z) {
    const std::uint64_t asked = slot.stale[z] & cells.slice[z];
    if (asked == 0) continue;
    asked_.first_y = std::min(asked_.first_y, std::countr_zero(asked) >> 3);
    asked_.last_y = std::max(asked_.last_y, (63 - std::countl_zero(asked)) >> 3);
    asked_.first_z = std::min(asked_.first_z, z);
    asked_.last_z = z;
  }
  if (asked_.last_z < 0) return;
  const IVec3 at = volume.specimen().brick_at(brick);
  const IVec3 corner = at * kBrickEdge;
  const std::uint16_t* values = volume.cut_of(brick);
  ++revision_;

  // The cells that are no longer true, of those that are asked for, in cell order.
  made_count_ = 0;
  bool decoded = false;
  wide_ready_ = base_ready_ = false;
  const Parts resolved_parts = slots_resolved_[static_cast<std::size_t>(volume.cut_slot(brick))];
  const BasePoints points = volume.specimen().surface().in(brick);
  int next_point = 0;
  for (int z = asked_.first_z; z <= asked_.last_z; ++z) {
    const std::uint64_t resolved_cells = cells_of(resolved_parts, z);
    for (std::uint64_t left = slot.stale[z] & cells.slice[z]; left != 0; left &= left - 1) {
      const int o = z << 6 | std::countr_zero(left);
      const Part part = (resolved_cells >> (o & 63) & 1) != 0 ? Part::resolved : Part::unresolved;
      slot.creased[z] &= ~(std::uint64_t{1} << (o & 63));
      while (next_point < points.count && points.normal[next_point].cell() < o) ++next_point;
      while (next_point < points.count && points.normal[next_point].cell() == o) {
        if (!decoded) decode_cut(volume, at);
        decoded = true;
        if (make_base(volume, points, next_point, part)) slot.creased[z] |= std::uint64_t{1} << (o & 63);
        ++next_point;
      }
      if (values[o] < kLeast || values[o] > kMost) continue;
      if (!decoded) decode_cut(volume, at);
      decoded = true;
      if (make_cell(volume, corner, o, part)) slot.creased[z] |= std::uint64_t{1} << (o & 63);
    }
  }
  mark_swept(volume, corner);
  put(slot);

  // Where no room was left they serve until the next brick is asked for.
  for (int z = 0; z < 8; ++z) slot.stale[z] = slot.first < 0 || kept(slot.first) ? slot.stale[z] & ~cells.slice[z] : ~std::uint64_t{0};
}

/// Marks the features of the cut whose cells' voxels all name sweeps.
void CutSurface::mark_swept(const Volume& volume, IVec3 corner) noexcept {
  if (!volume.keeps_sweeps()) return;
  int cell = -1;
  bool swept = false;
  for (std::size_t i = 0; i < made_count_; ++i) {
    CutFeature& feature = made_[i].feature;
    if (feature.field != Field::cut) continue;
    if (feature.cell != cell) {
      cell = feature.cell;
      std::int32_t ids[8];
      swept = sweeps_of_cell(volume, corner + IVec3(cell & 7, cell >> 3 & 7, cell >> 6), ids);
    }
    feature.swept = swept;
  }
}

/// What is still true of a brick's features, and what was made, in cell order: into new pages; where no room is left for them,
/// into those that serve one brick.
void CutSurface::put(Slot& slot) noexcept {
  std::size_t old_count = 0;
  if (!kept(slot.first)) slot.first = -1;
  for (std::int32_t p = slot.first; p >= 0; p = pages_[static_cast<std::size_t>(p)].next)
    old_count += static_cast<std::size_t>(pages_[static_cast<std::size_t>(p)].count);
  const bool room = (old_count + made_count_ + kPage - 1) / kPage <= free_.size();
  std::int32_t from = slot.first, last = -1;
  std::size_t spare = kept_pages_;
  std::int32_t first = -1;
  const auto add = [&](float x, float y, float z, const CutFeature& feature) {
    if (last < 0 || pages_[static_cast<std::size_t>(last)].count == kPage) {
      std::int32_t p = static_cast<std::int32_t>(spare);
      if (room) {
        p = free_.back();
        free_.pop_back();
      } else if (spare++ == pages_.size()) {
        return;  // as many as made_ holds
      }
      (last < 0 ? first : pages_[static_cast<std::size_t>(last)].next) = p;
      pages_[static_cast<std::size_t>(p)].count = 0;
      pages_[static_cast<std::size_t>(p)].next = -1;
      last = p;
    }
    Page& page = pages_[static_cast<std::size_t>(last)];
    page.x[page.count] = x;
    page.y[page.count] = y;
    page.z[page.count] = z;
    page.feature[page.count++] = feature;
  };
  std::size_t next = 0;
  const auto add_made_before = [&](int cell) {
    for (; next < made_count_ && made_[next].feature.cell <= cell; ++next)
      add(made_[next].at.x, made_[next].at.y, made_[next].at.z, made_[next].feature);
  };
  while (from >= 0) {
    const Page& page = pages_[static_cast<std::size_t>(from)];
    for (int i = 0; i < page.count; ++i) {
      const int cell = page.feature[i].cell;
      if ((slot.stale[cell >> 6] >> (cell & 63) & 1) != 0) continue;
      add_made_before(cell);
      add(page.x[i], page.y[i], page.z[i], page.feature[i]);
    }
    const std::int32_t done = from;
    from = page.next;
    free_.push_back(done);
  }
  add_made_before(kBrickVoxels);
  slot.first = first;
}

}  // namespace cusp::engine
