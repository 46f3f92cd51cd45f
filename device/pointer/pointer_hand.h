/// What the mouse and the keys ask for, handed from the UI thread to the haptic thread without a lock.
/// Every method: UI thread (one), wait-free. Millimetres in the specimen frame, newtons.
#pragma once

#include <cstdint>

#include "engine/base/triple_buffer.h"
#include "engine/base/vec.h"

namespace cusp::device {

/// One consistent wish. Values are finite and in range: PointerHand sees to it.
struct PointerWish {
  Vec3 target_mm{0.0};               // place that the pointer shows on the tooth
  Vec3 approach{0.0, 0.0, -1.0};     // unit; the way a push goes
  double push_n = 0;                 // 0 = let go: the bur lifts off
  bool cut = false;
  std::uint16_t bur = 0;
  Quat orientation{1.0, 0.0, 0.0, 0.0};  // by which the handpiece is turned from rest
};

class PointerHand {
 public:
  /// The most that a push may ask for; about three times a usual load on a handpiece (dental.md 3.3: about 1 N).
  static constexpr double kMaxPushN = 3.0;

  explicit PointerHand(Vec3 start_mm = Vec3(0.0));

  /// Slide to this place. Only the part across the approach moves a bur that touches; the part along it says how high
  /// a lifted bur hovers. Ignored when not finite.
  void move_to(Vec3 target_mm) noexcept;
  /// Slide by so many mm to the right and up as seen along the approach: for held keys, steps of speed * time.
  void nudge(double right_mm, double up_mm) noexcept;
  /// Newtons along the approach, cut to [0, kMaxPushN]. 0 lets go.
  void set_push(double push_n) noexcept;
  /// Lets go: push 0, and the bur lifts off. The cut button stays as it is.
  void lift() noexcept { set_push(0); }
  void set_cut(bool cut) noexcept;
  void set_bur(std::uint16_t bur) noexcept;
  /// Turns the handpiece by so many degrees, so that its shank leans to the right and up as seen along the approach; no
  /// further from rest than turn_limit_deg. For held keys, steps of speed * time.
  void turn(double right_deg, double up_deg) noexcept;
  /// Back to rest.
  void turn_back() noexcept;
  /// 0 to 60; what the exercise allows. 0, as at first: it stays.
  void set_turn_limit(double degrees) noexcept;
  double turned_deg() const noexcept;
  /// Which way a push goes, and which way is right on the screen. Refused (unchanged) when not finite, of no length, or
  /// parallel. Default: downward, x to the right.
  void set_view(Vec3 approach, Vec3 right) noexcept;

  const PointerWish& wish() const noexcept { return wish_; }

  /// Haptic thread. The newest wish.
  const PointerWish& latest() noexcept { return exchange_.read(); }

 private:
  void hand_over() noexcept { exchange_.write(wish_); }

  PointerWish wish_;
  Vec3 right_{1.0, 0.0, 0.0};  // unit, across the approach
  Vec3 up_{0.0, 1.0, 0.0};
  Vec3 turned_{0.0};           // about this, by its length in radians
  double turn_limit_ = 0.0;    // radians
  TripleBuffer<PointerWish> exchange_;
};

}  // namespace cusp::device
