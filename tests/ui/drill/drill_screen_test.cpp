// A whole attempt on the platform "offscreen": real loop, mirror and scores, by keys alone, nothing drawn.
#include "tests/modules.h"
#include "ui/drill/drill_screen.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <optional>
#include <thread>

#include "scenarios/library/library.h"
#include "ui/session/drawn_tooth.h"
#include "ui/settings/settings.h"
#include "ui/text/names.h"
#include "ui/drill/bur_tray.h"
#include "ui/drill/handpiece_panel.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/gauge.h"

namespace cusp::test {
namespace {

constexpr int kPatienceMs = 60'000;  // waits for progress; a slow machine may take its time

class Screen : public testing::Test {
 protected:
  Screen() {
    ports.ask = [this](QWidget*, const Question& question, std::function<void(bool)> then) {
      asked << question.act;
      code = question.code;
      then(answer);
    };
    screen = std::make_unique<DrillScreen>(ports);
    screen->resize(1280, 800);
    screen->show();
  }
  void begin(const char* key, const std::vector<std::string>& phenomena = {}, Guidance guidance = Guidance::full) {
    SessionPlan plan;
    plan.guidance = guidance;
    plan.scenario = load_builtin(key).value();
    plan.scenario.specimen.voxel_mm = 0.2;  // an eighth of its voxels
    plan.scenario.phenomena = phenomena;
    plan.kind = SessionKind::try_it;
    screen->begin(std::move(plan), {QStringLiteral("Channel"), QStringLiteral("Practice")});
    screen->activateWindow();  // shortcuts are the active window's
    ASSERT_TRUE(QTest::qWaitForWindowActive(screen.get()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return screen->running(); }, kPatienceMs));
  }
  double removed() const {
    for (const Bar* bar : screen->findChildren<Bar*>()) {
      if (bar->accessibleName() == QStringLiteral("Plastic")) return bar->share();
    }
    return -1;
  }
  HandpiecePanel* panel() const { return screen->findChild<HandpiecePanel*>(); }
  QString coach() const {
    for (const QLabel* label : screen->findChildren<QLabel*>()) {
      if (label->accessibleName() == QStringLiteral("Coach")) return label->text();
    }
    return {};
  }

  Ports ports = Ports::of_the_system();
  QStringList asked;
  QString code;
  bool answer = true;
  std::unique_ptr<DrillScreen> screen;
};

TEST_F(Screen, space_alone_drills_the_block_and_finishing_brings_the_grade) {
  begin("channel-1");
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  QSignalSpy failed(screen.get(), &DrillScreen::failed);
  ASSERT_TRUE(QTest::qWaitFor([&] { return coach().contains(QStringLiteral("left button")); }, kPatienceMs));
  QTest::keyPress(screen.get(), Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return removed() > 0.05; }, kPatienceMs));
  EXPECT_FALSE(coach().contains(QStringLiteral("left button")));  // the hint goes with the first cut
  QTest::keyRelease(screen.get(), Qt::Key_Space);
  screen->ask_finish();
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() + failed.count() > 0; }, kPatienceMs));
  ASSERT_EQ(failed.count(), 0);
  const auto result = finished[0][0].value<std::shared_ptr<const SessionResult>>();
  ASSERT_TRUE(result);
  EXPECT_GT(result->seconds, 0);
  EXPECT_FALSE(result->volume->cut_bricks().empty());
  EXPECT_EQ(asked, QStringList{QStringLiteral("Finish")});
  EXPECT_FALSE(screen->running());
}

TEST_F(Screen, without_guidance_the_task_is_shown_but_neither_depth_section_progress_coach_nor_target_and_the_question_is_to_hand_in) {
  begin("channel-1", {}, Guidance::silent);
  QTest::keyPress(screen.get(), Qt::Key_Space);
  const auto shown = [this](const QString& name) {
    for (const QWidget* w : screen->findChildren<QWidget*>())
      if (w->isVisible() && w->accessibleName() == name) return true;
    return false;
  };
  const auto reads = [this](const QString& text) {
    for (const QLabel* label : screen->findChildren<QLabel*>())
      if (label->isVisible() && label->text() == text) return true;
    return false;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return removed() > 0.05; }, kPatienceMs)) << "it is cut all the same";
  QTest::keyRelease(screen.get(), Qt::Key_Space);
  EXPECT_FALSE(shown(QStringLiteral("Target removed")) || shown(QStringLiteral("Plastic")));
  EXPECT_TRUE(coach().isEmpty()) << coach().toStdString();
  for (const QPushButton* b : screen->findChildren<QPushButton*>()) {
    EXPECT_FALSE(b->isVisible() && (b->text().contains(QStringLiteral("Target")) || b->text().contains(QStringLiteral("Cutaway"))));
  }
  EXPECT_TRUE(reads(briefing_text(load_builtin("channel-1").value()))) << "a candidate need not keep it in mind";
  EXPECT_FALSE(shown(QStringLiteral("Section at the bur"))) << "it shows how deep the bur is, and where the pulp lies";
  QTest::keyClick(screen.get(), Qt::Key_3);
  EXPECT_FALSE(screen->view()->scene().cutaway.has_value());
  answer = false;
  screen->ask_finish();
  EXPECT_EQ(asked, QStringList{QStringLiteral("Hand in")});
}

TEST_F(Screen, leaving_while_the_tooth_grows_leaves_at_once_and_until_then_the_part_in_work_is_named) {
  SessionPlan plan;
  plan.scenario = load_builtin("class-1-36").value();
  plan.scenario.specimen.voxel_mm = 0.08;  // grown in some ten seconds
  plan.kind = SessionKind::try_it;
  QSignalSpy left(screen.get(), &DrillScreen::left);
  screen->begin(std::move(plan), {});
  const auto shown = [this](const QString& start) {
    for (const QLabel* label : screen->findChildren<QLabel*>())
      if (label->isVisible() && label->text().startsWith(start) && label->text().endsWith(u'%')) return true;
    return false;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return shown(QStringLiteral("Growing the tooth: ")); }, kPatienceMs));
  screen->ask_leave();
  ASSERT_TRUE(QTest::qWaitFor([&] { return left.count() == 1; }, kPatienceMs));
  EXPECT_FALSE(screen->running());
}

TEST_F(Screen, without_phenomena_nothing_of_a_handpiece_is_shown) {
  begin("channel-1");
  EXPECT_FALSE(panel()->isVisible());
}

TEST_F(Screen, speed_coolant_and_warmth_are_shown_where_the_exercise_reckons_them_and_w_runs_the_coolant) {
  begin("channel-1", {"spindle-turbine", "vibration", "sound", "heat"});
  EXPECT_TRUE(panel()->isVisible());
  const auto shows = [this](const QString& part) {
    for (const QLabel* label : panel()->findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(part)) return true;
    return false;
  };
  EXPECT_FALSE(shows(QStringLiteral("not verified"))) << "authors see that mark, students do not";
  ASSERT_TRUE(QTest::qWaitFor([&] { return shows(QStringLiteral("0 rpm")); }, kPatienceMs));
  QTest::keyPress(screen.get(), Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return shows(QStringLiteral("000 rpm")); }, kPatienceMs));
  const auto warmth = [this] {
    for (const Bar* bar : panel()->findChildren<Bar*>())
      if (bar->accessibleName() == QStringLiteral("Tooth warmer by")) return bar->share();
    return -1.0;
  };
  // Of 5.5 K: the text then begins at 0.1 K. The bar only rises while the tooth is cut dry.
  ASSERT_TRUE(QTest::qWaitFor([&] { return warmth() >= 0.01; }, kPatienceMs)) << "dry cutting warms the tooth";
  EXPECT_FALSE(panel()->spoken().contains(QStringLiteral("by 0.0"))) << "the number follows the bar";
  const auto wet = [this] { return screen->running() && panel()->spoken().contains(QStringLiteral("Coolant is on")); };
  EXPECT_FALSE(wet());
  QTest::keyClick(screen.get(), Qt::Key_W);
  EXPECT_TRUE(QTest::qWaitFor(wet, kPatienceMs));
  QTest::keyRelease(screen.get(), Qt::Key_Space);
}

TEST_F(Screen, the_sound_is_turned_down_and_off_by_key_and_kept_or_its_lack_is_shown) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  settings.set_volume_percent(30);
  screen->keep_settings_in(&settings);
  begin("channel-1", {"spindle-electric", "sound"});
  // Where this machine has no output, the panel shows it; the controls are the same with one.
  bool shown = false;
  for (const QLabel* label : panel()->findChildren<QLabel*>())
    shown = shown || (label->isVisible() && label->text().startsWith(QStringLiteral("No sound")));
  const auto* slider = panel()->findChild<QSlider*>();
  ASSERT_NE(slider, nullptr);
  EXPECT_NE(shown, slider->isVisible());
  panel()->set_sound({.available = true, .volume_percent = settings.volume_percent(), .muted = settings.muted()});
  EXPECT_EQ(slider->value(), 30);
  EXPECT_NE(slider->focusPolicy() & Qt::TabFocus, 0);
  QTest::keyClick(panel()->findChild<QSlider*>(), Qt::Key_Right);
  EXPECT_GT(settings.volume_percent(), 30);
  QTest::keyClick(screen.get(), Qt::Key_M);
  EXPECT_TRUE(QTest::qWaitFor([&] { return settings.muted(); }, kPatienceMs));
  EXPECT_FALSE(slider->isEnabled());
}

TEST_F(Screen, the_handpiece_is_put_away_by_key_and_stays_away) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  screen->keep_settings_in(&settings);
  begin("channel-1");
  EXPECT_TRUE(screen->view()->scene().show_handpiece);
  QTest::keyClick(screen.get(), Qt::Key_6, Qt::KeypadModifier);  // the others press the one above the letters
  EXPECT_TRUE(QTest::qWaitFor([&] { return !screen->view()->scene().show_handpiece; }, kPatienceMs));
  EXPECT_FALSE(settings.handpiece_shown());
  DrillScreen next(ports);
  next.keep_settings_in(&settings);
  EXPECT_FALSE(next.view()->scene().show_handpiece);
}

TEST_F(Screen, the_handpiece_is_in_the_hand_that_the_settings_name) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  screen->keep_settings_in(&settings);
  EXPECT_EQ(screen->view()->scene().hand, HandSide::right);
  settings.set_left_handed(true);
  DrillScreen next(ports);
  next.keep_settings_in(&settings);
  EXPECT_EQ(next.view()->scene().hand, HandSide::left);
}

TEST_F(Screen, answering_no_continues_the_attempt) {
  begin("channel-1");
  answer = false;
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  screen->ask_finish();
  EXPECT_TRUE(screen->running());
  QTest::keyPress(screen.get(), Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return removed() > 0.01; }, kPatienceMs));
  EXPECT_EQ(finished.count(), 0);
}

TEST_F(Screen, pause_is_shown_and_the_same_key_resumes) {
  begin("channel-1");
  const auto button = [this](const QString& text) {
    for (QPushButton* b : screen->findChildren<QPushButton*>()) {
      if (b->accessibleName() == text && b->text().trimmed() == text && b->isVisible()) return true;
    }
    return false;
  };
  ASSERT_TRUE(QTest::qWaitFor([&] { return button(QStringLiteral("Pause")); }, kPatienceMs));
  screen->toggle_pause();
  ASSERT_TRUE(QTest::qWaitFor([&] { return button(QStringLiteral("Resume")); }, kPatienceMs));
  screen->toggle_pause();
  ASSERT_TRUE(QTest::qWaitFor([&] { return button(QStringLiteral("Pause")); }, kPatienceMs));
}

/// A device that lies on the table, 30 mm beside the block.
class LaidAside final : public HapticPort {
 public:
  Result<void, PortFailure> open() override { return {}; }
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    std::this_thread::sleep_until(deadline);
    return {.status = Sample::Status::fresh, .position_mm = {0, -30, 3}};
  }
  void write(const Feedback&) noexcept override {}
  DeviceLimits limits() const override {
    DeviceLimits out;
    out.name = "Laid aside";
    out.device_class = "scripted";
    return out;
  }
  void close() noexcept override {}
};

TEST_F(Screen, the_cutaway_of_a_bur_that_is_laid_aside_cuts_the_target) {
  SessionPlan plan;
  plan.scenario = load_builtin("channel-1").value();
  plan.kind = SessionKind::try_it;
  screen->begin(std::move(plan), {}, std::make_unique<LaidAside>());
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen->running(); }, kPatienceMs));
  QTest::keyClick(screen.get(), Qt::Key_3);
  const auto lid = [&] { return screen->view()->scene().cutaway; };
  ASSERT_TRUE(QTest::qWaitFor([&] { return lid().has_value(); }, kPatienceMs));
  EXPECT_LT(std::abs(lid()->centre_mm.y), 1.0) << "the channel lies along y = 0";
}

TEST_F(Screen, a_key_that_is_held_while_the_focus_goes_elsewhere_drills_no_longer) {
  begin("channel-1");
  const auto push = [this] {
    for (const Gauge* gauge : screen->findChildren<Gauge*>())
      if (gauge->title() == QStringLiteral("Force")) return gauge->value().value_or(0);
    return -1.0;
  };
  QTest::keyPress(screen.get(), Qt::Key_Space);
  ASSERT_TRUE(QTest::qWaitFor([&] { return push() > 0.1; }, kPatienceMs));
  // As Tab does: the key comes up in another widget, and the screen gets no event.
  screen->findChild<BurTray*>()->findChild<QAbstractButton*>()->setFocus();
  EXPECT_TRUE(QTest::qWaitFor([&] { return push() == 0; }, kPatienceMs));
}

TEST_F(Screen, leaving_before_anything_is_cut_asks_nothing) {
  begin("channel-1");
  QSignalSpy left(screen.get(), &DrillScreen::left);
  screen->ask_leave();
  EXPECT_TRUE(asked.isEmpty());
  EXPECT_FALSE(screen->running());
  EXPECT_TRUE(QTest::qWaitFor([&] { return left.count() == 1; }, kPatienceMs));
}

TEST_F(Screen, an_assessment_is_left_with_its_start_code_alone_even_before_anything_is_cut) {
  SessionPlan plan;
  plan.scenario = load_builtin("channel-1").value();
  plan.guidance = Guidance::silent;
  plan.kind = SessionKind::try_it;
  plan.start_code = "K7P2";
  screen->begin(std::move(plan), {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen->running(); }, kPatienceMs));
  answer = false;
  QTest::keyClick(screen.get(), Qt::Key_Escape);
  EXPECT_EQ(code, QStringLiteral("K7P2"));
  EXPECT_TRUE(screen->running());
  answer = true;
  screen->ask_leave();
  EXPECT_FALSE(screen->running());
}

TEST_F(Screen, a_question_with_a_code_is_answered_once_the_code_is_typed) {
  std::optional<bool> left;
  Ports::of_the_system().ask(screen.get(), {QStringLiteral("Leave?"), QStringLiteral("The code."), QStringLiteral("Leave"), true, {}, QStringLiteral("K7P2")},
                             [&](bool yes) { left = yes; });
  auto* box = screen->findChild<QMessageBox*>();
  ASSERT_NE(box, nullptr);
  auto* field = box->findChild<QLineEdit*>();
  ASSERT_NE(field, nullptr);
  QAbstractButton* act = box->buttons().front();
  for (QAbstractButton* one : box->buttons())
    if (one->text() == QStringLiteral("Leave")) act = one;
  EXPECT_FALSE(act->isEnabled());
  QTest::keyClicks(field, QStringLiteral("K7P1"));
  EXPECT_FALSE(act->isEnabled());
  field->setText(QStringLiteral(" K7P2 "));
  ASSERT_TRUE(act->isEnabled());
  act->click();
  EXPECT_EQ(left, true);
}

TEST_F(Screen, a_scenario_whose_volume_is_missing_fails_with_its_reason) {
  SessionPlan plan;
  plan.scenario = load_builtin("channel-1").value();
  plan.scenario.specimen = {};
  plan.scenario.specimen.volume = "nowhere.nrrd";
  plan.kind = SessionKind::try_it;
  QSignalSpy failed(screen.get(), &DrillScreen::failed);
  screen->begin(std::move(plan), {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.count() == 1; }, kPatienceMs));
  EXPECT_EQ(failed[0][0].value<SessionFailure>().code, SessionError::specimen);
  EXPECT_FALSE(screen->running());
}

TEST_F(Screen, brackets_go_through_the_burs_and_stop_at_the_ends) {
  begin("channel-1");
  auto* tray = screen->findChild<BurTray*>();
  ASSERT_NE(tray, nullptr);
  EXPECT_EQ(tray->chosen(), 0);
  tray->step(+1);
  EXPECT_EQ(tray->chosen(), 1);
  tray->step(+1);
  EXPECT_EQ(tray->chosen(), 1);
}

TEST_F(Screen, it_can_be_closed_while_the_tooth_is_being_made_ready) {
  SessionPlan plan;
  plan.scenario = load_builtin("channel-1").value();
  plan.kind = SessionKind::try_it;
  screen->begin(std::move(plan), {});
  screen.reset();
}

TEST_F(Screen, it_can_be_closed_in_the_middle_of_an_attempt) {
  begin("channel-1");
  QTest::keyPress(screen.get(), Qt::Key_Space);
  screen.reset();
}

TEST_F(Screen, an_assessment_that_draws_a_tooth_begins_on_the_candidates) {
  SessionPlan plan;
  plan.scenario = load_builtin("class-1-46").value();
  plan.scenario.specimen.voxel_mm = 0.2;
  plan.kind = SessionKind::assessment;
  plan.guidance = Guidance::silent;
  plan.assignment = AssignmentId::make();
  plan.student = {UserId::make(), Role::student};
  plan.drawn_tooth = true;
  std::vector<std::uint64_t> drawn;
  for (int draw = 0; draw < kMostDraws; ++draw) drawn.push_back(drawn_seed(*plan.assignment, plan.student.id, draw));
  QSignalSpy finished(screen.get(), &DrillScreen::finished);
  screen->begin(std::move(plan), {QStringLiteral("Class I"), QStringLiteral("Assessment")});
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen->running(); }, kPatienceMs));
  screen->ask_finish();
  ASSERT_TRUE(QTest::qWaitFor([&] { return finished.count() == 1; }, kPatienceMs));
  const auto result = finished.at(0).at(0).value<std::shared_ptr<const SessionResult>>();
  EXPECT_TRUE(std::ranges::count(drawn, result->scenario.specimen.seed) == 1) << result->scenario.specimen.seed;
}

}  // namespace
}  // namespace cusp::test
