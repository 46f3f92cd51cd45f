#include <gtest/gtest.h>

#include "tests/modules.h"
#include "ui/render/mirror_pass.h"
#include "ui/render/mouth_mirror.h"

namespace cusp::test {
namespace {

Camera working() {
  Camera camera = Camera::about({1, 2, 3}, 5.0);
  camera.set_preset(PresetView::working);
  return camera;
}

TEST(MouthMirror, sends_the_ray_through_its_middle_to_the_place_it_was_put_behind) {
  for (const PresetView view : {PresetView::working, PresetView::occlusal, PresetView::buccal, PresetView::lingual}) {
    Camera camera = Camera::about({1, 2, 3}, 5.0);
    camera.set_preset(view);
    const Vec3 place(1.5, 2.5, 4.0);
    const MouthMirror mirror = mirror_behind(camera, place);
    EXPECT_TRUE(shows_glass(mirror, camera.eye_mm()));
    const Vec3 in = glm::normalize(mirror.centre_mm - camera.eye_mm());
    const Vec3 out = in - 2.0 * glm::dot(in, mirror.normal) * mirror.normal;
    EXPECT_NEAR(glm::dot(out, glm::normalize(place - mirror.centre_mm)), 1.0, 1e-12);
  }
}

TEST(MouthMirror, reflects_twice_to_where_a_place_was) {
  const MouthMirror mirror = mirror_behind(working(), {1, 2, 3});
  const Vec3 place(-4, 0.5, 7);
  EXPECT_LT(glm::length(reflected(mirror, reflected(mirror, place)) - place), 1e-12);
  EXPECT_NEAR(glm::length(reflected(mirror, place) - mirror.centre_mm), glm::length(place - mirror.centre_mm), 1e-12);
}

TEST(MouthMirror, is_met_by_a_ray_to_its_glass_alone) {
  const Camera camera = working();
  const MouthMirror mirror = mirror_behind(camera, {1, 2, 3});
  const auto towards = [&](Vec3 mm) { return Ray{camera.eye_mm(), glm::normalize(mm - camera.eye_mm())}; };
  const Vec3 side = glm::cross(mirror.normal, mirror.handle);
  const auto hit = distance_to(mirror, towards(mirror.centre_mm + 9.9 * side));
  ASSERT_TRUE(hit);
  EXPECT_NEAR(*hit, glm::length(mirror.centre_mm + 9.9 * side - camera.eye_mm()), 1e-9);
  EXPECT_FALSE(distance_to(mirror, towards(mirror.centre_mm + 10.1 * side)));
  EXPECT_FALSE(distance_to(mirror, {camera.eye_mm(), -towards(mirror.centre_mm).along}));
}

TEST(MouthMirror, stays_a_mirror_however_it_is_turned) {
  const Camera camera = working();
  MouthMirror mirror = mirror_behind(camera, {1, 2, 3});
  for (int i = 0; i < 1000; ++i) mirror = turned(mirror, camera, {0.05, -0.03});
  EXPECT_NEAR(glm::length(mirror.normal), 1.0, 1e-9);
  EXPECT_NEAR(glm::length(mirror.handle), 1.0, 1e-9);
  EXPECT_NEAR(glm::dot(mirror.normal, mirror.handle), 0.0, 1e-9);
}

TEST(MouthMirror, goes_as_the_hand_goes_on_the_screen) {
  const Camera camera = working();
  const MouthMirror mirror = mirror_behind(camera, {1, 2, 3});
  const auto before = camera.project(mirror.centre_mm, {800, 600});
  const auto right = camera.project(moved(mirror, camera, {2, 0, 0}).centre_mm, {800, 600});
  const auto up = camera.project(moved(mirror, camera, {0, 2, 0}).centre_mm, {800, 600});
  EXPECT_GT(right->x, before->x + 10);
  EXPECT_LT(up->y, before->y - 10);
}

TEST(MouthMirror, puts_a_place_in_the_picture_where_its_reflection_is) {
  const Camera camera = working();
  const MouthMirror mirror = mirror_behind(camera, {1, 2, 3});
  FrameView view;
  view.clip_from_world = glm::mat4(camera.clip_from_world(1.0, 40.0));
  const glm::vec3 place(0.5f, 1.5f, 3.5f);
  const glm::vec4 seen = reflected(view, mirror).clip_from_world * glm::vec4(place, 1.0f);
  const glm::vec4 expected = view.clip_from_world * glm::vec4(glm::vec3(reflected(mirror, Vec3(place))), 1.0f);
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(seen[i], expected[i], 2e-5f * std::abs(expected.w)) << i;
}

}  // namespace
}  // namespace cusp::test
