/// The surface of a brick that a burr has reached, as points and edges in cell order: what is left of the specimen's own
/// points, the cut's points, and the edges where surfaces meet. Computed when contact asks for a brick, kept until a voxel
/// that it was read from changes. What it answers depends on the volume, the strokes that made it and sharpen() alone, so
/// that an incremental answer equals a full rebuild bit for bit. Fixed memory, in pages of eight features. Thread: haptic.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/contact/stroke_cells.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/volume.h"

namespace cusp {

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

  /// strokes: what has been cut, complete whenever sharpen() is on; or nullptr. Outlives this.
  CutSurface(const Volume& volume, const CutMemory* strokes);

  /// Voxels low..high (inclusive) of the cut field have changed.
  void changed(const Volume& volume, IVec3 low, IVec3 high) noexcept;

  /// Whether ridges between cuts are found to their edge, or rounded as the field has them (while the burr cuts).
  void sharpen(const Volume& volume, bool on) noexcept;

  /// First page of a brick's features, brought up to date; -1 when it has none. Valid until the next call.
  /// Pre: volume.has_cut(brick).
  std::int32_t first(const Volume& volume, int brick) noexcept;
  const Page& page(std::int32_t i) const noexcept { return pages_[static_cast<std::size_t>(i)]; }

  /// False for a page that holds one brick's features only until the next brick is asked for: room has run out.
  bool kept(std::int32_t i) const noexcept { return static_cast<std::size_t>(i) < kept_pages_; }

  /// Everything is to be read anew (after the volume was loaded).
  void forget() noexcept;

 private:
  struct Slot {
    std::uint64_t stale[8];    // by cell, one word for each slice
    std::uint64_t creased[8];  // cells whose features depend on the cells two away as well
    std::int32_t first = -1;
  };
  struct Made {
    Vec3f at{0.0f};
    CutFeature feature;
  };
  /// The brick's samples and one more below, two above: what its cells' stencils read.
  static constexpr int kSide = 11;

  void refresh(const Volume& volume, int brick, Slot& slot) noexcept;
  void decode(const Volume& volume, IVec3 brick) noexcept;
  /// True when the cell is creased.
  bool make_cell(const Volume& volume, IVec3 corner, int offset) noexcept;
  /// True when the cell is creased.
  bool make_base(const Volume& volume, const BasePoints& points, int i) noexcept;
  void make_from_strokes(const Volume& volume, IVec3 cell, int offset, const CellField* base) noexcept;

  std::vector<Slot> slots_;
  std::vector<Page> pages_;   // room for kept ones, then for one brick that found none
  std::vector<std::int32_t> free_;
  std::vector<Made> made_;    // of the brick being refreshed
  std::vector<Made> merged_;
  const CutMemory* strokes_;
  StrokeCells stroke_cells_;
  bool sharp_ = true;
  std::size_t made_count_ = 0;
  std::size_t kept_pages_ = 0;
  double samples_[kSide * kSide * kSide];
};

}  // namespace cusp
