/// A tissue boundary as straight segments in a plane, endless along the third axis, and its offset curve, which the
/// centre of a bur of radius r cannot cross: offset segments, arcs about outer corners, trimmed at inner corners.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace cusp::bench {

using Vec2 = glm::dvec2;

class PlaneProfile {
 public:
  /// Corners from left to right, tissue to the right of the direction of travel; the first and last lie far outside.
  PlaneProfile(std::vector<Vec2> corners, double radius_mm);

  double distance_mm(Vec2 p) const;  // signed, negative in tissue, exact

  /// A place on the offset curve.
  struct On {
    std::size_t segment = 0;
    Vec2 at{0.0};
    Vec2 normal{0.0};  // out of the tissue
  };
  On nearest(Vec2 q) const;
  /// Downhill from `on` towards q along the curve: the local minimum of the distance to q.
  On slide(On on, Vec2 q) const;

  struct Segment {
    bool arc = false;
    Vec2 a{0.0}, b{0.0};          // ends
    Vec2 normal{0.0};             // of a straight segment
    Vec2 middle{0.0};             // of an arc, clockwise from a to b
    double from = 0.0, to = 0.0;  // its angles, falling
  };
  const std::vector<Segment>& segments() const { return segments_; }

 private:
  On foot(std::size_t segment, Vec2 q, Vec2 from) const;
  enum class End : std::uint8_t { start, end };
  bool downhill(const Segment& segment, End end, Vec2 q) const;

  std::vector<Vec2> corners_;
  double radius_;
  std::vector<Segment> segments_;
};

}  // namespace cusp::bench
