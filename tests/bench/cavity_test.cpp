// The exact proxy of a milled cavity against closed forms, CarvedTruth and blind sampling, and the motion that mills it.
// CUSP_TOLERANCE_ZERO=1 prints the residuals by failing every bound.
#include "tests/bench/cavity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <set>

#include "tests/bench/carved_truth.h"
#include "tests/bench/cavity_truth.h"
#include "tests/bench/frame.h"
#include "tests/bench/mill.h"

namespace cusp::bench {
namespace {

constexpr double kUm = 1e-3;
constexpr double kThinnerMm = 0.001;  // the method's clearance against cuts

double bound(double value) { return std::getenv("CUSP_TOLERANCE_ZERO") ? 0.0 : value; }

Vec3 random_unit(Random& random) {
  const double z = random.between(-1.0, 1.0), phi = random.between(0.0, 6.283185307179586);
  const double rho = std::sqrt(1.0 - z * z);
  return {rho * std::cos(phi), rho * std::sin(phi), z};
}

const std::vector<Vec3>& directions() {
  static const std::vector<Vec3> all = [] {
    // 40,000 are 1.3 % of a radius apart.
    std::vector<Vec3> out;
    for (int i = 0; i < 40000; ++i) {
      const double z = 1.0 - (2.0 * i + 1.0) / 40000, phi = i * 2.399963229728653, rho = std::sqrt(1.0 - z * z);
      out.push_back({rho * std::cos(phi), rho * std::sin(phi), z});
    }
    return out;
  }();
  return all;
}

/// Knows of the tissue only if a place is solid and how far a free place surely is from it.
class BlindSearch {
 public:
  explicit BlindSearch(const SweptPath& path) : path_(path) {}

  bool solid(Vec3 p) const { return !path_.taken(p, -1, -1, 0.0); }
  /// Way along u from c to the tissue, `most` if it is further.
  double ray(Vec3 c, Vec3 u, double most) const {
    double t = 0.9 * most;
    if (path_.deepest(c + u * t).mm < 0.0) t = 0.0;
    for (int k = 0; k < 200 && t < most; ++k) {
      const double free = path_.deepest(c + u * t).mm;
      if (free < 1e-8) break;
      t += free;
    }
    return std::min(t, most);
  }
  /// Distance from c to the tissue up to kBeyondMm more than r, by rays; points: where they met it.
  double nearest(Vec3 c, double r, std::vector<Vec3>& points) const {
    std::vector<std::pair<double, Vec3>> hits;
    const double most = r + kBeyondMm;
    for (const Vec3& u : directions())
      if (solid(c + u * most)) hits.emplace_back(0.0, u);
    const std::size_t every = 1 + hits.size() / 1500;
    std::vector<std::pair<double, Vec3>> kept;
    for (std::size_t i = 0; i < hits.size(); i += every) kept.emplace_back(ray(c, hits[i].second, most), hits[i].second);
    std::ranges::sort(kept, {}, [](const auto& hit) { return hit.first; });
    double least = most;
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (i < kRefined) refine(c, most, kept[i].first, kept[i].second);
      points.push_back(c + kept[i].second * kept[i].first);
      least = std::min(least, kept[i].first);
    }
    return least;
  }

  static constexpr double kBeyondMm = 0.003;

 private:
  static constexpr std::size_t kRefined = 30;
  void refine(Vec3 c, double most, double& far, Vec3& u) const {
    for (double step = 0.015; step > 1e-5;) {
      const Frame frame = Frame::of(u, std::fabs(u.z) < 0.8 ? Vec3(0, 0, 1) : Vec3(1, 0, 0), Vec3(0.0));
      bool better = false;
      for (int k = 0; k < 6 && !better; ++k) {
        const double phi = 1.0471975511965976 * k;
        const Vec3 to = unit(u + frame.x * (step * std::cos(phi)) + frame.y * (step * std::sin(phi)));
        const double there = ray(c, to, most);
        better = there < far - 1e-9;
        if (better) {
          far = there;
          u = to;
        }
      }
      if (!better) step *= 0.5;
    }
  }
  const SweptPath& path_;
};

/// What a blind search found about poses, um.
struct Residuals {
  double overlap = 0.0;  // most that tissue reaches into the true ball
  double gap = 0.0;      // most between the ball and the tissue nearest to it, in contact
  double better = 0.0;   // most that an admissible pose nearby is nearer to the device point
  int poses = 0;
  bool passes() const { return overlap <= 0.05 && gap <= 0.1 && better <= 0.1; }
};

/// Compares one pose in contact.
void inspect(const BlindSearch& blind, Vec3 pose, Vec3 device, double r, Random& random, Residuals& out) {
  ++out.poses;
  std::vector<Vec3> points;
  const double least = blind.nearest(pose, r, points);
  out.overlap = std::max(out.overlap, (r - least) / kUm);
  out.gap = std::max(out.gap, (least - r) / kUm);
  const double spring = length(pose - device);
  const Vec3 way = unit(device - pose);
  for (int k = 0; k < 2000; ++k) {
    // Some straight to the device point, most aside.
    const Vec3 aside = random_unit(random);
    const double far = 0.9 * BlindSearch::kBeyondMm * std::pow(10.0, random.between(-1.0, 0.0));
    const Vec3 at = pose + unit(aside + way * random.between(0.0, 1.5)) * far;
    const double gain = (spring - length(at - device)) / kUm;
    if (gain <= out.better || gain < 0.05) continue;
    if (std::ranges::any_of(points, [&](Vec3 p) { return length(p - at) < r - 1e-6; })) continue;
    std::vector<Vec3> there;
    if (blind.nearest(at, r, there) < r - 1e-6) {
      points.insert(points.end(), there.begin(), there.begin() + std::min<std::ptrdiff_t>(40, std::ssize(there)));
      continue;
    }
    out.better = gain;
  }
}

Vec3 squeezed(Vec3 p) {
  const Frame frame = oblique_frame();
  const Vec3 local = frame.to_local(p);
  return frame.to_world({0.2 * local.x, local.y, local.z});
}

/// A minute of the trembling hand's points, where the cavity is squeezed to a fifth of its length.
std::vector<Sweep> milled() {
  MillMotion motion({0.05, 0.0, 3});
  std::vector<Sweep> out;
  Vec3 last = squeezed(motion.next());
  for (int tick = 1; tick < 66000; ++tick) {
    const Vec3 now = squeezed(motion.next());
    if (tick % 6 != 0) continue;
    if (oblique_frame().to_local(now).z < 0.3) out.push_back({last, now});
    last = now;
  }
  return out;
}

const std::shared_ptr<const SweptSurface>& milled_surface() {
  static const std::shared_ptr<const SweptSurface> all = cavity_surface(milled());
  return all;
}

/// Follows exploring points and inspects poses in contact. changed: what stands in for the truth's pose.
template <class Change>
Residuals explore(const SweptPath& path, CavityTruth& truth, double radius, int poses, Change changed) {
  const BlindSearch blind(path);
  Random random(11);
  Residuals out;
  truth.start(oblique_frame().to_world({0.0, 0.0, -0.8}));
  int contacts = 0;
  for (const Vec3 point : exploring_points(radius, 50.0, 5, 2000)) {
    const Vec3 device = squeezed(point);
    const Exact exact = truth.follow(device);
    if (!exact.contact || length(exact.pose_mm - device) < 0.02 || ++contacts % 17 != 0) continue;
    inspect(blind, changed(exact.pose_mm, device), device, radius - kThinnerMm, random, out);
    if (out.poses == poses) break;
  }
  return out;
}
const auto kAsIs = [](Vec3 pose, Vec3) { return pose; };

class InTheCavity : public testing::TestWithParam<double> {};

TEST_P(InTheCavity, StandsWhereBlindSamplingFindsNoBetterPlace) {
  const double radius = GetParam();
  CavityTruth truth(milled_surface(), radius, kThinnerMm);
  const Residuals found = explore(milled_surface()->path(), truth, radius, 8, kAsIs);
  EXPECT_EQ(found.poses, 8);
  EXPECT_LE(found.overlap, bound(0.05));  // measured 0
  EXPECT_LE(found.gap, bound(0.1));       // measured 0.007 um, with 0.5 mm
  EXPECT_LE(found.better, bound(0.1));    // measured 0
}

INSTANTIATE_TEST_SUITE_P(Radii, InTheCavity, testing::Values(0.25, 0.4, 0.5));

TEST(BlindSampling, FindsAPoseOneMicrometreOff) {
  const SweptPath& path = milled_surface()->path();
  CavityTruth truth(milled_surface(), 0.25, kThinnerMm);
  const auto deeper = [](Vec3 pose, Vec3 device) { return pose + unit(device - pose) * kUm; };
  const auto higher = [](Vec3 pose, Vec3 device) { return pose - unit(device - pose) * kUm; };
  const auto aside = [](Vec3 pose, Vec3 device) { return pose + unit(glm::cross(device - pose, oblique_frame().x)) * 5.0 * kUm; };
  EXPECT_GT(explore(path, truth, 0.25, 3, deeper).overlap, 0.3);
  EXPECT_GT(explore(path, truth, 0.25, 3, higher).better, 0.3);
  EXPECT_FALSE(explore(path, truth, 0.25, 3, aside).passes());
}

TEST(BlindSampling, FindsAFaceThatTheTruthForgot) {
  // A surface without the lower half of the cavity has no floor.
  const SweptPath& path = milled_surface()->path();
  const auto forgotten = std::make_shared<const SweptSurface>(
      path, [](Vec3 p) { return oblique_frame().to_local(p).z + 1.65; });
  CavityTruth truth(forgotten, 0.25, kThinnerMm);
  EXPECT_FALSE(explore(path, truth, 0.25, 6, kAsIs).passes());
}

TEST(BlindSampling, FindsEdgesOneMicrometreAside) {
  // The truth of a path one micrometre aside has every edge and face there.
  std::vector<Sweep> aside = milled();
  for (Sweep& s : aside) {
    s.a += oblique_frame().z * kUm;
    s.b += oblique_frame().z * kUm;
  }
  CavityTruth truth(cavity_surface(aside), 0.5, kThinnerMm);
  EXPECT_FALSE(explore(milled_surface()->path(), truth, 0.5, 6, kAsIs).passes());
}

TEST(CavityTruth, StandsOnTheClosedFormInOneChannel) {
  // A ball in a tube: its centre stays within R - r of the axis.
  std::vector<Sweep> sweeps;
  for (int k = 0; k < 40; ++k) sweeps.push_back({{-1.0 + 0.05 * k, 0.0, 0.0}, {-0.95 + 0.05 * k, 0.0, 0.0}});
  const auto surface =
      std::make_shared<const SweptSurface>(SweptPath(sweeps, kMillRadiusMm), [](Vec3 p) { return 0.25 - std::fabs(p.x); });
  Random random(2);
  for (const double radius : {0.25, 0.39, 0.4}) {
    CavityTruth truth(surface, radius, kThinnerMm);
    truth.start(Vec3(0.0));
    const double play = kMillRadiusMm - radius + kThinnerMm;
    double worst = 0.0;
    for (int k = 0; k < 24; ++k) {
      const double phi = random.between(0.0, 6.283185307179586), far = random.between(0.0, 0.2) + play;
      const Vec3 device(random.between(-0.1, 0.1), far * std::cos(phi), far * std::sin(phi));
      const Vec3 expected(device.x, play * std::cos(phi), play * std::sin(phi));
      worst = std::max(worst, length(truth.follow(device).pose_mm - expected) / kUm);
    }
    EXPECT_LE(worst, bound(0.05)) << radius;  // measured 2e-8 um
  }
}

TEST(CavityTruth, AgreesWithCarvedTruthInTwoCrossingChannels) {
  const std::vector<Capsule> capsules = {{{-1.5, 0.0, 0.0}, {1.5, 0.0, 0.0}, kMillRadiusMm},
                                         {{-0.9, -1.2, 0.25}, {0.9, 1.2, 0.1}, kMillRadiusMm}};
  std::vector<Sweep> sweeps;
  for (const Capsule& c : capsules)
    for (int k = 0; k < 30; ++k) sweeps.push_back({c.a + (c.b - c.a) * (k / 30.0), c.a + (c.b - c.a) * ((k + 1) / 30.0)});
  const auto surface =
      std::make_shared<const SweptSurface>(SweptPath(sweeps, kMillRadiusMm), [](Vec3 p) { return 1.1 - length(p); });
  Random random(4);
  for (const double radius : {0.25, 0.34}) {
    // The plane lies 100 mm above.
    CarvedTruth carved(std::make_shared<CarvedBlock>(Vec3(0.0, 0.0, 1.0), 100.0, capsules, radius, kThinnerMm),
                       std::make_shared<CarvedMemory>());
    CavityTruth truth(surface, radius, kThinnerMm);
    carved.start(Vec3(0.0));
    truth.start(Vec3(0.0));
    double worst = 0.0;
    Vec3 device(0.0);
    int apart = 0, contacts = 0;
    for (int leg = 0; leg < 14; ++leg) {
      const Vec3 from = device;
      device = {random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.35, 0.5)};
      const int ticks = static_cast<int>(length(device - from) / 0.02) + 1;
      for (int k = 1; k <= ticks; ++k) {
        const Vec3 at = from + (device - from) * (static_cast<double>(k) / ticks);
        const Exact a = carved.follow(at), b = truth.follow(at);
        contacts += a.contact;
        const double um = length(a.pose_mm - b.pose_mm) / kUm;
        // Where a minimum vanishes, the two may leave it in different sub-steps.
        if (a.vanished || b.vanished) {
          ++apart;
        } else {
          worst = std::max(worst, um);
        }
      }
    }
    EXPECT_GE(contacts, 200) << radius;
    EXPECT_LE(apart, 10) << radius;
    EXPECT_LE(worst, bound(0.05)) << radius;  // measured 0.0004 and 0.004 um
  }
}

TEST(SweptPath, FindsTheDeepestOfAllSweeps) {
  const std::vector<Sweep> sweeps = milled();
  const SweptPath path(sweeps, kMillRadiusMm);
  Random random(8);
  for (int k = 0; k < 100; ++k) {
    const Vec3 p = oblique_frame().to_world({random.between(-0.9, 0.9), random.between(-1.0, 1.0), random.between(-1.9, 0.0)});
    double most = -1e300;
    for (const Sweep& s : sweeps) most = std::max(most, kMillRadiusMm - length(p - nearest_on(s, p)));
    const int guess = static_cast<int>(random.between(0.0, static_cast<double>(sweeps.size())));
    EXPECT_NEAR(path.deepest(p).mm, most, 1e-12);
    EXPECT_NEAR(path.deepest(p, guess).mm, most, 1e-12);
    EXPECT_EQ(path.taken(p, -1, -1, 0.0), most > 0.0);
  }
}

/// The hand's tremor at each tick: the same motion with it less the one without.
std::vector<Vec3> tremor_of(double rms_mm, int ticks) {
  MillMotion with({rms_mm, 0.0, 7}), without({0.0, 0.0, 7});
  std::vector<Vec3> out;
  for (int k = 0; k < ticks; ++k) out.push_back(with.next() - without.next());
  return out;
}

TEST(MillMotion, TremblesAsAskedBetween8And12Hz) {
  constexpr int kTicks = 20000;  // 20 s: lines 0.05 Hz apart
  const std::vector<Vec3> tremor = tremor_of(0.05, kTicks);
  double all = 0.0, inside = 0.0;
  for (const Vec3& t : tremor) all += glm::dot(t, t) / kTicks;
  EXPECT_NEAR(std::sqrt(all), 0.05, 0.001);
  for (int line = 158; line <= 242; ++line) {
    Vec3 cosine(0.0), sine(0.0);
    for (int k = 0; k < kTicks; ++k) {
      const double phi = 6.283185307179586 * line * k / kTicks;
      cosine += tremor[static_cast<std::size_t>(k)] * (2.0 / kTicks * std::cos(phi));
      sine += tremor[static_cast<std::size_t>(k)] * (2.0 / kTicks * std::sin(phi));
    }
    inside += 0.5 * (glm::dot(cosine, cosine) + glm::dot(sine, sine));
  }
  EXPECT_GT(inside, 0.98 * all);
}

TEST(MillMotion, ReadsInTheEncodersSteps) {
  MillMotion coarse({0.05, 0.05, 7}), fine({0.05, 0.0, 7});
  for (int k = 0; k < 3000; ++k) {
    const Vec3 a = coarse.next(), b = fine.next();
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(a[axis] / 0.05, std::round(a[axis] / 0.05), 1e-9);
      EXPECT_LE(std::fabs(a[axis] - b[axis]), 0.025 + 1e-12);
    }
  }
}

TEST(MillMotion, ReachesTheWholeCavity) {
  MillMotion motion({0.0, 0.0, 7});
  Vec3 low(1e9), high(-1e9);
  for (int k = 0; k < 80000; ++k) {
    const Vec3 p = oblique_frame().to_local(motion.next());
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  EXPECT_NEAR(high.x - low.x + 2.0 * kMillRadiusMm, 4.85, 0.01);
  EXPECT_NEAR(high.y - low.y + 2.0 * kMillRadiusMm, 1.9, 0.01);
  EXPECT_NEAR(kMillRadiusMm - low.z, 1.8, 0.01);
}

TEST(Cavity, RecordsAnUnbrokenPathAsLongAsTheRows) {
  Cavity cavity(Method::surface, {0.0, 0.0, 1});
  cavity.mill_until(5.0 / 60.0, [](double) {});
  ASSERT_GT(cavity.sweeps().size(), 100u);
  int joined = 0;
  Vec3 low(1e9), high(-1e9);
  for (std::size_t i = 0; i < cavity.sweeps().size(); ++i) {
    const Sweep& s = cavity.sweeps()[i];
    joined += i > 0 && s.a == cavity.sweeps()[i - 1].b;
    low = glm::min(low, oblique_frame().to_local(s.b));
    high = glm::max(high, oblique_frame().to_local(s.b));
  }
  EXPECT_GT(joined, static_cast<int>(0.98 * static_cast<double>(cavity.sweeps().size())));
  EXPECT_NEAR(high.x - low.x, 4.05, 0.01);  // of the centres: at the end of a row the cut arrives
}

TEST(Cavity, MillsTheSamePointsWithEveryMethod) {
  Options options;
  options.minutes = {0.4 / 60.0};
  options.methods = {"occupancy", "surface"};
  const std::vector<Row> rows = mill_rows(options);
  ASSERT_EQ(rows.size(), 2u);
  for (const Row& row : rows) {
    EXPECT_EQ(row.samples, 400);
    EXPECT_EQ(row.task, "mill");
    EXPECT_EQ(row.shape, "cavity");
    EXPECT_GT(row.tick_us_max, row.tick_us_p50);
  }
  EXPECT_DOUBLE_EQ(rows[0].ratio_to_occupancy, 1.0);
  EXPECT_DOUBLE_EQ(rows[1].ratio_to_occupancy, rows[0].tick_us_mean / rows[1].tick_us_mean);
}

TEST(Cavity, RefusesAnExploringBurThatTheSceneLacks) { EXPECT_THROW(Cavity::bur_of(0.3), std::invalid_argument); }

}  // namespace
}  // namespace cusp::bench
