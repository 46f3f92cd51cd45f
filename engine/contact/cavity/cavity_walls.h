/// Constraints of a ball in what balls have cut. sample() looks for the surface in some hundred directions about the ball, and
/// on the ridges between them: each place found is a constraint. refine() goes from a place that holds the ball to the nearest
/// place of a wall, a ridge or a corner. held_by_sweep() answers alone where the ball stands in one sweep.
/// Frame: specimen, mm. Thread: haptic. Wait-free; the constructor takes all memory.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/contact/cavity/swept_void.h"
#include "engine/contact/solver/plane_search.h"

namespace cusp::engine {

/// n . y >= c keeps the ball off one feature, seen from the pose that it was built at.
struct CavityConstraint {
  Vec3 n{0.0};
  double c = 0.0;
  glm::dmat3 bend{0.0};  // minus the second derivative of the distance to the feature, 1/mm
  Vec3 foot{0.0};        // where the ball would touch
  Vec3 seen_from{0.0};   // the pose that it was built at
  bool seen = false;     // else the foot alone counts
  bool ended = false;    // its descent has reached the feature
  bool sampled = false;   // of a place, else of a feature
  std::int32_t from = 0;  // its number among these
};

class CavityWalls {
 public:
  /// sweeps outlives this.
  CavityWalls(const Volume& volume, const Sweeps& sweeps);

  /// What is asked for: a ball about `at`, everything within slack_mm of it.
  struct Ball {
    Vec3 at{0.0};
    double radius_mm = 0.0;  // less its clearance against cuts
    double slack_mm = 0.0;
  };
  /// True if build() would find any.
  bool near(const Volume& volume, const Ball& ball) noexcept;
  /// Builds the constraints.
  void build(const Volume& volume, const Ball& ball) noexcept;
  std::span<const CavityConstraint> constraints() const noexcept { return {constraints_.data(), count_}; }
  /// Whether a feature whose place jumps gives up its old place, which holds a ball as well.
  enum class Jump : std::uint8_t { replaces, keeps_both };
  /// Makes the feature that a constraint of the last build() is a place of, for a ball at `at`. The next build() has it.
  /// How far the ball is off it; negative: it enters. steps: most of its descent; kMostSteps reach its end.
  static constexpr int kMostSteps = 10;
  double refine(const Volume& volume, const Ball& ball, std::size_t constraint, Jump jump, int steps) noexcept;
  /// A ball that cuts may lie this far from the end of its sweep: its cut pose is tied to the proxy.
  static constexpr double kTieMm = 5e-3;
  /// Where one sweep alone holds a ball: it stands within what a ball as wide or wider has swept.
  struct Held {
    bool held = false;    // else that sweep alone does not answer
    Vec3 pose{0.0};       // nearest to the device along the sweep's way
    double gap_mm = 0.0;  // from there to the device; 0: nothing keeps the ball from it
    Vec3 n{0.0};          // unit, from the device to the pose
    Vec3 foot{0.0};       // of the sweep's wall, which nothing else has swept
  };
  /// Follows the sweep that holds the ball at ball.at towards the device.
  Held held_by_sweep(const Volume& volume, const Ball& ball, Vec3 device) noexcept;
  /// Poses near the ball where a ball at least as wide has cut: this one fits there too.
  std::span<const Vec3> past() const noexcept { return {past_, static_cast<std::size_t>(past_count_)}; }
  /// Moves a place out of what balls have carved about it and of `uncarved`, onto what is left; not by more than most_mm. False if
  /// there is nothing left so near.
  bool move_out(const Volume& volume, SweepRun uncarved, double most_mm, Vec3& place) noexcept;
  /// True if a sweep that is not carved holds a place.
  bool uncarved_holds(Vec3 place) const noexcept { return cutting_.any() && sweeps_.holds(cutting_.uncarved, place, SweptVoid::kTakenMm); }
  /// Pre: volume.has_cut(brick).
  const SweptVoid::Known& known(const Volume& volume, int brick) noexcept { return void_.known(volume, brick); }

  /// Voxels low..high (inclusive) have changed.
  void changed(const Volume& volume, IVec3 low, IVec3 high) noexcept {
    void_.changed(volume, low, high);
    release();
  }
  /// Discards every cache.
  void forget() noexcept {
    void_.forget();
    places_made_ = false;
    for (std::size_t i = 0; i < feature_count_; ++i) features_[i].seen = false;
  }
  /// To be called at each tick's begin. What was found last serves on where nothing has been cut since.
  void start(const Cutting& cutting) noexcept;
  /// Sweeps that are not carved have grown, or some were carved.
  void set_cutting(const Cutting& cutting) noexcept {
    if (cutting.end != cutting_.end) release();
    ++cuttings_;
    cutting_ = cutting;
  }
  const Cutting& cutting() const noexcept { return cutting_; }
  /// Nothing that was found serves on.
  void release() noexcept {
    sampled_ = {Vec3(0.0), 0.0, -1.0};
    feature_count_ = 0;
    places_made_ = true;
  }
  /// Keeps the features within slack_mm of the ball, at most kMostKept of them. To be called at the end of a search.
  void keep(const Ball& ball) noexcept;
  static constexpr std::size_t kMostKept = 24;
  /// How far a build() may reach from `ball` without looking for the surface anew; mm, negative where it has to.
  double room_mm(const Ball& ball) const noexcept;

  /// State: where the surface was looked for, and places of the features that were found.
  struct Found {
    Ball sampled{Vec3(0.0), 0.0, -1.0};
    std::int32_t features = 0;
    Vec3 foot[kMostKept]{};
  };
  Found found() const noexcept;
  void set_found(const Found& found) noexcept;
  /// Work since the last call, in units of 25 ns: for budgets.
  int take_work() noexcept { return std::exchange(work_, 0); }

 private:
  static constexpr std::size_t kMostFeatures = 48;
  static constexpr double kNoWayMm = 1e-9;      // nearer than this nothing has a direction
  static constexpr double kSeenMm = 2e-3;       // a feature is made anew when the ball has moved further
  static constexpr double kPlaceMetMm = 1e-3;   // a search for a place ends so near to it
  static constexpr double kLeastFacing = 0.1;   // cosine: a wall that faces less is seen edgewise
  static constexpr std::size_t kMostBetween = 256;  // places on ridges between others
  struct Place {
    Vec3 at{0.0};
    bool dropped = false;  // its feature stands for it
    Vec3 inwards{0.0};     // unit, out of what is left
    double curved = 0.0;   // of the wall about the ball, 1/mm
    Vec3 moved{0.0};       // by what was not carved at that time, of cuttings_
    std::uint32_t moved_for = 0;
  };
  using Side = Sweeps::Deepest;  // a surface at a place: what a run has swept, or the specimen's own without a sweep
  /// What a search for the nearest place of the surface stands at.
  struct Descent {
    Vec3 x{0.0};
    int active = 0;
    Side side[3];
    double curved = 1.0;  // half the second derivative of the squared distance along a ridge
    Vec3 along{0.0};      // the ridge's tangent
    bool arrived = false;
    bool in_void = false;
    bool at_rest = false;  // nowhere nearby is nearer
    bool ended = false;    // no further step brings it nearer
    // All that the cells on its way have named: one cell's names alone would let it go round in circles.
    static constexpr int kMostRuns = Sweeps::kMostRuns;
    SweepRun run[kMostRuns];
    IVec3 cell{1 << 30};
    int runs = 0;
    bool near_base = false;
    Side all[kMostRuns + 1];
    int sides = 0;
  };
  static PlaneSearch nearest_under(const Side* side, int sides, Vec3 wanted) noexcept;
  bool settle(const Volume& volume, Vec3 at, Descent& d) noexcept;
  bool to_surface(const Volume& volume, const Ball& ball, Descent& d) noexcept;
  void look(const Volume& volume, const Ball& ball) noexcept;
  void sample(const Volume& volume) noexcept;
  bool sample_at(const Volume& volume, Vec3 at) noexcept;
  void sample_between(const Volume& volume, const Place& a, const Place& b) noexcept;
  void note_nearby(std::int32_t sweep) noexcept;
  void find_past(const Volume& volume, const Ball& ball) noexcept;
  void note_past(const Ball& ball, std::int32_t sweep) noexcept;
  void add_feature(const Ball& ball, std::size_t i) noexcept;
  void add_place(const Ball& ball, std::int32_t i) noexcept;
  std::int32_t holder(const Ball& ball, std::int32_t about) const noexcept;
  bool along_way(const Ball& ball, Vec3 device, std::int32_t& sweep) const noexcept;
  void add_run(SweepRun run, Descent& d) const noexcept;
  Sweeps::Deepest deepest(const SweptRuns& runs, Vec3 x) const noexcept;
  bool add_runs(const Volume& volume, Descent& d) noexcept;
  int sides_at(const Volume& volume, const Descent& d, Side* out) noexcept;
  void descend(const Volume& volume, const Ball& ball, int steps, Descent& d) noexcept;
  struct Step {
    Vec3 whole{0.0};    // under the sides that hold the place
    Vec3 to_wall{0.0};  // up to where another side takes over
  };
  bool step_of_descent(const Ball& ball, Descent& d, Step& step) const noexcept;
  static Vec3 up_to_wall(Vec3 from, Vec3 further, const PlaneSearch& found, const Descent& d) noexcept;
  double most_gain(const Ball& ball, const Descent& d, Vec3 step) const noexcept;
  struct Tried {
    double gain_mm = 0.0;  // so much nearer; without it the place has not moved
    double share = 0.0;    // of the step, which may gain
  };
  Tried try_step(const Volume& volume, const Ball& ball, Vec3 step, Descent& d) noexcept;
  double depth_of(std::int32_t sweep, Vec3 x, const Side* known, int count) const noexcept;
  CavityConstraint constraint_of(const Ball& ball, const Descent& d) const noexcept;

  const Sweeps& sweeps_;
  SweptVoid void_;
  double voxel_mm_;
  Ball sampled_{Vec3(0.0), 0.0, -1.0};  // where the surface was looked for; a negative slack: nowhere
  bool places_made_ = true;   // places_ are those of sampled_
  std::vector<Place> places_;
  Cutting cutting_;
  std::uint32_t cuttings_ = 0;  // times that the cutting may have changed
  std::vector<std::int16_t> place_at_;  // [direction]: of places_; -1: none
  std::vector<CavityConstraint> features_;
  std::vector<CavityConstraint> constraints_;
  std::size_t place_count_ = 0, feature_count_ = 0, count_ = 0;
  static constexpr int kMostPast = 24;  // both ends of twelve sweeps
  Vec3 past_[kMostPast];
  static constexpr int kMostNearby = 24;
  std::int32_t nearby_[kMostNearby];  // sweeps
  int nearby_count_ = 0;
  int past_count_ = 0;
  std::int32_t past_sweep_[kMostPast / 2];
  Sweep past_way_[kMostPast / 2];  // of past_sweep_
  int past_sweeps_ = 0;
  int work_ = 0;
};

}  // namespace cusp::engine
