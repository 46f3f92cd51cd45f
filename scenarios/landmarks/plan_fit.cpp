#include "scenarios/landmarks/plan_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scenarios/teeth/shape.h"

namespace cusp::scenarios {

namespace {

constexpr double kStepMm = 0.3;       // between samples of the table's heights
constexpr double kBesideMm = 1.5;     // sampled beside the table's crown: where the specimen is not to stand
constexpr double kCrownShare = 0.75;  // of the crown's length that is looked at from above: roots spread below it
constexpr int kTurns = 24, kStarts = 3, kHalvings = 7, kRounds = 3;
constexpr double kLeastScale = 0.7, kMostScale = 1.4;  // four times the spread of teeth (teeth/shape.cpp)

/// Turn, shift along x and y, scale along mesial and buccal.
using Parameters = std::array<double, 5>;
constexpr Parameters kFirstStep = {8.0 * std::numbers::pi / 180.0, 0.4, 0.4, 0.05, 0.05};

struct Sample {
  Vec2 at_mm{0.0};
  double below_mm = 0;  // the highest place, at most deepest_mm
};

class Fitter {
 public:
  Fitter(const ToothSurface& tooth, const ToothShape& table, Hand hand) : tooth_(tooth), hand_(hand) {
    const Vec3 low = table.low(), high = table.high();
    table_top_mm_ = high.z;
    deepest_mm_ = kCrownShare * high.z;
    Vec2 from(1e9), to(-1e9);
    for (double y = low.y - kBesideMm; y <= high.y + kBesideMm; y += kStepMm)
      for (double x = low.x - kBesideMm; x <= high.x + kBesideMm; x += kStepMm) {
        const auto p = table.top_at(x, y);
        const double below = p ? std::min(table_top_mm_ - p->z, deepest_mm_) : deepest_mm_;
        samples_.push_back({{x, y}, below});
        if (below >= deepest_mm_) continue;
        from = glm::min(from, Vec2(x, y));
        to = glm::max(to, Vec2(x, y));
      }
    table_middle_mm_ = 0.5 * (from + to);
    table_size_mm_ = to - from;
    columns_ = tooth.columns_above(tooth.top_mm() - deepest_mm_);
  }

  PlanFit best() const {
    std::vector<std::pair<double, Parameters>> starts;
    for (int i = 0; i < kTurns; ++i) {
      const Parameters p = start_at(2.0 * std::numbers::pi * i / kTurns);
      starts.emplace_back(off_mm(p), p);
    }
    std::ranges::sort(starts);
    starts.resize(kStarts);
    for (auto& [off, p] : starts) descend(off, p);
    const auto& [off, p] = *std::ranges::min_element(starts);
    PlanFit out = fit_of(p);
    out.off_mm = off;
    return out;
  }

 private:
  PlanFit fit_of(const Parameters& p) const noexcept {
    PlanFit out;
    out.mesial = {std::cos(p[0]), std::sin(p[0])};
    const double side = hand_ == Hand::as_table ? 1.0 : -1.0;
    out.buccal = side * Vec2(-out.mesial.y, out.mesial.x);
    out.centre_mm = {p[1], p[2]};
    out.table_centre_mm = table_middle_mm_;
    out.scale = {p[3], p[4]};
    return out;
  }
  /// Middle and scales by the crown's extents along the two ways.
  Parameters start_at(double turn) const noexcept {
    const PlanFit ways = fit_of({turn, 0, 0, 1, 1});
    Vec2 from(1e9), to(-1e9);
    for (const Vec2 p : columns_) {
      const Vec2 at(glm::dot(p, ways.mesial), glm::dot(p, ways.buccal));
      from = glm::min(from, at);
      to = glm::max(to, at);
    }
    const Vec2 middle = 0.5 * (from + to), scale = glm::clamp((to - from) / table_size_mm_, kLeastScale, kMostScale);
    const Vec2 centre = middle.x * ways.mesial + middle.y * ways.buccal;
    return {turn, centre.x, centre.y, scale.x, scale.y};
  }
  double off_mm(const Parameters& p) const noexcept {
    const PlanFit fit = fit_of(p);
    double sum = 0;
    int standing = 0;
    for (const Sample& sample : samples_) {
      const auto z = tooth_.height_mm(fit.to_specimen(sample.at_mm));
      const double below = z ? std::min(tooth_.top_mm() - *z, deepest_mm_) : deepest_mm_;
      sum += std::fabs(below - sample.below_mm);
      standing += below < deepest_mm_ || sample.below_mm < deepest_mm_ ? 1 : 0;
    }
    return standing > 0 ? sum / standing : deepest_mm_;
  }
  void descend(double& off, Parameters& p) const {
    Parameters step = kFirstStep;
    for (int halving = 0; halving < kHalvings; ++halving) {
      for (int round = 0; round < kRounds; ++round)
        for (std::size_t i = 0; i < p.size(); ++i)
          for (const double way : {-1.0, 1.0}) try_step(off, p, i, way * step[i]);
      for (double& one : step) one *= 0.5;
    }
  }
  void try_step(double& off, Parameters& p, std::size_t i, double by) const {
    Parameters next = p;
    next[i] += by;
    if (i >= 3 && !(next[i] >= kLeastScale && next[i] <= kMostScale)) return;
    const double found = off_mm(next);
    if (found >= off) return;
    off = found;
    p = next;
  }

  const ToothSurface& tooth_;
  Hand hand_;
  double table_top_mm_ = 0, deepest_mm_ = 0;
  Vec2 table_middle_mm_{0.0}, table_size_mm_{1.0};
  std::vector<Sample> samples_;
  std::vector<Vec2> columns_;
};

}  // namespace

PlanFit fit_plan(const ToothSurface& tooth, const ToothShape& table, Hand hand) { return Fitter(tooth, table, hand).best(); }

}  // namespace cusp::scenarios
