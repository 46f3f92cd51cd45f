// Mouse and keys to wishes of the pointer, on a view without a picture (platform "offscreen").
#include "tests/modules.h"
#include "ui/drill/pointer_input.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QTest>
#include <cmath>

#include "scenarios/library/library.h"
#include "tests/ui/render/ball.h"
#include "ui/drill/drill_screen.h"

namespace cusp::test {
namespace {

class Input : public testing::Test {
 protected:
  Input() {
    view.resize(800, 600);
    view.show_volume(Volume(Specimen::build(test::ball(2.0), Reading::banded)));
    Camera camera = Camera::about({0, 0, 0}, 3.0);
    camera.set_angles(0.0, 0.9);
    view.set_camera(camera);
    input = std::make_unique<PointerInput>(view, hand, Vec3(0, 0, 1), 0.8, nullptr);
  }
  QPointF px(Vec3 mm) { return view.project(mm).value(); }

  ToothView view;
  PointerHand hand{Vec3(0, 0, 4)};
  std::unique_ptr<PointerInput> input;
};

TEST_F(Input, a_view_without_opengl_is_a_placeholder_that_still_picks) {
  EXPECT_NE(view.findChild<QLabel*>(), nullptr) << "the placeholder";
  EXPECT_TRUE(view.pick(px({0, 0, 2})));
  EXPECT_FALSE(view.pick({1, 1}));
}

TEST_F(Input, the_bur_goes_where_the_mouse_points_and_neither_pushes_nor_cuts) {
  const Vec3 place = glm::normalize(Vec3(0.3, 0.4, 1.0)) * 2.0;
  Q_EMIT view.moved(px(place), Qt::NoButton, Qt::NoModifier);
  EXPECT_LT(glm::length(hand.wish().target_mm - place), 0.01);
  EXPECT_EQ(hand.wish().push_n, 0);
  EXPECT_FALSE(hand.wish().cut);
}

TEST_F(Input, beside_the_tooth_the_bur_stays_where_it_was) {
  Q_EMIT view.moved(px({0, 0, 2}), Qt::NoButton, Qt::NoModifier);
  const Vec3 before = hand.wish().target_mm;
  Q_EMIT view.moved({2, 2}, Qt::NoButton, Qt::NoModifier);
  EXPECT_EQ(hand.wish().target_mm, before);
}

TEST_F(Input, a_press_where_no_tooth_was_under_the_mouse_yet_does_not_drill) {
  Q_EMIT view.pressed({1, 1}, Qt::NoModifier);
  EXPECT_FALSE(hand.wish().cut);
  EXPECT_EQ(hand.wish().push_n, 0);
  Q_EMIT view.released({1, 1});
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  EXPECT_TRUE(hand.wish().cut);
}

TEST_F(Input, a_button_that_is_held_over_a_pause_drills_only_after_its_release) {
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  EXPECT_FALSE(input->ignores_cut());
  input->set_enabled(false);
  EXPECT_FALSE(input->ignores_cut()) << "first comes Resume";
  input->set_enabled(true);
  Q_EMIT view.moved(px({0.1, 0, 2}), Qt::LeftButton, Qt::NoModifier);
  EXPECT_TRUE(input->ignores_cut());
  EXPECT_FALSE(hand.wish().cut);
  Q_EMIT view.released(px({0.1, 0, 2}));
  EXPECT_FALSE(input->ignores_cut());
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  EXPECT_TRUE(hand.wish().cut);
  EXPECT_FALSE(input->ignores_cut());
}

TEST_F(Input, a_button_whose_release_this_view_never_gets_is_not_waited_for) {
  input->set_enabled(false);
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  input->set_enabled(true);
  ASSERT_TRUE(input->ignores_cut()) << "it was pressed during the pause";
  Q_EMIT view.moved(px({0, 0, 2}), Qt::NoButton, Qt::NoModifier);
  EXPECT_FALSE(input->ignores_cut());
}

TEST_F(Input, space_that_is_held_over_a_pause_drills_only_after_its_release) {
  input->press_key(Qt::Key_Space);
  input->set_enabled(false);
  input->set_enabled(true);
  input->press_key(Qt::Key_Space, PointerInput::KeyPress::repeated);
  EXPECT_TRUE(input->ignores_cut());
  EXPECT_FALSE(hand.wish().cut);
  input->release_key(Qt::Key_Space);
  EXPECT_FALSE(input->ignores_cut());
  input->set_enabled(false);
  input->press_key(Qt::Key_Space);
  input->set_enabled(true);
  EXPECT_TRUE(input->ignores_cut()) << "it was pressed during the pause";
  input->release_all();
  EXPECT_FALSE(input->ignores_cut()) << "another window hears of its release";
}

TEST_F(Input, the_left_button_drills_with_the_push_that_the_wheel_set_and_releasing_lifts) {
  Q_EMIT view.wheel_turned(240);
  EXPECT_NEAR(input->push_n(), 1.0, 1e-9);
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  EXPECT_TRUE(hand.wish().cut);
  EXPECT_NEAR(hand.wish().push_n, 1.0, 1e-9);
  Q_EMIT view.released(px({0, 0, 2}));
  EXPECT_FALSE(hand.wish().cut);
  EXPECT_EQ(hand.wish().push_n, 0);
}

TEST_F(Input, a_mouse_held_still_while_drilling_does_not_move_the_bur_sideways_as_the_hole_deepens) {
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  const Vec3 pressed = hand.wish().target_mm;
  // The mesh under the mouse sinks; the pick would now be elsewhere.
  Volume cut(Specimen::build(test::ball(2.0), Reading::banded));
  for (int i = 0; i < 10; ++i) test::carve(cut, {0, 0, 2.2 - 0.1 * i}, 0.5);
  const QPointF at = px({0, 0, 2});
  view.show_volume(cut);
  ASSERT_GT(glm::length(view.pick(at)->at_mm - pressed), 0.2);
  Q_EMIT view.moved(at, Qt::LeftButton, Qt::NoModifier);
  EXPECT_LT(glm::length(hand.wish().target_mm - pressed), 1e-6);
}

TEST_F(Input, h_holds_the_depth_at_which_the_bur_stands_and_lets_it_go) {
  std::vector<bool> held;
  QObject::connect(input.get(), &PointerInput::depth_held, [&](bool on) { held.push_back(on); });
  input->press_key(Qt::Key_H);
  EXPECT_TRUE(std::isinf(hand.wish().stop_mm)) << "nothing was drilled yet";
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  input->follow_bur({0.3, 0, 1.4}, 0.5);
  EXPECT_NEAR(hand.wish().floor_mm, -0.9, 1e-12);  // along the approach, which points down
  Q_EMIT view.released(px({0, 0, 2}));
  input->follow_bur({0.3, 0, 5}, std::nullopt);  // lifted, on the way to the button
  input->press_key(Qt::Key_H);
  EXPECT_NEAR(hand.wish().stop_mm, -1.4, 1e-12);
  EXPECT_NEAR(hand.wish().stop_mm, -1.4, 1e-12);
  EXPECT_TRUE(std::isinf(hand.wish().floor_mm));
  input->press_key(Qt::Key_H);
  EXPECT_TRUE(std::isinf(hand.wish().stop_mm));
  EXPECT_EQ(held, (std::vector<bool>{false, true, false}));
}

TEST_F(Input, whatever_takes_the_mouse_away_releases_at_once) {
  for (const QEvent::Type type : {QEvent::WindowDeactivate, QEvent::WindowBlocked, QEvent::Hide, QEvent::TouchCancel,
                                  QEvent::TabletLeaveProximity, QEvent::UngrabMouse}) {
    Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
    input->press_key(Qt::Key_PageDown);
    ASSERT_TRUE(hand.wish().cut);
    QEvent event(type);
    QApplication::sendEvent(&view, &event);
    EXPECT_FALSE(hand.wish().cut) << type;
    EXPECT_EQ(hand.wish().push_n, 0) << type;
    // The button that is still down is none that drills.
    Q_EMIT view.moved(px({0.3, 0, 2}), Qt::LeftButton, Qt::NoModifier);
    EXPECT_FALSE(hand.wish().cut) << type;
  }
}

TEST_F(Input, a_button_that_was_released_elsewhere_is_released_with_the_next_move) {
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  Q_EMIT view.moved(px({0.1, 0, 2}), Qt::LeftButton, Qt::NoModifier);
  EXPECT_TRUE(hand.wish().cut);
  Q_EMIT view.moved(px({0.2, 0, 2}), Qt::NoButton, Qt::NoModifier);
  EXPECT_FALSE(hand.wish().cut);
  EXPECT_EQ(hand.wish().push_n, 0);
}

TEST_F(Input, every_step_of_a_sweep_reaches_the_pointer_on_the_plane_that_was_pressed) {
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  const double height = hand.wish().target_mm.z;
  for (int i = 1; i <= 40; ++i) {
    const double x = 1.5 * std::sin(0.4 * i);
    Q_EMIT view.moved(px({x, 0, height}), Qt::LeftButton, Qt::NoModifier);
    EXPECT_NEAR(hand.wish().target_mm.x, x, 1e-6);
    EXPECT_NEAR(hand.wish().target_mm.z, height, 1e-6);
  }
}

TEST_F(Input, page_down_rests_on_the_tooth_and_page_up_lifts_off) {
  EXPECT_TRUE(input->press_key(Qt::Key_PageDown));
  EXPECT_NEAR(hand.wish().push_n, 0.8, 1e-9);
  EXPECT_FALSE(hand.wish().cut);
  input->press_key(Qt::Key_PageDown);
  EXPECT_NEAR(hand.wish().push_n, 0.9, 1e-9);
  for (int i = 0; i < 20; ++i) input->press_key(Qt::Key_PageUp, PointerInput::KeyPress::repeated);
  EXPECT_EQ(hand.wish().push_n, 0);
}

TEST_F(Input, space_drills_while_it_is_held) {
  EXPECT_TRUE(input->press_key(Qt::Key_Space));
  EXPECT_TRUE(hand.wish().cut);
  EXPECT_NEAR(hand.wish().push_n, 0.8, 1e-9);
  input->release_key(Qt::Key_Space);
  EXPECT_FALSE(hand.wish().cut);
  EXPECT_EQ(hand.wish().push_n, 0);
}

TEST_F(Input, arrows_slide_the_way_that_they_point_on_the_screen) {
  const QPointF before = px(hand.wish().target_mm);
  input->press_key(Qt::Key_Right);
  ASSERT_TRUE(QTest::qWaitFor([&] { return px(hand.wish().target_mm).x() > before.x() + 5; }, 30'000));
  input->release_key(Qt::Key_Right);
  const QPointF there = px(hand.wish().target_mm);
  EXPECT_NEAR(there.y(), before.y(), 2.0);
  input->press_key(Qt::Key_Up);
  ASSERT_TRUE(QTest::qWaitFor([&] { return px(hand.wish().target_mm).y() < there.y() - 5; }, 30'000));
  input->release_key(Qt::Key_Up);
}

TEST_F(Input, the_push_stays_between_its_least_and_what_the_pointer_allows) {
  for (int i = 0; i < 100; ++i) Q_EMIT view.wheel_turned(120);
  EXPECT_NEAR(input->push_n(), PointerHand::kMaxPushN, 1e-9);
  for (int i = 0; i < 100; ++i) Q_EMIT view.wheel_turned(-120);
  EXPECT_NEAR(input->push_n(), PointerInput::kLeastPushN, 1e-9);
}

TEST_F(Input, a_notch_that_comes_in_parts_is_one_step_of_the_push) {
  for (int i = 0; i < 8; ++i) Q_EMIT view.wheel_turned(15);
  EXPECT_NEAR(input->push_n(), 0.9, 1e-9);
  for (int i = 0; i < 20; ++i) Q_EMIT view.wheel_turned(-6);
  EXPECT_NEAR(input->push_n(), 0.8, 1e-9);
}

TEST_F(Input, while_it_is_switched_off_nothing_is_wished_for) {
  input->press_key(Qt::Key_Space);
  input->set_enabled(false);
  EXPECT_FALSE(hand.wish().cut);
  EXPECT_EQ(hand.wish().push_n, 0);
  EXPECT_FALSE(input->press_key(Qt::Key_Space));
  Q_EMIT view.pressed(px({0, 0, 2}), Qt::NoModifier);
  EXPECT_FALSE(hand.wish().cut);
}

TEST(DrillScreenKeys, control_with_an_arrow_turns_the_handpiece_and_control_with_space_drills_nothing) {
  DrillScreen screen(Ports::of_the_system());
  SessionPlan plan;
  plan.scenario = load_builtin("channel-1").value();
  plan.kind = SessionKind::try_it;
  screen.begin(std::move(plan), {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen.running(); }, 60'000));
  const auto takes = [&screen](int key, Qt::KeyboardModifiers modifiers) {
    QKeyEvent press(QEvent::KeyPress, key, modifiers), release(QEvent::KeyRelease, key, modifiers);
    QApplication::sendEvent(&screen, &press);
    QApplication::sendEvent(&screen, &release);
    return press.isAccepted();
  };
  for (const int key : {Qt::Key_Left, Qt::Key_Up, Qt::Key_Right, Qt::Key_Down}) {
    EXPECT_TRUE(takes(key, Qt::ControlModifier)) << key;
    EXPECT_FALSE(takes(key, Qt::AltModifier)) << key << ": not drilling's";
  }
  EXPECT_FALSE(takes(Qt::Key_Space, Qt::ControlModifier));
}

}  // namespace
}  // namespace cusp::test
