// Carving with a head that is a profile of revolution. Brick by brick: what is out of reach and what is gone already is
// passed over; the outline's pieces that can be nearest anywhere in the brick are picked out; then four voxels at a time
// in single precision, relative to the pivot in voxels: 1e-5 of a voxel, where a cut value's quantum is 8e-5.
#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/removal/carve.h"
#include "engine/removal/flat_head.h"
#include "engine/tool/swept.h"

namespace cusp::engine {

namespace {

constexpr double kHalfBrick = 3.5;       // from its middle to its outermost voxel centres, per axis
constexpr double kBrickReach = 6.0622;   // along its diagonal
constexpr double kHalfEighth = 1.5;      // the same of 4 x 4 x 4 voxels
constexpr double kEighthReach = 2.5981;

/// The head in the carving's own frame: t along the axis, p across it in the plane of the way, q across both.
struct Frame {
  Vec3 p{0.0}, q{0.0};  // unit
  double way_t = 0.0, way_p = 0.0;
};

/// Where on the way a brick's places are nearest to the head.
enum class Nearest { at_start, at_end, either };

/// The brick at hand: what all pieces of a way share of it.
struct AtBrick {
  int index = 0;
  IVec3 corner{0};
  const std::uint16_t* known = nullptr;  // its cut values; none: nothing was cut
  std::uint16_t* values = nullptr;       // once written
  ChangedVoxels changed;
};

/// Places that a neighbouring piece or the last carving answers for: those nearest to an end of this one.
struct Elsewhere {
  bool start = false, end = false;
};

/// The head along one straight piece of a way.
class Piece {
 public:
  Piece(Volume& volume, Vec3 a, Vec3 b, const Bur& bur, const FlatHead& head, Vec3 axis, Elsewhere elsewhere) noexcept
      : volume_{volume}, bur_{bur}, axis_{axis}, a_{a}, b_{b}, elsewhere_{elsewhere}, voxel_{volume.grid().voxel_mm}, head_{head} {
    start_ = (a - volume.grid().origin_mm) / voxel_;
    way_ = (b - a) / voxel_;
    length_ = std::sqrt(glm::dot(way_, way_));
    frame_.way_t = glm::dot(way_, axis);
    const Vec3 off = way_ - axis * frame_.way_t;
    frame_.way_p = std::sqrt(glm::dot(off, off));
    rim_way_ = on_way(head_.rim(), frame_.way_t, frame_.way_p);
    frame_.p = frame_.way_p > 1e-9 ? off / frame_.way_p : across(axis);
    frame_.q = glm::cross(axis, frame_.p);
    const auto sum = [](Vec3 v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); };
    spread_ = {sum(axis), sum(frame_.p), sum(frame_.q)};
    const Lanes count{0.0f, 1.0f, 2.0f, 3.0f};
    step_t_ = count * static_cast<float>(axis.x);
    step_p_ = count * static_cast<float>(frame_.p.x);
    step_q_ = count * static_cast<float>(frame_.q.x);
    const Vec3* in[] = {&axis_, &frame_.p, &frame_.q};
    for (int i = 0; i < 3; ++i) {
      axis_y_[i] = static_cast<float>(in[i]->y);
      axis_z_[i] = static_cast<float>(in[i]->z);
    }
    // The head lies in a cylinder about its axis: its box, swept, with the band round it.
    const Grid& grid = volume.grid();
    const double wide = bur.head.widest() / voxel_ + kBandVoxels;
    const Vec3 foot = start_ + axis_ * (bur.head.low() / voxel_), top = start_ + axis_ * (bur.head.high() / voxel_);
    const Vec3 least = glm::min(glm::min(foot, top), glm::min(foot, top) + way_) - wide;
    const Vec3 most = glm::max(glm::max(foot, top), glm::max(foot, top) + way_) + wide;
    low_ = glm::max(IVec3(glm::floor(least)), IVec3(0));
    high_ = glm::min(IVec3(glm::ceil(most)), grid.size - 1);
  }
  IVec3 low() const noexcept { return low_; }
  IVec3 high() const noexcept { return high_; }

  enum class Did : std::uint8_t { lowered, cleared, no_room };
  /// Lowers a brick's values to the distance from the piece.
  Did brick(AtBrick& brick) noexcept {
    const Vec3 middle = Vec3(brick.corner) + kHalfBrick - start_;
    // From the middle of the way no pose is further than half of it; distance is convex, so it lies above its tangent.
    const Vec3 from = middle - 0.5 * way_;
    Vec3 slope;
    const double d = head_distance(bur_, axis_, from * voxel_, slope) / voxel_;
    const double nearest = d - 0.5 * length_;
    const Vec3 steep = glm::abs(slope);
    if (nearest - kHalfBrick * (steep.x + steep.y + steep.z) >= kBandVoxels) return Did::lowered;
    if (d + 0.5 * length_ + kBrickReach <= -kBandVoxels) return Did::cleared;

    const Seen whole = seen(from, kHalfBrick, kBrickReach);
    if (answered_elsewhere(whole.where)) return Did::lowered;
    brick_ = &brick;
    const bool plain = whole.where != Nearest::either && whole.hand.chain;
    // By eighths: what their middles' tangents cannot rule out, and of a brick that is not plain what each sees of the head.
    for (int i = 0; i < 8; ++i) {
      const IVec3 low(i & 1 ? 4 : 0, i & 2 ? 4 : 0, i & 4 ? 4 : 0);
      if (glm::any(glm::greaterThan(brick.corner + low, high_)) || glm::any(glm::lessThan(brick.corner + low + 3, low_))) continue;
      const Vec3 off = Vec3(low) + kHalfEighth - kHalfBrick;
      const double near = nearest + glm::dot(slope, off);
      if (near - kHalfEighth * (steep.x + steep.y + steep.z) >= kBandVoxels) continue;
      const unsigned rows = rows_to_lower(low, slope, near);
      if (rows == 0) continue;
      const Seen part = plain ? whole : seen(from + off, kHalfEighth, kEighthReach);
      if (!plain && answered_elsewhere(part.where)) continue;
      if (!eighth(low, part, slope, rows)) return Did::no_room;
    }
    return Did::lowered;
  }

 private:
  /// By the signs that the slope along the way can have in a box of places; c: between what the cosine of the angle
  /// between p and the way from the axis lies.
  Nearest nearest_of(const AtHand& hand, double c_low, double c_high) const noexcept {
    constexpr double kLevel = 1e-5;  // voxels that an end may be off the least
    const double wt = frame_.way_t, wp = frame_.way_p;
    const double low_t = wt * (wt > 0.0 ? hand.gt_low : hand.gt_high), high_t = wt * (wt > 0.0 ? hand.gt_high : hand.gt_low);
    const double low_p = wp * c_low * (c_low > 0.0 ? hand.gr_low : hand.gr_high);
    const double high_p = wp * c_high * (c_high > 0.0 ? hand.gr_high : hand.gr_low);
    if (low_t + low_p >= -kLevel) return Nearest::at_end;
    if (high_t + high_p <= kLevel) return Nearest::at_start;
    return Nearest::either;
  }

  bool answered_elsewhere(Nearest where) const noexcept {
    return (where == Nearest::at_start && elsewhere_.start) || (where == Nearest::at_end && elsewhere_.end);
  }

  /// What a cube of places sees of the head: `from` its middle, from the pivot in the middle of the way.
  struct Seen {
    AtHand hand;
    Nearest where = Nearest::either;
  };
  Seen seen(Vec3 from, double half_cube, double reach) const noexcept {
    const double t = glm::dot(from, axis_), p = glm::dot(from, frame_.p), q = glm::dot(from, frame_.q);
    const double half_p = half_cube * spread_.y + 0.5 * frame_.way_p, half_q = half_cube * spread_.z;
    const double near_p = std::fabs(p) > half_p ? std::fabs(p) - half_p : 0.0;
    const double near_q = std::fabs(q) > half_q ? std::fabs(q) - half_q : 0.0;
    const double far_p = std::fabs(p) + half_p, far_q = std::fabs(q) + half_q;
    double rho_low = std::sqrt(near_p * near_p + near_q * near_q), rho_high = std::sqrt(far_p * far_p + far_q * far_q);
    // A cube's places lie in a ball too.
    const double rho = std::sqrt(p * p + q * q), ball = reach + 0.5 * length_;
    rho_low = rho - ball > rho_low ? rho - ball : rho_low;
    rho_high = rho + ball < rho_high ? rho + ball : rho_high;
    const OnHalf half{half_cube * spread_.x + 0.5 * std::fabs(frame_.way_t), 0.5 * (rho_high - rho_low)};
    Seen out;
    head_.at_hand({t, 0.5 * (rho_low + rho_high)}, half, out.hand);
    const auto cosine = [&](double of_p, bool least) {
      const double of_q = (of_p > 0.0) == least ? far_q : near_q;
      const double away = std::sqrt(of_p * of_p + of_q * of_q);
      return away > 0.0 ? of_p / away : of_p;
    };
    out.where = nearest_of(out.hand, cosine(p - half_p, true), cosine(p + half_p, false));
    return out;
  }

  /// What the rows of an eighth share: places of its first row against the head, and what the head's rim asks.
  struct Eighth {
    IVec3 first;         // voxel of the specimen
    unsigned meant;      // lanes within the carved box
    bool rim, either;
    HeadMoves moves;
    Lanes foot_t, foot_p, foot_q, back_t, back_p;
    FourPlaces at;
  };
  Eighth eighth_of(IVec3 first, const Seen& seen, Vec3 slope) const noexcept {
    Eighth e;
    e.first = first;
    e.meant = meant_in(first);
    e.moves = glm::dot(slope, way_) < 0.0 ? HeadMoves::away : HeadMoves::towards;
    e.either = seen.where == Nearest::either;
    e.rim = seen.hand.rim && rim_way_.leaves;
    e.at.wt = all_lanes(static_cast<float>(frame_.way_t));
    e.at.wp = all_lanes(static_cast<float>(frame_.way_p));
    const bool at_end = seen.where == Nearest::at_end;
    const Vec3 foot = Vec3(first) - start_;
    e.foot_t = static_cast<float>(glm::dot(foot, axis_) - (at_end ? frame_.way_t : 0.0)) + step_t_;
    e.foot_p = static_cast<float>(glm::dot(foot, frame_.p) - (at_end ? frame_.way_p : 0.0)) + step_p_;
    e.foot_q = static_cast<float>(glm::dot(foot, frame_.q)) + step_q_;
    e.back_t = all_lanes(at_end ? static_cast<float>(frame_.way_t) : 0.0f);
    e.back_p = all_lanes(at_end ? static_cast<float>(frame_.way_p) : 0.0f);
    return e;
  }

  /// Distance of the four voxels of row y, z of an eighth, voxels.
  Lanes row_distance(Eighth& e, const Seen& seen, int y, int z) noexcept {
    const auto fy = static_cast<float>(y), fz = static_cast<float>(z);
    e.at.t = e.foot_t + (fy * axis_y_[0] + fz * axis_z_[0]);
    e.at.p = e.foot_p + (fy * axis_y_[1] + fz * axis_z_[1]);
    const Lanes q = e.foot_q + (fy * axis_y_[2] + fz * axis_z_[2]);
    e.at.q2 = q * q;
    Lanes d = e.either ? swept(seen.hand, e.first + IVec3(0, y, z), e.at, e.moves)
                       : look_there(seen.hand, e.at.t, e.at.p, e.at.q2);
    const Lanes band = all_lanes(static_cast<float>(kBandVoxels));
    if (e.rim && bits_of((d < 0.0f) & (d > -band)) != 0) {
      const Lanes deep = behind_rim(head_.rim(), rim_way_, e.at.t + e.back_t, e.at.p + e.back_p, e.at.q2);
      d = d < 0.0f ? least_of(d, -deep) : d;
    }
    return d;
  }

  /// Lowers the row at offset o of the brick to the distance d. `four`: what stands there; `less`: the lanes it lowers. False if the
  /// volume has no room.
  bool lower_row(int o, std::uint64_t four, Lanes d, unsigned meant, unsigned& less) noexcept {
    const LaneMask solid = solid_from_distances(d);
    const LaneMask was = from_memory(four);
    less = bits_of(solid < was) & meant;
    if (less == 0) return true;
    if (brick_->values == nullptr) {
      brick_->known = brick_->values = volume_.cut_for_writing(brick_->index);
      if (brick_->values == nullptr) return false;
    }
    for (int i = 0; i < kLanes; ++i) {
      if ((less >> i & 1u) == 0) continue;
      brick_->values[o + i] = static_cast<std::uint16_t>(solid[i]);
      if (volume_.keeps_sweeps()) volume_.forget_sweep(brick_->index, o + i);
    }
    return true;
  }

  /// Lanes of an eighth's rows that lie within the carved box.
  unsigned meant_in(IVec3 first) const noexcept {
    const int from = std::max(low_.x - first.x, 0), to = std::min(high_.x - first.x, 3);
    return (0xfu << from) & (0xfu >> (3 - to));
  }

  /// Rows of an eighth that the piece may lower, a bit each: 4 z + y. `nearest`: the least that its middle can be off the head.
  unsigned rows_to_lower(IVec3 low, Vec3 slope, double nearest) const noexcept {
    constexpr double kRounding = 4e-4;  // voxels: a head's carving is exact to this (carve.h)
    const IVec3 first = brick_->corner + low;
    const IVec3 from = glm::max(low_ - first, IVec3(0)), to = glm::min(high_ - first, IVec3(3));
    const unsigned meant = meant_in(first);
    // Distance is convex: it lies above its tangent at the middle.
    const double foot = nearest - kHalfEighth * (slope.x + slope.y + slope.z) - kRounding;
    const Lanes along = Lanes{0.0f, 1.0f, 2.0f, 3.0f} * static_cast<float>(slope.x);
    unsigned rows = 0;
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y) {
        std::uint64_t four = ~std::uint64_t{0};
        if (brick_->known != nullptr) __builtin_memcpy(&four, brick_->known + brick_offset(low.x, low.y + y, low.z + z), sizeof four);
        if (four == 0) continue;
        Lanes d = static_cast<float>(foot + slope.y * y + slope.z * z) + along;
        // Behind a rim places are deeper than the head.
        if (rim_way_.leaves) d = d < 0.0f ? all_lanes(static_cast<float>(-kBandVoxels)) : d;
        if ((bits_of(solid_from_distances(d) < from_memory(four)) & meant) != 0) rows |= 1u << (4 * z + y);
      }
    return rows;
  }

  /// Lowers rows of 4 x 4 x 4 voxels of the brick from `low` on. False when the volume has no room.
  bool eighth(IVec3 low, const Seen& seen, Vec3 slope, unsigned rows) noexcept {
    Eighth e = eighth_of(brick_->corner + low, seen, slope);
    for (; rows != 0; rows &= rows - 1) {
      const int row = __builtin_ctz(rows), y = row & 3, z = row >> 2;
      const int o = brick_offset(low.x, low.y + y, low.z + z);
      std::uint64_t four = ~std::uint64_t{0};
      if (brick_->known != nullptr) __builtin_memcpy(&four, brick_->known + o, sizeof four);
      unsigned less = 0;
      if (!lower_row(o, four, row_distance(e, seen, y, z), e.meant, less)) return false;
      brick_->changed.add_row(low.y + y, low.z + z, less << low.x);
    }
    return true;
  }

  /// Distance to all that the head passes, in voxels, of four voxels from `first` on.
  Lanes swept(const AtHand& hand, IVec3 first, const FourPlaces& at, HeadMoves which) noexcept {
    unsigned unsure = 0;
    Lanes out = passing(hand, at, which, unsure);
    for (; unsure != 0; unsure &= unsure - 1) {
      const int i = __builtin_ctz(unsure);
      const Vec3 place = volume_.grid().origin_mm + Vec3(first + IVec3(i, 0, 0)) * voxel_;
      out[i] = static_cast<float>(passing_head(bur_, axis_, a_, b_, place).distance_mm / voxel_);
    }
    return out;
  }

  Volume& volume_;
  const Bur& bur_;
  Vec3 axis_, a_, b_;
  Elsewhere elsewhere_;
  double voxel_;
  const FlatHead& head_;
  Vec3 start_{0.0}, way_{0.0};  // in voxels
  double length_ = 0.0;
  Frame frame_;
  RimOnWay rim_way_;
  Vec3 spread_{0.0};  // of a cube of half width 1 along t, p and q
  Lanes step_t_{}, step_p_{}, step_q_{};  // of four voxels in a row
  float axis_y_[3], axis_z_[3];           // y and z of t, p and q
  AtBrick* brick_ = nullptr;
  IVec3 low_{0}, high_{0};
};

/// Everything in this brick is deep inside the bur. False if the volume has no room.
bool clear(Volume& volume, AtBrick& brick) noexcept {
  std::uint16_t* values = volume.cut_for_writing(brick.index);
  if (values == nullptr) return false;
  for (int o = 0; o < kBrickVoxels; ++o) {
    if (values[o] == 0) continue;
    values[o] = 0;
    volume.forget_sweep(brick.index, o);
    brick.changed.add_row(o >> 3 & 7, o >> 6, 1u << (o & 7));
  }
  return true;
}

}  // namespace

Carved carve_sweep(Volume& volume, const Polyline& way, const Bur& bur, Vec3 axis, SweepStart start) noexcept {
  if (bur.head.ball()) return carve_sweep(volume, way.first(), way.last(), bur.radius_mm);
  const FlatHead head(bur.head, volume.grid().voxel_mm);
  const auto pieces = static_cast<std::size_t>(way.count - 1);
  std::array<std::optional<Piece>, Polyline::kMost - 1> piece;
  IVec3 low{0}, high{0};
  for (std::size_t i = 0; i < pieces; ++i) {
    // Of two pieces that meet the later one answers for the place where they do.
    const Elsewhere elsewhere{i == 0 && start == SweepStart::carved, i + 1 < pieces};
    piece[i].emplace(volume, way.vertex[i], way.vertex[i + 1], bur, head, axis, elsewhere);
    low = i == 0 ? piece[i]->low() : glm::min(low, piece[i]->low());
    high = i == 0 ? piece[i]->high() : glm::max(high, piece[i]->high());
  }
  Carved out;
  for_bricks_within(low, high, [&](IVec3 at) {
    AtBrick brick;
    brick.index = volume.specimen().brick_index(at);
    if (brick.index < 0 || !volume.cuttable(brick.index)) return;
    brick.corner = at * kBrickEdge;
    brick.known = volume.cut_of(brick.index);
    // The newest piece lowers most, and leaves the others little.
    for (std::size_t i = pieces; i-- > 0;) {
      const Piece::Did did = piece[i]->brick(brick);
      if (did == Piece::Did::lowered) continue;
      if (did == Piece::Did::no_room || !clear(volume, brick)) out.overflow = true;
      break;
    }
    if (!brick.changed.close(brick.corner)) return;
    volume.touched(brick.index);
    out.add(brick.changed);
  });
  return out;
}

}  // namespace cusp::engine
