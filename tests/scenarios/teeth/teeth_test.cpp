#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "scenarios/teeth/shape.h"
#include "scenarios/teeth/tables.h"
#include "scenarios/teeth/tooth.h"
#include "tests/modules.h"
#include "tests/scenarios/teeth/measure.h"

namespace cusp::test {
namespace {

constexpr int kKinds[] = {11, 12, 13, 14, 15, 16, 17, 18, 31, 32, 33, 34, 35, 36, 37, 38};

/// Grown once for all tests of this program.
const Tooth& tooth(int fdi, double voxel_mm = 0.2, std::uint64_t seed = 0) {
  static std::map<std::tuple<int, double, std::uint64_t>, Tooth> grown;
  const auto key = std::tuple(fdi, voxel_mm, seed);
  const auto found = grown.find(key);
  if (found != grown.end()) return found->second;
  auto made = grow_tooth({fdi, seed, voxel_mm});
  if (!made) throw std::runtime_error("tooth: " + made.error().where + " " + made.error().detail);
  return grown.emplace(key, std::move(*made)).first->second;
}
const Tooth& first_molar() { return tooth(36, 0.1); }

const ToothTable& table(int fdi) { return *table_for(fdi)->table; }

void expect_dims(const ToothDims& got, const ToothDims& want, double share) {
  EXPECT_NEAR(got.crown_length, want.crown_length, share * want.crown_length);
  EXPECT_NEAR(got.root_length, want.root_length, share * want.root_length);
  EXPECT_NEAR(got.mesiodistal, want.mesiodistal, share * want.mesiodistal);
  EXPECT_NEAR(got.buccolingual, want.buccolingual, share * want.buccolingual);
  EXPECT_NEAR(got.mesiodistal_neck, want.mesiodistal_neck, share * want.mesiodistal_neck);
  EXPECT_NEAR(got.buccolingual_neck, want.buccolingual_neck, share * want.buccolingual_neck);
}

void expect_single_components(const VoxelVolume& v) {
  const Components p = components_of_tissues(v);
  EXPECT_TRUE(p.all_one()) << p.whole << " enamel " << p.enamel << " dentine " << p.dentine << " cementum " << p.cementum
                           << " pulp " << p.pulp;
}

TEST(Teeth, TurnTheirMesialSideAsTheQuadrantAsks) {
  for (const int fdi : {16, 26, 36, 46}) {
    const auto marks = tooth_landmarks({fdi, 0, 0.2});
    ASSERT_TRUE(marks);
    EXPECT_GT(mesial_x(fdi) * (marks->mesial_contact.x - marks->distal_contact.x), 5.0) << fdi;
  }
  for (const int none : {0, 6, 51, -36}) EXPECT_EQ(mesial_x(none), 0) << none;
}

TEST(FirstMolar, HasTheLengthsOfTheTable) {
  // dental.md 3.1: 7.5, 14, 11, 10.5, necks 9 and 9. Measured on the voxels: within 0.4 %; 2 % is promised.
  const ToothDims d = measured_dims(first_molar().volume, 1.0, 0.0);
  expect_dims(d, table_for(36)->table->dims, 0.01);
  EXPECT_DOUBLE_EQ(table_for(36)->table->dims.mesiodistal, 11.0);
  EXPECT_DOUBLE_EQ(table_for(36)->table->dims.crown_length, 7.5);
}

TEST(FirstMolar, HasFiveCuspsAtTheHeightsOfTheTable) {
  const Tooth& t = first_molar();
  ASSERT_EQ(t.landmarks.cusp_tips.size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const SurfacePlace& tip = t.landmarks.cusp_tips[i];
    const CuspTable& want = table(36).cusps[i];
    EXPECT_EQ(tip.name, want.name);
    EXPECT_NEAR(tip.at_mm.z, want.tip.z, 0.12) << tip.name;  // measured: 0.06 at most
    EXPECT_LT(glm::length(Vec2(tip.at_mm) - Vec2(want.tip)), 0.3) << tip.name;
    EXPECT_NEAR(distance_mm(t.volume, tip.at_mm), 0.0, 0.02) << tip.name;
  }
  EXPECT_EQ(peaks(t.volume, 0.25), 5);  // by the voxels alone too
}

TEST(FirstMolar, IsOneComponentOfEachTissue) { expect_single_components(first_molar().volume); }

TEST(FirstMolar, HasEnamelAsThickAsQuoted) {
  const Tooth& t = first_molar();
  for (const SurfacePlace& tip : t.landmarks.cusp_tips) {
    const double thick = thickness_below(t.volume, tip.at_mm, Tissue::enamel);
    EXPECT_GE(thick, 1.6) << tip.name;  // teeth.md: straight down at posterior tips 1.6 to 2.6 mm
    EXPECT_LE(thick, 2.6) << tip.name;
  }
  for (const SurfacePlace& pit : t.landmarks.pits) {
    const double thick = thickness_below(t.volume, pit.at_mm, Tissue::enamel);
    EXPECT_GE(thick, 0.2) << pit.name;  // dental.md 3.2: 0.2 to 0.5 left under a fissure; a pit may be shallower
    EXPECT_LE(thick, 1.0) << pit.name;
  }
  EXPECT_LE(thickness_below(t.volume, t.landmarks.central, Tissue::enamel), 0.6);
}

TEST(FirstMolar, HasItsPulpWhereDeutschAndMusikantFoundIt) {
  const PulpHeights h = pulp_heights(first_molar().volume, first_molar().landmarks.cusp_tips.front().at_mm);
  EXPECT_EQ(first_molar().landmarks.cusp_tips.front().name, "MB");
  EXPECT_LE(furthest_from_quoted(h, kLowerMolars), 1.0);
}

TEST(FirstMolar, KeepsItsPulpInsideDentine) {
  // The apical quarter is not counted: there the canal opens. Measured: see the message; teeth.md found 0.49 at least.
  EXPECT_GE(pulp_cover_mm(first_molar().volume, -10.5, 1.0), 0.6);
}

TEST(FirstMolar, HasFissuresInTheSurfaceThatMeetInTheCentralPit) {
  const Tooth& t = first_molar();
  const Vec3 pit = t.landmarks.central;
  EXPECT_NEAR(pit.x, 0.2, 0.15);  // teeth.json, pit "central"
  EXPECT_NEAR(pit.y, -0.15, 0.15);
  for (const char* name : {"central mesial", "central distal", "lingual"}) {
    const SurfaceLine* line = t.landmarks.fissure(name);
    ASSERT_NE(line, nullptr) << name;
    ASSERT_GE(line->points_mm.size(), 10u) << name;
    const double near = std::min(glm::length(line->points_mm.front() - pit), glm::length(line->points_mm.back() - pit));
    EXPECT_LT(near, 0.3) << name;
  }
  for (const SurfaceLine& line : t.landmarks.fissures) {
    // Measured: 0.06. Between voxels a sharp bottom is read too high.
    for (const Vec3& p : line.points_mm) EXPECT_NEAR(distance_mm(t.volume, p), 0.0, 0.09) << line.name;
  }
  EXPECT_EQ(t.landmarks.fissure("no such"), nullptr);
  // A fissure is a valley: 0.7 mm to either side the surface is higher.
  const SurfaceLine& line = *t.landmarks.fissure("central mesial");
  for (std::size_t i = 3; i + 3 < line.points_mm.size(); ++i) {
    const Vec3 p = line.points_mm[i];
    EXPECT_GT(distance_mm(t.volume, p + Vec3(0, 0, 0.1)), 0.0);
    if (p.x < 1.4) continue;  // there the mesiobuccal fissure runs in from the side
    EXPECT_NE(tissue_at(t.volume, p + Vec3(0, 0.7, 0.15)), Tissue::empty);
    EXPECT_NE(tissue_at(t.volume, p + Vec3(0, -0.7, 0.15)), Tissue::empty);
  }
}

TEST(FirstMolar, HasTheCejBetweenEnamelAndCementum) {
  const Tooth& t = first_molar();
  ASSERT_EQ(t.landmarks.cej.size(), 73u);
  EXPECT_EQ(t.landmarks.cej.front(), t.landmarks.cej.back());
  for (const Vec3& p : t.landmarks.cej) {
    EXPECT_NEAR(distance_mm(t.volume, p), 0.0, 0.03);
    EXPECT_GE(p.z, -0.05);
    EXPECT_LE(p.z, 1.05);  // dental.md 3.1: 1 mm mesial, 0 elsewhere
    const Vec3 in = -0.02 * glm::normalize(Vec3(p.x, p.y, 0.0));
    const auto first = [&](Vec3 at) {
      at -= 20.0 * in;
      for (int i = 0; i < 60 && tissue_at(t.volume, at) == Tissue::empty; ++i) at += in;
      return tissue_at(t.volume, at);
    };
    EXPECT_EQ(first(p + Vec3(0, 0, 0.3)), Tissue::enamel);
    EXPECT_EQ(first(p - Vec3(0, 0, 0.3)), Tissue::cementum);
  }
}

TEST(FirstMolar, HasContactsAsItsOutermostPoints) {
  const ToothLandmarks& l = first_molar().landmarks;
  EXPECT_NEAR(l.mesial_contact.x - l.distal_contact.x, l.dims.mesiodistal, 1e-9);
  EXPECT_NEAR(distance_mm(first_molar().volume, l.mesial_contact), 0.0, 0.02);
  EXPECT_GT(l.mesial_contact.z, 3.0);  // in the occlusal half of a 7.5 mm crown
  EXPECT_EQ(l.marginal_ridges.size(), 2u);
}

TEST(Distance, OfTheVoxelsIsTrueNearTheSurface) {
  const VoxelVolume& v = first_molar().volume;
  const Grid& g = v.grid;
  std::vector<double> slope;
  double steepest = 0.0;
  IVec3 p;
  for (p.z = 1; p.z + 1 < g.size.z; ++p.z) {
    for (p.y = 1; p.y + 1 < g.size.y; ++p.y) {
      for (p.x = 1; p.x + 1 < g.size.x; ++p.x) {
        const auto d = [&](int x, int y, int z) { return distance_from_solid(v.s[g.index(p + IVec3(x, y, z))]); };
        const double here = d(0, 0, 0);
        if (std::fabs(here) >= kBandVoxels) continue;
        for (const IVec3 o : {IVec3(1, 0, 0), IVec3(0, 1, 0), IVec3(0, 0, 1)}) {
          steepest = std::max(steepest, std::fabs(d(o.x, o.y, o.z) - here));
        }
        if (std::fabs(here) > 0.9) continue;
        slope.push_back(0.5 * glm::length(Vec3(d(1, 0, 0) - d(-1, 0, 0), d(0, 1, 0) - d(0, -1, 0), d(0, 0, 1) - d(0, 0, -1))));
      }
    }
  }
  std::sort(slope.begin(), slope.end());
  const auto at = [&](double share) { return slope[static_cast<std::size_t>(share * static_cast<double>(slope.size() - 1))]; };
  std::printf("slope of distance, p1 p5 p50 p95 p99 max: %.3f %.3f %.4f %.3f %.3f %.3f; steepest step %.3f voxels\n", at(0.01),
              at(0.05), at(0.5), at(0.95), at(0.99), slope.back(), steepest);
  // Measured: p1 0.97 (the bottoms of fissures, where distance has an edge), p5 0.996, p50 1.000, p99 1.002, step 1.11.
  EXPECT_GE(at(0.01), 0.94);
  EXPECT_GE(at(0.05), 0.98);
  EXPECT_NEAR(at(0.5), 1.0, 0.001);
  EXPECT_LE(at(0.99), 1.01);
  EXPECT_LE(steepest, 1.15);  // distance grows by no more than the way; a wrong branch at a fissure gave 2.3
}

TEST(Distance, AboveFissuresIsNoLessThanRaysFind) {
  // There the field is far steeper than distance, and its value over its slope promised a surface twice too near.
  const double h = 0.2;
  const VoxelVolume& v = tooth(36, h).volume;
  const ToothShape shape(table(36), 0, h);
  int looked = 0;
  IVec3 p;
  for (p.z = 0; p.z < v.grid.size.z; ++p.z) {
    for (p.y = 0; p.y < v.grid.size.y; ++p.y) {
      for (p.x = 0; p.x < v.grid.size.x; ++p.x) {
        const std::uint16_t s = v.s[v.grid.index(p)];
        const double d = distance_from_solid(s);
        const Vec3 at = v.grid.centre_mm(p);
        if (s == 0 || d < 0.5 || at.z < 3.0 || shape.outside(at) / h < 1.4 * d + 0.5) continue;
        ++looked;
        double least = 3.0;
        for (int k = 0; k < 200; ++k) {  // directions spread evenly over the sphere
          const double z = 1.0 - 2.0 * (k + 0.5) / 200, turn = k * 2.39996, r = std::sqrt(1.0 - z * z);
          const Vec3 way(r * std::cos(turn), r * std::sin(turn), z);
          double gone = 0.0;
          while (gone < least && shape.outside(at + gone * way) > 0.0) gone += 0.05;
          least = std::min(least, gone);
        }
        EXPECT_GE(d, 0.8 * least / h - 0.5) << at.x << " " << at.y << " " << at.z;  // rays are coarse: 0.25 voxels, 10 degrees
      }
    }
  }
  EXPECT_GT(looked, 0);
}

TEST(Distance, OfTheFieldAloneWouldMiss) {
  // The naive way, the composite field as it stands: its slope at the same tooth's fissures is far from 1.
  const ToothShape shape(table(36), 0, 0.1);
  std::vector<double> slope;
  for (const SurfaceLine& line : first_molar().landmarks.fissures) {
    for (const Vec3& p : line.points_mm) {
      const double h = 0.02;
      const auto f = [&](double x, double y, double z) { return shape.outside(p + h * Vec3(x, y, z)); };
      slope.push_back(glm::length(Vec3(f(1, 0, 0) - f(-1, 0, 0), f(0, 1, 0) - f(0, -1, 0), f(0, 0, 1) - f(0, 0, -1))) / (2 * h));
    }
  }
  std::sort(slope.begin(), slope.end());
  EXPECT_TRUE(slope.front() < 0.9 || slope.back() > 1.1) << slope.front() << " " << slope.back();
}

TEST(Volume, IsEmptyAtItsRimAndNamesATissueWhereverSolid) {
  for (const int fdi : {36, 11, 26}) {
    const VoxelVolume& v = tooth(fdi).volume;
    const Grid& g = v.grid;
    IVec3 p;
    std::size_t wrong = 0;
    for (p.z = 0; p.z < g.size.z; ++p.z) {
      for (p.y = 0; p.y < g.size.y; ++p.y) {
        for (p.x = 0; p.x < g.size.x; ++p.x) {
          const std::size_t i = g.index(p);
          wrong += (v.s[i] > 0) != (v.tissue[i] != Tissue::empty);
          const bool rim = glm::any(glm::lessThan(p, IVec3(4))) || glm::any(glm::greaterThanEqual(p, g.size - 4));
          wrong += rim && v.s[i] > 0;
        }
      }
    }
    EXPECT_EQ(wrong, 0u) << fdi;
  }
}

class EveryKind : public testing::TestWithParam<int> {};

TEST_P(EveryKind, HasTheLengthsOfTheTable) {
  const ToothTable& t = table(GetParam());
  // At 0.2 mm: an edge or a tip thinner than a voxel is blunted, and a slice may lie half a voxel off the CEJ's height.
  expect_dims(measured_dims(tooth(GetParam()).volume, t.cej_m, t.cej_d), t.dims, 0.02);
  expect_dims(tooth(GetParam()).landmarks.dims, t.dims, 0.005);
}

TEST_P(EveryKind, IsOneComponentOfEachTissueWithThePulpInside) {
  const VoxelVolume& v = tooth(GetParam()).volume;
  expect_single_components(v);
  EXPECT_GE(pulp_cover_mm(v, -0.7 * table(GetParam()).dims.root_length, 0.8), 0.4);  // teeth.md: 0.49 at least
}

TEST_P(EveryKind, HasItsCuspsAtTheHeightsOfTheTable) {
  const ToothTable& t = table(GetParam());
  const ToothLandmarks& l = tooth(GetParam()).landmarks;
  ASSERT_EQ(l.cusp_tips.size(), t.cusps.size());
  for (std::size_t i = 0; i < t.cusps.size(); ++i) EXPECT_NEAR(l.cusp_tips[i].at_mm.z, t.cusps[i].tip.z, 0.25) << t.cusps[i].name;
}

INSTANTIATE_TEST_SUITE_P(Teeth, EveryKind, testing::ValuesIn(kKinds), [](const auto& kind) { return std::to_string(kind.param); });

TEST(Mirror, GivesTheOtherSideBitForBit) {
  for (const auto& [left, right] : {std::pair{36, 46}, std::pair{11, 21}}) {
    const Tooth &a = tooth(left, 0.2, 5), &b = tooth(right, 0.2, 5);
    const Grid &g = a.volume.grid, &k = b.volume.grid;
    ASSERT_EQ(g.size, k.size);
    EXPECT_NEAR(g.origin_mm.x + g.voxel_mm * (g.size.x - 1), -k.origin_mm.x, 1e-12);
    std::size_t wrong = 0;
    IVec3 p;
    for (p.z = 0; p.z < g.size.z; ++p.z) {
      for (p.y = 0; p.y < g.size.y; ++p.y) {
        for (p.x = 0; p.x < g.size.x; ++p.x) {
          const std::size_t i = g.index(p), j = k.index({g.size.x - 1 - p.x, p.y, p.z});
          wrong += a.volume.s[i] != b.volume.s[j] || a.volume.tissue[i] != b.volume.tissue[j];
        }
      }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_EQ(a.landmarks.central, b.landmarks.central * Vec3(-1, 1, 1));
    EXPECT_EQ(a.landmarks.mesial_contact, b.landmarks.mesial_contact * Vec3(-1, 1, 1));
  }
}

TEST(Seed, ChangesTheToothWithinTheSpread) {
  const ToothDims mean = table_for(36)->table->dims;
  double before = 0.0;
  for (const std::uint64_t seed : {1ull, 2ull, 3ull}) {
    const Tooth& t = tooth(36, 0.2, seed);
    const ToothDims& d = t.landmarks.dims;
    // teeth.md: one sigma is 5 % of MD and BL, 6 % of the crown, 9 % of the root; draws are cut at two.
    EXPECT_NEAR(d.mesiodistal / mean.mesiodistal, 1.0, 0.11) << seed;
    EXPECT_NEAR(d.buccolingual / mean.buccolingual, 1.0, 0.11) << seed;
    EXPECT_NEAR(d.crown_length / mean.crown_length, 1.0, 0.13) << seed;
    EXPECT_NEAR(d.root_length / mean.root_length, 1.0, 0.19) << seed;
    EXPECT_NE(d.mesiodistal, before);
    before = d.mesiodistal;
    expect_dims(measured_dims(t.volume, d.crown_length / 7.5, 0.0), d, 0.02);
    expect_single_components(t.volume);
    EXPECT_EQ(peaks(t.volume, 0.2), 5) << seed;
    EXPECT_GE(pulp_cover_mm(t.volume, -0.7 * d.root_length, 0.8), 0.4) << seed;
  }
}

TEST(Seed, GivesTheSameToothTwice) {
  const auto again = make_tooth({36, 2, 0.2});
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(again->s, tooth(36, 0.2, 2).volume.s);
  EXPECT_EQ(again->tissue, tooth(36, 0.2, 2).volume.tissue);
  EXPECT_NE(again->s, tooth(36, 0.2, 0).volume.s);
}

TEST(Landmarks, AreTheSameWithAndWithoutVoxels) {
  const auto alone = tooth_landmarks({36, 0, 0.1});
  ASSERT_TRUE(alone.has_value());
  EXPECT_EQ(alone->central, first_molar().landmarks.central);
  EXPECT_EQ(alone->fissures.size(), first_molar().landmarks.fissures.size());
}

TEST(Refused, IsANumberThatNamesNoTooth) {
  for (const int fdi : {0, -36, 6, 10, 19, 30, 39, 49, 51, 55, 85, 99, 136}) {
    const auto made = make_tooth({fdi, 0, 0.2});
    ASSERT_FALSE(made.has_value()) << fdi;
    EXPECT_EQ(made.error().code, ToothError::unknown_fdi);
    EXPECT_EQ(made.error().where, std::to_string(fdi));
    EXPECT_FALSE(table_for(fdi).has_value());
    EXPECT_FALSE(tooth_landmarks({fdi, 0, 0.2}).has_value());
  }
}

TEST(Refused, IsAnAbsurdVoxelSize) {
  for (const double h : {0.0, -0.1, 0.01, 0.039, 0.41, 5.0, std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::infinity()}) {
    const auto made = make_tooth({36, 0, h});
    ASSERT_FALSE(made.has_value()) << h;
    EXPECT_EQ(made.error().code, ToothError::bad_voxel_size);
    EXPECT_FALSE(tooth_landmarks({36, 0, h}).has_value());
  }
}

TEST(Cancel, StopsTheWork) {
  std::atomic<bool> cancel{true};
  auto made = make_tooth({36, 0, 0.2}, &cancel);
  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().code, ToothError::cancelled);
  cancel = false;  // and half-way, from the progress it reports
  made = make_tooth({36, 0, 0.2}, &cancel, [&](double share) { cancel = cancel || share > 0.5; });
  ASSERT_FALSE(made.has_value());
  EXPECT_EQ(made.error().code, ToothError::cancelled);
}

TEST(Progress, RisesToOne) {
  double last = 0.0;
  const auto made = make_tooth({36, 0, 0.3}, nullptr, [&](double share) {
    EXPECT_GE(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
  });
  EXPECT_TRUE(made.has_value());
  EXPECT_GT(last, 0.5);
}

TEST(Tables, ThatAreBrokenAreNamed) {
  EXPECT_EQ(read_tooth_tables("{").error().code, ToothError::bad_tables);
  EXPECT_EQ(read_tooth_tables(R"({"format":"cusp-teeth-2","teeth":[]})").error().where, "format");
  EXPECT_EQ(read_tooth_tables(R"({"format":"cusp-teeth-1","teeth":[]})").error().where, "teeth");
  const auto missing = read_tooth_tables(R"({"format":"cusp-teeth-1","teeth":[{"id":"max_i1","fdi":11}]})");
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().where, "max_i1");
  EXPECT_NE(missing.error().detail.find("dims"), std::string::npos);
}

}  // namespace
}  // namespace cusp::test
