/// The surface of a brick that a bur has reached, as points and edges in cell order: what is left of the specimen's own
/// points, the cut's points, and the edges where surfaces meet. Computed when contact asks for a brick, kept until a voxel
/// that it was read from changes. What it answers depends on the volume, the strokes that made it and on which parts are
/// sharp alone, so that an incremental answer equals a full rebuild bit for bit. Fixed memory, in pages of eight features.
///
/// A part (sixteen of a brick: halves of its slices, four rows of eight cells each) is *sharp* where ridges between cuts are
/// found to their edge, *dull* where they are rounded as the field has them. While the bur cuts all are dull; afterwards
/// they are sharpened some a tick (sharpen_parts), for an edge costs ten times a smooth cell. Which are sharp is part of the
/// step's state.
/// Thread: haptic.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "engine/contact/cells_near.h"
#include "engine/contact/stroke_cells.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

struct CutFeature {
  Vec3f normal{0.0f};           // out of the tissue; for an edge its tangent
  Vec3f other_normal{0.0f};     // of the nearest other surface; an edge's bend, per mm
  Vec3f third_normal{0.0f};     // of the next; an edge's twist, per mm^2
  Vec3f fourth{0.0f};           // of an edge, per mm^3
  float other_d_mm = 0.0f;      // distance of the point to the other surface, negative inside; where an edge's piece begins
  float third_d_mm = 0.0f;      // to the next; where an edge's piece ends
  std::uint16_t cell = 0;       // brick_offset of the cell's lower corner
  Field field = Field::cut;     // which surface it lies on
  Tissue tissue = Tissue::empty;
  bool edge = false;
  std::uint8_t others = 0;      // surfaces near the point
};

/// What the specimen's own surface has at place i of a brick's points.
void base_feature(const BaseSurface& surface, const BasePoints& points, int i, double voxel_mm, CutFeature& out) noexcept;

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

  /// strokes: what has been cut, complete whenever anything is sharp; or nullptr. Outlives this.
  CutSurface(const Volume& volume, const CutMemory* strokes);

  /// Voxels low..high (inclusive) of the cut field have changed. What was sharp stays so.
  void changed(const Volume& volume, IVec3 low, IVec3 high) noexcept;
  /// The same, and dulled: for changes too large to be made out to their edges at once.
  void changed_dull(const Volume& volume, IVec3 low, IVec3 high) noexcept;

  /// Off: every part is dull from now on. On: bricks that are cut from now on are sharp; those that were stay dull until
  /// sharpen_parts() comes to them.
  void sharpen(const Volume& volume, bool on) noexcept;
  bool sharpens() const noexcept { return on_; }
  /// Parts that are dull still, while it sharpens.
  std::size_t dull_parts() const noexcept { return dull_parts_; }

  /// Parts of a brick: bit 2 z of the rows 0 to 3 of slice z, the next one of the rows 4 to 7.
  using Parts = std::uint16_t;
  static constexpr Parts kAllParts = 0xffff;
  static constexpr Parts parts_of_slice(int z) noexcept { return static_cast<Parts>(3u << (2 * z)); }
  /// Dull parts of a brick. Pre: volume.has_cut(brick).
  Parts dull(const Volume& volume, int brick) const noexcept;
  /// What may be sharpened in a tick, or one part if that is more: a cell that strokes tell takes up to 20 us.
  static constexpr int kSharpenATick = 24;
  /// Sharpens dull parts of a brick among `parts`, lowest first, and makes them out at once, while `budget` lasts (of
  /// kSharpenATick); returns what is left of it, 0 when a part has to wait. A part costs its voxels that the cut's surface
  /// passes, and its points of the specimen's.
  int sharpen_parts(const Volume& volume, int brick, Parts parts, int budget) noexcept;

  /// For saving: sharp parts of a brick.
  Parts sharp(const Volume& volume, int brick) const noexcept { return static_cast<Parts>(~dull(volume, brick)); }
  /// Replaces which are sharp, of all of volume.cut_bricks(): sharp_of(brick). Everything is to be read anew.
  template <class SharpOf>
  void load_sharp(const Volume& volume, bool on, SharpOf&& sharp_of) noexcept {
    on_ = on;
    std::fill(slots_sharp_.begin(), slots_sharp_.end(), on ? kAllParts : Parts{0});
    for (const std::int32_t brick : volume.cut_bricks())
      slots_sharp_[static_cast<std::size_t>(volume.cut_slot(brick))] = sharp_of(brick);
    count_dull();
    forget();
  }

  /// First page of a brick's features, brought up to date for cells() (CellsNear); -1 when it has none. Of other cells what
  /// has changed is left out. Valid until the next call. Pre: volume.has_cut(brick).
  template <class Cells>
  std::int32_t first(const Volume& volume, int brick, Cells&& cells) noexcept {
    const Slot& slot = slots_[static_cast<std::size_t>(volume.cut_slot(brick))];
    std::uint64_t any = 0;
    for (const std::uint64_t stale : slot.stale) any |= stale;
    if (any != 0) refresh(volume, brick, cells());
    return slot.first;
  }
  /// Brings cells up to date, slice by slice, while `budget` lasts (of cells looked at); returns what is left of it, less than
  /// 0 when some have to wait. Pre: volume.has_cut(brick).
  int prepare(const Volume& volume, int brick, const CellsNear& cells, int budget) noexcept;
  const Page& page(std::int32_t i) const noexcept { return pages_[static_cast<std::size_t>(i)]; }

  /// Rises whenever a brick's features are put anew: pages read before no longer hold.
  std::uint64_t revision() const noexcept { return revision_; }

  /// False for a page that holds one brick's features only until the next brick is asked for: room has run out.
  bool kept(std::int32_t i) const noexcept { return i >= 0 && static_cast<std::size_t>(i) < kept_pages_; }

  /// Everything is to be read anew (after the volume was loaded). Which parts are sharp stays.
  void forget() noexcept;

  /// Cells whose edges have been looked for so far, the costliest work there is here, and all that the surface passes or
  /// the specimen has a point in; for tests and benches.
  std::uint64_t cells_sharpened() const noexcept { return cells_sharpened_; }
  std::uint64_t cells_made() const noexcept { return cells_made_; }

 private:
  struct Slot {
    std::uint64_t stale[8];    // by cell, one word for each slice
    std::uint64_t creased[8];  // sharp cells that depend on the cells two away as well, or would be other cells if dull
    std::int32_t first = -1;
  };
  struct Made {
    Vec3f at{0.0f};
    CutFeature feature;
  };
  /// The brick's samples and one more below, two above: what its cells' stencils read.
  static constexpr int kSide = 11;
  /// Three more below, four above: what an edge's look at the cells two away reads.
  static constexpr int kWide = 15;

  void refresh(const Volume& volume, int brick, const CellsNear& cells) noexcept;
  /// Cells of these parts in a slice.
  static std::uint64_t cells_of(Parts parts, int z) noexcept {
    const unsigned both = parts >> (2 * z) & 3u;
    return (both & 1u ? 0xffffffffull : 0) | (both & 2u ? 0xffffffff00000000ull : 0);
  }
  void count_dull() noexcept;
  void put(Slot& slot) noexcept;
  void decode_cut(const Volume& volume, IVec3 brick) noexcept;
  void decode_base(const Specimen& specimen, IVec3 brick) noexcept;
  template <class Source>
  static void decode(const Specimen& specimen, IVec3 brick, double (&samples)[kSide * kSide * kSide], Source&& source) noexcept;
  void decode_wide(const Volume& volume, IVec3 brick) noexcept;
  /// True when the cell is creased: never where it is dull.
  bool make_cell(const Volume& volume, IVec3 corner, int offset, bool sharp) noexcept;
  /// The same.
  bool make_base(const Volume& volume, const BasePoints& points, int i, bool sharp) noexcept;
  void make_from_strokes(const Volume& volume, IVec3 cell, int offset, const CellField* base) noexcept;

  std::vector<Slot> slots_;
  std::size_t dull_parts_ = 0;      // of the bricks that are cut, while it sharpens
  std::vector<Parts> slots_sharp_;  // [slot]: sharp parts; state, all else is kept for speed
  std::vector<Page> pages_;   // room for kept ones, then for one brick that found none
  std::vector<std::int32_t> free_;
  std::vector<Made> made_;    // of the brick being refreshed
  const CutMemory* strokes_;
  StrokeCells stroke_cells_;
  bool on_ = true;
  bool wide_ready_ = false;  // wide_ is of the brick being refreshed
  bool base_ready_ = false;  // base_ is
  std::uint64_t cells_sharpened_ = 0, cells_made_ = 0, revision_ = 0;
  std::size_t made_count_ = 0;
  std::size_t kept_pages_ = 0;
  double samples_[kSide * kSide * kSide], base_[kSide * kSide * kSide];
  double wide_[kWide * kWide * kWide];
};

}  // namespace cusp::engine
