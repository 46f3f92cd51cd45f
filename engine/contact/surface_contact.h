/// The surface proxy: the local minimum of the distance to the device point over poses in which the burr's ball does
/// not enter tissue and its neck and shank touch none, followed from the last pose (design, "Contact methods", 5).
/// Planes of the two fields within reach of a step, at most three active, polished by Newton on the fields.
/// Frame: specimen, mm. Thread: haptic. Wait-free; all memory is taken at construction.
#pragma once

#include <vector>

#include "engine/contact/cut_memory.h"
#include "engine/contact/cut_surface.h"
#include "engine/contact/plane_search.h"
#include "engine/step/scene.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/volume.h"

namespace cusp {

struct Contact {
  Vec3 pose_mm{0.0};
  int active = 0;                 // planes that hold the pose, at most 3
  Vec3 normal[3];                 // out of the tissue
  double weight[3] = {0, 0, 0};   // pose - device = sum weight * normal
  Tissue tissue[3] = {Tissue::empty, Tissue::empty, Tissue::empty};
  bool shank = false;             // the neck or the shank is among them
  Vec3 shank_normal{0.0};
  bool infeasible = false;        // planes contradicted each other: the pose stayed admissible, counted
  bool overflow = false;          // more candidates than room
  bool deferred = false;          // still on its way: the rest next tick
};

class SurfaceContact {
 public:
  /// Clearance by which the burr is thinner against what it has cut itself: without it the burr jams in its own hole.
  static constexpr double kClearanceMm = 0.001;

  SurfaceContact(const Scene& scene, const Volume& volume);

  /// From `from` (admissible) towards `device`. reach_mm: how far one search looks, about the device's own move.
  /// memory: past cut poses, or nullptr.
  Contact solve(const Volume& volume, const Scene& scene, std::uint16_t burr, Vec3 axis, Vec3 from, Vec3 device, double reach_mm,
                const CutMemory* memory) noexcept;

  /// True when the burr at this pose is in free space: ball, neck and shank clear of tissue.
  bool fits(const Volume& volume, const Burr& burr, Vec3 axis, Vec3 pose) noexcept;

  /// Nearest pose to `pose` at which a ball of `radius_mm` (and no shank) fits; false when there is none within 20 um.
  bool push_out(const Volume& volume, Vec3 pose, double radius_mm, Vec3& out) noexcept;

  /// To be told of every change of the cut field: voxels low..high, inclusive.
  void changed(const Volume& volume, IVec3 low, IVec3 high) noexcept {
    cut_.changed(volume, low, high);
    kept_.valid = false;
  }

  /// What the last search gathered stands until the burr has left its middle or the field changes. Which candidates are
  /// at hand is part of what the next step depends on, so key states hold it; keep() gathers the same ones again.
  struct Kept {
    Vec3 centre{0.0};
    double margin_mm = 0.0;
    std::uint16_t burr = 0;
    bool valid = false;
  };
  const Kept& kept() const noexcept { return kept_; }
  void keep(const Volume& volume, const Scene& scene, const Kept& kept) noexcept;

 private:
  enum class Kind : std::uint8_t { surface, edge, shank };
  struct Candidate {
    Vec3 point{0.0};
    Vec3 normal{0.0};        // surface; tangent for an edge
    Vec3 other_normal{0.0};
    double other_d_mm = 0.0;
    Kind kind = Kind::surface;
    Field field = Field::base;
    Tissue tissue = Tissue::empty;
    bool near_other = false;
  };
  /// How a plane came to be, beside Plane itself.
  struct Origin {
    std::int32_t candidate = -1;
    bool trusted_plane = false;  // false: tangent to a point, an edge or the shank
    bool relaxed = false;        // the stroke's memory let it recede: the field is not what holds the pose
  };
  struct Polished {
    bool accepted = false;
    PlaneSearch search;
    Vec3 normal[3];
    std::int32_t candidate[3] = {0, 0, 0};
  };

  void gather(const Volume& volume, const Burr& burr, Vec3 axis, Vec3 centre, double ball_reach,
              double shank_reach, bool with_shank) noexcept;
  void gather_ball_brick(const Volume& volume, int brick, Vec3 centre, double reach) noexcept;
  void gather_shank_brick(const Volume& volume, int brick, const Burr& burr, Vec3 axis, Vec3 centre,
                          double reach) noexcept;
  bool add(const Candidate& candidate) noexcept;
  bool base_candidate(const Volume& volume, int brick, IVec3 cell, const BasePoint& point, Candidate& out) noexcept;
  void foot(const Volume& volume, Vec3 pose, Vec3 device, double radius) noexcept;
  void planes(const Burr& burr, Vec3 axis, Vec3 y, double r_base, double r_cut, double slack_mm) noexcept;
  void relax_by_memory(const CutMemory& memory, Vec3 y, double radius) noexcept;
  Polished polish(const Volume& volume, Vec3 y, Vec3 device, const PlaneSearch& found, double r_base,
                  double r_cut) const noexcept;
  bool clear_path(const Volume& volume, const Burr& burr, Vec3 axis, Vec3 from, Vec3 to) const noexcept;

  double voxel_mm_;
  std::vector<Candidate> candidates_;
  std::vector<Plane> planes_;
  std::vector<Origin> origins_;
  std::size_t count_ = 0;     // candidates, with those of the foot
  std::size_t gathered_ = 0;  // without
  Kept kept_;
  std::size_t plane_count_ = 0;
  bool overflow_ = false;
  CutSurface cut_;
};

}  // namespace cusp
