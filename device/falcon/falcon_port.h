/// The Falcon as a HapticPort, over any link. It paces the loop: wait() returns when the device has answered, one packet a
/// millisecond, at most two unanswered. If position or force cannot be trusted (unplugged, uploading, not homed, 10 ms of
/// silence, a line being drained), it reports Sample::gone: the loop holds at zero force until resumed. A sample is fresh
/// if its packet left within SessionTimes::fresh; torque leaves only in answer to a fresh sample.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "device/falcon/gravity.h"
#include "device/falcon/kinematics.h"
#include "device/falcon/link.h"
#include "device/falcon/reach.h"
#include "device/falcon/session.h"
#include "device/falcon/workspace.h"
#include "engine/base/haptic_port.h"
#include "engine/base/triple_buffer.h"

namespace cusp::device {

/// Function of each button; falcon::status bits, 0 for none.
struct FalconButtons {
  std::uint8_t cut = falcon::status::kCentre;
  std::uint8_t clutch = falcon::status::kForward;
  std::uint8_t next_bur = falcon::status::kPlus;
  std::uint8_t previous_bur = falcon::status::kMinus;
};

struct FalconSettings {
  falcon::SessionSettings session{};
  falcon::Geometry geometry{};
  falcon::Calibration calibration{};
  falcon::GravityCalibration gravity{};
  falcon::WorkspaceSettings workspace{};
  FalconButtons buttons{};
  std::uint16_t burs = 1;  // number of burs in the scene; the buttons count from Feedback::bur and stop at the ends
  std::string name = "Novint Falcon";
  std::string device_class = "falcon";
  double max_force_n = 4.4;             // at force_gain 1, in any direction, within 40 mm of the axis and z 0.080 to 0.170 m
  double max_stiffness_n_per_mm = 3.0;  // [M] CHAI3D's figure for a Falcon; a self-test may find less
  bool closed_loop = true;
  std::optional<double> damping_ns_per_m;  // of the device at the grip; none until measured [M]
  std::optional<double> delay_ms;          // round trip from motion to force; none until measured [M]
  std::optional<double> encoder_mm;        // coarsest step at the grip; published figures if not measured
  bool home_in_open = false;               // open() returns only when the user has homed the device
};

/// The driver's limits in the specimen's frame. A scale under 1 raises stiffness and damping there.
DeviceLimits limits_of(const FalconSettings& settings);

/// Plain values for a screen.
struct FalconView {
  falcon::SessionState session{};
  Vec3 grip_m{0.0};                      // last solved; meaningless before homing
  std::array<std::int16_t, 3> torque{};  // words of the last packet
  std::uint64_t unsolved = 0;            // readings without a solution of the kinematics
  std::uint64_t unreached = 0;           // positions too far from the last one for a hand: rejected
  bool clutched = false;
  bool by_port = false;                  // FalconLink::known_by_port()
};

class FalconPort final : public HapticPort {
 public:
  /// Replaces a `settings.workspace` out of range by the default.
  FalconPort(std::unique_ptr<falcon::FalconLink> link, const FalconSettings& settings = {});
  ~FalconPort() override;

  /// Not while the loop runs. The port keeps it for its life.
  void give_image(falcon::FirmwareImage image);
  /// Not while the loop runs. Why there is no image: open() fails with it if firmware must be loaded.
  void lack_image(PortFailure why) { no_image_ = std::move(why); }

  /// Blocks until the firmware answers: at once if it runs, some seconds with an upload, ten if no answer can be used, up to
  /// a minute if the loader does not answer. Homing follows in wait(), or here with home_in_open. not_found, no_permission, busy; bad_file
  /// "needs_image", or as lack_image(), if firmware must be loaded and none was given; io with the Trouble's key. `where`: the link's name.
  Result<void, PortFailure> open() override;
  /// Any thread. A running open() returns io "cancelled".
  void cancel() noexcept { cancelled_.store(true, std::memory_order_release); }

  /// Returns by `deadline`, and within 20 ms in any case. Looks for a lost device twice a second.
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override { return limits_of(settings_); }
  void close() noexcept override;

  /// One other thread. State after the last wait() or open().
  const FalconView& view() noexcept { return view_.read(); }
  /// Any thread; falcon::control bits, lit while ready.
  void set_leds(std::uint8_t leds) noexcept { leds_.store(leds, std::memory_order_relaxed); }
  /// Any thread, while no force is given: Calibration::force_gain from the next packet on.
  void set_force_gain(double gain) noexcept { force_gain_.store(gain, std::memory_order_relaxed); }

 private:
  void hand_over() noexcept;
  falcon::LinkEvent::Kind once(falcon::LinkTime until) noexcept;
  void catch_up() noexcept;
  bool answered(falcon::LinkTime now) const noexcept;
  Sample fresh() noexcept;
  void take_buttons(std::uint8_t bits) noexcept;
  void publish() noexcept;
  bool forcing() const noexcept;

  std::unique_ptr<falcon::FalconLink> link_;
  FalconSettings settings_;
  falcon::Session session_;
  std::optional<falcon::FirmwareImage> image_;
  std::optional<PortFailure> no_image_;
  falcon::Workspace workspace_;
  std::optional<falcon::Pose> pose_;  // newest accepted one; none if it cannot be trusted
  falcon::LinkTime pose_asked_{0};    // departure of the packet that it answers
  falcon::Reach reach_;
  Vec3 last_grip_m_ = falcon::kMiddleM;
  falcon::LinkTime due_{0};  // of the next packet
  std::uint64_t seen_replies_ = 0, unsolved_ = 0, unreached_ = 0;
  bool repeated_ = false;  // this period's packet left without a new force
  std::uint8_t next_ticks_ = 0, previous_ticks_ = 0;
  bool clutch_ = false;  // of the newest accepted position
  bool pressed_ = false;  // a button changed last_.bur since the last write()
  Sample last_;
  bool open_ = false;
  bool by_port_ = false;  // FalconLink::known_by_port(), since it was opened
  std::atomic<bool> cancelled_{false};
  std::atomic<double> force_gain_;
  std::atomic<std::uint8_t> leds_{falcon::control::kBlue};
  TripleBuffer<FalconView> view_;
};

}  // namespace cusp::device
