// A pinned place on the tooth: the ring shows it, or the card names what hides it.

#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>
#include <cmath>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/view/compass.h"
#include "ui/view/tooth_view.h"
#include "ui/report/pinned_tooth.h"
#include "ui/render/place_view.h"

namespace cusp::test {
namespace {

/// A block with a deep narrow pit.
struct Pit {
  Volume volume{Specimen::build(block(), Reading::banded)};
  PatchStore store;
  static VoxelVolume block() {
    VoxelVolume out(Grid{IVec3(40, 40, 40), 0.2, Vec3(-3.9)});
    IVec3 v;
    for (v.z = 0; v.z < 40; ++v.z)
      for (v.y = 0; v.y < 40; ++v.y)
        for (v.x = 0; v.x < 40; ++v.x) {
          const Vec3 p = out.grid.centre_mm(v);
          const double box = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 3.0;
          const double pit = std::max({std::abs(p.x) - 0.8, std::abs(p.y) - 0.8, -p.z});
          const std::size_t i = out.grid.index(v);
          out.s[i] = solid_from_distance(std::max(box, -pit) / 0.2);
          if (out.s[i] > 0) out.tissue[i] = Tissue::enamel;
        }
    return out;
  }
  Pit() {
    PatchFeed feed({});
    feed.build_all(volume);
    for (BakedPatch& patch : feed.take(~std::size_t{0}).patches) store.put(std::move(patch));
  }
};

TEST(PlaceView, a_camera_looks_into_the_pit_and_never_through_a_wall) {
  const Pit pit;
  const PatchStore nothing;
  const Meshes meshes = {&pit.store, &nothing};
  const Camera from = Camera::about(Vec3(0.0), 5.0);
  for (const Vec3 place : {Vec3(0, 0, 0.0), Vec3(0.8, 0, 1.5), Vec3(-0.8, 0.2, 2.5), Vec3(3.0, 0, 0), Vec3(0, -3.0, 1.0),
                           Vec3(2.0, 2.0, 3.0)}) {
    const Camera to = look_at_place(from, meshes, place);
    EXPECT_TRUE(seen_from(to, meshes, place)) << place.x << ' ' << place.y << ' ' << place.z;
    EXPECT_LT(glm::length(to.centre_mm() - place), 1e-9);
    EXPECT_DOUBLE_EQ(to.distance_mm(), from.distance_mm());
  }
  // Chosen again from somewhere else, the same place is seen again.
  const Camera second = look_at_place(look_at_place(from, meshes, {3.0, 0, 0}), meshes, {0, 0, 0});
  EXPECT_TRUE(seen_from(second, meshes, {0, 0, 0}));
}

TEST(PlaceView, a_tooth_that_has_room_in_the_picture_is_not_cut_off_by_its_edge) {
  const Pit pit;
  const Meshes meshes = {&pit.store};
  const glm::dvec2 picture(560.0, 660.0);
  const auto outside = [&](const Camera& camera) {
    double out = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const auto px = camera.project(Vec3(corner & 1 ? 3 : -3, corner & 2 ? 3 : -3, corner & 4 ? 3 : -3), picture);
      for (int axis = 0; axis < 2; ++axis) out = std::max({out, -(*px)[axis], (*px)[axis] - picture[axis]});
    }
    return out;
  };
  for (const Vec3 place : {Vec3(2.9, 2.0, 3.0), Vec3(-2.9, 0.0, 3.0), Vec3(0.0, -2.9, 3.0)}) {
    const Camera facing = look_at_place(Camera::about(Vec3(0.0), 4.6), meshes, place);
    EXPECT_GT(outside(facing), 20.0) << "else nothing is tested";
    const Camera kept = keep_in_picture(facing, meshes, place, picture, 8.0);
    EXPECT_LT(outside(kept), 1.0);
    EXPECT_TRUE(seen_from(kept, meshes, place));
    EXPECT_EQ(kept.distance_mm(), facing.distance_mm());
  }
  Camera near = Camera::about(Vec3(2.9, 2.0, 3.0), 1.0);
  near.set_preset(PresetView::occlusal);
  EXPECT_EQ(keep_in_picture(near, meshes, {2.9, 2.0, 3.0}, picture, 8.0), near) << "no room: the place stays in the middle";
}

TEST(PlaceView, what_stands_beside_the_tooth_hides_a_place_too) {
  const Pit pit;
  Camera side = Camera::about(Vec3(3.0, 0, 0), 5.0);
  side.set_angles(-1.5707963, 0.1);  // the eye on the +x side
  const PatchStore nothing;
  EXPECT_TRUE(seen_from(side, {&pit.store, &nothing}, {3.0, 0, 0}));
  PatchStore wall;
  BakedPatch patch;
  for (const auto& [y, z] : {std::pair{-4.f, -4.f}, {4.f, -4.f}, {4.f, 4.f}, {-4.f, 4.f}}) {
    PackedVertex v{};
    v.position_mm[0] = 4.0f;
    v.position_mm[1] = y;
    v.position_mm[2] = z;
    v.normal[0] = 32767;
    patch.vertices.push_back(v);
  }
  patch.indices = {0, 1, 2, 0, 2, 3};
  patch.low_mm = {4.f, -4.f, -4.f};
  patch.high_mm = {4.f, 4.f, 4.f};
  wall.put(patch);
  EXPECT_FALSE(seen_from(side, {&pit.store, &wall}, {3.0, 0, 0}));
}

TEST(PinnedTooth, shows_its_ring_where_the_place_is_seen_and_takes_it_away_where_the_tooth_hides_it) {
  const Pit pit;
  PinnedTooth tooth(std::make_shared<const Volume>(pit.volume), *load_builtin("channel-1"));
  tooth.resize(600, 600);
  tooth.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tooth.tooth_shown(); }, 60'000));
  tooth.pin(Vec3(0, 0, 0), QStringLiteral("Floor"), {});
  EXPECT_TRUE(tooth.ring_shown());
  Camera from_below = tooth.view()->camera();
  from_below.set_angles(0.0, -1.2);
  tooth.view()->set_camera(from_below);
  EXPECT_FALSE(tooth.ring_shown());
  QString all;
  for (const QLabel* label : tooth.findChildren<QLabel*>()) all += label->text();
  EXPECT_TRUE(all.contains(QStringLiteral("The tooth hides this place."))) << all.toStdString();
  tooth.pin(Vec3(0, 0, 0), QStringLiteral("Floor"), {});
  EXPECT_TRUE(tooth.ring_shown());
  tooth.pin(std::nullopt, QStringLiteral("Time"), {});
  EXPECT_FALSE(tooth.ring_shown());
}

TEST(PinnedTooth, a_place_that_is_pinned_before_the_tooth_stands_is_shown_with_it) {
  const Pit pit;
  PinnedTooth tooth(std::make_shared<const Volume>(pit.volume), *load_builtin("channel-1"));
  tooth.resize(600, 600);
  tooth.show();
  tooth.pin(Vec3(0, 0, 0), QStringLiteral("Floor"), {});
  EXPECT_FALSE(tooth.ring_shown());
  ASSERT_TRUE(QTest::qWaitFor([&] { return tooth.ring_shown(); }, 60'000));
}

TEST(PinnedTooth, its_card_stands_clear_of_the_place_and_a_line_leads_to_it) {
  const Pit pit;
  PinnedTooth tooth(std::make_shared<const Volume>(pit.volume), *load_builtin("channel-1"));
  tooth.resize(600, 600);
  tooth.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tooth.tooth_shown(); }, 60'000));
  tooth.pin(Vec3(0, 0, 0), QStringLiteral("Floor"), QStringLiteral("0.3 mm too deep"));
  const auto* card = tooth.findChild<QLabel*>();
  const auto at = tooth.view()->project({0, 0, 0});
  ASSERT_TRUE(at);
  const auto edge = tooth.view()->project({1.6, 1.6, 3.0});  // beyond the pit's rim
  ASSERT_TRUE(edge);
  const double pit_px = std::hypot(edge->x() - at->x(), edge->y() - at->y());
  const QPoint ring = at->toPoint();
  EXPECT_GT(std::max(card->y() - ring.y(), ring.y() - card->geometry().bottom()), pit_px);
  EXPECT_TRUE(tooth.rect().contains(card->geometry()));
  ASSERT_TRUE(tooth.leader());
  EXPECT_LT(QLineF(tooth.leader()->p1(), *at).length(), 16);  // from the ring's edge
  EXPECT_TRUE(card->geometry().adjusted(-1, -1, 1, 1).contains(tooth.leader()->p2().toPoint()));
  tooth.pin(std::nullopt, QStringLiteral("Time"), {});
  EXPECT_FALSE(tooth.leader());
}

TEST(PinnedTooth, a_long_comment_leaves_most_of_the_tooth_in_sight) {
  const Pit pit;
  PinnedTooth tooth(std::make_shared<const Volume>(pit.volume), *load_builtin("channel-1"));
  tooth.resize(600, 600);
  tooth.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tooth.tooth_shown(); }, 60'000));
  const auto* card = tooth.findChild<QLabel*>();
  for (const QString& comment : {QStringLiteral("The floor is uneven. ").repeated(100), QStringLiteral("a\n").repeated(75)}) {
    tooth.pin(Vec3(0, 0, 0), QStringLiteral("Dr Berg"), comment);
    EXPECT_LT(card->height(), tooth.height() / 2);
    EXPECT_TRUE(card->text().contains(QChar(u'…'))) << card->text().toStdString();
  }
  tooth.pin(Vec3(0, 0, 0), QStringLiteral("Dr Berg"), QStringLiteral("one\ntwo\nthree\nfour\nfive\nsix\nseven"));
  EXPECT_TRUE(card->text().contains(QStringLiteral("five<br>six…"))) << card->text().toStdString();
  tooth.pin(Vec3(0, 0, 0), QStringLiteral("Dr Berg"), QStringLiteral("one\n\n\n\n\n\n\n"));
  EXPECT_FALSE(card->text().contains(QChar(u'…'))) << "nothing is left out: " << card->text().toStdString();
}

TEST(PinnedTooth, paints_the_patch_of_the_measure_that_is_pinned_and_of_no_other) {
  const Pit pit;
  PinnedTooth tooth(std::make_shared<const Volume>(pit.volume), *load_builtin("channel-1"));
  tooth.pin(std::nullopt, QStringLiteral("Not removed"), {}, "uncut_remainder");
  EXPECT_TRUE(tooth.marks().empty()) << "computed in the background";
  ASSERT_TRUE(QTest::qWaitFor([&] { return !tooth.marks().empty(); }, 60'000));
  const auto target = load_builtin("channel-1")->target.outline;
  for (const auto& t : tooth.marks().triangles)
    for (const Vec3f& p : t) ASSERT_GT(p.z, target.top_mm - target.depth_mm - 0.2) << "what stands in the target lies above its floor";
  tooth.pin(std::nullopt, QStringLiteral("Time"), {}, "time");
  EXPECT_TRUE(tooth.marks().empty());
}

TEST(PinnedTooth, a_place_inside_the_tooth_has_no_ring_on_its_front) {
  const Pit pit;
  PinnedTooth tooth(std::make_shared<const Volume>(pit.volume), *load_builtin("channel-1"));
  tooth.resize(600, 600);
  tooth.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tooth.tooth_shown(); }, 60'000));
  tooth.pin(Vec3(2.0, 2.0, 1.0), QStringLiteral("Dentine over pulp"), {});
  EXPECT_FALSE(tooth.ring_shown());
  QString all;
  for (const QLabel* label : tooth.findChildren<QLabel*>()) all += label->text();
  EXPECT_TRUE(all.contains(QStringLiteral("This place lies below the surface."))) << all.toStdString();
}

TEST(PinnedTooth, caries_under_tissue_is_pinned_on_the_surface_over_it_and_within_a_section_where_it_is) {
  const Vec3 lesion(2.0, 2.0, 1.0);
  VoxelVolume block = Pit::block();
  for (std::size_t i = 0; i < block.s.size(); ++i)
    if (block.s[i] > 0) block.tissue[i] = Tissue::dentine;
  IVec3 v;
  for (v.z = 20; v.z < 30; ++v.z)
    for (v.y = 25; v.y < 35; ++v.y)
      for (v.x = 25; v.x < 35; ++v.x)
        if (glm::length(block.grid.centre_mm(v) - lesion) < 0.5) block.tissue[block.grid.index(v)] = Tissue::carious_dentine;
  const auto specimen = Specimen::build(block, Reading::banded);
  PinnedTooth tooth(std::make_shared<const Volume>(specimen), *load_builtin("channel-1"));
  tooth.resize(600, 600);
  tooth.show();
  ASSERT_TRUE(QTest::qWaitFor([&] { return tooth.tooth_shown(); }, 60'000));
  tooth.pin(lesion, QStringLiteral("Caries left"), {}, "caries_left_pulp");
  ASSERT_TRUE(QTest::qWaitFor([&] { return tooth.ring_shown(); }, 60'000));
  EXPECT_FALSE(tooth.marks().empty());
  QString all;
  for (const QLabel* label : tooth.findChildren<QLabel*>()) all += label->text();
  EXPECT_TRUE(all.contains(QStringLiteral("This place lies below the surface."))) << all.toStdString();
  EXPECT_EQ(tooth.place_mm(), lesion) << "a section goes through the lesion";
}

TEST(PinnedTooth, names_the_sides_of_a_tooth_and_none_of_a_block) {
  for (const auto& [key, named] : {std::pair("class-1-36", true), {"channel-1", false}}) {
    PinnedTooth tooth(nullptr, *load_builtin(key));
    tooth.resize(560, 660);
    tooth.set_head(44);
    tooth.show();
    const auto* compass = tooth.findChild<Compass*>();
    EXPECT_EQ(compass->isVisible(), named) << key;
    EXPECT_GE(compass->y(), 44) << "below the tools";
    EXPECT_TRUE(tooth.rect().contains(compass->geometry()));
  }
}

TEST(DeviationLegend, reads_its_two_ends_in_words_without_a_sign) {
  const QString name = DeviationLegend().accessibleName().remove(QChar(0x2069));
  EXPECT_TRUE(name.contains(QStringLiteral("mm not removed"))) << name.toStdString();
  EXPECT_TRUE(name.contains(QStringLiteral("mm over-cut"))) << name.toStdString();
  EXPECT_FALSE(name.contains(QStringLiteral("-0")) || name.contains(u'+')) << name.toStdString();
}

}  // namespace
}  // namespace cusp::test
