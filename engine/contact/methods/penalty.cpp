#include "engine/contact/methods/penalty.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/contact/methods/trilinear_field.h"

namespace cusp::engine {

namespace {
constexpr double kHolderVoxels = 3.0;  // spacing of the neck's and shank's points
constexpr int kHalvings = 40;          // of the bur's diameter: to 1e-12 mm
constexpr int kChords = 24;            // of another head's depth
constexpr double kSettledMm = 1e-6;

/// What the points of a shell in tissue push. `head`: the sum of the head's; `holder`: of neck and shank, unscaled.
struct Pushes {
  Vec3 head{0.0}, holder{0.0};
  double holder_depth_mm = 0.0;
  std::array<double, kTissueCodes> of{};  // by tissue
};

Pushes pushes_of(const TrilinearField& field, const PointShell& shell, const TissueBox& box, Vec3 device) noexcept {
  Pushes out;
  const double even = shell.holder.empty() ? 0.0 : 1.0 / static_cast<double>(shell.holder.size());
  const auto of_head = [&](const PointShell::HeadPoint& point, Vec3 place) {
    const double d = field.at(place);
    if (d >= 0.0) return;
    const double push = -d * point.share;
    out.head -= point.out * push;
    out.of[index_of(field.tissue(place))] += push;
  };
  const auto of_holder = [&](const PointShell::HolderPoint& point, Vec3 place) {
    const double d = field.at(place);
    if (d >= 0.0) return;
    out.holder += point.out * d;
    out.holder_depth_mm = std::max(out.holder_depth_mm, -d);
    out.of[index_of(field.tissue(place))] -= d * even;
  };
  shell.for_points_in(box, device, of_head, of_holder);
  return out;
}

/// The heaviest tissue, and the stiffness as the mean over the pushes.
void take_tissue(const Scene& scene, const Pushes& pushes, BandedContact& out) noexcept {
  double weight = 0.0, stiff = 0.0, heaviest = 0.0;
  for (std::size_t t = 0; t < pushes.of.size(); ++t) {
    const double push = pushes.of[t];
    if (push <= 0.0) continue;
    weight += push;
    stiff += push * scene.tissues[t].stiffness_n_per_mm;
    if (push > heaviest) {
      heaviest = push;
      out.tissue = static_cast<Tissue>(t);
    }
  }
  out.stiffness_n_per_mm = stiff / weight;
}

}  // namespace

Penalty::Penalty(const Scene& scene, const Volume& volume)
    : box_(volume), band_mm_(kBandVoxels * volume.grid().voxel_mm) {
  const double voxel = volume.grid().voxel_mm;
  for (const Bur& bur : scene.burs) {
    Shell shell;
    shell.points = shell_of(bur, scene.tool_axis, voxel, kHolderVoxels * voxel);  // a point a voxel, as in VPS
    shell.radius_mm = bur.radius_mm;
    shell.deepest_mm = std::min(2.0 * bur.radius_mm, bur.radius_mm + 0.5 * band_mm_);
    // A flat end's points all reach the band's end at once: a deeper push is not measured.
    if (!bur.head.ball()) shell.deepest_mm = band_mm_;
    shell.most = response(shell, shell.deepest_mm);
    shells_.push_back(std::move(shell));
  }
}

/// Mean over the sphere of push times the cosine to the plane's normal, for a plane at this depth. With h the height
/// over the lowest point a sphere has equal skin for equal h: 1/2r of the integral over h of min(d - h, band) (1 -
/// h/r).
double Penalty::response(const Shell& shell, double depth_mm) const noexcept {
  const double r = shell.radius_mm;
  const double top = std::min(depth_mm, 2.0 * r);
  const double full = std::clamp(depth_mm - band_mm_, 0.0, top);  // below this height the field is clamped
  const auto rising = [&](double h) {
    return depth_mm * h - 0.5 * h * h - (0.5 * depth_mm * h * h - h * h * h / 3.0) / r;
  };
  const double clamped = band_mm_ * (full - full * full / (2.0 * r));
  return (clamped + rising(top) - rising(full)) / (2.0 * r);
}

double Penalty::depth_of(const Shell& shell, double sum_mm) const noexcept {
  if (sum_mm >= shell.most) return shell.deepest_mm;
  double low = 0.0, high = shell.deepest_mm;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (response(shell, middle) < sum_mm ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The same of a shell whose lowest point against the plane lies lowest_mm along -normal from the pivot.
double Penalty::response(const Shell& shell, Vec3 normal, double lowest_mm, double depth_mm) const noexcept {
  double sum = 0.0;
  for (const PointShell::HeadPoint& point : shell.points.head) {
    const double deep = depth_mm - (lowest_mm + glm::dot(point.offset_mm, normal));
    if (deep > 0.0) sum -= point.share * (deep < band_mm_ ? deep : band_mm_) * glm::dot(point.out, normal);
  }
  return sum;
}

double Penalty::depth_of(const Shell& shell, Vec3 normal, double sum_mm) const noexcept {
  double lowest = -1e300;
  for (const PointShell::HeadPoint& point : shell.points.head)
    lowest = std::max(lowest, -glm::dot(point.offset_mm, normal));
  double low = 0.0, high = shell.deepest_mm;
  if (response(shell, normal, lowest, high) <= sum_mm) return high;
  // It rises piece by piece and bends little: between chords and halves.
  double at_low = 0.0, at_high = response(shell, normal, lowest, high);
  for (int i = 0; i < kChords && high - low > kSettledMm; ++i) {
    const double chord = low + (high - low) * (sum_mm - at_low) / (at_high - at_low);
    const double middle = i % 3 == 2 ? 0.5 * (low + high) : chord;
    const double at_middle = response(shell, normal, lowest, middle);
    if (std::fabs(at_middle - sum_mm) < 1e-9 * at_high) return middle;
    (at_middle < sum_mm ? low : high) = middle;
    (at_middle < sum_mm ? at_low : at_high) = at_middle;
  }
  return 0.5 * (low + high);
}

BandedContact Penalty::solve(const Volume& volume, const Scene& scene, std::size_t bur, Vec3 /*from*/, Vec3 device,
                             Vec3& /*kept*/) noexcept {
  BandedContact out;
  out.pose_mm = device;
  const Shell& shell = shells_[bur];
  const Bur& shape = scene.burs[bur];
  const TrilinearField field(volume);
  const Pushes pushes = pushes_of(field, shell.points, box_, device);

  Vec3 push(0.0);
  const double sum = length_of(pushes.head);
  if (sum > 1e-12)
    push = pushes.head * ((shape.head.ball() ? depth_of(shell, sum) : depth_of(shell, pushes.head / sum, sum)) / sum);
  const double holding = length_of(pushes.holder);
  if (holding > 1e-12) {
    out.shank = true;
    out.shank_normal = pushes.holder / holding;
    push += out.shank_normal * pushes.holder_depth_mm;
  }
  if (length_of(push) <= 1e-9) return out;
  out.touching = true;
  take_tissue(scene, pushes, out);
  out.pose_mm = device + push;
  return out;
}

}  // namespace cusp::engine
