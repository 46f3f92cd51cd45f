/// Profile of revolution of a bur's cutting head: a convex solid about the axis, given by its outline in the half
/// plane. t is along the axis towards the shank, rho >= 0 across it. The outline goes from the tip's pole to the upper
/// one in straight lines and arcs. A profile's origin is the bur's pivot. Lengths in mm.
/// Any thread; wait-free. Only + - * / sqrt: the step uses it.
#pragma once

#include <array>
#include <span>

#include "engine/base/vec.h"

namespace cusp::engine {

/// A point of the half plane.
struct OnHalf {
  double t = 0.0, rho = 0.0;
  friend bool operator==(const OnHalf&, const OnHalf&) = default;
};

/// A piece of an outline: straight for radius 0, else the arc about `centre` between its ends, bulging outwards.
struct OutlinePiece {
  OnHalf from, to;
  OnHalf centre;
  double radius = 0.0;
  friend bool operator==(const OutlinePiece&, const OutlinePiece&) = default;
};

/// A line that the solid touches and does not cross: normal (unit, outwards) . place - level is never above the distance.
struct SupportLine {
  OnHalf normal;
  double level = 0.0;
};

class Profile {
 public:
  static constexpr int kMostPieces = 8, kMostOfPiece = 9;  // support lines of a piece

  /// None: the bur is a ball about its pivot.
  Profile() = default;
  bool ball() const noexcept { return count_ == 0; }
  int size() const noexcept { return count_; }
  const OutlinePiece& piece(int i) const noexcept { return pieces_[static_cast<std::size_t>(i)]; }
  /// Adds the next piece from the tip. False, and unchanged, if the profile is full or closed, or if the piece does not
  /// begin at the last one's end. False, too, if the solid would not be convex.
  bool add(const OutlinePiece& piece) noexcept;
  /// True if the outline begins and ends on the axis and encloses a volume.
  bool closed() const noexcept;

  double low() const noexcept { return low_; }    // of t
  double high() const noexcept { return high_; }
  double widest() const noexcept { return wide_; }  // of rho
  /// Radius of the ball about the pivot that contains the head.
  double reach() const noexcept { return reach_; }

  /// Signed distance of a place to the solid, negative inside, and its gradient (unit). Exact: a convex solid's nearest
  /// point lies in the same half plane. Ties (on the axis, on a ridge inside) go to the lowest piece. Pre: closed().
  double distance(OnHalf at, OnHalf& gradient) const noexcept;

  /// Least radius of curvature of the solid, its edges left out; 0 where it has a point.
  double least_radius() const noexcept { return sharpest_; }
  /// True if pieces i and i + 1 meet in an edge.
  bool edge(int i) const noexcept;
  /// The nearest edge between two pieces within `far` of a place of the outline. False if there is none.
  bool rim(OnHalf at, double far, OnHalf& out) const noexcept;

  /// The point of the solid furthest along `direction` (unit; rho component >= 0). If a whole flat end or straight
  /// flank is furthest, its point nearest to `near`. Pre: closed().
  OnHalf support(OnHalf direction, OnHalf near) const noexcept;

  /// Lines about the outline, which leave it by at most kOffArcMm (a wide arc by more).
  static constexpr double kOffArcMm = 0.02;
  std::span<const SupportLine> support_lines() const noexcept { return {lines_.data(), static_cast<std::size_t>(line_count_)}; }

  friend bool operator==(const Profile& a, const Profile& b) noexcept {
    if (a.count_ != b.count_) return false;
    for (int i = 0; i < a.count_; ++i)
      if (!(a.piece(i) == b.piece(i))) return false;
    return true;
  }

 private:
  /// A piece's outward normals at its ends, alike for a straight one.
  struct Side {
    OnHalf first, last;
    double level = 0.0;   // of a straight piece: its normal times any point of it
    double length = 0.0;  // of a straight piece
  };
  /// Distance of a place to an arc's circle, and its outward normal. above: the nearest point lies on the arc.
  static double arc_distance(const OutlinePiece& piece, const Side& side, OnHalf at, OnHalf& normal, bool& above) noexcept;
  void add_lines(const OutlinePiece& piece, const Side& side) noexcept;

  std::array<OutlinePiece, kMostPieces> pieces_{};
  std::array<Side, kMostPieces> sides_{};
  std::array<SupportLine, static_cast<std::size_t>(kMostPieces * kMostOfPiece)> lines_{};
  int count_ = 0, line_count_ = 0;
  double sharpest_ = 1e9;
  double low_ = 0.0, high_ = 0.0, wide_ = 0.0, reach_ = 0.0;
};

}  // namespace cusp::engine
