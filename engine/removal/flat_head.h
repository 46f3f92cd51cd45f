/// A bur's outline in voxels and single precision, four places at a time: what carving with a head spends its time in.
/// 1e-5 of a voxel at the distances that a band asks for. Wait-free; only + - * / sqrt.
#pragma once

#include "engine/base/lanes.h"
#include "engine/tool/profile.h"

namespace cusp::engine {

/// A piece of the outline, and what tells the places that stand above it.
struct FlatPiece {
  bool arc = false;
  float nt = 0.0f, nr = 0.0f, level = 0.0f, length = 0.0f;          // straight: normal, normal times a point, extent
  float ft = 0.0f, fr = 0.0f;                                       // its first point, or the arc's centre
  float radius = 0.0f, mt = 0.0f, mr = 0.0f, lt = 0.0f, lr = 0.0f;  // arc: radius, its normals at both ends
  Lanes a{}, b{}, c{};  // four times the same: normal and level, or centre and radius
};

/// Where two pieces meet: the point, and the ways along both there.
struct FlatJoint {
  float t = 0.0f, rho = 0.0f, before_t = 0.0f, before_rho = 0.0f, after_t = 0.0f, after_rho = 0.0f;
  bool smooth = false;  // no corner
};

/// The pieces and corners that can be nearest in a brick.
struct AtHand {
  int pieces = 0, corners = 0;
  const FlatPiece* piece[Profile::kMostPieces];
  float corner_t[Profile::kMostPieces + 1], corner_rho[Profile::kMostPieces + 1];
  /// The pieces follow each other, no place stands beyond the first or the last, and what they meet at tells which one is
  /// nearest: joint[i] between piece i - 1 and i.
  bool chain = false;
  const FlatJoint* joint[Profile::kMostPieces];
  bool rim = false;  // an acute rim is so near that what it leaves can be
  // What every gradient in the brick lies between.
  double gt_low = 1.0, gt_high = -1.0, gr_low = 1.0, gr_high = 0.0;
};

/// Four distances to one piece's line or circle.
template <bool kGradient>
inline Lanes distance_of_one(const FlatPiece& piece, Lanes t, Lanes rho, Lanes& gt, Lanes& gr) noexcept {
  if (!piece.arc) {
    if constexpr (kGradient) {
      gt = piece.a;
      gr = piece.b;
    }
    return t * piece.a + rho * piece.b - piece.c;
  }
  const Lanes vt = t - piece.a, vr = rho - piece.b;
  const Lanes away = sqrt_of(vt * vt + vr * vr);
  if constexpr (kGradient) {
    const Lanes scale = 1.0f / (away + 1e-12f);
    gt = vt * scale;
    gr = vr * scale;
  }
  return away - piece.c;
}

/// Four distances to a chain. At a joint with u along the piece before and w along the one after: past both ends the
/// corner is nearest, past one of them the other piece, past none (inside) the one that is less deep.
template <bool kGradient>
inline Lanes distance_of_chain(const AtHand& hand, Lanes t, Lanes rho, Lanes& gt, Lanes& gr) noexcept {
  Lanes d = distance_of_one<kGradient>(*hand.piece[0], t, rho, gt, gr);
  for (int i = 1; i < hand.pieces; ++i) {
    const FlatJoint& joint = *hand.joint[i];
    Lanes nt{}, nr{};
    Lanes next = distance_of_one<kGradient>(*hand.piece[i], t, rho, nt, nr);
    const Lanes ft = t - joint.t, fr = rho - joint.rho;
    const LaneMask past = ft * joint.before_t + fr * joint.before_rho > 0.0f;
    if (joint.smooth) {
      d = past ? next : d;
      if constexpr (kGradient) {
        gt = past ? nt : gt;
        gr = past ? nr : gr;
      }
      continue;
    }
    const LaneMask early = ft * joint.after_t + fr * joint.after_rho < 0.0f;
    const Lanes corner = sqrt_of(ft * ft + fr * fr);
    const LaneMask to_next = past | (~early & (next > d)), at_corner = past & early;
    d = at_corner ? corner : to_next ? next : d;
    if constexpr (kGradient) {
      const Lanes scale = 1.0f / (corner + 1e-12f);
      gt = at_corner ? ft * scale : to_next ? nt : gt;
      gr = at_corner ? fr * scale : to_next ? nr : gr;
    }
  }
  return d;
}

/// Where a corner is nearer than the root of `square`: its square, and the way from it.
template <bool kGradient>
inline LaneMask nearer_corners(const AtHand& hand, Lanes t, Lanes rho, Lanes& square, Lanes& ct, Lanes& cr) noexcept {
  LaneMask out{};
  for (int i = 0; i < hand.corners; ++i) {
    const Lanes vt = t - hand.corner_t[i], vr = rho - hand.corner_rho[i];
    const Lanes of_point = vt * vt + vr * vr;
    const LaneMask nearer = of_point < square;
    square = nearer ? of_point : square;
    out = out | nearer;
    if constexpr (kGradient) {
      ct = nearer ? vt : ct;
      cr = nearer ? vr : cr;
    }
  }
  return out;
}

/// Four distances to the outline, and with kGradient their gradients (else gt and gr are left alone).
template <bool kGradient>
inline Lanes distance_of(const AtHand& hand, Lanes t, Lanes rho, Lanes& gt, Lanes& gr) noexcept {
  if (hand.chain) return distance_of_chain<kGradient>(hand, t, rho, gt, gr);
  const Lanes tiny = all_lanes(1e-12f);
  Lanes most = all_lanes(-1e30f), least = all_lanes(1e15f), ot{}, orho{};
  for (int i = 0; i < hand.pieces; ++i) {
    const FlatPiece& piece = *hand.piece[i];
    Lanes d, nt{}, nr{};
    LaneMask above;
    if (!piece.arc) {
      const Lanes on = (t - piece.ft) * piece.nr - (rho - piece.fr) * piece.nt;
      above = (on >= 0.0f) & (on <= piece.length);
      d = distance_of_one<kGradient>(piece, t, rho, nt, nr);
    } else {
      const Lanes vt = t - piece.ft, vr = rho - piece.fr;
      above = (vr * piece.mt - vt * piece.mr <= 0.0f) & (vt * piece.lr - vr * piece.lt <= 0.0f);
      const Lanes square = vt * vt + vr * vr;
      const Lanes away = sqrt_of(square > tiny ? square : tiny);
      const Lanes first = vt * piece.mt + vr * piece.mr, last = vt * piece.lt + vr * piece.lr;
      const LaneMask to_first = first >= last;
      d = (above ? away : to_first ? first : last) - piece.radius;
      if constexpr (kGradient) {
        const Lanes scale = 1.0f / away;
        nt = above ? vt * scale : to_first ? all_lanes(piece.mt) : all_lanes(piece.lt);
        nr = above ? vr * scale : to_first ? all_lanes(piece.mr) : all_lanes(piece.lr);
      }
    }
    const LaneMask more = d > most, nearer = above & (d > 0.0f) & (d < least);
    most = more ? d : most;
    least = nearer ? d : least;
    if constexpr (kGradient) {
      gt = more ? nt : gt;
      gr = more ? nr : gr;
      ot = nearer ? nt : ot;
      orho = nearer ? nr : orho;
    }
  }
  // On the skin a smooth neighbour's line may say more than the piece that a place stands on, by a rounding.
  const LaneMask outside = most > 1e-4f;
  if (bits_of(outside) == 0) return most;
  Lanes square = least * least, ct{}, cr{};
  const LaneMask cornered = nearer_corners<kGradient>(hand, t, rho, square, ct, cr);
  const Lanes away = sqrt_of(square > tiny ? square : tiny);
  if constexpr (kGradient) {
    const Lanes scale = 1.0f / away;
    gt = outside ? (cornered ? ct * scale : ot) : gt;
    gr = outside ? (cornered ? cr * scale : orho) : gr;
  }
  return outside ? (cornered ? away : least) : most;
}

/// Four places by the bur at the start of its way: t along the axis, p across it in the plane of the way, and the
/// square of q, across both. The way: wt along the axis, wp across it.
struct FourPlaces {
  Lanes t, p, q2;
  Lanes wt, wp;
};

struct Looked {
  Lanes d, slope;
};

/// Distance at a part of the way, and its slope along it.
inline Looked look(const AtHand& hand, const FourPlaces& at, Lanes part) noexcept {
  const Lanes t = at.t - part * at.wt, p = at.p - part * at.wp;
  const Lanes rho = sqrt_of(p * p + at.q2);
  Lanes gt{}, gr{};
  Looked out;
  out.d = distance_of<true>(hand, t, rho, gt, gr);
  // On the axis no way across is a slope.
  out.slope = -(gt * at.wt + gr * (p / (rho + 1e-12f)) * at.wp);
  return out;
}

/// Where the way begins, without the slope.
inline Lanes look_there(const AtHand& hand, Lanes t, Lanes p, Lanes q2) noexcept {
  Lanes gt{}, gr{};
  return distance_of<false>(hand, t, sqrt_of(p * p + q2), gt, gr);
}

/// Whether the head mostly comes to the places or leaves them behind.
enum class HeadMoves : std::uint8_t { towards, away };

/// Distance of four places to all that the head passes on its way. Lanes that
/// would take longer than a few looks are reported in `unsure`.
inline Lanes passing(const AtHand& hand, const FourPlaces& at, HeadMoves which, unsigned& unsure) noexcept {
  constexpr float kLevel = 2e-5f;  // voxels that an answer may be off
  const Lanes zero{}, one = all_lanes(1.0f);
  unsure = 0;
  // Convex along the way: where it still falls at the end, the end is nearest; where it rises from the start, the start.
  Looked low, high;
  if (which == HeadMoves::away) {
    low = look(hand, at, zero);
    if (bits_of(low.slope < 0.0f) == 0) return low.d;
    high = look(hand, at, one);
  } else {
    high = look(hand, at, one);
    if (bits_of(high.slope > 0.0f) == 0) return high.d;
    low = look(hand, at, zero);
  }
  Lanes out = least_of(low.d, high.d);
  LaneMask open = (low.slope < -kLevel) & (high.slope > kLevel);
  // Between them by turns at the secant of the slopes and where the tangents meet, which is no higher than the least.
  Lanes from = zero, to = one;
  constexpr int kMostCandidates = 8;
  for (int i = 0; bits_of(open) != 0; ++i) {
    if (i == kMostCandidates) {
      unsure = bits_of(open);
      break;
    }
    const Lanes width = to - from, rise = open ? high.slope - low.slope : one;
    const Lanes meet = (high.slope * width - (high.d - low.d)) / rise;
    const Lanes floor = low.d + low.slope * meet;
    open = open & (out - floor > kLevel);
    const Lanes step = i & 1 ? meet : -low.slope * width / rise;
    const LaneMask fits = open & (step > 0.0f) & (step < width);  // else halves
    const Lanes part = fits ? from + step : from + 0.5f * width;
    const Looked next = look(hand, at, part);
    out = open ? least_of(out, next.d) : out;
    const LaneMask falls = open & (next.slope <= 0.0f), rises = open & (next.slope > 0.0f);
    from = falls ? part : from;
    to = rises ? part : to;
    low.d = falls ? next.d : low.d;
    low.slope = falls ? next.slope : low.slope;
    high.d = rises ? next.d : high.d;
    high.slope = rises ? next.slope : high.slope;
    const Lanes level = next.slope < 0.0f ? -next.slope : next.slope;
    open = open & (level > kLevel);
  }
  return out;
}

/// Where a level tip and a straight flank that leans inwards meet: a rim of less than a right angle. What it leaves, a wall
/// where it is led down its axis and a floor where it leans, has no distance by the head's own depth: that grows by 0.62 to
/// 0.78 a voxel off it, and a field that has a kink at its zero is read 0.04 voxel off. So where the rim passes a place, that
/// is as deep as it lies off what the rim sweeps on a straight way: the cylinder over the rim's ellipse, seen along the way.
struct AcuteRim {
  bool any = false;
  float t = 0.0f, rho = 0.0f;
  double lean = 0.0;     // tangent of the flank's angle to the axis
  static constexpr double kReach = 4.5;  // voxels from the rim that it tells of: of the band, by a head's least depth there
};

/// The rim on its way, unit direction (along the axis, across it) and length.
struct RimOnWay {
  bool leaves = false;  // it goes along its axis enough to leave something
  float length = 0.0f, along = 0.0f, aside = 0.0f;
  float minor = 0.0f;   // half axis of its ellipse in the plane of the way; across that plane it is the rim's radius
  float most = 0.0f;    // cosine about the axis, against the way: where it is more the flank passes after the rim
};
RimOnWay on_way(const AcuteRim& rim, double way_t, double way_p) noexcept;

/// How deep places lie off what the rim leaves, where it passes them on this way; else 0. t, p, q2 as in FourPlaces, where the
/// way begins.
Lanes behind_rim(const AcuteRim& rim, const RimOnWay& way, Lanes t, Lanes p, Lanes q2) noexcept;

/// A profile in voxels. Refers to the profile it is made of.
class FlatHead {
 public:
  FlatHead(const Profile& profile, double voxel_mm) noexcept;

  /// The pieces and corners that can be nearest to any place within `half` of `at` (voxels). `out` refers to this.
  void at_hand(OnHalf at, OnHalf half, AtHand& out) const noexcept;

  const AcuteRim& rim() const noexcept { return rim_; }

 private:
  const Profile& profile_;
  double voxel_;
  FlatPiece flat_[Profile::kMostPieces];
  FlatJoint joint_[Profile::kMostPieces];   // [i] between piece i - 1 and i
  AcuteRim rim_;
  bool level_tip_ = false, level_top_ = false;  // level at the pole: no place is beyond it
};

}  // namespace cusp::engine
