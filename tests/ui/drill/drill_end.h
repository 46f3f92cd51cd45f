/// An attempt on the platform "offscreen" with a device that sinks into the tooth, and whose driver a test stops.
#pragma once

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <atomic>
#include <memory>
#include <thread>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/session/gate.h"
#include "ui/drill/drill_screen.h"
#include "ui/drill/stop_card.h"
#include "ui/widgets/gauge.h"

namespace cusp::test {

inline constexpr int kComesWithinMs = 60'000;  // waits for progress; a slow machine may take its time
inline constexpr int kShownWithinMs = 500;  // five looks between two of which texts and gauges change

/// What a device in the hand of a test sees and shows; the port reads it on the haptic thread.
struct Hand {
  std::atomic<bool> plugged{true};
  std::atomic<bool> pressed{true};  // its button
  std::atomic<double> aside_mm{0};  // where it holds the bur beside the middle
  std::atomic<bool> stuck{false};  // its driver does not come back
  std::atomic<bool> open{false};
  std::shared_ptr<Gate> opens{};   // its driver comes back from open() when this gate opens; null: at once
  std::atomic<double> force_n{0};  // as it was written last
  std::atomic<int> ticks{0};
};

/// Its button is pressed until a test releases it. It sinks through the channel of "channel-1" at 1 mm/s, so that it cuts for some seconds.
class SinkingPort final : public HapticPort {
 public:
  explicit SinkingPort(std::shared_ptr<Hand> hand) : hand_(std::move(hand)) {}
  Result<void, PortFailure> open() override {
    hand_->open = true;
    if (hand_->opens) hand_->opens->pass();
    return {};
  }
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    std::this_thread::sleep_until(deadline);
    ++hand_->ticks;
    hand_->stuck.wait(true);
    if (!hand_->plugged) return {};
    depth_mm_ = std::min(depth_mm_ + 0.001, kMostMm);
    const bool pressed = hand_->pressed;
    return {.status = Sample::Status::fresh,
            .position_mm = {hand_->aside_mm.load(), 0, kStartMm - depth_mm_},
            .buttons = static_cast<std::uint16_t>(pressed ? 1 : 0),
            .pedal = static_cast<std::uint16_t>(pressed ? 65535 : 0)};
  }
  bool over() const noexcept override { return false; }
  void write(const Feedback& feedback) noexcept override { hand_->force_n = glm::length(feedback.force_n); }
  DeviceLimits limits() const override {
    DeviceLimits out;
    out.name = "Sinking";
    out.device_class = "scripted";
    return out;
  }
  void close() noexcept override { hand_->open = false; }

 private:
  static constexpr double kStartMm = 1.5, kMostMm = 6.0;  // pivot of the bur; the block's top lies at 0
  std::shared_ptr<Hand> hand_;
  double depth_mm_ = 0;
};

class DrillEnd : public testing::Test {
 protected:
  DrillEnd() {
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked << question.act;
      more = question.more;
      pending = std::move(then);
    };
    screen = std::make_unique<DrillScreen>(ports);
    screen->resize(1280, 800);
    screen->show();
    screen->activateWindow();  // shortcuts are the active window's
  }
  ~DrillEnd() override {
    let_driver_go();
    screen.reset();
  }
  /// Returns who drills.
  Actor begin_recorded(DeskRecords& records) {
    SessionPlan kept = plan();
    kept.kind = SessionKind::practice;
    kept.database = records.file();
    kept.student = records.student("20267314", "Lena Brandt").actor();
    const Actor student = kept.student;
    begin(std::move(kept));
    return student;
  }
  void let_driver_go() {
    hand->stuck = false;
    hand->stuck.notify_all();
  }
  static SessionPlan plan(Guidance guidance = Guidance::full) {
    SessionPlan out;
    out.scenario = load_builtin("channel-1").value();
    out.scenario.specimen.voxel_mm = 0.2;  // an eighth of its voxels: what is tested here does not depend on them
    out.kind = SessionKind::try_it;
    out.guidance = guidance;
    return out;
  }
  void begin(SessionPlan plan) {
    screen->begin(std::move(plan), {QStringLiteral("Channel"), QStringLiteral("Practice")}, std::make_unique<SinkingPort>(hand));
    ASSERT_TRUE(QTest::qWaitForWindowActive(screen.get()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return removed() > 0.01; }, kComesWithinMs));
  }
  void answer(bool yes) {
    ASSERT_TRUE(pending);
    std::exchange(pending, nullptr)(yes);
  }
  double removed() const {
    for (const Bar* bar : screen->findChildren<Bar*>())
      if (bar->accessibleName() == QStringLiteral("Plastic")) return bar->share();
    return -1;
  }
  StopCard& card() const { return *screen->findChild<StopCard*>(); }
  bool card_shows(const char* text) const {
    for (const QLabel* label : card().findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(QLatin1String(text))) return true;
    return false;
  }
  bool wait_for_card(const char* text) const {
    return QTest::qWaitFor([&] { return card_shows(text); }, kComesWithinMs);
  }
  /// Visible; nullptr: none.
  static QPushButton* button(const QWidget& in, const char* name) {
    for (QPushButton* one : in.findChildren<QPushButton*>())
      if (one->isVisible() && one->accessibleName() == QLatin1String(name)) return one;
    return nullptr;
  }
  /// The device has sunk as deep as it goes, and the screen has looked.
  void let_it_come_to_rest() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return hand->ticks > 6'000; }, kComesWithinMs));
    let_it_run();
  }
  QString clock() const {
    for (const QLabel* label : screen->findChildren<QLabel*>())
      if (label->accessibleDescription() == QStringLiteral("Time")) return label->text();
    return {};
  }
  /// The loop has ticked and the screen has looked.
  void let_it_run() {
    const int until = hand->ticks + 300;
    ASSERT_TRUE(QTest::qWaitFor([&] { return hand->ticks > until; }, kComesWithinMs));
    QTest::qWait(kShownWithinMs);
  }
  /// Opens Finish's question, then Leave's, and answers both with Cancel.
  void cancel_both_questions() {
    screen->ask_finish();
    answer(false);
    let_it_run();
    screen->ask_leave();
    answer(false);
    let_it_run();
    EXPECT_EQ(asked, QStringList({QStringLiteral("Finish"), QStringLiteral("Leave")}));
  }

  Ports ports = Ports::of_the_system();
  QStringList asked;
  QString more;  // of the newest question
  std::function<void(bool)> pending;
  std::shared_ptr<Hand> hand = std::make_shared<Hand>();
  std::unique_ptr<DrillScreen> screen;
};

}  // namespace cusp::test
