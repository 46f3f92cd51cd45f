/// Features (points and edges) of the surface in the bricks that a bur has reached, in cell order: the specimen's points
/// that are left, the cut's points, and the edges where surfaces meet. A brick's features are computed on demand and cached
/// until a voxel that they were read from changes. They depend on the volume and on which parts are resolved, so an incremental answer equals a full rebuild bit for bit. Fixed memory, in pages of eight features.
///
/// A part is half a slice of a brick: four rows of eight cells, sixteen parts a brick. It is *resolved* if the edges between
/// its cuts were looked for in the field, *unresolved* if the field rounds them. All parts are unresolved while the bur cuts.
/// resolve_parts() resolves some a tick afterwards: an edge costs ten times a smooth cell. Which parts are resolved is state.
/// Thread: haptic. Wait-free.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/contact/features/cells_near.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/changed_voxels.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

struct Creased;
struct SharpEdge;

struct CutFeature {
  Vec3f normal{0.0f};           // out of the tissue; for an edge its tangent
  Vec3f other_normal{0.0f};     // of the nearest other surface; an edge's bend, per mm
  Vec3f third_normal{0.0f};     // of the next; an edge's twist, per mm^2
  float other_d_mm = 0.0f;      // distance of the point to the other surface, negative inside; an edge's first end, along it
  float third_d_mm = 0.0f;      // to the next; an edge's last end, along it
  std::uint16_t cell = 0;       // brick_offset of the cell's lower corner
  Field field = Field::cut;     // which surface it lies on
  Tissue tissue = Tissue::empty;
  bool edge = false;
  bool swept = false;           // balls' sweeps alone made the cell: CavityWalls has it exactly
  std::uint8_t others = 0;      // surfaces near the point
  bool inner_edge = false;      // a point that the field rounds off an inner edge: heads have its voxels inside instead
  bool inside = false;          // a voxel in the tissue, whose surface is other_d_mm away; normal: of the surface there
};

/// What the specimen's own surface has at place i of a brick's points.
void base_feature(const BaseSurface& surface, const BasePoints& points, int i, double voxel_mm, CutFeature& out) noexcept;

/// off: every part is unresolved from now on. on: bricks cut from now on are resolved, those cut before wait for
/// CutSurface::resolve_parts().
enum class Resolving : std::uint8_t { off, on };

class CutSurface {
 public:
  static constexpr int kPage = 8;
  /// Place i is (x[i], y[i], z[i]) in voxels from the brick's first voxel centre.
  struct Page {
    float x[kPage], y[kPage], z[kPage];
    CutFeature feature[kPage];
    std::int32_t count = 0;
    std::int32_t next = -1;
  };

  explicit CutSurface(const Volume& volume);

  /// Voxels of the cut field have changed. Resolved parts stay resolved.
  void changed(const Volume& volume, const ChangedVoxels& voxels) noexcept;
  /// The same of voxels low..high (inclusive); their parts become unresolved: for changes too large to resolve at once.
  void changed_unresolved(const Volume& volume, IVec3 low, IVec3 high) noexcept;

  void resolve(const Volume& volume, Resolving resolving) noexcept;
  bool resolves() const noexcept { return on_; }
  /// Unresolved parts, while it resolves.
  std::size_t unresolved_parts() const noexcept { return unresolved_parts_; }

  /// Parts of a brick: bit 2 z of the rows 0 to 3 of slice z, the next one of the rows 4 to 7.
  using Parts = std::uint16_t;
  static constexpr Parts kAllParts = 0xffff;
  static constexpr Parts parts_of_slice(int z) noexcept { return static_cast<Parts>(3u << (2 * z)); }
  /// Unresolved parts of a brick. Pre: volume.has_cut(brick).
  Parts unresolved(const Volume& volume, int brick) const noexcept;
  /// Surface voxels that a tick may resolve; one part may exceed it. 
  static constexpr int kResolvePerTick = 24;
  /// Resolves unresolved parts of a brick among `parts`, lowest first, and computes their features, while `budget` lasts.
  /// Returns the rest of the budget, 0 if a part has to wait. A part costs its voxels that the cut's surface crosses and its
  /// points of the specimen's.
  int resolve_parts(const Volume& volume, int brick, Parts parts, int budget) noexcept;

  /// For saving: resolved parts of a brick.
  Parts resolved(const Volume& volume, int brick) const noexcept { return static_cast<Parts>(~unresolved(volume, brick)); }
  /// Replaces the resolved parts of all volume.cut_bricks() by resolved_of(brick), and discards all features.
  template <class ResolvedOf>
  void load_resolved(const Volume& volume, Resolving resolving, ResolvedOf&& resolved_of) noexcept {
    on_ = resolving == Resolving::on;
    std::fill(slots_resolved_.begin(), slots_resolved_.end(), on_ ? kAllParts : Parts{0});
    for (const std::int32_t brick : volume.cut_bricks())
      slots_resolved_[static_cast<std::size_t>(volume.cut_slot(brick))] = resolved_of(brick);
    count_unresolved();
    forget();
  }

  /// First page of a brick's features, -1 if it has none. Features of cells(slices) (CellsNear; slices: which are asked for) are
  /// up to date; changed features of other cells are left out. Valid until the next call. Pre: volume.has_cut(brick).
  template <class Cells>
  std::int32_t first(const Volume& volume, int brick, Cells&& cells) noexcept {
    const Slot& slot = slots_[static_cast<std::size_t>(volume.cut_slot(brick))];
    unsigned slices = 0;
    for (int z = 0; z < kBrickEdge; ++z) slices |= slot.stale[z] != 0 ? 1u << z : 0u;
    if (slices != 0) refresh(volume, brick, cells(slices));
    return slot.first;
  }
  /// Brings cells up to date, slice by slice, while `budget` (cells) lasts. Returns the rest of it, negative if some have to
  /// wait. Pre: volume.has_cut(brick).
  int prepare(const Volume& volume, int brick, const CellsNear& cells, int budget) noexcept;
  const Page& page(std::int32_t i) const noexcept { return pages_[static_cast<std::size_t>(i)]; }

  /// Rises whenever a brick's features are replaced: pages read before are invalid.
  std::uint64_t revision() const noexcept { return revision_; }

  /// False if the page is reused for the next brick, because room has run out.
  bool kept(std::int32_t i) const noexcept { return i >= 0 && static_cast<std::size_t>(i) < kept_pages_; }

  /// Discards all features, after the volume was loaded. Which parts are resolved stays.
  void forget() noexcept;

  /// Cells resolved since construction, and cells whose features were computed; for tests and benches.
  std::uint64_t cells_resolved() const noexcept { return cells_resolved_; }
  std::uint64_t cells_made() const noexcept { return cells_made_; }

 private:
  struct Slot {
    std::uint64_t stale[8];    // by cell, one word for each slice
    std::uint64_t creased[8];  // resolved cells whose features also depend on the cells two away, or on being resolved
    std::int32_t first = -1;
  };
  struct Made {
    Vec3f at{0.0f};
    CutFeature feature;
  };
  /// The brick's samples and one more below, two above: what its cells' stencils read.
  static constexpr int kSide = 11;
  /// Three more below, four above: what edge detection reads of the cells two away.
  static constexpr int kWide = 15;

  void refresh(const Volume& volume, int brick, const CellsNear& cells) noexcept;
  /// Cells of these parts in a slice.
  static std::uint64_t cells_of(Parts parts, int z) noexcept {
    const unsigned both = parts >> (2 * z) & 3u;
    return (both & 1u ? 0xffffffffull : 0) | (both & 2u ? 0xffffffff00000000ull : 0);
  }
  void count_unresolved() noexcept;
  void mark_swept(const Volume& volume, IVec3 corner) noexcept;
  void put(Slot& slot) noexcept;
  /// Rows of a brick's cells, inclusive: along y and z.
  struct Rows {
    int first_y = 0, last_y = kBrickEdge - 1, first_z = 0, last_z = kBrickEdge - 1;
  };
  void decode_cut(const Volume& volume, IVec3 brick) noexcept;
  void decode_base(const Specimen& specimen, IVec3 brick) noexcept;
  template <int kBelow, int kAbove, class Source>
  static void decode(const Specimen& specimen, IVec3 brick, Rows cells, double* samples, Source&& source) noexcept;
  void decode_wide(const Volume& volume, IVec3 brick) noexcept;
  enum class Part : std::uint8_t { unresolved, resolved };
  /// Adds the features of a cell of the cut. True if the cell is creased; an unresolved cell never is.
  bool make_cell(const Volume& volume, IVec3 corner, int offset, Part part) noexcept;
  struct Cell;
  struct BaseAbout;
  BaseAbout base_about(const Volume& volume, const Cell& cell, const double* corners) noexcept;
  CutFeature& add_feature(const Volume& volume, const Cell& cell, Vec3 place, Vec3 normal, Vec3 under) noexcept;
  void add_mouth(const Volume& volume, const Cell& cell, const SharpEdge& edge) noexcept;
  void add_edge(const Volume& volume, const Cell& cell, const SharpEdge& edge) noexcept;
  void add_insides(const Volume& volume, const Cell& cell, const CellField& cut, const CellField* base, Vec3 normal) noexcept;
  bool load_beside(const Volume& volume, const Cell& cell, IVec3 o, CellField& to) noexcept;
  void add_cut(const Volume& volume, const Cell& cell, const Creased& crease, const CellField& cut, const CellField* base) noexcept;
  /// Adds the specimen's point i, if the cut has left it. True if the cell is creased; an unresolved cell never is.
  bool make_base(const Volume& volume, const BasePoints& points, int i, Part part) noexcept;

  std::vector<Slot> slots_;
  std::size_t unresolved_parts_ = 0;      // of the bricks that are cut, while it resolves
  std::vector<Parts> slots_resolved_;  // [slot]: resolved parts; state, all else is kept for speed
  std::vector<Page> pages_;   // room for kept ones, then for one brick that found none
  std::vector<std::int32_t> free_;
  std::vector<Made> made_;    // of the brick being refreshed
  bool on_ = true;
  bool wide_ready_ = false;  // wide_ is of the brick being refreshed
  bool base_ready_ = false;  // base_ is
  std::uint64_t cells_resolved_ = 0, cells_made_ = 0, revision_ = 0;
  std::size_t made_count_ = 0;
  std::size_t kept_pages_ = 0;
  Rows asked_;               // of the brick being refreshed
  double samples_[kSide * kSide * kSide], base_[kSide * kSide * kSide];
  double wide_[kWide * kWide * kWide];
};

}  // namespace cusp::engine
