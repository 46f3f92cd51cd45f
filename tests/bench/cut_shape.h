/// Blocks with known cuts: `cut` (one scratch or three crossing ones, explored by a smaller bur), the holes of
/// `channel`, and faces that change under a bur.
#pragma once

#include <memory>
#include <string_view>

#include "tests/bench/carved_truth.h"
#include "tests/bench/frame.h"
#include "tests/bench/shapes.h"

namespace cusp::bench {

/// An oblique face with capsules cut out of it. cut_along makes each cut in steps of 0.1 mm that join to one capsule.
class CutBlock : public Shape {
 public:
  double distance_mm(Vec3 p) const override { return frame_.to_local(p).z; }
  std::string key() const override { return "face"; }
  bool prepare(StepState& state) const override;
  std::unique_ptr<Truth> truth() const override { return std::make_unique<CarvedTruth>(block_, memory_); }
  const std::vector<Capsule>& capsules() const { return block_->capsules(); }

 protected:
  CutBlock(std::string name, double bur_radius_mm) : Shape(std::move(name), bur_radius_mm) {}
  /// capsules in the frame's own axes. thinner_mm: the bur's clearance against cuts.
  void carve(std::vector<Capsule> local, double thinner_mm);

  Frame frame_ = oblique_frame();
  std::shared_ptr<CarvedBlock> block_;
  std::shared_ptr<CarvedMemory> memory_ = std::make_shared<CarvedMemory>();
};

/// Scratches of a bur 1.5 times as wide, 0.3 to 0.6 bur radii deep. single: one scratch. crossing: three in a triangle,
/// with ridges where two cross.
enum class CutKind : std::uint8_t { single, crossing };
std::unique_ptr<Shape> make_cut(double bur_radius_mm, CutKind kind);

/// An islet on a neck of 0.4 mm between four slots.
std::unique_ptr<Shape> make_islet(double bur_radius_mm);

/// A face whose tissue disappears under a pressing bur.
class ChangingFace : public Shape {
 public:
  /// Removes the tissue. False: the volume has no room for the cut.
  virtual bool give_way(StepState& state) const = 0;
  /// The exact proxy before give_way.
  std::unique_ptr<Truth> truth() const override { return face_->truth(); }
  virtual std::unique_ptr<Truth> truth_after() const = 0;

  Vec3 tool_axis() const override { return face_->tool_axis(); }
  Vec3 home() const override { return face_->home(); }
  Leg leg(Random& random, const Vec3* from) const override { return face_->leg(random, from); }
  Vec3 before(Vec3 first) const override { return face_->before(first); }

 protected:
  ChangingFace(std::string name, double bur_radius_mm);
  const Shape& face() const { return *face_; }
  Frame frame_ = oblique_frame();

 private:
  std::unique_ptr<Shape> face_;
};

/// give_way cuts a hole of 1.6 mm at once.
class SuddenHole : public ChangingFace {
 public:
  explicit SuddenHole(double bur_radius_mm) : ChangingFace("sudden-hole", bur_radius_mm) {}
  bool give_way(StepState& state) const override;
  /// The exact proxy inside the hole, below its mouth.
  std::unique_ptr<Truth> truth_after() const override;

  std::string key() const override { return face().key(); }
  double distance_mm(Vec3 p) const override { return face().distance_mm(p); }
  double cutter_radius_mm() const override;
  Spot spot(Random& random) const override;
};

/// A plate of 0.5 mm with its top in the plane of the face, on a bridge to a block beside it.
class DetachablePlate : public ChangingFace {
 public:
  explicit DetachablePlate(double bur_radius_mm) : ChangingFace("fragment", bur_radius_mm) {}
  /// Cuts the bridge; the step then removes the fragment.
  bool give_way(StepState& state) const override;
  /// Empty space.
  std::unique_ptr<Truth> truth_after() const override;

  double distance_mm(Vec3 p) const override;
  double cutter_radius_mm() const override;
  Spot spot(Random& random) const override;
};

enum class HoleKind { straight, oblique, slot };
const char* name_of(HoleKind kind);

/// A hole of the bur's own width, by seed: 0.4 to 1.3 mm deep along its axis. straight: within 5 degrees of the face's
/// normal; oblique: 10 to 70 degrees; slot: oblique, across an older slot.
class Hole : public CutBlock {
 public:
  Hole(double bur_radius_mm, HoleKind kind, std::uint64_t seed, double thinner_mm);

  std::string variant() const override;
  Vec3 tool_axis() const override { return axis_; }
  Vec3 home() const override { return mouth_ + axis_ * 8.0; }
  double cutter_radius_mm() const override { return 0.0; }  // the bur cuts its own hole
  Spot spot(Random&) const override { return {bottom_, axis_}; }
  Leg leg(Random&, const Vec3*) const override;
  Vec3 before(Vec3) const override { return bottom_; }

  std::uint64_t seed() const { return seed_; }
  Vec3 axis() const { return axis_; }      // out of the hole
  Vec3 bottom() const { return bottom_; }  // centre of the bur at the end of its cut
  Vec3 outside() const { return mouth_ + axis_ * (3.0 * bur_radius_mm()); }
  Vec3 pull() const { return pull_; }  // 0.1 mm across

 private:
  HoleKind kind_;
  std::uint64_t seed_;
  Vec3 axis_{0.0}, bottom_{0.0}, mouth_{0.0}, pull_{0.0};
};

}  // namespace cusp::bench
