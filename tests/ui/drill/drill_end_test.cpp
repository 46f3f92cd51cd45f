// How an attempt stands and ends on the platform "offscreen": open questions, a lost device, a record that is refused.
#include "tests/modules.h"
#include "ui/drill/drill_screen.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <atomic>
#include <thread>

#include "scenarios/library/library.h"
#include "storage/sqlite/database.h"
#include "tests/refused_rows.h"
#include "tests/ui/desk_records.h"
#include "tests/ui/session/gate.h"
#include "ui/drill/stop_card.h"
#include "ui/session/background_task.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/gauge.h"

namespace cusp::test {
namespace {

constexpr int kComesWithinMs = 60'000;  // waits for progress; a slow machine may take its time
constexpr int kShownWithinMs = 500;  // five looks between two of which texts and gauges change

/// What a device in the hand of a test sees and shows; the port reads it on the haptic thread.
struct Hand {
  std::atomic<bool> plugged{true};
  std::atomic<bool> stuck{false};  // its driver does not come back
  std::atomic<bool> open{false};
  std::shared_ptr<Gate> opens{};   // its driver comes back from open() when this gate opens; null: at once
  std::atomic<double> force_n{0};  // as it was written last
  std::atomic<int> ticks{0};
};

/// Its button is pressed. It sinks through the channel of "channel-1" at 1 mm/s, so that it cuts for some seconds.
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
    depth_mm_ = std::min(depth_mm_ + 0.001, 6.0);
    return {.status = Sample::Status::fresh, .position_mm = {0, 0, kStartMm - depth_mm_}, .buttons = 1, .pedal = 65535};
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
  static constexpr double kStartMm = 1.5;  // pivot of the bur; the block's top lies at 0
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

TEST_F(DrillEnd, cancelling_a_question_leaves_a_paused_attempt_paused) {
  begin(plan());
  screen->toggle_pause();
  ASSERT_TRUE(wait_for_card("Paused"));
  const QString stood_at = clock();
  cancel_both_questions();
  EXPECT_TRUE(card_shows("Paused"));
  EXPECT_EQ(clock(), stood_at);
  EXPECT_EQ(hand->force_n, 0);
}

TEST_F(DrillEnd, cancelling_a_question_gives_no_force_to_a_device_that_came_back) {
  begin(plan());
  hand->plugged = false;
  ASSERT_TRUE(wait_for_card("does not answer"));
  hand->plugged = true;
  ASSERT_TRUE(wait_for_card("answers again"));
  cancel_both_questions();
  EXPECT_TRUE(card_shows("answers again"));
  EXPECT_EQ(hand->force_n, 0);
}

TEST_F(DrillEnd, a_device_that_was_lost_during_a_question_waits_for_resume) {
  begin(plan());
  screen->ask_finish();
  hand->plugged = false;
  ASSERT_TRUE(wait_for_card("does not answer"));
  hand->plugged = true;
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card_shows("does not answer"); }, kComesWithinMs));
  answer(false);
  ASSERT_TRUE(wait_for_card("Paused"));
  EXPECT_EQ(hand->force_n, 0);
  button(card(), "Resume")->click();
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, cancelling_a_question_continues_an_attempt_that_ran) {
  begin(plan());
  screen->ask_finish();
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n == 0; }, kComesWithinMs));
  answer(false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, an_attempt_whose_driver_stands_still_is_not_finished) {
  begin(plan());
  hand->stuck = true;
  ASSERT_TRUE(wait_for_card("driver of the device"));
  EXPECT_EQ(button(card(), "Resume"), nullptr);
  screen->ask_finish();
  EXPECT_TRUE(asked.isEmpty()) << "it would be graded without what the driver still holds";
  let_driver_go();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !card_shows("driver of the device"); }, kComesWithinMs));
  screen->ask_finish();
  EXPECT_EQ(asked, QStringList({QStringLiteral("Finish")}));
}

TEST_F(DrillEnd, an_attempt_whose_driver_stands_still_is_left_and_kept) {
  DeskRecords records;
  const Actor student = begin_recorded(records);
  QSignalSpy left(screen.get(), &DrillScreen::left);
  let_it_run();
  hand->stuck = true;
  ASSERT_TRUE(wait_for_card("driver of the device"));
  ASSERT_NE(button(card(), "Leave"), nullptr);
  button(card(), "Leave")->click();
  EXPECT_TRUE(more.contains(QStringLiteral("until the driver of the device stood still"))) << more.toStdString();
  answer(true);
  EXPECT_FALSE(screen->running()) << "the window may close";
  ASSERT_TRUE(QTest::qWaitFor([&] { return left.count() == 1; }, kComesWithinMs));
  screen.reset();
  EXPECT_TRUE(hand->open) << "its driver has not come back";
  const auto kept = records.store().history.interrupted(student, student.id);
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->size(), 1u);
  const auto chunks = records.store().traces.chunks(kept->front().session);
  ASSERT_TRUE(chunks);
  EXPECT_FALSE(chunks->empty());
  let_driver_go();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !hand->open; }, kComesWithinMs)) << "the thread that waits for it closes it";
}

TEST_F(DrillEnd, an_attempt_whose_driver_does_not_open_is_left) {
  hand->opens = std::make_shared<Gate>();
  QSignalSpy left(screen.get(), &DrillScreen::left);
  screen->begin(plan(), {QStringLiteral("Channel"), QStringLiteral("Practice")}, std::make_unique<SinkingPort>(hand));
  ASSERT_TRUE(QTest::qWaitFor([&] { return hand->open.load(); }, kComesWithinMs));
  screen->ask_leave();
  EXPECT_TRUE(QTest::qWaitFor([&] { return left.count() == 1; }, kComesWithinMs));
  EXPECT_FALSE(hand->opens->gave_up()) << "nobody waits for the driver";
  screen.reset();
  EXPECT_TRUE(hand->open) << "its driver has not come back";
  hand->opens->open();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !hand->open; }, kComesWithinMs)) << "the thread that waits for it closes it";
}

TEST_F(DrillEnd, the_window_closes_while_a_driver_does_not_open) {
  hand->opens = std::make_shared<Gate>();
  screen->begin(plan(), {QStringLiteral("Channel"), QStringLiteral("Practice")}, std::make_unique<SinkingPort>(hand));
  ASSERT_TRUE(QTest::qWaitFor([&] { return hand->open.load(); }, kComesWithinMs));
  screen.reset();
  EXPECT_FALSE(hand->opens->gave_up());
  EXPECT_TRUE(hand->open);
  hand->opens->open();
  EXPECT_TRUE(QTest::qWaitFor([&] { return !hand->open; }, kComesWithinMs));
}

TEST_F(DrillEnd, the_stop_card_is_hidden_while_the_tooth_is_measured) {
  begin(plan());
  screen->toggle_pause();
  ASSERT_TRUE(wait_for_card("Paused"));
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  screen->ask_finish();
  answer(true);
  ASSERT_TRUE(screen->findChild<Busy*>()->running());
  EXPECT_FALSE(card().isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] { return finished.count() == 1; }, kComesWithinMs));
}

TEST_F(DrillEnd, an_assessment_cannot_be_paused) {
  begin(plan(Guidance::silent));
  EXPECT_EQ(button(*screen, "Pause"), nullptr);
  QTest::keyClick(screen.get(), Qt::Key_P);
  screen->toggle_pause();
  let_it_run();
  EXPECT_FALSE(card().isVisible());
  const QString before = clock();
  EXPECT_TRUE(QTest::qWaitFor([&] { return clock() != before; }, kComesWithinMs)) << "the clock runs on";
}

TEST_F(DrillEnd, an_assessment_that_a_lost_device_stopped_is_resumed) {
  begin(plan(Guidance::silent));
  hand->plugged = false;
  ASSERT_TRUE(wait_for_card("does not answer"));
  hand->plugged = true;
  ASSERT_TRUE(wait_for_card("answers again"));
  screen->ask_finish();
  answer(false);
  let_it_run();
  EXPECT_TRUE(card_shows("answers again"));
  EXPECT_EQ(hand->force_n, 0);
  EXPECT_NE(button(card(), "Resume"), nullptr);
  ASSERT_NE(button(*screen, "Resume"), nullptr);
  QTest::keyClick(screen.get(), Qt::Key_P);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !card().isVisible() && hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, the_cutaway_opens_while_the_attempt_is_paused) {
  begin(plan());
  screen->toggle_pause();
  ASSERT_TRUE(QTest::qWaitFor([&] { return card().isVisible(); }, kComesWithinMs));
  EXPECT_FALSE(screen->view()->scene().cutaway);
  QTest::keyClick(screen.get(), Qt::Key_3);
  EXPECT_TRUE(QTest::qWaitFor([&] { return screen->view()->scene().cutaway.has_value(); }, kComesWithinMs));
}

TEST_F(DrillEnd, an_attempt_begins_while_work_that_was_left_goes_on) {
  auto gate = std::make_shared<test::Gate>();
  BackgroundTask([gate] { gate->pass(); });
  begin(plan());
  EXPECT_FALSE(gate->gave_up());
  gate->open();
}

TEST_F(DrillEnd, an_open_question_of_an_assessment_takes_cut_and_force_off_and_lets_the_clock_run) {
  begin(plan(Guidance::silent));
  screen->ask_finish();
  ASSERT_TRUE(QTest::qWaitFor([&] { return hand->force_n == 0; }, kComesWithinMs));
  // What was cut before is shown once the bar stands; three rounds are less than the depth that is left.
  double cut = -1.0;
  for (int round = 0; round < 3 && cut != removed(); ++round) {
    cut = removed();
    let_it_run();
  }
  const QString before = clock();
  EXPECT_TRUE(QTest::qWaitFor([&] { return clock() != before; }, kComesWithinMs)) << "the clock runs on";
  let_it_run();
  EXPECT_EQ(removed(), cut);
  EXPECT_EQ(hand->force_n, 0);
  answer(false);
  EXPECT_TRUE(QTest::qWaitFor([&] { return removed() > cut && hand->force_n > 0; }, kComesWithinMs));
}

TEST_F(DrillEnd, the_time_limit_of_an_assessment_ends_it_under_an_open_question) {
  SessionPlan limited = plan(Guidance::silent);
  limited.scenario.time_limit_s = 8;
  limited.start_code = "K7P2";
  begin(std::move(limited));
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  screen->ask_leave();
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen->findChild<Busy*>()->running(); }, kComesWithinMs));
  answer(true);  // too late: it is measured already
  EXPECT_TRUE(QTest::qWaitFor([&] { return finished.count() == 1; }, kComesWithinMs));
}

TEST_F(DrillEnd, leaving_keeps_the_window_alive_while_the_last_second_waits_for_the_disk) {
  DeskRecords records;
  begin_recorded(records);
  QSignalSpy left(screen.get(), &DrillScreen::left);
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(database->run("BEGIN IMMEDIATE"));  // as another program may
  let_it_run();
  screen->ask_leave();
  answer(true);
  EXPECT_FALSE(screen->running());
  EXPECT_EQ(left.count(), 0);
  ASSERT_TRUE(database->run("COMMIT"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return left.count() == 1; }, kComesWithinMs));
}

TEST_F(DrillEnd, a_refused_record_is_finished_again_from_its_card_and_nothing_is_lost) {
  DeskRecords records;
  begin_recorded(records);
  QSignalSpy finished(screen.get(), &DrillScreen::finished), failed(screen.get(), &DrillScreen::failed);
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  // From the third second on.
  ASSERT_TRUE(refuse_rows(*database, "trace_chunks", "row <= 1"));
  ASSERT_TRUE(wait_for_card("Resume then writes"));
  screen->ask_finish();
  answer(true);
  for (int tries = 0; tries < 2; ++tries) {
    ASSERT_TRUE(wait_for_card("Try again then writes"));
    EXPECT_EQ(button(card(), "Resume"), nullptr) << "the session is stopped";
    EXPECT_EQ(button(card(), "Leave"), nullptr);
    if (tries == 1) {
      ASSERT_TRUE(take_rows(*database, "trace_chunks"));
    }
    ASSERT_NE(button(card(), "Try again"), nullptr);
    button(card(), "Try again")->click();
    EXPECT_FALSE(card().isVisible());
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() + failed.count() > 0; }, kComesWithinMs));
  ASSERT_EQ(finished.count(), 1);
  const auto result = finished.at(0).at(0).value<std::shared_ptr<const SessionResult>>();
  EXPECT_FALSE(result->interrupted);
  const auto chunks = records.store().traces.chunks(result->session);
  ASSERT_TRUE(chunks);
  EXPECT_GE(static_cast<double>(chunks->size()) + 1e-9, result->seconds) << "every second is kept";
}

TEST_F(DrillEnd, leaving_an_attempt_whose_record_is_refused_names_what_goes) {
  DeskRecords records;
  begin_recorded(records);
  auto database = Database::open(records.file());
  ASSERT_TRUE(database);
  ASSERT_TRUE(refuse_rows(*database, "trace_chunks", "row <= 1"));
  ASSERT_TRUE(wait_for_card("Resume then writes"));
  screen->ask_leave();
  EXPECT_TRUE(more.contains(QStringLiteral("without what cannot be written"))) << more.toStdString();
  answer(false);
  screen.reset();  // before its records
}

}  // namespace
}  // namespace cusp::test
