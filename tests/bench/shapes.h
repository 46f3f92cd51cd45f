/// The shapes that methods are measured on. Each has a closed form, stands obliquely to the grid and gives the motions of
/// a bur on it. Frame: specimen. Unit: mm.
///
/// Grid: 128^3 voxels in 10 mm at a voxel of 10/128 mm; at any other size as many as 10 mm need, more where a shape
/// with its band and four empty voxels on every side would not fit. The shape ends where the padding begins.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/step/step.h"
#include "tests/bench/truth.h"
#include "tests/modules.h"
#include "tests/random.h"

namespace cusp::bench {

using test::Random;

inline constexpr double kDepthMm = 0.3;  // of the device point below the offset surface

/// Start of a press: a touching centre of the bur and the outward normal.
struct Spot {
  Vec3 centre{0.0};
  Vec3 normal{0.0};
};

/// One leg of a slide: device points by travelled length.
struct Leg {
  double length_mm = 0.0;
  std::function<Vec3(double)> at;
};

class Shape {
 public:
  Shape(std::string name, double bur_radius_mm) : name_(std::move(name)), radius_(bur_radius_mm) {}
  virtual ~Shape() = default;

  const std::string& name() const { return name_; }
  double bur_radius_mm() const { return radius_; }
  /// Of a cut: single, crossing, drilled; of a channel: straight, oblique, slot; else empty.
  virtual std::string variant() const { return {}; }
  /// Two shapes with the same key have the same tissue before any cut.
  virtual std::string key() const { return name_; }

  /// Signed distance of the tissue before any cut, negative inside; exact wherever a band can reach.
  virtual double distance_mm(Vec3 p) const = 0;
  /// Of the place, before any cut.
  virtual Tissue tissue(Vec3) const { return Tissue::dentine; }
  /// True: every voxel of the grid is tissue.
  virtual bool fills_grid() const { return false; }
  /// Half edge of the cube about the origin that must hold tissue and its band; 0: as much as 10 mm give.
  virtual double half_mm() const { return 0.0; }
  /// Thickness of the thinnest feature; 0: none that matters.
  virtual double thinnest_mm() const { return 0.0; }
  /// Smallest radius of curvature; 0: flat or sharp.
  virtual double least_radius_mm() const { return 0.0; }
  bool unresolved(double voxel_mm) const {
    return (thinnest_mm() > 0.0 && thinnest_mm() < 2.5 * voxel_mm) ||
           (least_radius_mm() > 0.0 && least_radius_mm() < 3.0 * voxel_mm);
  }

  /// Unit, from the ball to the shank: away from the tissue.
  virtual Vec3 tool_axis() const = 0;
  /// A centre far above the shape, with free straight lines to just above every spot.
  virtual Vec3 home() const = 0;

  /// Bur that cuts (cut, channel), as a second one in Scene::burs; 0: none.
  virtual double cutter_radius_mm() const { return 0.0; }
  /// Its head; none: a ball.
  virtual std::optional<Profile> cutter_head() const { return {}; }
  /// Makes the shape's cuts in a fresh state. False: the volume has no room.
  virtual bool prepare(StepState&) const { return true; }

  virtual std::unique_ptr<Truth> truth() const = 0;

  /// A random place to press.
  virtual Spot spot(Random& random) const = 0;
  /// The next leg from `from`, the end of the last one; nullptr: the first leg. The first point lies kDepthMm below the
  /// offset surface unless the leg crosses an edge.
  virtual Leg leg(Random& random, const Vec3* from) const = 0;
  /// An admissible centre from which a straight line leads into the first point of a slide.
  virtual Vec3 before(Vec3 first) const = 0;

 private:
  std::string name_;
  double radius_;
};

/// nullptr for another name, and for channel, whose holes channel.h makes. variant: of a cut, single unless it says
/// crossing or drilled.
std::unique_ptr<Shape> make_shape(std::string_view name, double bur_radius_mm, std::string_view variant = {});

/// The specimen of a shape, built at first use; a few are kept.
std::shared_ptr<const Specimen> specimen_of(const Shape& shape, double voxel_mm, Reading reading);

/// A scene with the shape's specimen: K 1 N/mm everywhere, friction off, a guard that stays out of the way; the bur
/// with a neck and a shank of 0.4 of its radius, along the shape's axis.
std::shared_ptr<Scene> scene_of(const Shape& shape, Method method, double voxel_mm);

}  // namespace cusp::bench
