/// The Falcon as a device of the haptic loop, over any link. It paces the loop: wait() returns when the device has
/// answered, one packet a millisecond, at most two unanswered. Sample::gone whenever its place or its force cannot be
/// trusted (unplugged, uploading, not homed, 10 ms of silence, a line that is drained): the loop then holds at zero
/// force, and resuming re-arms. A sample is fresh if the packet that asked for it left within SessionTimes::fresh; a
/// torque leaves only if the sample that it answers is.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "device/falcon/gravity.h"
#include "device/falcon/kinematics.h"
#include "device/falcon/link.h"
#include "device/falcon/reach.h"
#include "device/falcon/session.h"
#include "device/falcon/workspace.h"
#include "engine/base/haptic_port.h"
#include "engine/base/triple_buffer.h"

namespace cusp::device {

/// Which button does what; falcon::status bits, 0 for none.
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
  std::uint16_t burs = 1;  // how many the scene has; the buttons stop at the ends
  std::string name = "Novint Falcon";
  std::string device_class = "falcon";
  double max_force_n = 4.4;             // in any direction, anywhere within 40 mm of the axis and z 0.080 to 0.170 m
  double max_stiffness_n_per_mm = 3.0;  // [M] CHAI3D's figure for a Falcon; a self-test may say less
  bool closed_loop = true;
  std::optional<double> damping_ns_per_m;  // of the device at the grip; known of no Falcon until it is measured [M]
  std::optional<double> delay_ms;          // from motion to force, there and back; likewise [M]
  std::optional<double> encoder_mm;        // coarsest step at the grip; published figures where it was not measured
  bool home_in_open = false;               // open() returns once it is homed, however long the hand takes
};

/// What such a driver tells a scene. Stiffness and damping as the specimen's frame sees them: with a scale under 1 more of
/// both.
DeviceLimits limits_of(const FalconSettings& settings);

/// What a screen may want to know; plain values.
struct FalconView {
  falcon::SessionState session{};
  Vec3 grip_m{0.0};                      // last solved; of no meaning before homing
  std::array<std::int16_t, 3> torque{};  // words of the last packet
  std::uint64_t unsolved = 0;            // readings that no place of the grip has
  std::uint64_t unreached = 0;           // places that no hand can have reached: not believed
  bool clutched = false;
};

class FalconPort final : public HapticPort {
 public:
  /// `settings.workspace` out of range is taken as the default workspace.
  FalconPort(std::unique_ptr<falcon::FalconLink> link, const FalconSettings& settings = {});
  ~FalconPort() override;

  /// Not while the loop runs. Kept for this port's life.
  void give_image(falcon::FirmwareImage image);

  /// Until firmware answers: at once where it runs already, some seconds with an upload, up to a minute where nothing
  /// says hello. Homing comes later, in wait(). not_found, no_permission, busy; bad_file "needs_image" when firmware
  /// has to be loaded and none was given; io with the Trouble's key. `where` is the link's name. With home_in_open it
  /// ends in `ready`, or when the device is lost.
  Result<void, PortFailure> open() override;
  /// Any thread: an open() under way returns io "cancelled".
  void cancel() noexcept { cancelled_.store(true, std::memory_order_release); }

  /// Returns by `deadline`, and within 20 ms whatever that is. Looks for a lost device twice a second by itself.
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override;
  void write(const Feedback& feedback) noexcept override;
  DeviceLimits limits() const override { return limits_of(settings_); }
  void close() noexcept override;

  /// One other thread: what the last wait() or open() left.
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
  falcon::Workspace workspace_;
  std::optional<falcon::Pose> pose_;  // newest that is believed; none when it cannot be trusted
  falcon::LinkTime pose_asked_{0};    // when the packet left that told of it
  falcon::Reach reach_;
  Vec3 last_grip_m_ = falcon::kMiddleM;
  falcon::LinkTime due_{0};  // of the next packet
  std::uint64_t seen_replies_ = 0, unsolved_ = 0, unreached_ = 0;
  bool repeated_ = false;  // this period's packet went out without a new force
  std::uint8_t next_ticks_ = 0, previous_ticks_ = 0;
  bool clutch_ = false;  // of the newest place that was believed
  Sample last_;
  bool open_ = false;
  std::atomic<bool> cancelled_{false};
  std::atomic<double> force_gain_;
  std::atomic<std::uint8_t> leds_{falcon::control::kBlue};
  TripleBuffer<FalconView> view_;
};

}  // namespace cusp::device
