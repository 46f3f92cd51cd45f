#include "engine/removal/flat_head.h"

#include <cmath>

#include "engine/volume/voxel_volume.h"

namespace cusp {

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

}  // namespace

FlatHead::FlatHead(const Profile& profile, double voxel_mm) noexcept : profile_{profile}, voxel_{voxel_mm} {
  for (int i = 0; i < profile.size(); ++i) {
    flat_[i] = in_voxels(profile.piece(i), voxel_mm);
    if (i == 0) continue;
    const FlatPiece &before = flat_[i - 1], &after = flat_[i];
    const float t = (before.arc ? before.lt : before.nt) - (after.arc ? after.mt : after.nt);
    const float rho = (before.arc ? before.lr : before.nr) - (after.arc ? after.mr : after.nr);
    smooth_[i] = t * t + rho * rho < 1e-12f;
    const OnHalf at = profile.piece(i).from;
    joint_[i] = {static_cast<float>(at.t / voxel_),
                 static_cast<float>(at.rho / voxel_),
                 before.arc ? before.lr : before.nr,
                 before.arc ? -before.lt : -before.nt,
                 after.arc ? after.mr : after.nr,
                 after.arc ? -after.mt : -after.nt,
                 smooth_[i]};
  }
  if (profile.size() > 1 && !flat_[0].arc && !flat_[1].arc && flat_[0].nt < -1.0f + 1e-6f && flat_[1].nt > 1e-3f) {
    // Full depth is due where a place is as high over the tip as off the wall; there the flank is cos - sin of that deep.
    const double cosine = flat_[1].nr, sine = flat_[1].nt;
    const double flank = cosine - sine;
    constexpr double kLeast = 0.2;  // of it: a rim of less than half a right angle leaves walls that are read as they were
    if (flank > kLeast) {
      const double more = 1.0 / flank - 1.0, along = 1.0 + 5.0 * more, off = 2.0 * more * flank;
      const double t = along * sine + off, r = along * cosine - off, length = std::sqrt(t * t + r * r);
      rim_ = {static_cast<float>(more), joint_[1].t, joint_[1].rho, flat_[1].nt, flat_[1].nr,
              static_cast<float>(std::sqrt(2.0) / flank), t / length, r / length};
    }
  }
  const FlatPiece &tip = flat_[0], &top = flat_[profile.size() - 1];
  level_tip_ = (tip.arc ? tip.mt : tip.nt) < -1.0f + 1e-6f;
  level_top_ = (top.arc ? top.lt : top.nt) > 1.0f - 1e-6f;
}

void FlatHead::at_hand(OnHalf at, OnHalf half, AtHand& out) const noexcept {
  const int n = profile_.size();
  double low[Profile::kMostPieces], high[Profile::kMostPieces];
  bool above[Profile::kMostPieces], from_start[Profile::kMostPieces], to_end[Profile::kMostPieces];
  const double diagonal = std::sqrt(half.t * half.t + half.rho * half.rho);
  double floor = -1e30;
  for (int i = 0; i < n; ++i) {
    const FlatPiece& p = flat_[i];
    double middle = 0.0, spread = 0.0;
    if (!p.arc) {
      middle = at.t * p.nt + at.rho * p.nr - p.level;
      spread = half.t * std::fabs(p.nt) + half.rho * std::fabs(p.nr);
      const double on = (at.t - p.ft) * p.nr - (at.rho - p.fr) * p.nt;
      const double over = half.t * std::fabs(p.nr) + half.rho * std::fabs(p.nt);
      from_start[i] = on - over >= 0.0;
      to_end[i] = on + over <= p.length;
      above[i] = from_start[i] && to_end[i];
    } else {
      const double vt = at.t - p.ft, vr = at.rho - p.fr;
      const double first = vr * p.mt - vt * p.mr, last = vt * p.lr - vr * p.lt;
      const double over_first = half.rho * std::fabs(p.mt) + half.t * std::fabs(p.mr);
      const double over_last = half.t * std::fabs(p.lr) + half.rho * std::fabs(p.lt);
      from_start[i] = first + over_first <= 0.0;
      to_end[i] = last + over_last <= 0.0;
      const double away = std::sqrt(vt * vt + vr * vr);
      if (first <= 0.0 && last <= 0.0) {
        middle = away - p.radius;
      } else {
        const double a = vt * p.mt + vr * p.mr, b = vt * p.lt + vr * p.lr;
        middle = (a > b ? a : b) - p.radius;
      }
      spread = diagonal;
      above[i] = from_start[i] && to_end[i] && away > diagonal + 1.0;
    }
    low[i] = middle - spread;
    if (i == 1 && rim_.more > 0.0f && low[i] < 0.0) low[i] *= 1.0 + rim_.more;
    high[i] = middle + spread;
    floor = low[i] > floor ? low[i] : floor;
  }
  bool corner[Profile::kMostPieces + 1] = {};
  int first = -1, last = -1;
  bool smooth = true, round = true;
  for (int i = 0; i < n; ++i) {
    if (high[i] < floor - 0.01) continue;
    // Above a piece, the next one that leaves it smoothly is never nearer, and its line never says more.
    if ((i > 0 && above[i - 1] && smooth_[i]) || (i + 1 < n && above[i + 1] && smooth_[i + 1])) continue;
    if (out.pieces > 0) {
      smooth = smooth && smooth_[i];
      out.joint[out.pieces] = &joint_[i];
    }
    round = round && (!flat_[i].arc || flat_[i].radius > kBandVoxels + 0.25);
    out.piece[out.pieces++] = &flat_[i];
    if (i == 1 && rim_.more > 0.0f) {
      out.rim = &rim_;
      out.flank = &flat_[i];
      between(out, rim_.turned_t, rim_.turned_r);
    }
    corner[i] = corner[i + 1] = true;
    first = first < 0 ? i : first;
    last = i;
  }
  out.chain = last - first + 1 == out.pieces && (out.pieces <= 2 || smooth) && (round || (out.pieces == 1 && above[first])) &&
              (from_start[first] || (first == 0 && level_tip_)) && (to_end[last] || (last == n - 1 && level_top_));
  if (out.chain && out.pieces == 1 && above[first]) {
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

}  // namespace cusp
