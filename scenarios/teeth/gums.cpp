#include "scenarios/teeth/gums.h"

#include <algorithm>
#include <cmath>

#include "scenarios/teeth/two_threads.h"

namespace cusp::scenarios {
namespace {

constexpr double kStepMm = 0.4;
constexpr double kNeckOnlyMm = 4.0;      // below the CEJ: where gingiva without bone ends
constexpr double kBelowApexMm = 1.5;     // where bone ends
constexpr double kThinMm = 0.7, kThickestMm = 2.4, kThickBelowMm = 8.0;  // over a root, growing downwards
constexpr double kSideBlendMm = 3.0;     // of one tooth's mount into the next
constexpr double kMucosaMm = 0.9;        // over the bone
constexpr double kPapillaMm = 1.6, kPapillaReachMm = 1.4;

constexpr double kFarMm = 4.0;    // no tissue of the gums is further from its tooth
constexpr double kNeckMm = 1.5;   // below the buccal CEJ
constexpr double kKnownMm = 0.7;  // so near to its surface a tooth's field is a distance

/// A tooth's distance on the nodes of a grid that lie about it, at most kFarMm.
struct AboutTooth {
  IVec3 low{0}, size{0};  // nodes
  std::vector<float> distance;
  int neck_node = 0;  // z of the nodes at the neck
  double neck(int x, int y) const noexcept { return double(distance[at({x, y, neck_node})]); }
  std::size_t at(IVec3 v) const noexcept {
    return static_cast<std::size_t>(v.x - low.x + size.x * (v.y - low.y + size.y * (v.z - low.z)));
  }
  /// Bone reaches as far below a short root as below the longest.
  bool holds_column(IVec3 v) const noexcept {
    const IVec3 q = v - low;
    return q.x >= 0 && q.y >= 0 && q.x < size.x && q.y < size.y && q.z < size.z;
  }
  double at_node(IVec3 v) const noexcept { return v.z < low.z ? kFarMm : double(distance[at(v)]); }
};

/// Away from its surface a tooth's field is no distance; it is carried outwards from where it is one, by fast sweeping
/// (upwind differences of |grad d| = 1, in the eight orders of the axes).
AboutTooth distance_about(const ToothBody& tooth, Vec3 origin, IVec3 nodes) {
  AboutTooth out;
  out.low = glm::max(IVec3(glm::floor((tooth.low() - origin - kFarMm) / kStepMm)), IVec3(0));
  const IVec3 high = glm::min(IVec3(glm::ceil((tooth.high() - origin + kFarMm) / kStepMm)), nodes - 1);
  out.size = high - out.low + 1;
  const double neck = (tooth.place().move_mm.z - kNeckMm - origin.z) / kStepMm;
  out.neck_node = std::clamp(static_cast<int>(neck + 0.5), out.low.z, high.z);
  const IVec3 n = out.size;
  out.distance.assign(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z), static_cast<float>(kFarMm));
  std::vector<std::uint8_t> known(out.distance.size(), 0);
  std::size_t i = 0;
  for (int z = 0; z < n.z; ++z) {
    for (int y = 0; y < n.y; ++y) {
      for (int x = 0; x < n.x; ++x, ++i) {
        const Vec3 p = origin + kStepMm * Vec3(out.low + IVec3(x, y, z));
        const Vec3 off = glm::max(glm::max(tooth.low() - p, p - tooth.high()), Vec3(0.0));
        if (glm::dot(off, off) > kKnownMm * kKnownMm) continue;
        const double f = tooth.outside(p);
        if (f > kKnownMm) continue;
        out.distance[i] = static_cast<float>(f);
        known[i] = 1;
      }
    }
  }
  const IVec3 step(1, n.x, n.x * n.y);
  for (int order = 0; order < 8; ++order) {
    for (int c = 0; c < n.z; ++c) {
      for (int b = 0; b < n.y; ++b) {
        for (int a = 0; a < n.x; ++a) {
          const IVec3 v(order & 1 ? n.x - 1 - a : a, order & 2 ? n.y - 1 - b : b, order & 4 ? n.z - 1 - c : c);
          const int k = v.x * step.x + v.y * step.y + v.z * step.z;
          if (known[static_cast<std::size_t>(k)]) continue;
          float& own = out.distance[static_cast<std::size_t>(k)];
          double u[3];
          for (int axis = 0; axis < 3; ++axis) {
            const double before = v[axis] > 0 ? double(out.distance[static_cast<std::size_t>(k - step[axis])]) : kFarMm;
            const double behind = v[axis] + 1 < n[axis] ? double(out.distance[static_cast<std::size_t>(k + step[axis])]) : kFarMm;
            u[axis] = std::min(before, behind);
          }
          // What comes from a neighbour is at least step / sqrt(3) more than it has.
          if (std::min({u[0], u[1], u[2]}) + 0.5 * kStepMm >= double(own)) continue;
          std::sort(u, u + 3);
          double d = u[0] + kStepMm;
          if (d > u[1]) {
            d = 0.5 * (u[0] + u[1] + std::sqrt(std::max(0.0, 2.0 * kStepMm * kStepMm - (u[0] - u[1]) * (u[0] - u[1]))));
            if (d > u[2]) {
              const double sum = u[0] + u[1] + u[2], squares = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
              d = (sum + std::sqrt(std::max(0.0, sum * sum - 3.0 * (squares - kStepMm * kStepMm)))) / 3.0;
            }
          }
          own = std::min(own, static_cast<float>(d));
        }
      }
    }
  }
  return out;
}

}  // namespace

double Gums::Coarse::at(Vec3 p) const noexcept {
  // Beyond the samples that a cubic needs, the last value stands: carried on, it would swing back.
  const Vec3 q = glm::clamp((p - low) / kStepMm, Vec3(1.0), Vec3(size - 2));
  const IVec3 i = glm::clamp(IVec3(glm::floor(q)), IVec3(1), size - 3);
  double w[3][4];
  for (int a = 0; a < 3; ++a) {
    const double t = q[a] - i[a], t2 = t * t, t3 = t2 * t;
    w[a][0] = 0.5 * (2 * t2 - t3 - t);
    w[a][1] = 0.5 * (3 * t3 - 5 * t2 + 2);
    w[a][2] = 0.5 * (4 * t2 - 3 * t3 + t);
    w[a][3] = 0.5 * (t3 - t2);
  }
  double sum = 0.0;
  for (int c = 0; c < 4; ++c) {
    double plane = 0.0;
    for (int b = 0; b < 4; ++b) {
      const float* row = &values[static_cast<std::size_t>(i.x - 1 + size.x * (i.y - 1 + b + size.y * (i.z - 1 + c)))];
      plane += w[1][b] * (w[0][0] * double(row[0]) + w[0][1] * double(row[1]) + w[0][2] * double(row[2]) + w[0][3] * double(row[3]));
    }
    sum += w[2][c] * plane;
  }
  return sum;
}

Gums::Gums(const std::vector<const ToothBody*>& teeth, Parts parts) : parts_(parts) {
  low_ = Vec3(1e9);
  high_ = Vec3(-1e9);
  double neck = 1e9;
  for (const ToothBody* t : teeth) {
    low_ = glm::min(low_, t->low());
    high_ = glm::max(high_, t->high());
    neck = std::min(neck, t->place().move_mm.z);
  }
  floor_ = parts.bone ? low_.z - kBelowApexMm : neck - kNeckOnlyMm;
  const double wide = kThickestMm + 0.25 * kSideBlendMm + 0.2;  // where two teeth meet the blend bulges by a quarter
  low_ = Vec3(low_.x - wide, low_.y - wide, floor_ - 0.2);
  high_ += Vec3(wide, wide, -1.0);
  for (Coarse* c : {&surface_, &bone_, &tooth_}) {
    c->low = low_ - 3.0 * kStepMm;
    c->size = IVec3(glm::ceil((high_ - low_) / kStepMm)) + 7;
    c->values.resize(static_cast<std::size_t>(c->size.x) * static_cast<std::size_t>(c->size.y) * static_cast<std::size_t>(c->size.z));
  }
  std::vector<AboutTooth> about(teeth.size());
  in_two_threads(static_cast<int>(teeth.size()), [&](int i) {
    const auto at = static_cast<std::size_t>(i);
    about[at] = distance_about(*teeth[at], surface_.low, surface_.size);
  });
  in_two_threads(surface_.size.z, [&](int k) {
    for (int j = 0; j < surface_.size.y; ++j) {
      for (int i = 0; i < surface_.size.x; ++i) {
        const Vec3 p = surface_.low + kStepMm * Vec3(i, j, k);
        double side = 1e9, margin = 1e9, crest = 1e9, nearest = 1e9, second = 1e9;
        for (std::size_t t = 0; t < teeth.size(); ++t) {
          if (!about[t].holds_column({i, j, k})) continue;
          const double d = about[t].at_node({i, j, k}), clear = std::max(d, 0.0);
          if (d >= kFarMm && about[t].neck(i, j) >= kFarMm) continue;
          const double h = teeth[t]->above_cej(p), over = p.z - teeth[t]->place().move_mm.z;
          // About the crown along it; below, a column about the neck: it fills what lies between the roots.
          const double column = smin(about[t].neck(i, j), d + 0.3, 1.0), below_neck = smoothstep(-0.5, -2.5, over);
          const double beside = d + below_neck * (column - d);
          side = smin(side, beside - (kThinMm + (kThickestMm - kThinMm) * smoothstep(0.0, kThickBelowMm, -h)), kSideBlendMm);
          margin = smin(margin, h - kGumMarginMm + 0.5 * clear, 0.8);
          crest = smin(crest, h + kBoneCrestMm + 0.2 * clear, 0.8);
          second = std::min(second, std::max(nearest, clear));
          nearest = std::min(nearest, d);
        }
        if (nearest > 1e8) nearest = side = margin = crest = kFarMm;
        const double both = std::max(nearest, 0.0) + second;
        if (both < 4.0) margin -= kPapillaMm * std::exp(-(both / kPapillaReachMm) * (both / kPapillaReachMm));
        const double below = floor_ - p.z;
        const double gum = smax(smax(margin, side, 0.5), below, 0.5);
        const double bone = smax(smax(crest, side + (parts_.gingiva ? kMucosaMm : 0.0), 0.8), below + (parts_.gingiva ? 0.3 : 0.0), 0.5);
        const auto at = static_cast<std::size_t>(i + surface_.size.x * (j + surface_.size.y * k));
        surface_.values[at] = static_cast<float>(parts_.gingiva ? gum : bone);
        bone_.values[at] = static_cast<float>(parts_.bone ? bone : 4.0);
        tooth_.values[at] = static_cast<float>(nearest);
      }
    }
  });
}

Tissue Gums::inside(Vec3 p, double) const noexcept {
  const double bone = bone_.at(p);
  if (parts_.bone && bone < kLigamentMm && tooth_.at(p) < kLigamentMm) return Tissue::ligament;
  if (parts_.bone && (bone < 0.0 || !parts_.gingiva)) return Tissue::bone;
  return Tissue::gingiva;
}

Tissue Gums::whole(Vec3 p, double far) const noexcept {
  const double bone = bone_.at(p), tooth = tooth_.at(p);
  if (bone < -far && tooth > far + kLigamentMm) return Tissue::bone;
  if (parts_.gingiva && bone > far + kLigamentMm) return Tissue::gingiva;
  return Tissue::empty;
}

}  // namespace cusp::scenarios
