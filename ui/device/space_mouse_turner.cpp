#include "ui/device/space_mouse_turner.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/view/tooth_view.h"

namespace cusp::ui {

namespace {

constexpr int kTurnMs = 16;            // as often as the device speaks
constexpr int kIdleMs = 100;           // while it is not there, or nobody sees the view
constexpr double kLongestS = 0.1;      // after a stall the view continues, it does not leap
constexpr double kTurnRadS = std::numbers::pi / 2;
constexpr double kMoveShareS = 0.5;    // of the view's shorter side
constexpr double kMoveMmS = 20.0;      // of the mirror
constexpr double kSidePx = 1000.0;     // moves are shares: any length will do
constexpr std::uint32_t kLeft = 1, kRight = 2;

}  // namespace

Camera led(const Camera& camera, const hid::SpaceMouseMotion& motion, double speed, double dt_s) {
  Camera out = camera;
  const double s = speed * dt_s;
  // What the hand does to the cap, the tooth does: pushed right, it goes right; pulled to the user, it comes nearer.
  out.orbit(-motion.turn[1] * kTurnRadS * s, motion.turn[0] * kTurnRadS * s);
  out.pan(kMoveShareS * kSidePx * s * glm::dvec2(motion.move[0], -motion.move[1]), kSidePx);
  if (motion.move[2] != 0.0) out.zoom(std::exp(motion.move[2] * s));
  return out;
}

MouthMirror led(const MouthMirror& mirror, const Camera& camera, const hid::SpaceMouseMotion& motion, double speed, double dt_s) {
  const double s = speed * dt_s;
  const MouthMirror there = moved(mirror, camera, kMoveMmS * s * Vec3(motion.move[0], motion.move[1], -motion.move[2]));
  return turned(there, camera, kTurnRadS * s * glm::dvec2(motion.turn[1], motion.turn[0]));
}

SpaceMouseTurner::SpaceMouseTurner(ToothView& view, hid::SpaceMouseReader& reader)
    : QObject(&view), view_(view), reader_(reader) {
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &SpaceMouseTurner::look);
  timer_.start(kIdleMs);
}

void SpaceMouseTurner::look() {
  const auto now = std::chrono::steady_clock::now();
  const bool seen = view_.isVisible() && view_.window()->isActiveWindow();
  const hid::SpaceMouseView latest = seen ? reader_.view(now) : hid::SpaceMouseView{};
  if (!latest.connected) {
    if (timer_.interval() != kIdleMs) timer_.setInterval(kIdleMs);
    before_ = now;
    buttons_ = 0;
    return;
  }
  if (timer_.interval() != kTurnMs) timer_.setInterval(kTurnMs);
  const double dt_s = std::min(std::chrono::duration<double>(now - before_).count(), kLongestS);
  before_ = now;
  const std::uint32_t pressed = latest.motion.buttons & ~buttons_;
  buttons_ = latest.motion.buttons;
  if ((pressed & kRight) != 0) Q_EMIT mirror_asked();
  if ((pressed & kLeft) != 0 && first_) view_.set_camera(*first_);
  if (latest.motion.still()) return;
  Q_EMIT moved();
  if (const auto& mirror = view_.scene().mirror) {
    view_.set_mirror(led(*mirror, view_.camera(), latest.motion, reader_.settings().speed, dt_s));
    return;
  }
  if (!first_) first_ = view_.camera();
  view_.set_camera(led(view_.camera(), latest.motion, reader_.settings().speed, dt_s));
}

}  // namespace cusp::ui
