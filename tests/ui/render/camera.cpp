#include "tests/modules.h"
#include "ui/render/camera.h"

#include <gtest/gtest.h>

namespace cusp::test {
namespace {

TEST(Camera, a_ray_through_the_pixel_of_a_place_meets_that_place) {
  for (const auto& [w, h] : {std::pair{976.0, 680.0}, {500.0, 900.0}}) {
    Camera camera = Camera::about({0.3, -0.2, 3.0}, 5.0);
    camera.set_angles(0.7, 0.9);
    for (const Vec3 place : {Vec3(0.3, -0.2, 3.0), Vec3(2, 1, 2), Vec3(-3, 2, 4)}) {
      const auto px = camera.project(place, {w, h});
      ASSERT_TRUE(px);
      const Ray ray = camera.ray(*px, {w, h});
      const Vec3 to = place - ray.from_mm;
      EXPECT_LT(glm::length(to - glm::dot(to, ray.along) * ray.along), 1e-9);
    }
  }
}

TEST(Camera, the_matrix_puts_a_place_where_project_says) {
  Camera camera = Camera::about({0, 0, 0}, 5.0);
  camera.set_angles(-0.4, 0.6);
  const Vec3 place(1.5, -0.7, 0.9);
  const glm::dvec4 clip = camera.clip_from_world(1.25, 40.0) * glm::dvec4(place, 1.0);
  const auto px = camera.project(place, {1000, 800});
  ASSERT_TRUE(px);
  EXPECT_NEAR((clip.x / clip.w + 1) * 500, px->x, 1e-6);
  EXPECT_NEAR((1 - clip.y / clip.w) * 400, px->y, 1e-6);
}

TEST(Camera, the_working_view_has_mesial_left_and_buccal_below) {
  const Camera camera = Camera::about({0, 0, 0}, 5.0);
  const auto middle = camera.project({0, 0, 0}, {800, 600}), mesial = camera.project({1, 0, 0}, {800, 600}),
             buccal = camera.project({0, 1, 0}, {800, 600});
  EXPECT_LT(mesial->x, middle->x - 20);
  EXPECT_GT(buccal->y, middle->y + 20);
}

TEST(Camera, a_ball_that_it_looks_about_just_fits_the_shorter_side) {
  const double r = 3.0;
  const Camera camera = Camera::about({1, 2, 3}, r);
  // The outline of a ball seen in perspective: half angle asin(r / distance), which is half the field of view.
  EXPECT_NEAR(camera.distance_mm() * std::sin(14.0 * 3.14159265358979 / 180), r, 1e-9);
}

TEST(Camera, zoom_and_tilt_stop_at_their_limits) {
  Camera camera = Camera::about({0, 0, 0}, 5.0);
  const double first = camera.distance_mm();
  for (int i = 0; i < 200; ++i) camera.zoom(1.2);
  EXPECT_NEAR(camera.distance_mm(), 0.15 * first, 1e-9);
  camera.zoom(0.0);
  camera.zoom(-1.0);
  EXPECT_NEAR(camera.distance_mm(), 0.15 * first, 1e-9);
  for (int i = 0; i < 200; ++i) camera.orbit(0.1, 0.1);
  EXPECT_LT(camera.pitch(), 1.5708);
  EXPECT_GT(glm::length(camera.up()), 0.99);
}

TEST(Camera, panning_moves_what_is_in_the_middle_by_the_pixels_asked) {
  Camera camera = Camera::about({0, 0, 0}, 5.0);
  camera.pan({30, -12}, 600);
  const auto px = camera.project({0, 0, 0}, {800, 600});
  EXPECT_NEAR(px->x, 430, 0.5);
  EXPECT_NEAR(px->y, 288, 0.5);
}

TEST(Camera, the_distal_view_is_from_distal_in_every_quadrant) {
  for (const int mesial_x : {1, -1}) {
    Camera camera = Camera::about({0, 0, 0}, 5.0);
    camera.set_preset(PresetView::distal, mesial_x);
    EXPECT_LT(mesial_x * camera.eye_mm().x, -1.0);
  }
}

TEST(Camera, a_place_behind_the_eye_has_no_pixel) {
  const Camera camera = Camera::about({0, 0, 0}, 5.0);
  EXPECT_FALSE(camera.project(camera.eye_mm() - camera.forward(), {800, 600}));
}

}  // namespace
}  // namespace cusp::test
