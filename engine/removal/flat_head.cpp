#include "engine/removal/flat_head.h"

#include <cmath>

#include "engine/volume/voxel_volume.h"

namespace cusp::engine {

namespace {

FlatPiece in_voxels(const OutlinePiece& piece, double voxel_mm) noexcept {
  FlatPiece out;
  const auto f = [voxel_mm](double mm) { return static_cast<float>(mm / voxel_mm); };
  if (piece.radius > 0.0) {
    out.arc = true;
    out.ft = f(piece.centre.t);
    out.fr = f(piece.centre.rho);
    out.radius = f(piece.radius);
    out.mt = static_cast<float>((piece.from.t - piece.centre.t) / piece.radius);
    out.mr = static_cast<float>((piece.from.rho - piece.centre.rho) / piece.radius);
    out.lt = static_cast<float>((piece.to.t - piece.centre.t) / piece.radius);
    out.lr = static_cast<float>((piece.to.rho - piece.centre.rho) / piece.radius);
    out.a = all_lanes(out.ft);
    out.b = all_lanes(out.fr);
    out.c = all_lanes(out.radius);
    return out;
  }
  const double t = piece.to.t - piece.from.t, rho = piece.to.rho - piece.from.rho;
  const double length = std::sqrt(t * t + rho * rho);
  out.nt = static_cast<float>(-rho / length);
  out.nr = static_cast<float>(t / length);
  out.ft = f(piece.from.t);
  out.fr = f(piece.from.rho);
  out.level = static_cast<float>((-rho * piece.from.t + t * piece.from.rho) / (length * voxel_mm));
  out.length = f(length);
  out.a = all_lanes(out.nt);
  out.b = all_lanes(out.nr);
  out.c = all_lanes(out.level);
  return out;
}

/// Widens what a brick's gradients lie between.
void between(AtHand& hand, double gt, double gr) noexcept {
  hand.gt_low = gt < hand.gt_low ? gt : hand.gt_low;
  hand.gt_high = gt > hand.gt_high ? gt : hand.gt_high;
  hand.gr_low = gr < hand.gr_low ? gr : hand.gr_low;
  hand.gr_high = gr > hand.gr_high ? gr : hand.gr_high;
  if (hand.gt_low < 0.0 && hand.gt_high > 0.0) hand.gr_high = 1.0;
}
void between(AtHand& hand, const FlatPiece& piece) noexcept {
  between(hand, piece.arc ? piece.mt : piece.nt, piece.arc ? piece.mr : piece.nr);
  if (piece.arc) between(hand, piece.lt, piece.lr);
}
/// The same for a piece that all of a box stands above.
void between(AtHand& hand, const FlatPiece& piece, OnHalf at, OnHalf half) noexcept {
  if (!piece.arc) return between(hand, piece);
  for (int i = 0; i < 4; ++i) {
    const double t = at.t + (i & 1 ? half.t : -half.t) - piece.ft, rho = at.rho + (i & 2 ? half.rho : -half.rho) - piece.fr;
    const double away = std::sqrt(t * t + rho * rho);
    between(hand, t / away, rho / away);
  }
}

/// How far each piece of a profile is from a box, and which piece the box stands over.
struct Spreads {
  double low[Profile::kMostPieces], high[Profile::kMostPieces];  // of the distance to each piece
  double floor = -1e30;                                          // the greatest of low
  // The whole box stands over the piece, or over its begin or end at least.
  bool above[Profile::kMostPieces], from_start[Profile::kMostPieces], to_end[Profile::kMostPieces];
};

void spread_of_line(const FlatPiece& p, OnHalf at, OnHalf half, int i, Spreads& out) noexcept {
  const double middle = at.t * p.nt + at.rho * p.nr - p.level;
  const double spread = half.t * std::fabs(p.nt) + half.rho * std::fabs(p.nr);
  const double on = (at.t - p.ft) * p.nr - (at.rho - p.fr) * p.nt;
  const double over = half.t * std::fabs(p.nr) + half.rho * std::fabs(p.nt);
  out.from_start[i] = on - over >= 0.0;
  out.to_end[i] = on + over <= p.length;
  out.above[i] = out.from_start[i] && out.to_end[i];
  out.low[i] = middle - spread;
  out.high[i] = middle + spread;
}

void spread_of_arc(const FlatPiece& p, OnHalf at, OnHalf half, int i, Spreads& out) noexcept {
  const double diagonal = std::sqrt(half.t * half.t + half.rho * half.rho);
  const double vt = at.t - p.ft, vr = at.rho - p.fr;
  const double first = vr * p.mt - vt * p.mr, last = vt * p.lr - vr * p.lt;
  const double over_first = half.rho * std::fabs(p.mt) + half.t * std::fabs(p.mr);
  const double over_last = half.t * std::fabs(p.lr) + half.rho * std::fabs(p.lt);
  out.from_start[i] = first + over_first <= 0.0;
  out.to_end[i] = last + over_last <= 0.0;
  const double away = std::sqrt(vt * vt + vr * vr);
  double middle = away - p.radius;
  if (!(first <= 0.0 && last <= 0.0)) {
    const double a = vt * p.mt + vr * p.mr, b = vt * p.lt + vr * p.lr;
    middle = (a > b ? a : b) - p.radius;
  }
  out.above[i] = out.from_start[i] && out.to_end[i] && away > diagonal + 1.0;
  out.low[i] = middle - diagonal;
  out.high[i] = middle + diagonal;
}

}  // namespace

FlatHead::FlatHead(const Profile& profile, double voxel_mm) noexcept : profile_{profile}, voxel_{voxel_mm} {
  for (int i = 0; i < profile.size(); ++i) {
    flat_[i] = in_voxels(profile.piece(i), voxel_mm);
    if (i == 0) continue;
    const FlatPiece &before = flat_[i - 1], &after = flat_[i];
    const float t = (before.arc ? before.lt : before.nt) - (after.arc ? after.mt : after.nt);
    const float rho = (before.arc ? before.lr : before.nr) - (after.arc ? after.mr : after.nr);
    const OnHalf at = profile.piece(i).from;
    joint_[i] = {static_cast<float>(at.t / voxel_),
                 static_cast<float>(at.rho / voxel_),
                 before.arc ? before.lr : before.nr,
                 before.arc ? -before.lt : -before.nt,
                 after.arc ? after.mr : after.nr,
                 after.arc ? -after.mt : -after.nt,
                 t * t + rho * rho < 1e-12f};
  }
  if (profile.size() > 1 && !flat_[0].arc && !flat_[1].arc && flat_[0].nt < -1.0f + 1e-6f && flat_[1].nt > 1e-3f) {
    const double cosine = flat_[1].nr, sine = flat_[1].nt;
    constexpr double kLeast = 0.2;  // a rim of less than half a right angle leaves walls that are read as they were
    if (cosine - sine > kLeast)
      rim_ = {true, joint_[1].t, joint_[1].rho, sine / cosine};
  }
  const FlatPiece &tip = flat_[0], &top = flat_[profile.size() - 1];
  level_tip_ = (tip.arc ? tip.mt : tip.nt) < -1.0f + 1e-6f;
  level_top_ = (top.arc ? top.lt : top.nt) > 1.0f - 1e-6f;
}

void FlatHead::at_hand(OnHalf at, OnHalf half, AtHand& out) const noexcept {
  const int n = profile_.size();
  Spreads s;
  for (int i = 0; i < n; ++i) {
    (flat_[i].arc ? spread_of_arc : spread_of_line)(flat_[i], at, half, i, s);
    s.floor = s.low[i] > s.floor ? s.low[i] : s.floor;
  }
  out.rim = rim_.any && std::fabs(at.t - rim_.t) < half.t + AcuteRim::kReach &&
            std::fabs(at.rho - rim_.rho) < half.rho + AcuteRim::kReach;
  bool corner[Profile::kMostPieces + 1] = {};
  int first = -1, last = -1;
  bool smooth = true, round = true;
  for (int i = 0; i < n; ++i) {
    if (s.high[i] < s.floor - 0.01) continue;
    // Above a piece, the next one that leaves it smoothly is never nearer, and its line never says more.
    if ((i > 0 && s.above[i - 1] && joint_[i].smooth) || (i + 1 < n && s.above[i + 1] && joint_[i + 1].smooth)) continue;
    if (out.pieces > 0) {
      smooth = smooth && joint_[i].smooth;
      out.joint[out.pieces] = &joint_[i];
    }
    round = round && (!flat_[i].arc || flat_[i].radius > kBandVoxels + 0.25);
    out.piece[out.pieces++] = &flat_[i];
    corner[i] = corner[i + 1] = true;
    first = first < 0 ? i : first;
    last = i;
  }
  out.chain = last - first + 1 == out.pieces && (out.pieces <= 2 || smooth) && (round || (out.pieces == 1 && s.above[first])) &&
              (s.from_start[first] || (first == 0 && level_tip_)) && (s.to_end[last] || (last == n - 1 && level_top_));
  if (out.chain && out.pieces == 1 && s.above[first]) {
    between(out, flat_[first], at, half);
    return;
  }
  for (int i = 0; i < n; ++i)
    if (corner[i] || corner[i + 1]) between(out, flat_[i]);
  if (corner[0]) between(out, -1.0, 0.0);
  if (corner[n]) between(out, 1.0, 0.0);
  for (int i = 0; i <= n; ++i) {
    if (!corner[i]) continue;
    const OnHalf c = i == 0 ? profile_.piece(0).from : profile_.piece(i - 1).to;
    out.corner_t[out.corners] = static_cast<float>(c.t / voxel_);
    out.corner_rho[out.corners++] = static_cast<float>(c.rho / voxel_);
  }
}

RimOnWay on_way(const AcuteRim& rim, double way_t, double way_p) noexcept {
  constexpr double kLevel = 0.01;  // of a way that goes across the axis the tip leaves the floor, and the flank the walls
  RimOnWay out;
  const double length = std::sqrt(way_t * way_t + way_p * way_p);
  if (!rim.any || !(length > 1e-6) || !(std::fabs(way_t) > kLevel * length)) return out;
  const double along = way_t / length, aside = way_p / length, steep = std::fabs(along);
  out.leaves = true;
  out.length = static_cast<float>(length);
  out.along = static_cast<float>(along);
  out.aside = static_cast<float>(aside);
  out.minor = static_cast<float>(steep) * rim.rho;
  const double most = rim.lean * steep;
  out.most = most < aside ? static_cast<float>(most / aside) : 1.0f;
  return out;
}

namespace {

/// A rim's ellipse as it is seen along its way, and places that stand still there: x across the plane of the way, y in it.
struct Ellipse {
  float major, minor, most;  // half axes, of x and y; the arc ends where y comes to -most of its own
  Lanes x, y;

  /// How far within the ellipse's tangent the places lie, where that touches at (major tx, minor ty); tx, ty unit.
  Lanes within_tangent(Lanes tx, Lanes ty) const noexcept {
    const Lanes nx = minor * tx, ny = major * ty;
    return (nx * (major * tx - x) + ny * (minor * ty - y)) / sqrt_of(nx * nx + ny * ny + 1e-12f);
  }
  /// The least of that over the arc, by circles of curvature, each of which leaves a hundredth of the error.
  Lanes within_arc() const noexcept {
    const Lanes zero{}, end = all_lanes(-most);
    const float focal = major * major - minor * minor, end_x = __builtin_sqrtf(1.0f - most * most);
    Lanes tx = all_lanes(0.70710678f), ty = tx;
    for (int i = 0; i < 4; ++i) {
      const Lanes ex = focal / major * (tx * tx * tx), ey = -focal / minor * (ty * ty * ty);
      const Lanes rx = major * tx - ex, ry = minor * ty - ey, qx = x - ex, qy = y - ey;
      const Lanes scale = sqrt_of((rx * rx + ry * ry) / (qx * qx + qy * qy + 1e-12f));
      tx = most_of((qx * scale + ex) / major, zero);
      ty = (qy * scale + ey) / minor;
      const Lanes unit = 1.0f / (sqrt_of(tx * tx + ty * ty) + 1e-12f);
      tx = tx * unit;
      ty = ty * unit;
      const LaneMask past = ty < end;
      tx = past ? all_lanes(end_x) : tx;
      ty = past ? end : ty;
    }
    return least_of(within_tangent(tx, ty), within_tangent(all_lanes(end_x), end));
  }
};

}  // namespace

Lanes behind_rim(const AcuteRim& rim, const RimOnWay& way, Lanes t, Lanes p, Lanes q2) noexcept {
  constexpr float kRounding = 1e-4f;  // of the way: two ways that follow each other leave no gap
  const Lanes zero{}, tiny = all_lanes(1e-9f);
  const Lanes up = t - rim.t;
  // The rim passes a place where that is as high over the tip as within the rim: at two places of the way at most.
  const float wt = way.along * way.length, wp = way.aside * way.length, square = wt * wt - wp * wp;
  const Lanes e = rim.rho - up, half = e * wt + p * wp, last = e * e - p * p - q2;
  const Lanes under = half * half - square * last;
  const Lanes root = sqrt_of(most_of(under, zero));
  const Lanes both = half < 0.0f ? half - root : half + root;
  const auto passed = [&](Lanes part, Lanes& at_p, Lanes& rho) {
    at_p = p - part * wp;
    rho = sqrt_of(at_p * at_p + q2);
    // Against the way about the axis the flank comes after the rim: that leaves nothing there.
    const Lanes against = way.along < 0.0f ? at_p : -at_p;
    return (under >= 0.0f) & (part > -kRounding) & (part < 1.0f + kRounding) & (up - part * wt > 0.0f) &
           (against <= way.most * rho + 1e-4f);
  };
  Lanes first_p, first_rho, second_p, second_rho;
  const LaneMask first = passed(-last / (both < 0.0f ? both - tiny : both + tiny), first_p, first_rho);
  const LaneMask second = passed(-both / (square < 0.0f ? square - tiny : square + tiny), second_p, second_rho);
  const LaneMask open = first | second;
  if (bits_of(open) == 0) return zero;
  Ellipse seen{rim.rho, way.minor, way.most, sqrt_of(q2), way.along * p - way.aside * up};
  if (way.most >= 1.0f) seen.y = most_of(seen.y, -seen.y);
  // No deeper than the tangent beside it says.
  const Lanes at_p = first ? first_p : second_p, inverse = 1.0f / ((first ? first_rho : second_rho) + 1e-12f);
  Lanes beside = at_p * inverse * (way.along < 0.0f ? -1.0f : 1.0f);
  if (way.most >= 1.0f) beside = most_of(beside, -beside);
  const Lanes off = least_of(seen.within_arc(), seen.within_tangent(seen.x * inverse, beside));
  return open ? most_of(off, zero) : zero;
}

}  // namespace cusp::engine
