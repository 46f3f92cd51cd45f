/// Requests of mouse and keys, passed from the UI thread to the haptic thread without a lock.
/// Every method: UI thread (one), wait-free. Millimetres in the specimen frame, newtons.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "engine/base/triple_buffer.h"
#include "engine/base/vec.h"

namespace cusp::device {

/// One consistent request. PointerHand keeps all values finite and in range.
struct PointerWish {
  Vec3 target_mm{0.0};               // point on the tooth under the pointer
  Vec3 approach{0.0, 0.0, -1.0};     // unit; direction of a push
  double push_n = 0;                 // 0 = released: the bur lifts off
  bool cut = false;
  // Heights of the bur's pivot along the approach, mm; +infinity: none.
  double floor_mm = std::numeric_limits<double>::infinity();  // a push that sweeps goes no deeper, one that rests waits there
  double stop_mm = std::numeric_limits<double>::infinity();   // no push goes deeper
  std::uint16_t bur = 0;
  Quat orientation{1.0, 0.0, 0.0, 0.0};  // rotation of the handpiece from rest
};

class PointerHand {
 public:
  /// Largest push, N; about three times a usual load on a handpiece (dental.md 3.3: about 1 N).
  static constexpr double kMaxPushN = 3.0;

  explicit PointerHand(Vec3 start_mm = Vec3(0.0));

  /// Slides to this point. In contact only the part across the approach moves the bur; the part along it sets the height of
  /// a lifted bur. Ignored if not finite.
  void move_to(Vec3 target_mm) noexcept;
  /// Slides by so many mm to the right and up as seen along the approach: for held keys, steps of speed * time.
  void nudge(double right_mm, double up_mm) noexcept;
  /// Newtons along the approach, limited to [0, kMaxPushN]. 0 releases.
  void set_push(double push_n) noexcept;
  /// Releases: push 0, and the bur lifts off. The cut button keeps its state.
  void lift() noexcept { set_push(0); }
  void set_cut(bool cut) noexcept;
  /// Pivot of a bur that stands on the floor of the target. While the pointer sweeps, a push goes no deeper; under a
  /// pointer that rests it waits there, and sinks on. nullopt: no floor. Ignored if not finite.
  void set_floor(const std::optional<Vec3>& pivot_mm) noexcept;
  /// Holds the depth: no push takes the bur's pivot beyond this place along the approach. nullopt: no longer. Ignored if not finite.
  void hold_depth(const std::optional<Vec3>& pivot_mm) noexcept;
  void set_bur(std::uint16_t bur) noexcept;
  /// Turns the handpiece by so many degrees: its shank leans to the right and up as seen along the approach, at most
  /// turn_limit_deg from rest. For held keys, steps of speed * time.
  void turn(double right_deg, double up_deg) noexcept;
  /// Back to rest.
  void turn_back() noexcept;
  /// Degrees from 0 to 60, as the exercise allows; 0 by default.
  void set_turn_limit(double degrees) noexcept;
  double turned_deg() const noexcept;
  /// Direction of a push, and the screen's right. Ignored if not finite, of zero length, or parallel. Default: downward, x
  /// to the right.
  void set_view(Vec3 approach, Vec3 right) noexcept;

  const PointerWish& wish() const noexcept { return wish_; }

  /// Thread: haptic. The newest request.
  const PointerWish& latest() noexcept { return exchange_.read(); }

 private:
  void hand_over() noexcept { exchange_.write(wish_); }
  void set_height(double& height_mm, const std::optional<Vec3>& pivot_mm) noexcept;

  PointerWish wish_;
  Vec3 right_{1.0, 0.0, 0.0};  // unit, across the approach
  Vec3 up_{0.0, 1.0, 0.0};
  Vec3 turned_{0.0};           // rotation vector, radians
  double turn_limit_ = 0.0;    // radians
  TripleBuffer<PointerWish> exchange_;
};

}  // namespace cusp::device
