/// The surface proxy: the local minimum of the distance to the device point over poses in which the bur's ball does
/// not enter tissue and its neck and shank touch none, followed from the last pose (design, "Contact methods", 5).
/// Planes of the two fields within reach of a step, at most three active, polished by Newton on the fields.
/// Frame: specimen, mm. Thread: haptic. Wait-free; all memory is taken at construction.
#pragma once

#include <vector>

#include "engine/contact/cut_memory.h"
#include "engine/contact/cut_surface.h"
#include "engine/contact/plane_search.h"
#include "engine/scene/scene.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

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
  /// Clearance by which the bur is thinner against what it has cut itself: without it the bur jams in its own hole.
  static constexpr double kClearanceMm = 0.001;

  /// memory: past cut poses of the stroke, and all that was cut; or nullptr. Outlives this.
  SurfaceContact(const Scene& scene, const Volume& volume, const CutMemory* memory);

  static constexpr double kAnyWay = 1e9;  // mm: most_mm where the pose may go as far as it must

  /// From `from` (admissible) towards `device`. ahead: how the proxy may be expected to move, where the search begins to
  /// look. reach_mm: how far one search looks, about as long. most_mm: once it has gone further it may stop on its way.
  Contact solve(const Volume& volume, const Scene& scene, std::uint16_t bur, Vec3 axis, Vec3 from, Vec3 device, Vec3 ahead,
                double reach_mm, double most_mm) noexcept;

  /// Contact again after a cut that the field does not hold yet, from `before`, what solve() answered last: the memory
  /// alone has grown, by advance_mm.
  Contact after_cut(const Volume& volume, const Scene& scene, std::uint16_t bur, Vec3 axis, const Contact& before,
                    Vec3 device, double advance_mm) noexcept;

  /// True when the bur at this pose is in free space: ball, neck and shank clear of tissue.
  bool fits(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose) noexcept;

  /// Nearest pose to `pose` at which the head (and no shank), thinner by thin_mm all over, fits; false when there is none
  /// within 20 um.
  bool push_out(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose, double thin_mm, Vec3& out) noexcept;

  /// To be told of every change of the cut field: voxels low..high, inclusive. Cutting only takes tissue away, so what
  /// was clear stays clear.
  void changed(const Volume& volume, IVec3 low, IVec3 high) noexcept {
    cut_.changed(volume, low, high);
    fields_.forget_cut();
    gathered_.valid = false;
  }

  /// The same of a change too large to be felt to its edges at once: what lies there is rounded until sharpen() comes to it.
  void changed_dull(const Volume& volume, IVec3 low, IVec3 high) noexcept {
    cut_.changed_dull(volume, low, high);
    fields_.forget_cut();
    gathered_.valid = free_.valid = false;
    dull_far_.valid = false;
  }

  /// How many passes the searches from here on may take together, or however many look at no more candidates than this, each
  /// search at least one: what is still on its way then goes on in the next tick. A look takes some 25 ns, and up to as much
  /// again what follows of it; a wide bur, or a long flank, lies near thousands.
  static constexpr int kMostPasses = 48, kMostLooks = 10000;
  static constexpr int kLooksOfPass = 20;  // what a pass costs besides
  void allow_passes() noexcept {
    looked_ = looks();
    passes_left_ = kMostPasses;
    looks_left_ = kMostLooks;
  }
  bool spent() const noexcept { return passes_left_ <= 0 && looks_left_ <= 0; }

  /// Once a tick, before solve(). Off while the bur cuts: then ridges between cuts are felt as the field rounds them, for
  /// strokes are carved later than they are remembered. On: some of what is still rounded about the bur at `pose` is found
  /// to its edges, as much as a tick has time for; nothing in a tick that has to wait.
  void sharpen(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose, bool on, bool wait) noexcept;
  /// What of it is state: see CutSurface.
  const CutSurface& cut_surface() const noexcept { return cut_; }
  template <class SharpOf>
  void load_sharp(const Volume& volume, bool on, SharpOf&& sharp_of) noexcept {
    cut_.load_sharp(volume, on, sharp_of);
    sharp_ = on;
    forget();
  }

  /// Everything kept is to be found anew (after the volume was loaded). What is kept never changes an answer.
  void forget() noexcept;

  /// Ticks that the cached clearance answered; for benches.
  std::uint64_t answered_free() const noexcept { return answered_free_; }
  /// Candidates that searches have looked at, passes counted as so many more; for tests and benches.
  std::int64_t looks() const noexcept { return looked_ + kMostLooks - looks_left_; }
  /// Most candidates that one search has looked at; for benches.
  std::size_t most_candidates() const noexcept { return most_candidates_; }

 private:
  static constexpr double kTolerance = 1e-7;        // mm: planes closer than a tenth of a nanometre count as met
  static constexpr double kLongestStep = 0.08;      // mm: one search looks no further
  static constexpr double kPlaneReach = 0.8;        // voxels beside its point within which a plane stands for the surface
  static constexpr std::uint16_t kNoBur = 0xffff;  // of a ball that no scene names
  static constexpr double kLeavesTangent = 0.25;    // voxels by which an edge's piece leaves its tangent at most
  static constexpr double kEdgeClose = 1e-4;        // voxels: leaves its distance off by 1e-8, the normal by 2e-6 degrees
  static constexpr double kEdgeBends = 0.02;        // below, it bends about the place about as the ball does
  static constexpr int kEdgeNewton = 4;             // steps of Newton along an edge
  enum class Kind : std::uint8_t { surface, edge, shank };
  struct Candidate {
    Vec3 point{0.0}, normal{0.0};          // an edge's tangent
    double level = 0.0;                    // normal . point
    const CutFeature* feature = nullptr;   // of an edge, and where others end the point's plane
    Kind kind = Kind::surface;
    Field field = Field::base;
    Tissue tissue = Tissue::empty;
    std::uint8_t others = 0;
  };
  /// Box about the points of a brick, in sixteenths of a voxel from a quarter voxel below its first voxel.
  struct PointsBox {
    std::uint8_t from[3] = {255, 255, 255};
    std::uint8_t to[3] = {0, 0, 0};
    bool edges = false;
    bool empty() const noexcept { return from[0] > to[0]; }
    Vec3 low() const noexcept { return Vec3(from[0], from[1], from[2]) * 0.0625 - 0.25; }
    Vec3 high() const noexcept { return Vec3(to[0], to[1], to[2]) * 0.0625 - 0.25; }
    void add(Vec3f p) noexcept;
  };
  /// Where a candidate is made from: a page of the cut's surface, or the specimen's own points.
  struct Source {
    const CutSurface::Page* page = nullptr;
    std::int32_t brick = 0;
    std::uint16_t index = 0;
    bool shank = false;
    std::int16_t x = 0, y = 0, z = 0;  // of the brick
  };
  /// How a plane came to be, beside Plane itself.
  struct Origin {
    std::int32_t candidate = -1;
    bool trusted_plane = false;  // false: tangent to a point, an edge or the shank
    bool relaxed = false;        // the stroke's memory let it recede: the field is not what holds the pose
  };
  /// What is known of a candidate: not yet made; a point of a face whose plane nothing ends, in faces_; an edge; or
  /// anything else.
  enum class Known : std::uint8_t { unmade, base_face, cut_face, edge, other };
  struct alignas(64) Face {
    double x = 0, y = 0, z = 0, nx = 0, ny = 0, nz = 0;
    double level = 0;   // normal . point
    double radius = 0;  // of the ball, thinner against what it has cut
  };
  /// All that was near when planes were last laid of everything at hand, and how near it can be at least.
  struct Laid {
    Vec3 at{0.0};
    double within_mm = -1.0;  // planes further off than this were not laid
    std::size_t count = 0;    // of near_, low_
  };
  struct Polished {
    bool accepted = false;
    PlaneSearch search;
    Vec3 normal[3];
    std::int32_t candidate[3] = {0, 0, 0};
  };
  /// A bur as the solve sees it.
  struct Tool {
    const Bur* bur = nullptr;
    Vec3 axis{0.0};
    std::uint16_t index = kNoBur;
    double thin_base = 0.0, thin_cut = kClearanceMm;  // by how much the head is thinner against each field
    bool ball() const noexcept { return bur->head.ball(); }
    double thin(Field field) const noexcept { return field == Field::base ? thin_base : thin_cut; }
    /// Where the neck leaves the head; of a ball the head answers for what lies within it.
    double neck_from() const noexcept { return ball() ? 0.0 : bur->head.high(); }
  };
  /// Candidates at hand: all that a ball of radius + margin about `centre` reaches, and the shank with the same margin.
  struct Gathered {
    Vec3 centre{0.0};
    double margin_mm = 0.0;
    std::uint16_t bur = 0;
    bool valid = false;
    Vec3 axis{0.0};
    std::uint64_t revision = 0;  // of the cut's surface
  };
  /// Poses known to be free: within margin of centre, the whole bur beyond a plane that no tissue nearby passes.
  struct FreeSpace {
    Vec3 centre{0.0}, n{0.0};
    double margin_mm = 0.0, c = 0.0;
    std::uint16_t bur = 0;
    bool valid = false, bounded = false;
    Vec3 axis{0.0};
    bool holds(Vec3 p) const noexcept {
      const Vec3 d = p - centre;
      return glm::dot(d, d) <= margin_mm * margin_mm && (!bounded || glm::dot(n, p) >= c);
    }
  };

  bool points_box(const Volume& volume, int brick, IVec3 at, Vec3& low, Vec3& high) const noexcept;
  void gather(const Volume& volume, const Tool& tool, Vec3 centre, double step) noexcept;
  void gather_head(const Volume& volume, const Tool& tool, Vec3 centre, double reach) noexcept;
  /// Two coaxial cylinders about the tool's axis, the second from `wide_from` on; mm from the pivot.
  struct Reach {
    double from = 0.0, wide_from = 0.0, to = 0.0;
    double slim = 0.0, thick = 0.0;
  };
  static Reach shank_within(const Tool& tool, double margin_mm) noexcept;
  static Reach head_within(const Tool& tool, double margin_mm) noexcept;
  template <class Visit>
  void bricks_within(const Volume& volume, Vec3 axis, Vec3 centre, const Reach& reach, Visit&& visit) const noexcept;
  template <class Visit>
  void features_within(const Volume& volume, Vec3 axis, Vec3 centre, const Reach& reach, Visit&& visit) noexcept;
  template <class Visit>
  void head_bricks(const Volume& volume, const Tool& tool, Vec3 centre, double margin_mm, Visit&& visit) const noexcept;
  template <class Cells, class Choose, class Visit>
  void features(const Volume& volume, int brick, IVec3 at, Cells&& cells, Choose&& choose, Visit&& visit) noexcept;
  /// Brings the cells of the cut that two cylinders reach up to date while `budget` lasts; what is left of it.
  int prepare_within(const Volume& volume, Vec3 axis, Vec3 centre, const Reach& reach, int budget) noexcept;
  template <class Cells, class Choose>
  void gather_from(const Volume& volume, const Tool& tool, Vec3 centre, int brick, IVec3 at, bool shank, Cells&& cells,
                   Choose&& near) noexcept;
  void gather_shank(const Volume& volume, const Tool& tool, Vec3 centre, double reach) noexcept;
  template <class Visit>
  void ball_bricks(const Volume& volume, Vec3 centre, double reach, Visit&& visit) const noexcept;
  void add(const Candidate& candidate, const CutFeature* own) noexcept;
  bool plane_of_shank(const Tool& tool, const Candidate& c, Vec3 y, double slack_mm, Plane& plane) const noexcept;
  /// Where a head stands on a surface: from the pivot; and the direction that holds it off there.
  struct HeadFoot {
    Vec3 at{0.0}, normal{0.0};
    bool deepest = true;  // no place of the head stands deeper over the surface's plane
  };
  HeadFoot head_foot(const Tool& tool, Vec3 normal, Vec3 point_from_pivot, double beside2) const noexcept;
  bool plane_of_head(const Tool& tool, const Candidate& c, Vec3 y, double slack_mm, Plane& plane, bool& trusted) const noexcept;
  bool plane_of_surface(double r, const Candidate& c, Vec3 y, double slack_mm, Plane& plane, bool& trusted) const noexcept;
  void add_unmade(float x, float y, float z, std::int32_t brick, IVec3 at, std::int32_t index,
                  const CutSurface::Page* page, bool shank) noexcept;
  void make(const Volume& volume, const Tool& tool, std::size_t i) noexcept;
  void near_planes(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at, double slack_mm) noexcept;
  bool near_planes_again(const Tool& tool, Vec3 at, double slack_mm) noexcept;
  void lay_edges(const Tool& tool, Vec3 centre, double reach2, Vec3 at, double slack_mm) noexcept;
  void lay_faces(Vec3 centre, double reach2, Vec3 at, double slack_mm) noexcept;
  void lay(const Tool& tool, std::size_t i, Vec3 at, double slack_mm) noexcept;
  void lay_plane(std::size_t i, Vec3 n, double c, bool trusted, double low_mm) noexcept;
  CellsNear cells_free(const Tool& tool, Vec3 pose, Vec3 corner_mm) const noexcept;
  bool raise_free(const Volume& volume, const Tool& tool, Vec3 pose, Vec3 n) noexcept;
  bool nearest_to_ball(const Volume& volume, const Tool& tool, Vec3 pose, Vec3& n) noexcept;
  bool nearest_to_head(const Volume& volume, const Tool& tool, Vec3 pose, Vec3& n) noexcept;
  void find_free(const Volume& volume, const Tool& tool, Vec3 pose) noexcept;
  void foot(const Volume& volume, const Tool& tool, Vec3 pose, Vec3 device) noexcept;
  void planes(const Tool& tool, Vec3 y, std::size_t from, std::size_t to, double slack_mm) noexcept;
  bool plane_of(const Tool& tool, const Candidate& c, Vec3 y, double slack_mm, Plane& plane, bool& trusted) const noexcept;
  void relax_by_memory(const Tool& tool, std::size_t from, std::size_t to) noexcept;
  static bool nearest_on(const Candidate& edge, double voxel_mm, double far_mm, Vec3& off, Vec3& along, double& curved) noexcept;
  Vec3 leap_of(const Tool& tool, const PlaneSearch& found, Vec3 at, Vec3 off_by, bool& rolls) const noexcept;
  void turn(const Tool& tool, Vec3 y, std::size_t plane) noexcept;
  PlaneSearch search_planes(Vec3 y, Vec3 device, bool& infeasible) noexcept;
  Polished polish(const Volume& volume, const Tool& tool, Vec3 y, Vec3 device, const PlaneSearch& found) noexcept;
  HeadFoot foot_of(const Tool& tool, Field field, Vec3 normal, Vec3 point, Vec3 pose) const noexcept;
  void note(const PlaneSearch& found, const Polished& polished, Contact& out) const noexcept;
  bool clear_path(const Volume& volume, const Tool& tool, Vec3 from, Vec3 to) const noexcept;
  bool inside_tissue(const Volume& volume, Vec3 pose) const noexcept;

  double voxel_mm_;
  const CutMemory* memory_;
  std::vector<PointsBox> boxes_;       // [brick]: where the specimen's own points lie
  IVec3 bricks_low_{0}, bricks_high_{0};  // bricks that hold a surface or can be cut
  std::vector<Candidate> candidates_;  // at hand, then those of the foot
  std::vector<CutFeature> features_;   // of those that no kept page of the cut's surface holds
  std::vector<Source> sources_;
  std::vector<Known> known_;
  std::vector<Face> faces_;
  /// Candidates that one look goes through.
  struct Looks {
    explicit Looks(std::size_t room) : of(room + 1) {}
    std::vector<std::int32_t> of;  // and room for one more, so that there are pairs
    std::size_t count = 0;
    void add(std::int32_t i) noexcept { of[count++] = i; }
    void even() noexcept { of[count] = of[count > 0 ? count - 1 : 0]; }
    std::size_t operator[](std::size_t j) const noexcept { return static_cast<std::size_t>(of[j]); }
  };
  Looks look_faces_, look_edges_, look_others_;
  std::vector<float> place_x_, place_y_, place_z_;  // in voxels from where they were gathered
  PlaneSet planes_;
  std::vector<Origin> origins_;        // of planes_
  Laid laid_;
  std::vector<std::int32_t> near_;     // candidates of laid_
  std::vector<double> low_;            // mm that each of near_ is off at least, for some way about laid_.at
  std::size_t count_ = 0, ball_count_ = 0;
  Gathered gathered_;                  // of the head, then of the neck and the shank
  std::size_t shank_count_ = 0;
  FreeSpace free_;
  int free_pause_ = 0;                 // looks to skip before trying again
  std::uint64_t answered_free_ = 0;
  std::size_t most_candidates_ = 0;
  bool overflow_ = false;
  int passes_left_ = kMostPasses, looks_left_ = kMostLooks;
  std::int64_t looked_ = 0;
  bool sharp_ = true;                  // no part about the bur is dull
  /// Nothing dull within kDullFar of here, when valid.
  struct DullFar {
    Vec3 at{0.0}, axis{0.0};
    const Bur* bur = nullptr;
    bool valid = false;
  };
  DullFar dull_far_;
  bool edges_ = false;                 // edges may be among the candidates at hand
  bool near_cut_ = false;              // a surface that a bur left is among those near
  /// Of this solve's last pass: planes that hold the pose, and whether planes_ are those it came from.
  struct Held {
    int plane[3] = {0, 0, 0};
    int count = 0;
    bool fresh = false;
    double room_mm = 0.0;  // that a pose may go from there, planes_ being all that it could meet
  };
  Held held_;
  std::array<Vec3, CutMemory::kMost> past_;          // poses of the stroke's memory near the pose
  int past_count_ = 0;
  CutSurface cut_;
  FieldCells fields_;
};

}  // namespace cusp::engine
