#include "scenarios/landmarks/valley.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cusp::scenarios {

namespace {

constexpr double kFirstStepMm = 0.2, kLastStepMm = 0.01;
constexpr double kOffsetMm = 0.05;  // between the places beside a line that are compared
constexpr double kTurnCost = 4.0;   // mm of height for a shift aside by 1 mm between two points, squared
constexpr double kNoHeight = 5.0;   // mm: beside the surface no line runs

/// A peak, pit, valley or crest stands out of what lies so far about or beside it by so much: flatter ones have no place.
constexpr double kAboutMm = 0.4, kAsideMm = 0.3, kStandsOutMm = 0.03;
constexpr int kRound = 16;

double signed_height(const ToothSurface& tooth, Vec2 at, Looks looks) noexcept {
  const auto z = tooth.height_mm(at);
  return !z ? -1e9 : looks == Looks::for_high ? *z : -*z;
}

bool stands_out(const ToothSurface& tooth, Vec2 at, Looks looks) noexcept {
  const double height = signed_height(tooth, at, looks);
  for (int i = 0; i < kRound; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRound;
    if (signed_height(tooth, at + kAboutMm * Vec2(std::cos(angle), std::sin(angle)), looks) > height - kStandsOutMm) return false;
  }
  return true;
}

bool stands_out_of_sides(const ToothSurface& tooth, Vec2 at, Vec2 across, Looks looks) noexcept {
  const double height = signed_height(tooth, at, looks);
  for (const double side : {-kAsideMm, kAsideMm})
    if (signed_height(tooth, at + side * across, looks) > height - kStandsOutMm) return false;
  return true;
}

/// Unit vectors across a line at each of its points.
std::vector<Vec2> across(const std::vector<Vec2>& line) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 along = line[std::min(i + 2, line.size() - 1)] - line[i < 2 ? 0 : i - 2];
    const double length = glm::length(along);
    out.push_back(length > 0.0 ? Vec2(-along.y, along.x) / length : Vec2(0.0, 1.0));
  }
  return out;
}

/// Heights beside each point of a line, the sought ones least; then the way through them with the least sum.
class Ways {
 public:
  Ways(const ToothSurface& tooth, const std::vector<Vec2>& line, double reach_mm, Looks looks)
      : side_(static_cast<int>(reach_mm / kOffsetMm)), cost_(line.size(), std::vector<double>(static_cast<std::size_t>(2 * side_ + 1))) {
    const std::vector<Vec2> normal = across(line);
    for (std::size_t i = 0; i < line.size(); ++i) {
      double highest = -1e9;
      for (int k = -side_; k <= side_; ++k) {
        const double h = signed_height(tooth, line[i] + k * kOffsetMm * normal[i], looks);
        at(i, k) = -h;
        highest = std::max(highest, h);
      }
      for (int k = -side_; k <= side_; ++k) at(i, k) = std::min(at(i, k) + highest, kNoHeight);
    }
  }
  /// For each point the offset of the best way, in kOffsetMm.
  std::vector<int> best() const {
    const std::size_t n = cost_.size();
    std::vector<std::vector<double>> sum = cost_;
    std::vector<std::vector<int>> from(n, std::vector<int>(cost_.front().size(), 0));
    for (std::size_t i = 1; i < n; ++i)
      for (std::size_t k = 0; k < sum[i].size(); ++k) {
        double least = 1e18;
        for (std::size_t j = k < 3 ? 0 : k - 3; j < std::min(k + 4, sum[i].size()); ++j) {
          const double aside = kOffsetMm * (static_cast<double>(k) - static_cast<double>(j));
          const double way = sum[i - 1][j] + kTurnCost * aside * aside;
          if (way >= least) continue;
          least = way;
          from[i][k] = static_cast<int>(j);
        }
        sum[i][k] += least;
      }
    std::vector<int> out(n);
    auto k = static_cast<std::size_t>(std::ranges::min_element(sum.back()) - sum.back().begin());
    for (std::size_t i = n; i-- > 0;) {
      out[i] = static_cast<int>(k) - side_;
      k = static_cast<std::size_t>(from[i][k]);
    }
    return out;
  }
  int side() const noexcept { return side_; }

 private:
  double& at(std::size_t i, int k) noexcept { return cost_[i][static_cast<std::size_t>(k + side_)]; }
  int side_;
  std::vector<std::vector<double>> cost_;
};

}  // namespace

std::optional<Vec3> extreme_near(const ToothSurface& tooth, Vec2 start_mm, double reach_mm, Looks looks) {
  Vec2 best = start_mm;
  double height = signed_height(tooth, best, looks);
  if (height <= -1e8) return std::nullopt;
  for (double step = kFirstStepMm; step > kLastStepMm; step *= 0.5)
    for (bool moved = true; moved;) {
      moved = false;
      const Vec2 about = best;
      for (int i = -1; i <= 1; ++i)
        for (int j = -1; j <= 1; ++j) {
          const Vec2 next = about + step * Vec2(i, j);
          const double h = signed_height(tooth, next, looks);
          if (h <= height) continue;
          height = h;
          best = next;
          moved = true;
        }
      if (glm::length(best - start_mm) > reach_mm) return std::nullopt;
    }
  if (!stands_out(tooth, best, looks)) return std::nullopt;
  return Vec3(best, looks == Looks::for_high ? height : -height);
}

std::vector<Vec3> line_near(const ToothSurface& tooth, const std::vector<Vec2>& expected, double reach_mm, Looks looks) {
  if (expected.size() < 2) return {};
  const Ways ways(tooth, expected, reach_mm, looks);
  const std::vector<int> offset = ways.best();
  const std::vector<Vec2> normal = across(expected);
  const auto place = [&](std::size_t i) { return expected[i] + offset[i] * kOffsetMm * normal[i]; };
  const auto is_of_line = [&](std::size_t i) {
    return std::abs(offset[i]) < ways.side() && stands_out_of_sides(tooth, place(i), normal[i], looks);
  };
  std::size_t first = 0, last = expected.size();
  while (first < last && !is_of_line(first)) ++first;
  while (last > first && !is_of_line(last - 1)) --last;
  std::vector<Vec3> out;
  for (std::size_t i = first; i < last; ++i) {
    const Vec2 at = place(i);
    const auto z = tooth.height_mm(at);
    if (is_of_line(i) && z) out.emplace_back(at, *z);
  }
  if (2 * out.size() < expected.size() || out.size() < 2) out.clear();
  return out;
}

}  // namespace cusp::scenarios
