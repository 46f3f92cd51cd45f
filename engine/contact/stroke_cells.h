/// What a cell of the cut holds where surfaces meet, computed from the strokes that made it: the bur's swept balls are known
/// exactly, while the field rounds the ridge between two of them and the corner where a ridge comes out at the mouth.
/// Only where the strokes explain every sample that the cell's field is made of, at most 120 reach the brick and 12 shape
/// the cell; elsewhere, as in a cavity of many short strokes, the field has to do. Thread: haptic.
#pragma once

#include <span>
#include <vector>

#include "engine/contact/cut_memory.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/sharp_edge.h"

namespace cusp::engine {

/// A surface beside a place, as a plane: distance of the place to it (negative inside the tissue) and its normal.
struct Beside {
  double d = 0.0;
  Vec3 normal{0.0};
};

/// A point of one surface, or a piece of an edge. Voxels, from the cell's lower corner.
struct StrokeFeature {
  bool edge = false;
  Vec3 at{0.5}, normal{0.0};     // for an edge its tangent
  Vec3 bend{0.0}, twist{0.0}, fourth{0.0};  // an edge's, as in SharpEdge
  double from = 0.0, to = 0.0;   // an edge's ends along its tangent
  Beside beside[2];              // the nearest other surfaces
  int besides = 0;
};

class StrokeCells {
 public:
  static constexpr int kMostFeatures = 24;
  /// An edge's piece ends here at the latest, voxels from its middle.
  static constexpr double kHalfEdge = 0.7;

  StrokeCells();

  /// Turns to the cells of a brick: first voxel `corner`. Cheap; the strokes are looked for when a cell asks.
  void turn_to(const CutMemory& memory, const Grid& grid, IVec3 corner) noexcept;

  /// True when more than one stroke reaches the brick: then there may be ridges between them.
  bool several() noexcept {
    if (!found_) find(*memory_, grid_, corner_);
    return usable_ && capsule_count_ > 1;
  }

  /// True when `least` strokes or more shape the cell at `local` (of the brick), and they give its samples as the field has
  /// them. Which strokes do depends on nothing but the samples: a stroke that is nowhere the deepest does not count.
  bool explain(IVec3 local, const CellField& cut, int least) noexcept;

  /// Of the cell explained last: points and edges of cuts and of the mouth. base: the specimen's own field of the cell, or
  /// nullptr deep inside it.
  std::span<const StrokeFeature> features(const CellField* base) noexcept;

  /// Of the cell explained last: false when a stroke has taken this place of the specimen's own surface (voxels from the
  /// cell's corner), else the nearest cuts beside it, at most two.
  bool beside(Vec3 place, Vec3 normal, Beside (&out)[2], int& count) const noexcept;

 private:
  struct Capsule {
    Vec3 a{0.0}, along{0.0};      // voxels from the brick's first voxel; b - a
    double inverse2 = 0.0;        // 1 / |along|^2, 0 for a ball
    double r = 0.0;
    double operator()(Vec3 x, Vec3& gradient) const noexcept;
    double depth(Vec3 x) const noexcept;
  };
  static constexpr int kMostInBrick = 120, kMostShaping = 12;
  static constexpr int kSide = 11;  // samples of a brick's cells along an edge
  static constexpr std::uint8_t kUnknown = 255, kOff = 254, kFar = 253;

  std::uint8_t deepest(IVec3 at, double has) noexcept;
  void find(const CutMemory& memory, const Grid& grid, IVec3 corner) noexcept;
  double depth(int surface, Vec3 x, Vec3& gradient) const noexcept;
  bool taken(Vec3 x, int but, int but_other) const noexcept;
  void add_point(int surface, Vec3 from) noexcept;
  void add_edges(int one, int other) noexcept;
  void add_edge(int one, int other, SharpEdge edge, double half) noexcept;
  void note_beside(Vec3 x, Vec3 normal, int but, Beside (&out)[2], int& count) const noexcept;

  const CutMemory* memory_ = nullptr;
  Grid grid_;
  IVec3 corner_{0};
  bool found_ = false, usable_ = false;
  std::vector<CutMemory::Segment> segments_;
  std::vector<Capsule> capsules_;          // of the brick
  int capsule_count_ = 0;
  double depth_[kMostInBrick];             // of each at the sample looked at
  std::uint8_t deepest_[kSide * kSide * kSide];  // which capsule is, by sample
  Capsule near_[kMostShaping];             // that shape the cell, voxels from its corner
  int near_count_ = 0;
  const CellField* base_ = nullptr;
  StrokeFeature features_[kMostFeatures];
  int feature_count_ = 0;
};

}  // namespace cusp::engine
