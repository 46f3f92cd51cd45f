/// The surface proxy: the pose nearest to the device point at which the head does not enter tissue and neck and shank touch
/// none. It is a local minimum, followed from the last pose, so that no wall is skipped.
/// Each search builds constraints n . y >= c from the features within reach, solves them with at most three active, and
/// polishes the answer by Newton on the fields.
/// Frame: specimen, mm. Thread: haptic. Wait-free; all memory is taken at construction.
#pragma once

#include <vector>

#include "engine/contact/cavity/cavity_walls.h"
#include "engine/contact/cavity/cut_memory.h"
#include "engine/contact/contact.h"
#include "engine/contact/features/cut_surface.h"
#include "engine/contact/features/points_box.h"
#include "engine/contact/features/seen_voxels.h"
#include "engine/contact/head_foot.h"
#include "engine/contact/solver/kept_planes.h"
#include "engine/contact/solver/plane_search.h"
#include "engine/scene/scene.h"
#include "engine/volume/cell_field.h"
#include "engine/volume/volume.h"

namespace cusp::engine {

class SurfaceContact {
 public:
  /// The bur is thinner by this against the cut field: without a clearance it jams in its own hole. The second is of a head
  /// that is no ball and does not cut: a field knows what it has cut to 2 um.
  static constexpr double kClearanceMm = 0.001, kHeadClearanceMm = 0.002;

  /// memory: past cut poses of heads that are no balls; sweeps: of balls. Both outlive this.
  SurfaceContact(const Scene& scene, const Volume& volume, const CutMemory& memory, const Sweeps& sweeps);

  static constexpr double kAnyWay = 1e9;  // mm: most_mm without a bound

  /// The pose nearest to `device` that is reached from `from`. Pre: `from` is admissible.
  /// predicted: displacement of the proxy at which the first constraints are built, mm. reach_mm: length of one search.
  /// most_mm: beyond this way from `from` the solve may stop, with `deferred` set.
  Contact solve(const Volume& volume, const Scene& scene, std::uint16_t bur, Vec3 axis, Vec3 from, Vec3 device, Vec3 predicted,
                double reach_mm, double most_mm) noexcept;

  /// True when head, neck and shank are clear of tissue by a voxel. in_free_space(): no brick in reach has any; costs a few us.
  bool fits(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose) noexcept;
  bool in_free_space(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose) const noexcept;

  /// The nearest pose at which the head alone, thinner by thin_mm all over, fits. False if there is none within 20 um.
  bool push_out(const Volume& volume, const Scene& scene, std::uint16_t bur, Vec3 axis, Vec3 pose, double thin_mm, Vec3& out) noexcept;

  /// To be called after every change of the cut field. Known free space stays valid, for cutting only removes tissue.
  void changed(const Volume& volume, const ChangedVoxels& changed) noexcept {
    cut_.changed(volume, changed);
    walls_.changed(volume, changed.low, changed.high);
    fields_.forget_cut();
    gathered_.valid = false;
  }

  /// The same of voxels low..high, inclusive: a change too large to resolve at once. Its parts wait for resolve().
  void changed_unresolved(const Volume& volume, IVec3 low, IVec3 high) noexcept {
    cut_.changed_unresolved(volume, low, high);
    walls_.changed(volume, low, high);
    fields_.forget_cut();
    gathered_.valid = free_.valid = unresolved_far_.valid = false;
    shank_free_ = {};
  }

  /// Of a tick: candidates of all searches after reset_budget(), at 25 to 50 ns, and so many passes at least. Where it runs out,
  /// a search that has moved stops with `deferred` set.
  /// Caches decide how many candidates are looked at, so constraints are charged: for each, 1.2 to 2.1 were looked at.
  struct Budget {
    int candidates, passes;
  };
  static constexpr int kCandidatesOfConstraint = 2, kCandidatesOfPass = 20, kHeadCandidate = 4;  // of another head: some 160 ns
  static constexpr Budget kExploring{10000, 8};
  /// A deferred tick cuts nothing: at 200 mm/s 16 passes leave 0.2 mm uncut (`cusp-bench removal --full`).
  static constexpr Budget kCutting{10000, 48};
  /// Of a head that is no ball and cuts, where its proxy outruns the device, or has still to settle on what was carved.
  static constexpr Budget kShort{2500, 4};
  void reset_budget(const Budget& budget) noexcept {
    visited_before_ = candidates_visited();
    budget_ = budget;
    candidates_left_ = budget.candidates;
    passes_ = 0;
  }
  bool spent() const noexcept { return candidates_left_ <= 0 && passes_ >= budget_.passes; }

  /// off: while the bur cuts; all parts are unresolved then, for strokes are carved later than they enter the memory. now:
  /// parts near the bur are resolved, at most CutSurface::kResolvePerTick. wait: none is in this tick.
  enum class Resolve : std::uint8_t { off, wait, now };
  /// Once a tick, before solve(), with the bur at `pose`.
  void resolve(const Volume& volume, const Bur& bur, Vec3 axis, Vec3 pose, Resolve when) noexcept;
  /// Its resolved parts are state (engine/step/state_fields.h).
  const CutSurface& cut_surface() const noexcept { return cut_; }
  template <class ResolvedOf>
  void load_resolved(const Volume& volume, Resolving resolving, ResolvedOf&& resolved_of) noexcept {
    cut_.load_resolved(volume, resolving, resolved_of);
    all_resolved_ = resolving == Resolving::on;
    forget();
  }

  /// To be called before a tick's first solve(); then set_cutting() after each change of the cutting.
  void start_tick(const Cutting& cutting, const Budget& budget) noexcept {
    reset_budget(budget);
    walls_.start(cutting);
  }
  void set_cutting(const Cutting& cutting) noexcept { walls_.set_cutting(cutting); }
  /// State: CavityWalls::found().
  CavityWalls::Found found_in_cavity() const noexcept { return walls_.found(); }
  void set_found_in_cavity(const CavityWalls::Found& found) noexcept { walls_.set_found(found); }

  /// Discards every cache, after the volume was loaded. A cache never changes an answer.
  void forget() noexcept;

  /// For tests and benches: ticks that FreeSpace answered, candidates looked at since construction, the most of one pass.
  std::uint64_t answered_free() const noexcept { return answered_free_; }
  std::int64_t candidates_visited() const noexcept { return visited_before_ + budget_.candidates - candidates_left_; }
  std::size_t most_candidates() const noexcept { return most_candidates_; }

 private:
  static constexpr double kMostMargin = 0.4;        // mm: candidates are gathered at most so far beyond a step
  static constexpr double kMemorySlack = 5e-4;      // mm
  static constexpr double kTolerance = 1e-7;        // mm: planes closer than a tenth of a nanometre count as met
  static constexpr double kTangentsHoldMm = 1e-3;  // after a smaller move constraints are good to 2 nm
  static constexpr double kLongestStep = 0.08;      // mm: longest reach of one search
  /// Voxels: so far the fields leave a neck's point within what balls have swept. One that stays blocks a neck which the ball's own
  /// walls let pass (tests/engine/step/neck.cpp).
  static constexpr double kMostMovedOut = 0.1;
  static constexpr double kPlaneReach = 0.8;        // voxels beside its point within which a plane stands for the surface
  static_assert(kPlaneReach >= kHalfEdge, "a head that is gathered for planes has its edges too");
  static constexpr std::uint16_t kNoBur = 0xffff;  // of a ball that no scene names
  enum class Kind : std::uint8_t { surface, edge, inside, shank };
  struct Candidate {
    Vec3 point{0.0}, normal{0.0};          // an edge's tangent
    double level = 0.0;                    // normal . point; inside the tissue: how far its surface is
    const CutFeature* feature = nullptr;   // of an edge, and where others end the point's plane
    Kind kind = Kind::surface;
    Field field = Field::base;
    Tissue tissue = Tissue::empty;
    std::uint8_t others = 0;
  };
  /// Where candidates are made from: a page of the cut's surface, or a brick's own points.
  struct PointList {
    const CutSurface::Page* page = nullptr;
    std::int32_t brick = 0;
    IVec3 at{0};  // the brick's place
  };
  /// A candidate's own, by its number there.
  struct Source {
    std::int32_t list = 0;  // of point_lists_
    std::uint16_t index = 0;
    Kind kind = Kind::surface;
  };
  /// How a plane came to be, beside Plane itself.
  struct Origin {
    std::int32_t candidate = -1;
    bool trusted_plane = false;  // false: tangent to a point, an edge or the shank
    bool relaxed = false;        // a past pose moved it back: the field does not support it
    std::int8_t kept = -1;       // number among kept_planes_: of an earlier pass
  };
  /// What is known of a candidate: not yet made; a point of a face whose plane nothing ends, in faces_; an edge; or
  /// anything else.
  enum class Known : std::uint8_t { unmade, base_face, cut_face, edge, other };
  struct alignas(64) Face {
    double x = 0, y = 0, z = 0, nx = 0, ny = 0, nz = 0;
    double level = 0;   // normal . point
    double radius = 0;  // of the ball, thinner against what it has cut
  };
  /// The last full build of constraints: near_ are its candidates, low_ their least distances.
  struct Built {
    Vec3 at{0.0};
    double within_mm = -1.0;  // it left out constraints further off; negative: invalid
    std::size_t count = 0;    // of near_ and low_
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
    double thin_base = 0.0, thin_cut = ball() ? kClearanceMm : kHeadClearanceMm;  // the head is thinner against each field
    bool ball() const noexcept { return bur->head.ball(); }
    double thin(Field field) const noexcept { return field == Field::base ? thin_base : thin_cut; }
    /// Where the neck leaves the head; of a ball the head answers for what lies within it.
    double neck_from() const noexcept { return ball() ? 0.0 : bur->head.high(); }
  };
  Tool tool_of(const Bur& bur, Vec3 axis, std::uint16_t index) const noexcept;
  /// Candidates at hand: all that a ball of radius + margin about `centre` reaches, and the shank with the same margin.
  struct Gathered {
    Vec3 centre{0.0};
    double margin_mm = 0.0;
    std::uint16_t bur = 0;
    bool valid = false;
    Vec3 axis{0.0};
    std::uint64_t revision = 0;  // of the cut's surface
    std::int32_t carved = 0;     // sweeps
  };
  /// Free poses: within margin of centre and, if bounded, beyond a plane that no tissue nearby crosses.
  struct FreeSpace {
    Vec3 centre{0.0}, n{0.0};
    double margin_mm = 0.0, c = 0.0;
    std::uint16_t bur = 0;
    bool valid = false, bounded = false;
    Vec3 axis{0.0};
    bool contains(Vec3 p) const noexcept {
      const Vec3 d = p - centre;
      return glm::dot(d, d) <= margin_mm * margin_mm && (!bounded || glm::dot(n, p) >= c);
    }
  };

  bool points_box(const Volume& volume, int brick, IVec3 at, Vec3& low, Vec3& high) const noexcept;
  void gather(const Volume& volume, const Tool& tool, Vec3 centre, double step, double most_margin_mm = kMostMargin) noexcept;
  void gather_head(const Volume& volume, const Tool& tool, Vec3 centre, double reach) noexcept;
  /// Two coaxial cylinders about the tool's axis, the second from `wide_from` on; mm from the pivot.
  struct Reach {
    double from = 0.0, wide_from = 0.0, to = 0.0;
    double slim = 0.0, thick = 0.0;
    /// In voxels, from a pivot that is still to be given, and a little wider.
    TwoCylinders cylinders(Vec3 axis, double voxel_mm) const noexcept;
    /// Narrows low..high along x and y to the bricks of layer z about the pieces that are level with it.
    void layer(const Grid& grid, Vec3 axis, Vec3 centre, int z, IVec3& low, IVec3& high) const noexcept;
  };
  static Reach shank_within(const Tool& tool, double margin_mm) noexcept;
  static Reach head_within(const Tool& tool, double margin_mm) noexcept;
  template <class Visit>
  void unresolved_near(const Volume& volume, const Tool& tool, Vec3 pose, double margin_mm, Visit&& visit) const noexcept;
  template <class Visit>
  void bricks_within(const Volume& volume, Vec3 axis, Vec3 centre, const Reach& reach, Visit&& visit) const noexcept;
  template <class Visit>
  void free_bricks(const Volume& volume, const Tool& tool, Vec3 pose, Visit&& visit) const noexcept;
  template <class Cells, class Look>
  void features(const Volume& volume, int brick, Cells&& cells, Look&& look) noexcept;
  enum class ToolPart : std::uint8_t { head, shank };
  template <class Cells, class Choose>
  void gather_from(const Volume& volume, const Tool& tool, Vec3 centre, int brick, IVec3 at, ToolPart part, Cells&& cells,
                   Choose&& near) noexcept;
  void gather_shank(const Volume& volume, const Tool& tool, Vec3 centre, double reach) noexcept;
  template <class Visit>
  void ball_bricks(const Volume& volume, Vec3 centre, double reach, Visit&& visit) const noexcept;
  /// What keeps the bur off one candidate.
  struct Constraint {
    Plane plane;
    bool near = false;     // it is within the slack
    bool trusted = false;  // it does not turn with the bur
    double low_mm = 0.0;   // less the bur's way, a bound of its distance from below; of a ball and a shank bounded_plane_of() sets it
  };
  static Constraint tangent_of(Vec3 off, Vec3 y, double r, double slack_mm) noexcept;
  Constraint plane_of_shank(const Tool& tool, const Candidate& c, Vec3 y, double slack_mm) const noexcept;
  bool near_rim(const Tool& tool, Vec3 from_pivot) const noexcept;
  Constraint plane_of_head(const Tool& tool, const Candidate& c, ByHead& place, const HeadFoot& foot, Vec3 y,
                           double slack_mm) const noexcept;
  bool on_edge(const Candidate& c) const noexcept;
  Constraint plane_of_surface(double r, const Candidate& c, Vec3 y, double slack_mm) const noexcept;
  void add_unmade(float x, float y, float z, Source source) noexcept;
  void make(const Volume& volume, const Tool& tool, std::size_t i) noexcept;
  void build_constraints(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at, double slack_mm) noexcept;
  bool rebuild_constraints(const Tool& tool, Vec3 at, double slack_mm) noexcept;
  Known known_of(const Volume& volume, const Tool& tool, std::size_t i) noexcept;
  std::size_t add_ball_constraints(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at, double slack_mm) noexcept;
  std::size_t add_head_constraints(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at, double slack_mm) noexcept;
  std::size_t add_shank_constraints(const Volume& volume, const Tool& tool, Vec3 centre, double step, Vec3 at, double slack_mm) noexcept;
  struct EdgePair;
  void add_edge_constraints(const Tool& tool, Vec3 centre, double reach2, Vec3 at, double slack_mm) noexcept;
  void add_face_constraints(Vec3 centre, double reach2, Vec3 at, double slack_mm) noexcept;
  Constraint bounded_plane_of(const Tool& tool, const Candidate& c, Vec3 at, double slack_mm) const noexcept;
  void constrain(std::size_t i, const Constraint& found) noexcept;
  void add_constraint(std::size_t i, const Constraint& constraint) noexcept;
  CellsNear cells_free(const Tool& tool, Vec3 pose, Vec3 corner_mm, unsigned slices) const noexcept;
  bool raise_free(const Volume& volume, const Tool& tool, Vec3 pose, Vec3 n) noexcept;
  void nearest_to_ball(const Volume& volume, const Tool& tool, Vec3 pose, Vec3& n) noexcept;
  void nearest_to_head(const Volume& volume, const Tool& tool, Vec3 pose, Vec3& n) noexcept;
  void find_free(const Volume& volume, const Tool& tool, Vec3 pose) noexcept;
  void foot(const Volume& volume, const Tool& tool, Vec3 pose, Vec3 device) noexcept;
  void planes(const Tool& tool, Vec3 y, std::size_t from, std::size_t to, double slack_mm) noexcept;
  Constraint plane_of(const Tool& tool, const Candidate& c, Vec3 y, double slack_mm) const noexcept;
  void find_past(const Tool& tool, Vec3 at) noexcept;
  bool of_shank(const Origin& origin) const noexcept;
  void relax_by_past(std::size_t from, std::size_t to) noexcept;
  bool nearest_on(const Candidate& edge, double far_mm, Vec3& off, Vec3& along, double& curved) const noexcept;
  static constexpr double kLongestLeap = 10.0, kFarthestLeapMm = 0.3;  // the first in moves of the last pass
  Vec3 leap_of_ball(const PlaneSearch& found, Vec3 at, Vec3 off_by, bool& rolls) const noexcept;
  void turn(const Tool& tool, Vec3 y, std::size_t plane) noexcept;
  Contact follow(const Volume& volume, const Tool& tool, Vec3 from, Vec3 device, Vec3 predicted, double reach_mm, double most_mm) noexcept;
  struct Metric;
  glm::dmat3 bend_of(const Origin& origin, Vec3 at) const noexcept;
  glm::dmat3 bend_of(const PlaneSearch& found, Vec3 at) const noexcept;
  void constrain_in_cavity(const Volume& volume, const Tool& tool, Vec3 at, double slack_mm) noexcept;
  void keep_planes(const PlaneSearch& found, Vec3 at) noexcept;
  void add_kept(Vec3 at, double within_mm) noexcept;
  void add_cavity(const Volume& volume, const Tool& tool, Vec3 at, double slack_mm) noexcept;
  PlaneSearch nearest_in_metric(const Metric& metric, Vec3 y, Vec3 z, bool& infeasible) noexcept;
  static constexpr double kNearCavityMm = 0.02;  // beyond a step: a ball this near to what balls have cut is solved in the cavity
  bool near_cavity(const Volume& volume, const Tool& tool, Vec3 from, double step) noexcept;
  bool refine_in_cavity(const Volume& volume, const Tool& tool, Vec3 at, const PlaneSearch& found, CavityWalls::Jump jump, int steps) noexcept;
  struct PlaneSolve;
  void begin_search(const Volume& volume, const Tool& tool, PlaneSolve& s) noexcept;
  Vec3 leap_of_head(const PlaneSearch& found, Vec3 y, PlaneSolve& s, bool& rolls) const noexcept;
  Vec3 leap_within(const Tool& tool, const PlaneSearch& found, Vec3 y, PlaneSolve& s, bool& rolls) const noexcept;
  void build_anew(PlaneSolve& s) noexcept;
  void build_further(const Tool& tool, const PlaneSearch& found, double off, int pass, PlaneSolve& s) noexcept;
  void constrain_pass(const Volume& volume, const Tool& tool, PlaneSolve& s, int pass) noexcept;
  bool deep_in_edge(Vec3 at) const noexcept;
  bool turn_back(PlaneSearch& found, PlaneSolve& s) noexcept;
  bool make_pass(const Volume& volume, const Tool& tool, PlaneSolve& s, int pass) noexcept;
  void go_to(const PlaneSearch& found, const Polished& polished, double whole, PlaneSolve& s) const noexcept;
  bool settled(const Tool& tool, const PlaneSearch& found, const Polished& polished, PlaneSolve& s) const noexcept;
  Contact solve_by_planes(const Volume& volume, const Tool& tool, Vec3 from, Vec3 device, Vec3 predicted, double step, double most_mm) noexcept;
  bool shank_free(const Volume& volume, const Tool& tool, Vec3 pose, double within_mm) noexcept;
  bool solve_in_sweep(const Volume& volume, const Tool& tool, Vec3 from, Vec3 device, double moved_mm, Contact& out) noexcept;
  Contact solve_in_cavity(const Volume& volume, const Tool& tool, Vec3 from, Vec3 device, double moved_mm) noexcept;
  PlaneSearch search_planes(Vec3 y, Vec3 device, bool& infeasible) noexcept;
  struct Touching;
  bool group_surfaces(const PlaneSearch& found, Touching& t) const noexcept;
  bool enclosed(const PlaneSearch& found, const Touching& t) const noexcept;
  bool correct(const Volume& volume, const Tool& tool, Vec3 at, Touching& t) noexcept;
  bool polish_holds(const Tool& tool, Vec3 at, const Touching& t) const noexcept;
  Polished polish(const Volume& volume, const Tool& tool, Vec3 y, Vec3 device, const PlaneSearch& found) noexcept;
  HeadFoot foot_of(const Tool& tool, Field field, Vec3 normal, Vec3 point, Vec3 pose) const noexcept;
  void note(const Volume& volume, const PlaneSearch& found, const Polished& polished, Contact& out) const noexcept;
  bool inside_tissue(const Volume& volume, Vec3 pose) const noexcept;
  Tissue tissue_under(const Volume& volume, Vec3 place, Vec3 outwards) const noexcept;

  double voxel_mm_;
  const CutMemory& memory_;
  std::vector<PointsBox> boxes_;       // [brick]: where the specimen's own points lie
  IVec3 bricks_low_{0}, bricks_high_{0};  // bricks that hold a surface or can be cut
  std::vector<Candidate> candidates_;  // at hand, then those of the foot
  std::vector<CutFeature> features_;   // of those that no kept page of the cut's surface holds
  std::vector<PointList> point_lists_;
  std::vector<Source> sources_;
  std::vector<Known> known_;
  SeenVoxels insides_;                 // of the head's candidates
  std::vector<Face> faces_;
  /// Candidates of one broad-phase pass.
  struct CandidateList {
    explicit CandidateList(std::size_t room) : of(room + 1) {}
    std::vector<std::int32_t> of;  // and room for one more, so that there are pairs
    std::size_t count = 0;
    void add(std::int32_t i) noexcept { of[count++] = i; }
    void even() noexcept { of[count] = of[count > 0 ? count - 1 : 0]; }
    std::size_t operator[](std::size_t j) const noexcept { return static_cast<std::size_t>(of[j]); }
  };
  CandidateList broad_faces_, broad_edges_, broad_others_;
  std::vector<float> place_x_, place_y_, place_z_;  // in voxels from where they were gathered
  PlaneSet planes_;
  std::vector<Origin> origins_;        // of planes_
  Built built_;
  std::vector<std::int32_t> near_;     // candidates of built_
  std::vector<double> low_;            // mm: least distance of each of near_, near built_.at
  std::size_t count_ = 0, ball_count_ = 0, shank_count_ = 0;
  Gathered gathered_;                  // of the head, then of the neck and the shank
  /// Nothing stands within margin_mm of neck and shank; cutting only removes tissue.
  struct ShankFree {
    Vec3 centre{0.0}, axis{0.0};
    double margin_mm = -1.0;
    const Bur* bur = nullptr;
  };
  ShankFree shank_free_;
  FreeSpace free_;
  int free_pause_ = 0;                 // solves before find_free() is tried again
  std::uint64_t answered_free_ = 0;
  std::size_t most_candidates_ = 0;
  bool overflow_ = false;
  Budget budget_ = kExploring;
  int candidates_left_ = kExploring.candidates, passes_ = 0;
  std::int64_t visited_before_ = 0;
  bool all_resolved_ = true;           // no part near the bur is unresolved
  /// If valid, no part within kUnresolvedMarginMm of `at` is unresolved.
  struct UnresolvedFar {
    Vec3 at{0.0}, axis{0.0};
    const Bur* bur = nullptr;
    bool valid = false;
  };
  UnresolvedFar unresolved_far_;
  bool edges_ = false;                 // edges may be among the candidates at hand
  bool near_cut_ = false;              // a surface that a bur left is among those near
  /// Active set of this solve's last pass.
  struct ActiveSet {
    int plane[3] = {0, 0, 0};
    int count = 0;
  };
  ActiveSet active_set_;
  std::array<Vec3, CutMemory::kMost> past_;          // poses of the stroke's memory near the pose
  int past_count_ = 0;
  CutSurface cut_;
  FieldCells fields_;
  const Sweeps& sweeps_;
  CavityWalls walls_;
  KeptPlanes kept_planes_;
  PlaneSet scaled_;                    // planes_ in the metric of a pass in the cavity
  std::vector<double> scale_;
};

}  // namespace cusp::engine
