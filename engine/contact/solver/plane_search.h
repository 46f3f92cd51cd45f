/// Closest admissible point: min |y - q|^2 with n_i . y >= c_i, in three dimensions, at most three planes active.
/// Dual active set (Goldfarb and Idnani 1983): starts at q, adds the most violated plane, drops those that pull.
/// Wait-free, bounded; ties go to the lowest index. Units as given (mm). Thread: haptic.
#pragma once

#include <span>
#include <vector>

#include "engine/base/lanes.h"
#include "engine/base/vec.h"

namespace cusp::engine {

struct Plane {
  Vec3 n{0.0};           // unit, out of the tissue
  double c = 0.0;        // n . y >= c is admissible
};

struct PlaneSearch {
  Vec3 y{0.0};
  int active = 0;              // number of active planes, at most 3
  int index[3] = {0, 0, 0};    // into the span given
  double weight[3] = {0, 0, 0};// multipliers: y - q = sum weight * n
  bool feasible = true;
};

/// tolerance_mm: a plane counts as violated below -tolerance.
PlaneSearch closest_point(Vec3 q, std::span<const Plane> planes, double tolerance_mm) noexcept;

/// Many planes, in arrays for two at a time. Room is taken at construction.
class PlaneSet {
 public:
  explicit PlaneSet(std::size_t room) : nx_(room + 3), ny_(room + 3), nz_(room + 3), c_(room + 3) {}
  void clear() noexcept { count_ = 0; }
  /// Pre: size() < room.
  void add(Vec3 n, double c) noexcept {
    nx_[count_] = n.x;
    ny_[count_] = n.y;
    nz_[count_] = n.z;
    c_[count_++] = c;
  }
  std::size_t size() const noexcept { return count_; }
  Vec3 n(std::size_t i) const noexcept { return {nx_[i], ny_[i], nz_[i]}; }
  double c(std::size_t i) const noexcept { return c_[i]; }
  void set_c(std::size_t i, double c) noexcept { c_[i] = c; }
  void set(std::size_t i, Vec3 n, double c) noexcept {
    nx_[i] = n.x;
    ny_[i] = n.y;
    nz_[i] = n.z;
    c_[i] = c;
  }
  double slack(std::size_t i, Vec3 y) const noexcept { return nx_[i] * y.x + ny_[i] * y.y + nz_[i] * y.z - c_[i]; }
  /// Index of the plane that y violates most, by more than tolerance; the lowest of equals; -1 when none.
  int worst(Vec3 y, double tolerance_mm) const noexcept;
  /// c of planes from..to - 1 lowered to what each of the places satisfies with slack_mm to spare; calls relaxed(i)
  /// for those. May(i): whether a plane may be.
  template <class May, class Relaxed>
  void recede_to(std::span<const Vec3> places, double slack_mm, std::size_t from, std::size_t to, May&& may,
                 Relaxed&& relaxed) noexcept {
    if (places.empty()) return;
    for (std::size_t i = from; i < to; i += 2) {
      const Pair nx = load_pair(&nx_[i]), ny = load_pair(&ny_[i]), nz = load_pair(&nz_[i]), c = load_pair(&c_[i]);
      Pair least = c;
      for (const Vec3& p : places) {
        const Pair reached = nx * p.x + ny * p.y + nz * p.z - slack_mm;
        least = reached < least ? reached : least;
      }
      const unsigned lower = bits_of(least < c);
      for (std::size_t k = 0; k < 2 && i + k < to; ++k) {
        if ((lower >> k & 1) == 0 || !may(i + k)) continue;
        c_[i + k] = least[k];
        relaxed(i + k);
      }
    }
  }

 private:
  std::vector<double> nx_, ny_, nz_, c_;
  std::size_t count_ = 0;
};

/// As above. `start`: planes thought to be active (of an earlier search of much the same planes), at most 3; the answer
/// is the same, it is only found sooner.
PlaneSearch closest_point(Vec3 q, const PlaneSet& planes, double tolerance_mm, std::span<const int> start) noexcept;

}  // namespace cusp::engine
