// What stands about a specimen: baked whole, drawn beside it, cut in sections.
#include "tests/modules.h"
#include "ui/render/scenery_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "scenarios/specimens/specimens.h"
#include "tests/engine/volume/carved.h"
#include "tests/ui/render/ball.h"
#include "ui/render/gl_context_egl.h"
#include "ui/render/scenery_section.h"
#include "ui/render/snapshot.h"
#include "ui/render/tooth_picture.h"

namespace cusp::test {
namespace {

/// A ball of rings and segments, of enamel about dentine.
SceneryMesh ball_mesh(Vec3 centre, double radius, int rings = 24, int turns = 48) {
  SceneryMesh out;
  for (int r = 0; r <= rings; ++r)
    for (int t = 0; t < turns; ++t) {
      const double a = std::numbers::pi * r / rings, b = 2 * std::numbers::pi * t / turns;
      const Vec3 n(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a));
      out.points_mm.emplace_back(centre + radius * n);
      out.normals.emplace_back(n);
      out.tissue.push_back(Tissue::enamel);
      out.ambient.push_back(255);
    }
  const auto at = [&](int r, int t) { return static_cast<std::uint32_t>(r * turns + t % turns); };
  for (int r = 0; r < rings; ++r)
    for (int t = 0; t < turns; ++t)
      for (const std::uint32_t i : {at(r, t), at(r + 1, t), at(r + 1, t + 1), at(r, t), at(r + 1, t + 1), at(r, t + 1)})
        out.triangles.push_back(i);
  out.seen = out.triangles.size();
  return out;
}

TEST(Scenery, every_triangle_that_lies_open_is_in_one_patch_and_no_other) {
  SceneryMesh mesh = ball_mesh({5, 0, 0}, 3.0);
  mesh.seen = mesh.triangles.size() / 6 * 3;
  const std::size_t wanted = mesh.seen / 3;
  const SceneryLook look({mesh});
  std::size_t triangles = 0;
  std::set<int> numbers;
  for (const BakedPatch& patch : look.patches()) {
    triangles += patch.indices.size() / 3;
    EXPECT_TRUE(numbers.insert(patch.brick).second);
    for (const std::uint16_t i : patch.indices) ASSERT_LT(i, patch.vertices.size());
    for (const PackedVertex& v : patch.vertices) {
      const Vec3f n(v.normal[0], v.normal[1], v.normal[2]);
      EXPECT_GE(glm::dot(n / 32767.0f, patch.cone_axis), patch.cone_cos - 1e-3f);
    }
  }
  EXPECT_EQ(triangles, wanted);
  EXPECT_NEAR(look.bounds().low.x, 2.0, 0.01);
  EXPECT_NEAR(look.bounds().high.x, 8.0, 0.01);
}

TEST(Scenery, stands_beside_the_tooth_in_the_picture) {
  if (!EglContext::create(16, 16)) GTEST_SKIP() << "no OpenGL on this machine";
  const Volume volume(Specimen::build(test::ball(1.5), Reading::banded));
  PictureRequest request;
  request.width_px = request.height_px = 200;
  request.view = PresetView::occlusal;
  request.look_at = {Vec3(-6.0), Vec3(6.0)};
  const auto alone = draw_tooth(volume, request);
  request.scenery = std::make_shared<const SceneryLook>(std::vector<SceneryMesh>{ball_mesh({-4.0, 0, 0}, 1.2)});
  const auto both = draw_tooth(volume, request);
  ASSERT_TRUE(alone && both);
  int added = 0, tooth_changed = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) {
      const std::size_t i = 4 * static_cast<std::size_t>(200 * y + x);
      const bool was = alone->rgba[i] > alone->rgba[i + 2], is = both->rgba[i] > both->rgba[i + 2];  // ivory, not grey blue
      added += is && !was;
      tooth_changed += was && alone->rgba[i] != both->rgba[i];
    }
  EXPECT_GT(added, 300);
  EXPECT_EQ(tooth_changed, 0);
}

TEST(Scenery, a_section_through_a_ball_is_a_disc_with_a_skin) {
  const SceneryLook look({ball_mesh({0, 0, 0}, 2.5, 96, 192)});
  SectionSettings settings;
  settings.plane = {{0, 0.3, 0}, {1, 0, 0}, {0, 0, 1}};
  settings.width = settings.height = 160;
  settings.mm_per_px = 0.04;
  const auto pixels = scenery_in_section(look, settings);
  ASSERT_EQ(pixels.size(), 160u * 160u);
  double skin = 0, within = 0;
  for (const SceneryPixel& p : pixels) {
    skin += p.tissue == Tissue::enamel;
    within += p.tissue == Tissue::dentine;
  }
  // Radius in the plane: sqrt(2.5^2 - 0.3^2); the skin is kSkinMm of it.
  const double r = std::sqrt(2.5 * 2.5 - 0.09), inner = r - kSkinMm, px = 0.04 * 0.04;
  EXPECT_NEAR((skin + within) * px / (std::numbers::pi * r * r), 1.0, 0.01);
  EXPECT_NEAR(within * px / (std::numbers::pi * inner * inner), 1.0, 0.02);
  settings.plane.centre_mm.y = 2.6;
  EXPECT_TRUE(scenery_in_section(look, settings).empty());
}

/// Two balls of radius 1 whose middles lie 1 mm apart: where the second goes into the first it has no line.
TEST(Scenery, a_body_within_another_has_no_line) {
  SectionSettings settings;
  settings.plane = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  settings.width = settings.height = 200;
  settings.mm_per_px = 0.03;
  const SceneryLook look({ball_mesh({0, 0, 0}, 1.0), ball_mesh({1, 0, 0}, 1.0)});
  const auto pixels = scenery_in_section(look, settings);
  const auto edge = [&](double x_mm) { return pixels[static_cast<std::size_t>(100 * 200) + static_cast<std::size_t>(std::lround(99.5 + x_mm / 0.03))].edge; };
  EXPECT_GT(edge(-1.0), 0.3f);
  EXPECT_EQ(edge(0.0), 0.0f) << "the second's left end, in the middle of the first";
  EXPECT_GT(edge(2.0), 0.3f);
  EXPECT_GT(edge(1.0), 0.3f) << "the first's own right end";
}

TEST(Scenery, in_a_section_scenery_continues_where_the_specimen_never_was_and_not_in_its_cuts) {
  Volume volume(Specimen::build(test::ball(1.5), Reading::banded));
  SectionSettings settings;
  settings.plane = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  settings.width = settings.height = 300;
  settings.mm_per_px = 0.03;
  carved::carve(volume, [](Vec3 p) { return glm::length(p - Vec3(0, 0, 1)) - 0.3; });
  const SectionImage alone = draw_section(volume, settings);
  settings.scenery = std::make_shared<const SceneryLook>(std::vector<SceneryMesh>{ball_mesh({0, 0, 0}, 4.0)});
  const SectionImage both = draw_section(volume, settings);
  const auto at = [](const SectionImage& image, int x, int y) { return image.rgba[static_cast<std::size_t>(300 * y + x)]; };
  EXPECT_EQ(at(both, 150, 150), at(alone, 150, 150));
  EXPECT_EQ(at(both, 150, 117) >> 24, 0u);           // 1 mm up: cut away
  EXPECT_EQ(at(alone, 150, 95) >> 24, 0u);
  EXPECT_EQ(at(both, 150, 95) >> 24, 255u);          // 1.65 mm up: within the specimen's box, and no tissue of its own
  EXPECT_EQ(at(alone, 150, 60) >> 24, 0u);
  EXPECT_EQ(at(both, 150, 60) >> 24, 255u);          // 2.7 mm up
}

/// Pixels of a row of gums, from the side and about their lower edge, through which the background is seen although
/// something lies all about them.
int specks(const Volume& volume, const std::shared_ptr<const SceneryLook>& scenery, double yaw, double pitch, double look_z) {
  constexpr int kSize = 500;
  const auto context = EglContext::create(kSize, kSize);
  const auto picture = ToothPicture::create();
  PatchFeed feed({});
  feed.build_all(volume);
  for (const BakedPatch& patch : feed.take(~std::size_t{0}).patches) picture->put(patch);
  picture->set_scenery(scenery.get());
  Scene3d scene;
  scene.camera = Camera::about({0.0, 2.0, look_z}, 9.0);
  scene.camera.set_angles(yaw, pitch);
  const auto shot = [&](std::uint32_t colour) {
    scene.background_middle = scene.background_edge = colour_of(colour);
    picture->draw(scene, kSize, kSize);
    return context->read_rgba();
  };
  const auto light = shot(0xFFFFFF), dark = shot(0x000000);
  std::vector<std::uint8_t> through(static_cast<std::size_t>(kSize * kSize));
  for (std::size_t i = 0; i < through.size(); ++i) through[i] = light[4 * i] != dark[4 * i];
  std::vector<int> outside;
  const auto reach = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= kSize || y >= kSize || through[static_cast<std::size_t>(kSize * y + x)] == 0) return;
    through[static_cast<std::size_t>(kSize * y + x)] = 0;
    outside.push_back(kSize * y + x);
  };
  for (int i = 0; i < kSize; ++i) {
    for (const int far : {0, kSize - 1}) reach(i, far), reach(far, i);
  }
  for (std::size_t k = 0; k < outside.size(); ++k) {
    const int x = outside[k] % kSize, y = outside[k] / kSize;
    reach(x - 1, y), reach(x + 1, y), reach(x, y - 1), reach(x, y + 1);
  }
  return static_cast<int>(std::count(through.begin(), through.end(), std::uint8_t{1}));
}

TEST(Scenery, no_background_shines_through_between_the_gums_of_voxels_and_those_of_the_jaw) {
  if (!EglContext::create(16, 16)) GTEST_SKIP() << "no OpenGL on this machine";
  SpecimenSource source;
  source.generator = "tooth";
  source.fdi = 36;
  source.voxel_mm = 0.25;
  source.around = {"neighbours", "gingiva", "bone", "jaw"};
  const auto dense = make_specimen(source, {});
  ASSERT_TRUE(dense.has_value());
  const Volume volume(Specimen::build(*dense, Reading::banded));
  const auto scenery = scenery_of(source);
  ASSERT_TRUE(scenery);
  for (const double yaw : {-0.4, 0.0, 0.4})
    for (const double pitch : {0.2, 0.5, 0.9}) EXPECT_EQ(specks(volume, scenery, yaw, pitch, -14.0), 0) << yaw << ' ' << pitch;
}

TEST(Scenery, only_a_specimen_that_asks_for_a_jaw_has_any) {
  SpecimenSource source;
  source.generator = "tooth";
  source.fdi = 36;
  source.around = {"neighbours", "gingiva"};
  EXPECT_EQ(scenery_of(source), nullptr);
  source.generator = "block";
  source.around = {"jaw"};
  EXPECT_EQ(scenery_of(source), nullptr);
}

}  // namespace
}  // namespace cusp::test
