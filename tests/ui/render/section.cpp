#include "tests/modules.h"
#include "ui/render/section.h"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/tool/heads.h"
#include "engine/tool/swept.h"

#include "tests/engine/volume/carved.h"
#include "tests/ui/render/ball.h"
#include "ui/render/bur_pass.h"

namespace cusp::test {
namespace {

SectionSettings through_the_middle() {
  SectionSettings out;
  out.plane = {{0, 0, 0}, {0, -1, 0}, {0, 0, 1}};
  out.width = out.height = 160;
  out.mm_per_px = 0.03;
  return out;
}

double alpha(std::uint32_t rgba) { return static_cast<double>(rgba >> 24) / 255.0; }

TEST(Section, a_ball_is_a_disc_of_its_area) {
  const double r = 1.5;
  const Volume volume(Specimen::build(test::ball(r), Reading::banded));
  const SectionImage image = draw_section(volume, through_the_middle());
  ASSERT_EQ(image.rgba.size(), 160u * 160u);
  double area = 0;
  for (const std::uint32_t p : image.rgba) area += alpha(p) * image.mm_per_px * image.mm_per_px;
  // The line round it lies half outside: 0.02 mm of 1.5; measured 1.4 % more than the disc.
  EXPECT_NEAR(area / (std::numbers::pi * r * r), 1.0, 0.03);
}

TEST(Section, the_core_has_the_colour_of_its_tissue_and_outside_is_clear) {
  const Volume volume(Specimen::build(test::ball(1.5, 0.8), Reading::banded));
  const SectionImage image = draw_section(volume, through_the_middle());
  const auto at = [&image](int x, int y) { return image.rgba[static_cast<std::size_t>(y * image.width + x)]; };
  const Colour dentine = tissue_colours()[index_of(Tissue::dentine)];
  EXPECT_NEAR(at(80, 80) & 255u, dentine.r * 255, 1);
  const Colour enamel = tissue_colours()[index_of(Tissue::enamel)];
  EXPECT_NEAR(at(80, 80 - 38) & 255u, enamel.r * 255, 1);  // 1.14 mm up
  EXPECT_EQ(at(2, 2) >> 24, 0u);
}

TEST(Section, the_walls_of_another_cut_are_drawn_in_dashes_of_two_colours) {
  const Volume volume(Specimen::build(test::ball(1.5), Reading::banded));
  SectionSettings settings = through_the_middle();
  auto other = std::make_shared<Volume>(volume.specimen_ptr());
  carved::carve(*other, [](Vec3 p) { return 0.6 - p.z; });
  settings.ghost = other;
  const SectionImage plain = draw_section(volume, through_the_middle()), image = draw_section(volume, settings);
  // 0.6 mm up is 20 px above the middle row 79.5; the ball is 1.37 mm or 45 px wide there.
  int light = 0, dark = 0, elsewhere = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const std::uint32_t p = image.rgba[static_cast<std::size_t>(y * image.width + x)];
      if (p == plain.rgba[static_cast<std::size_t>(y * image.width + x)]) continue;
      if (std::abs(y - 59.5) > 2.0) ++elsewhere;
      if (y != 59) continue;
      ((p & 255u) > 128u ? light : dark)++;
    }
  EXPECT_EQ(elsewhere, 0);
  EXPECT_GT(light, 30);
  EXPECT_GT(dark, 30);
  EXPECT_NEAR(light + dark, 2 * 45, 6) << "no line on the specimen's own surface";
}

TEST(Section, a_line_is_no_wider_where_its_wall_lies_nearly_in_the_plane) {
  const Volume volume(Specimen::build(test::ball(1.5), Reading::banded));
  // Rows of the middle column that a wall changes; it leans by so much out of the plane's normal.
  const auto rows_of_a_wall = [&volume](double lean) {
    SectionSettings settings = through_the_middle();
    const SectionImage plain = draw_section(volume, settings);
    settings.target = [lean](Vec3 p) { return std::sin(lean) * (p.z - 0.3) + std::cos(lean) * p.x; };
    const SectionImage image = draw_section(volume, settings);
    int rows = 0;
    for (int y = 0; y < image.height; ++y) rows += image.rgba[static_cast<std::size_t>(y * image.width + 80)] != plain.rgba[static_cast<std::size_t>(y * image.width + 80)];
    return rows;
  };
  const int upright = rows_of_a_wall(std::numbers::pi / 2), leaning = rows_of_a_wall(0.3);
  EXPECT_GT(upright, 1);
  EXPECT_LE(leaning, upright + 2) << "1 / sin 0.3 = 3.4 times as wide by its distance in space";
}

TEST(Section, the_bur_is_drawn_where_its_pivot_is) {
  const Volume volume(Specimen::build(test::ball(1.5), Reading::banded));
  SectionSettings settings = through_the_middle();
  settings.bur = Bur{"2", 0.3, 0.15, 1.0, 0.4, 4.0};
  settings.pivot_mm = {0, 0, 2.0};
  const SectionImage image = draw_section(volume, settings);
  // 2.0 mm up is 66.7 px above the middle row 79.5.
  const std::uint32_t ball = image.rgba[static_cast<std::size_t>(13 * image.width + 80)];
  EXPECT_EQ(ball >> 24, 255u);
  EXPECT_NEAR(ball & 255u, settings.metal.r * 255, 1);
}

TEST(Section, a_fissure_bur_is_drawn_with_its_flat_end_and_straight_flank) {
  const Volume volume(Specimen::build(test::ball(1.5), Reading::banded));
  SectionSettings settings = through_the_middle();
  settings.bur = Bur{"57", 0.5, 0.3, 1.0, 0.4, 4.0, flat_head(0.5, 0.5, 2.0).value()};
  settings.pivot_mm = {0, 0, 2.1};
  const SectionImage image = draw_section(volume, settings);
  const auto at = [&image](double y_mm, double z_mm) {
    const int x = static_cast<int>(79.5 - y_mm / 0.03 + 0.5), y = static_cast<int>(79.5 - z_mm / 0.03 + 0.5);
    return image.rgba[static_cast<std::size_t>(y * image.width + x)];
  };
  // The tip stands at 1.6, half a millimetre wide to either side: a ball would leave its corners free.
  for (const double side : {-0.44, 0.0, 0.44}) EXPECT_NEAR(at(side, 1.66) & 255u, settings.metal.r * 255, 1) << side;
  EXPECT_EQ(at(0.56, 2.0) >> 24, 0u);
  EXPECT_EQ(at(0.0, 1.54) >> 24, 0u);
}

TEST(BurMesh, lies_on_the_skin_of_head_neck_and_shank_and_looks_outwards) {
  for (const auto& head : {flat_head(0.5, 0.5, 4.0), round_end_head(0.45, 0.5, 4.0), pear_head(0.5, 0.3, 0.3, 2.0),
                           oval_head(0.5, 0.2, 1.5, 0.3, 3.0)}) {
    const Bur bur{"x", 0.5, 0.2, 5.0, 0.8, 6.0, head.value()};
    int on_head = 0;
    for (const BodyVertex& v : bur_mesh(bur)) {
      EXPECT_NEAR(glm::length(v.normal), 1.0f, 1e-5f);
      if (v.cutting < 0.5f) continue;
      const Vec3 at(v.position_mm);
      EXPECT_NEAR(head_distance(bur, {0, 0, 1}, at), 0.0, 1e-5);
      EXPECT_GT(head_distance(bur, {0, 0, 1}, at + 0.01 * Vec3(v.normal)), 0.0099);
      ++on_head;
    }
    EXPECT_GT(on_head, 300);
  }
}

TEST(Section, left_in_the_picture_is_where_right_points_away_from) {
  Volume volume(Specimen::build(test::ball(1.5), Reading::banded));
  test::carve(volume, {0, 1.2, 0}, 0.5);  // at the buccal side, which lies left: right is -y
  const SectionImage image = draw_section(volume, through_the_middle());
  const auto at = [&image](int x) { return alpha(image.rgba[static_cast<std::size_t>(80 * image.width + x)]); };
  EXPECT_LT(at(80 - 40), 0.1);  // y = +1.2
  EXPECT_GT(at(80 + 40), 0.9);  // y = -1.2
}

}  // namespace
}  // namespace cusp::test
