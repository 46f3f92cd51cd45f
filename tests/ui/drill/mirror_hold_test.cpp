// Mouse and keys to the mouth mirror, on a view without a picture (platform "offscreen").
#include "tests/modules.h"
#include "ui/drill/mirror_hold.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "tests/ui/render/ball.h"

namespace cusp::test {
namespace {

class Held : public testing::Test {
 protected:
  Held() {
    view.resize(800, 600);
    view.show_volume(Volume(Specimen::build(test::ball(2.0), Reading::banded)));
    view.set_camera(Camera::about({0, 0, 0}, 12.0));
    hold = new MirrorHold(view);
    hold->take({0, 0, 0});
  }
  const MouthMirror& mirror() const { return *view.scene().mirror; }
  QPoint middle() const { return view.project(mirror().centre_mm)->toPoint(); }
  void move_to(QPoint at, Qt::MouseButtons buttons) {
    QMouseEvent event(QEvent::MouseMove, at, view.mapToGlobal(at), Qt::NoButton, buttons, Qt::NoModifier);
    QCoreApplication::sendEvent(&view, &event);
  }

  ToothView view;
  MirrorHold* hold;
};

TEST_F(Held, a_drag_takes_the_mirror_along_and_presses_nothing_in_the_view) {
  QSignalSpy pressed(&view, &ToothView::pressed), moved(&view, &ToothView::moved);
  const QPoint from = middle();
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  move_to(from + QPoint(40, -25), Qt::LeftButton);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, from + QPoint(40, -25));
  EXPECT_NEAR(middle().x(), from.x() + 40, 2);
  EXPECT_NEAR(middle().y(), from.y() - 25, 2);
  EXPECT_TRUE(pressed.isEmpty());
  EXPECT_TRUE(moved.isEmpty());
}

TEST_F(Held, the_right_button_tilts_it_where_it_stands) {
  const MouthMirror before = mirror();
  const Camera camera = view.camera();
  const QPoint from = middle();
  QTest::mousePress(&view, Qt::RightButton, {}, from);
  move_to(from + QPoint(50, 0), Qt::RightButton);
  QTest::mouseRelease(&view, Qt::RightButton, {}, from + QPoint(50, 0));
  EXPECT_EQ(mirror().centre_mm, before.centre_mm);
  // 50 px of 0.004 rad, about an axis across the normal's own part.
  EXPECT_LT(glm::dot(mirror().normal, before.normal), 0.9999);
  EXPECT_EQ(view.camera(), camera);
}

TEST_F(Held, beside_the_mirror_and_on_the_tooth_before_it_the_mouse_is_the_views) {
  QSignalSpy pressed(&view, &ToothView::pressed);
  QTest::mousePress(&view, Qt::LeftButton, {}, view.project({0, 0, 2})->toPoint());
  QTest::mouseRelease(&view, Qt::LeftButton, {}, view.project({0, 0, 2})->toPoint());
  QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(5, 595));
  EXPECT_EQ(pressed.size(), 2);
}

TEST_F(Held, the_bur_is_not_led_over_the_glass) {
  QSignalSpy moved(&view, &ToothView::moved);
  view.setMouseTracking(true);
  move_to(middle(), Qt::NoButton);
  EXPECT_TRUE(moved.isEmpty());
}

TEST_F(Held, keys_move_and_tilt_it) {
  const MouthMirror before = mirror();
  EXPECT_TRUE(hold->press_key(Qt::Key_L, Qt::NoModifier));
  EXPECT_NEAR(glm::dot(mirror().centre_mm - before.centre_mm, view.camera().right()), 0.5, 1e-12);
  EXPECT_TRUE(hold->press_key(Qt::Key_O, Qt::NoModifier));
  EXPECT_NEAR(glm::dot(mirror().centre_mm - before.centre_mm, view.camera().forward()), 0.5, 1e-12);
  EXPECT_TRUE(hold->press_key(Qt::Key_I, Qt::ShiftModifier));
  EXPECT_LT(glm::dot(mirror().normal, before.normal), 0.9999);
  EXPECT_FALSE(hold->press_key(Qt::Key_H, Qt::NoModifier));
  hold->put_away();
  EXPECT_FALSE(hold->press_key(Qt::Key_L, Qt::NoModifier));
  EXPECT_FALSE(view.scene().mirror);
}

}  // namespace
}  // namespace cusp::test
