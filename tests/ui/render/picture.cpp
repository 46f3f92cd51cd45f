// What is drawn, read back from a framebuffer without a window. Skipped where the machine has no OpenGL at all.
#include <gtest/gtest.h>

#include <array>
#include <new>
#include <thread>

#include "tests/modules.h"
#include "tests/ui/render/ball.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/shaders.h"
#include "ui/render/snapshot.h"

namespace cusp::test {
namespace {

struct Rgb {
  int r, g, b;
};

Rgb at(const Picture& picture, int x, int y) {
  const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
  return {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]};
}

constexpr double kBallMm = 1.5;
Volume ball_volume() { return Volume(Specimen::build(test::ball(kBallMm), Reading::banded)); }

void put_mesh(ToothPicture& picture, const Volume& volume) {
  PatchFeed feed({});
  feed.build_all(volume);
  for (const BakedPatch& patch : feed.take(~std::size_t{0}).patches) picture.put(patch);
}

PictureRequest small() {
  PictureRequest out;
  out.width_px = out.height_px = 200;
  out.view = PresetView::occlusal;
  return out;
}

bool has_opengl() {
  std::string why;
  return EglContext::create(16, 16, &why) != nullptr;
}

class Drawn : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_opengl()) GTEST_SKIP() << "no OpenGL on this machine";
  }
};

TEST(Shaders, every_one_asks_for_330_core) {
  EXPECT_GE(shader_texts().size(), 10u);
  for (const ShaderText& shader : shader_texts())
    EXPECT_EQ(std::string_view(shader.text).substr(0, 17), "#version 330 core") << shader.name;
}

TEST_F(Drawn, a_ball_stands_before_the_background_in_the_colour_of_enamel) {
  const auto picture = draw_tooth(ball_volume(), small());
  ASSERT_TRUE(picture);
  const Rgb middle = at(*picture, 100, 100), corner = at(*picture, 2, 2);
  EXPECT_GT(middle.r, middle.b + 10);   // ivory
  EXPECT_GT(corner.b, corner.r + 5);    // the view's grey blue
  EXPECT_GT(at(*picture, 80, 80).r, at(*picture, 130, 140).r);  // the lamp is at the upper left
}

TEST_F(Drawn, the_same_request_gives_the_same_pixels) {
  const auto a = draw_tooth(ball_volume(), small()), b = draw_tooth(ball_volume(), small());
  ASSERT_TRUE(a && b);
  EXPECT_EQ(a->rgba, b->rgba);
}

TEST_F(Drawn, a_picture_leaves_the_callers_context_as_it_was) {
  // A window's thread has its own context; on it no second one can be current, and none may be taken away.
  std::string why;
  const auto own = EglContext::create(64, 64, &why);
  const auto picture = ToothPicture::create(&why);
  ASSERT_TRUE(own && picture) << why;
  Scene3d scene;
  scene.background_middle = scene.background_edge = Colour{1, 0, 0};
  picture->draw(scene, 64, 64);
  const auto before = own->read_rgba();
  ASSERT_TRUE(draw_tooth(ball_volume(), small()));
  EXPECT_EQ(own->read_rgba(), before);
  picture->draw(scene, 64, 64);
  EXPECT_EQ(own->failed_call(), "");
}

TEST_F(Drawn, memory_that_is_lacking_is_thrown_to_the_caller) {
  PictureRequest request = small();
  request.sideways_mm = [](Vec3) -> double { throw std::bad_alloc(); };
  EXPECT_THROW(static_cast<void>(draw_tooth(ball_volume(), request)), std::bad_alloc);
  EXPECT_TRUE(draw_tooth(ball_volume(), small()));
}

TEST_F(Drawn, pictures_drawn_on_two_threads_do_not_end_each_others_display) {
  // Both contexts come and go in turn: one that goes must leave the display to the other.
  constexpr int kPictures = 40;
  std::array<int, 2> drawn{};
  std::array<std::string, 2> first_failure;
  {
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 2; ++t)
      threads.emplace_back([&, t] {
        for (int i = 0; i < kPictures; ++i) {
          std::string why;
          const auto context = EglContext::create(32, 32, &why);
          if (context) ++drawn[t];
          else if (first_failure[t].empty()) first_failure[t] = why;
        }
      });
  }
  EXPECT_EQ(drawn[0], kPictures) << first_failure[0];
  EXPECT_EQ(drawn[1], kPictures) << first_failure[1];
}

TEST_F(Drawn, a_place_is_given_where_it_is_seen_and_not_where_the_tooth_hides_it) {
  PictureRequest request = small();
  request.view = PresetView::occlusal;
  request.places_mm = {{0, 0, kBallMm}, {0, 0, -kBallMm}, {0, 0, 0}};
  const auto picture = draw_tooth(ball_volume(), request);
  ASSERT_TRUE(picture);
  ASSERT_EQ(picture->places_px.size(), 3u);
  ASSERT_TRUE(picture->places_px[0]);
  EXPECT_NEAR(picture->places_px[0]->x, 100, 2);  // on the axis that the view looks along
  EXPECT_NEAR(picture->places_px[0]->y, 100, 2);
  EXPECT_FALSE(picture->places_px[1]) << "on the far side";
  EXPECT_FALSE(picture->places_px[2]) << "inside";
}

TEST_F(Drawn, over_cut_is_orange_and_the_uncut_remainder_is_violet_in_the_difference_map) {
  Volume volume = ball_volume();
  test::carve(volume, {0, 0, 1.5}, 0.5);
  PictureRequest request = small();
  request.colouring = Colouring::deviation;
  request.deviation = [](Vec3, SurfaceKind kind) { const bool cut = kind == SurfaceKind::cut; return Deviation{cut ? 0.6f : -0.6f, cut}; };
  const auto picture = draw_tooth(volume, request);
  ASSERT_TRUE(picture);
  const Rgb cut = at(*picture, 100, 100), standing = at(*picture, 60, 70);
  EXPECT_GT(cut.r, cut.b + 40);
  EXPECT_GT(standing.b, standing.g + 20);
}

TEST_F(Drawn, a_target_line_is_drawn_in_its_colour) {
  PictureRequest request = small();
  request.sideways_mm = [](Vec3 p) { return glm::length(glm::dvec2(p.x, p.y)) - 0.6; };
  const auto with = draw_tooth(ball_volume(), request);
  ASSERT_TRUE(with);
  int teal = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const Rgb c = at(*with, x, y);
      if (c.g > c.r + 60 && c.b > c.r + 40) ++teal;
    }
  EXPECT_GT(teal, 100);
  request.sideways_mm = nullptr;
  const auto without = draw_tooth(ball_volume(), request);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) EXPECT_FALSE(at(*without, x, y).g > at(*without, x, y).r + 60);
}

TEST_F(Drawn, four_samples_soften_an_edge) {
  std::string why;
  const auto context = EglContext::create(16, 16, &why);
  const auto picture = ToothPicture::create(&why);
  ASSERT_TRUE(context && picture) << why;
  put_mesh(*picture, ball_volume());
  Scene3d scene;
  scene.background_middle = scene.background_edge = Colour{0, 0, 1};
  scene.camera = Camera::about({0, 0, 0}, 2.0);
  const auto colours_between = [&](Multisampling multisampling) {
    const auto onto = Framebuffer::create({120, 120}, multisampling, &why);
    if (!onto) return -1;
    picture->draw(scene, 120, 120);
    std::vector<std::uint8_t> rgba(4 * 120 * 120);
    onto->read(PixelOrder::rgba, rgba);
    int between = 0;
    for (std::size_t i = 0; i < rgba.size(); i += 4) between += rgba[i] > 8 && rgba[i] < 90 && rgba[i + 2] > 150 ? 1 : 0;
    return between;
  };
  EXPECT_LT(colours_between(Multisampling::off), 5);
  EXPECT_GT(colours_between(Multisampling::four), 40);
}

TEST_F(Drawn, a_framebuffer_reads_the_same_picture_in_both_orders) {
  const auto context = EglContext::create(16, 16);
  ASSERT_TRUE(context);
  const auto picture = ToothPicture::create();
  const auto onto = Framebuffer::create({30, 20}, Multisampling::off);
  ASSERT_TRUE(picture && onto);
  Scene3d scene;
  picture->draw(scene, 30, 20);
  std::vector<std::uint8_t> rgba(4 * 30 * 20), bgra(rgba.size());
  onto->read(PixelOrder::rgba, rgba);
  onto->read(PixelOrder::bgra, bgra);
  for (std::size_t i = 0; i < rgba.size(); i += 4) {
    ASSERT_EQ(rgba[i], bgra[i + 2]);
    ASSERT_EQ(rgba[i + 1], bgra[i + 1]);
    ASSERT_EQ(rgba[i + 2], bgra[i]);
  }
}

/// How many pixels about the place that the mirror shows the ball's middle at are enamel: of 441.
int enamel_in_the_glass(const std::optional<MouthMirror>& mirror) {
  const auto context = EglContext::create(400, 300);
  const auto picture = ToothPicture::create();
  if (!context || !picture) return -1;
  put_mesh(*picture, ball_volume());
  Scene3d scene;
  scene.background_middle = scene.background_edge = Colour{0, 0, 1};
  scene.camera = Camera::about({0, 0, 0}, 14.0);
  const auto at = scene.camera.project(reflected(mirror_behind(scene.camera, {0, 0, 0}), {0, 0, 0}), {400, 300});
  if (!at) return -1;
  scene.mirror = mirror;
  picture->draw(scene, 400, 300);
  const auto rgba = context->read_rgba();
  int enamel = 0;
  for (int dy = -10; dy <= 10; ++dy)
    for (int dx = -10; dx <= 10; ++dx) {
      const auto i = 4 * (static_cast<std::size_t>(at->y + dy) * 400 + static_cast<std::size_t>(at->x + dx));
      enamel += rgba[i] > rgba[i + 2] + 10 && rgba[i] > 150 ? 1 : 0;
    }
  return enamel;
}

TEST_F(Drawn, the_mirror_shows_the_ball_where_its_reflection_stands) {
  const MouthMirror mirror = mirror_behind(Camera::about({0, 0, 0}, 14.0), {0, 0, 0});
  EXPECT_EQ(enamel_in_the_glass(std::nullopt), 0);
  EXPECT_GT(enamel_in_the_glass(mirror), 300);
}

TEST_F(Drawn, the_back_of_the_mirror_shows_nothing) {
  MouthMirror mirror = mirror_behind(Camera::about({0, 0, 0}, 14.0), {0, 0, 0});
  mirror.normal = -mirror.normal;
  EXPECT_EQ(enamel_in_the_glass(mirror), 0);
}

TEST_F(Drawn, a_close_up_has_its_place_in_the_middle_where_nothing_hides_it) {
  PictureRequest request = small();
  request.closeup_px = 120;
  request.closeups_mm = {{0, 0, kBallMm}, {0, 0, -kBallMm}, {kBallMm, 0, 0}};
  const auto picture = draw_tooth(ball_volume(), request);
  ASSERT_TRUE(picture);
  ASSERT_EQ(picture->closeups.size(), 3u);
  for (std::size_t i : {0u, 2u}) {
    const Picture& closeup = picture->closeups[i];
    ASSERT_TRUE(closeup.places_px.front()) << i;
    EXPECT_NEAR(closeup.places_px.front()->x, 60, 1);
    EXPECT_NEAR(closeup.places_px.front()->y, 60, 1);
    EXPECT_GT(at(closeup, 60, 60).r, at(closeup, 60, 60).b);  // enamel
  }
  EXPECT_FALSE(picture->closeups[1].places_px.front()) << "no view from above the horizon shows the underside";
}

TEST_F(Drawn, a_cutaway_takes_away_what_lies_before_its_plane_and_shows_the_lid) {
  std::string why;
  const auto context = EglContext::create(120, 120, &why);
  const auto picture = ToothPicture::create(&why);
  ASSERT_TRUE(context && picture) << why;
  const Volume volume(Specimen::build(test::ball(1.5, 1.0), Reading::banded));
  put_mesh(*picture, volume);
  SectionSettings settings;
  settings.plane = {{0, 0, 0}, {-1, 0, 0}, {0, 0, 1}};  // faces +y, where the camera's eye is
  settings.width = settings.height = 100;
  settings.mm_per_px = 0.04;
  const SectionImage image = draw_section(volume, settings);
  picture->set_section(image);
  Scene3d scene;
  scene.camera = Camera::about({0, 0, 0}, 2.0);
  scene.camera.set_angles(0.0, 0.0);
  scene.cutaway = image.plane;
  picture->draw(scene, 120, 120);
  const Picture drawn{120, 120, context->read_rgba()};
  const Colour dentine = tissue_colours()[index_of(Tissue::dentine)];
  EXPECT_NEAR(at(drawn, 60, 60).r, dentine.r * 255, 2);
  EXPECT_NEAR(at(drawn, 60, 60).b, dentine.b * 255, 2);
}

TEST_F(Drawn, patches_put_again_and_again_leave_no_trace_of_the_former_ones) {
  std::string why;
  const auto context = EglContext::create(100, 100, &why);
  const auto picture = ToothPicture::create(&why), fresh = ToothPicture::create(&why);
  ASSERT_TRUE(picture && fresh) << why;
  Volume volume = ball_volume();
  PatchFeed feed({});
  feed.build_all(volume);
  for (const BakedPatch& patch : feed.take(~std::size_t{0}).patches) picture->put(patch);
  for (int i = 0; i < 20; ++i) {
    feed.update(volume, test::carve(volume, Vec3(0.1 * i - 1.0, 0.05 * i, 1.3), 0.4), 1);
    for (const BakedPatch& patch : feed.take(~std::size_t{0}).patches) picture->put(patch);
  }
  PatchStore kept;
  Scene3d scene;
  scene.camera = Camera::about({0, 0, 0}, 1.7);
  const DrawStats long_way = picture->draw(scene, 100, 100);
  PatchFeed whole({});
  whole.build_all(volume);
  for (const BakedPatch& patch : whole.take(~std::size_t{0}).patches) fresh->put(patch);
  const DrawStats short_way = fresh->draw(scene, 100, 100);
  EXPECT_EQ(long_way.triangles, short_way.triangles);
  EXPECT_EQ(long_way.bricks, short_way.bricks);
}

}  // namespace
}  // namespace cusp::test
