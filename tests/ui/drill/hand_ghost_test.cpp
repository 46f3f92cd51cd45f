// The ghost of the mouse's hand: where it stands, and when.

#include "ui/drill/hand_ghost.h"

#include <gtest/gtest.h>

#include "tests/modules.h"
#include "tests/ui/render/ball.h"
#include "ui/drill/pointer_input.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

struct HandOverABall : testing::Test {
  HandOverABall() {
    view.resize(800, 600);
    view.show_volume(Volume(Specimen::build(test::ball(2.0), Reading::banded)));
    Camera camera = Camera::about({0, 0, 0}, 3.0);
    camera.set_angles(0.0, 1.2);
    view.set_camera(camera);
  }
  static constexpr HandGhost::Bur bur() { return {.at_mm = {0, 0, 1.5}, .radius_mm = 0.4}; }
  ToothView view;
  HandGhost ghost{view, &view};
};

TEST_F(HandOverABall, is_shown_about_the_hand_and_up_to_the_bur_while_the_bur_lags) {
  const Vec3 hand(1.2, 0.3, 1.5);
  ghost.follow(hand, bur());
  ASSERT_TRUE(ghost.isVisibleTo(&view));
  EXPECT_TRUE(ghost.geometry().contains(view.project(hand)->toPoint()));
  EXPECT_TRUE(ghost.geometry().contains(view.project(bur().at_mm)->toPoint()));
  // The tooth is seen within the ring.
  EXPECT_FALSE(ghost.mask().contains(view.project(hand)->toPoint() - ghost.pos()));
}

TEST_F(HandOverABall, is_hidden_where_the_bur_has_come_and_while_the_hand_does_not_drill) {
  ghost.follow(Vec3(1.2, 0.3, 1.5), bur());
  ghost.follow(Vec3(0.2, 0.0, 1.5), bur());
  EXPECT_FALSE(ghost.isVisibleTo(&view));
  ghost.follow(Vec3(1.2, 0.3, 1.5), bur());
  ghost.follow(std::nullopt, bur());
  EXPECT_FALSE(ghost.isVisibleTo(&view));
}

TEST_F(HandOverABall, stands_at_the_burs_depth_while_the_button_is_held) {
  PointerHand hand(Vec3(0, 0, 4));
  PointerInput input(view, hand, Vec3(0, 0, 1), 0.8, nullptr);
  EXPECT_FALSE(input.hand_mm({0, 0, 1}));
  const QPointF top = *view.project({0, 0, 2});
  Q_EMIT view.pressed(top, Qt::NoModifier);
  Q_EMIT view.moved(top + QPointF(60, 0), Qt::LeftButton, Qt::NoModifier);
  const auto at = input.hand_mm({0, 0, 1.1});
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->z, 1.1, 1e-12);
  EXPECT_NEAR(at->x, hand.wish().target_mm.x, 1e-12);
  EXPECT_GT(std::abs(at->x), 0.3);
  Q_EMIT view.released(top);
  EXPECT_FALSE(input.hand_mm({0, 0, 1.1}));
}

}  // namespace
}  // namespace cusp::test
