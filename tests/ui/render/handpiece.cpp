// The handpiece above the bur: where it stands, and what it leaves to be seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/modules.h"
#include "tests/ui/render/ball.h"
#include "ui/render/bur_pass.h"
#include "ui/render/framebuffer.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/handpiece_pass.h"
#include "ui/render/patch_feed.h"

namespace cusp::test {
namespace {

FrameView looking(glm::vec3 right, glm::vec3 up, glm::vec3 to_eye) {
  FrameView out;
  out.right = right, out.up = up, out.to_eye = to_eye;
  return out;
}

TEST(Handpiece, has_its_neck_at_the_side_of_the_hand_and_across_the_bur) {
  const FrameView view = looking({1, 0, 0}, {0, 0.5f, 0.8660254f}, {0, -0.8660254f, 0.5f});
  for (const Vec3 axis : {Vec3(0, 0, 1), glm::normalize(Vec3(0.4, 0.2, 1)), glm::normalize(Vec3(-1, 1, 0.2))}) {
    for (const HandSide hand : {HandSide::right, HandSide::left}) {
      const Vec3 side = neck_side(view, axis, hand);
      EXPECT_NEAR(glm::length(side), 1.0, 1e-12);
      EXPECT_NEAR(glm::dot(side, axis), 0.0, 1e-12);
      EXPECT_EQ(glm::dot(side, Vec3(view.right)) > 0.0, hand == HandSide::right);
    }
  }
}

TEST(Handpiece, has_a_side_for_its_neck_where_the_bur_lies_along_it) {
  const FrameView view = looking({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
  const Vec3 axis = glm::normalize(Vec3(0.9, 0, 0.45));
  for (const HandSide hand : {HandSide::right, HandSide::left}) {
    EXPECT_NEAR(glm::dot(neck_side(view, axis, hand), axis), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(neck_side(view, axis, hand)), 1.0, 1e-12);
  }
}

TEST(Handpiece, begins_above_the_burs_neck_and_reaches_beyond_any_picture) {
  float low = 1e3f, far = 0.0f;
  for (const BodyVertex& v : handpiece_mesh()) {
    low = std::min(low, v.position_mm.z);
    far = std::max(far, v.position_mm.x);
    ASSERT_NEAR(glm::length(v.normal), 1.0f, 1e-5f);
  }
  EXPECT_GT(low, 0.0f);
  EXPECT_GT(far, 60.0f);
}

TEST(BurMesh, is_closed_at_the_end_of_its_shank) {
  float end = -1e3f;
  for (const BodyVertex& v : bur_mesh(Bur{})) end = std::max(end, v.position_mm.z);
  int middle = 0;
  for (const BodyVertex& v : bur_mesh(Bur{}))
    if (v.position_mm.z > end - 1e-6f && std::hypot(v.position_mm.x, v.position_mm.y) < 1e-6f) {
      ++middle;
      EXPECT_NEAR(v.normal.z, 1.0f, 1e-5f);
    }
  EXPECT_GT(middle, 0);
}

/// A bur over a ball, drawn 300 x 300 with and without the handpiece: RGBA, row by row.
struct Compared {
  std::vector<std::uint8_t> with, without;
  bool differ(int x, int y) const {
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * 300 + static_cast<std::size_t>(x));
    return !std::equal(with.begin() + static_cast<std::ptrdiff_t>(i), with.begin() + static_cast<std::ptrdiff_t>(i) + 3,
                       without.begin() + static_cast<std::ptrdiff_t>(i));
  }
};

Scene3d over_a_ball() {
  Scene3d scene;
  scene.background_middle = scene.background_edge = Colour{0, 0, 1};
  scene.camera = Camera::about({0, 0, 1.5}, 12.0);
  scene.bur = BurPose{.bur = Bur{}, .pivot_mm = {0, 0, 1.5}};
  return scene;
}

std::vector<std::uint8_t> drawn(ToothPicture& picture, const Scene3d& scene) {
  const auto onto = Framebuffer::create({300, 300}, Multisampling::off);
  picture.draw(scene, 300, 300);
  std::vector<std::uint8_t> rgba(4 * 300 * 300);
  onto->read(PixelOrder::rgba, rgba);
  return rgba;
}

Compared compared(Scene3d scene) {
  const auto context = EglContext::create(16, 16);
  const auto picture = ToothPicture::create();
  PatchFeed feed({});
  feed.build_all(Volume(Specimen::build(ball(1.5), Reading::banded)));
  for (const BakedPatch& patch : feed.take(~std::size_t{0}).patches) picture->put(patch);
  Compared out;
  out.without = drawn(*picture, scene);
  scene.show_handpiece = true;
  out.with = drawn(*picture, scene);
  return out;
}

class DrawnHandpiece : public testing::Test {
 protected:
  void SetUp() override {
    if (!EglContext::create(16, 16)) GTEST_SKIP() << "no OpenGL on this machine";
  }
};

TEST_F(DrawnHandpiece, looks_alike_with_a_target_line_elsewhere) {
  const auto context = EglContext::create(16, 16);
  const auto picture = ToothPicture::create();
  Scene3d scene = over_a_ball();
  scene.show_handpiece = true;
  for (const PresetView view : {PresetView::working, PresetView::occlusal}) {
    scene.camera.set_preset(view);
    picture->set_lines({});
    const auto alone = drawn(*picture, scene);
    picture->set_lines({OverlayLine{{{200, 0, 0}, {201, 0, 0}}, {}, kTargetStyle}});  // outside the picture
    EXPECT_TRUE(drawn(*picture, scene) == alone);
  }
}

TEST_F(DrawnHandpiece, hides_nothing_about_the_burs_tip_and_stands_beyond_it) {
  for (const PresetView view : {PresetView::working, PresetView::occlusal, PresetView::buccal}) {
    Scene3d scene = over_a_ball();
    scene.camera.set_preset(view);
    const Compared pictures = compared(scene);
    const double px_per_mm = scene.camera.px_per_mm(300);
    int changed = 0;
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 300; ++x) {
        if (!pictures.differ(x, y)) continue;
        ++changed;
        EXPECT_GT(std::hypot(x - 150, y - 150), 3.9 * px_per_mm) << x << ", " << y;
      }
    EXPECT_GT(changed, 2000);
  }
}

TEST_F(DrawnHandpiece, is_left_out_of_a_cutaway_before_a_mirror_and_without_a_bur) {
  Scene3d cut = over_a_ball();
  cut.cutaway = SectionPlane{};
  Compared pictures = compared(cut);
  EXPECT_EQ(pictures.with, pictures.without);
  Scene3d mirrored = over_a_ball();
  mirrored.mirror = mirror_behind(mirrored.camera, {0, 0, 1.5});
  pictures = compared(mirrored);
  EXPECT_EQ(pictures.with, pictures.without);
  Scene3d none = over_a_ball();
  none.bur.reset();
  pictures = compared(none);
  EXPECT_EQ(pictures.with, pictures.without);
}

}  // namespace
}  // namespace cusp::test
