#include "engine/contact/cavity/cavity_walls.h"

#include <algorithm>
#include <cmath>

#include "engine/contact/cavity/ball_directions.h"

namespace cusp::engine {

namespace {

constexpr double kMarginMm = 0.016, kMostMarginMm = 0.06;  // looked for so far beyond what is asked for, for what is to come
constexpr double kSpacingVoxels = 2.0;  // of the directions' places on the ball; ridges between them are looked for
constexpr double kPastMm = 0.03;        // a way nearer to the ball's centre holds poses that fit
constexpr double kPlaceFarMm = 0.01;    // the field may be off by as much: a place beyond is looked for from there
/// A four's directions lie within this over n of its middle: 0.5 / n on a cube's face, sqrt 2 of it at a corner.
constexpr double kMiddleOff = 0.75;
constexpr int kPlacePasses = 2;
constexpr double kRidgeMm = 5e-4;  // a ridge that is higher over the line between two places is looked for
constexpr int kSampleWork = 1, kPlaceWork = 5;  // units of 25 ns

}  // namespace

CavityWalls::CavityWalls(const Volume& volume, const Sweeps& sweeps)
    : sweeps_(sweeps),
      void_(volume, sweeps),
      voxel_mm_(volume.grid().voxel_mm),
      places_(4 * BallDirections::of(BallDirections::kMostSide).fours.size() + kMostBetween),
      place_at_(places_.size()),
      features_(kMostFeatures),
      constraints_(places_.size() + kMostFeatures) {}

double CavityWalls::room_mm(const Ball& ball) const noexcept {
  if (sampled_.slack_mm < 0.0) return -1.0;
  return sampled_.radius_mm + sampled_.slack_mm - ball.radius_mm - length_of(ball.at - sampled_.at);
}

void CavityWalls::start(const Cutting& cutting) noexcept {
  cutting_ = cutting;
  if (cutting.any()) feature_count_ = 0;
  ++cuttings_;
  past_count_ = past_sweeps_ = 0;
  feature_count_ = std::min(feature_count_, kMostKept);
  for (std::size_t i = 0; i < feature_count_; ++i) features_[i].seen = false;
  for (std::size_t i = 0; i < place_count_; ++i) places_[i].dropped = false;
}

CavityWalls::Found CavityWalls::found() const noexcept {
  Found out;
  out.sampled = sampled_;
  out.features = static_cast<std::int32_t>(std::min(feature_count_, kMostKept));
  for (std::int32_t i = 0; i < out.features; ++i) out.foot[i] = features_[static_cast<std::size_t>(i)].foot;
  return out;
}

void CavityWalls::set_found(const Found& found) noexcept {
  release();
  sampled_ = found.sampled;
  places_made_ = false;
  feature_count_ = static_cast<std::size_t>(std::clamp(found.features, 0, static_cast<std::int32_t>(kMostKept)));
  for (std::size_t i = 0; i < feature_count_; ++i) {
    features_[i] = CavityConstraint{};
    features_[i].foot = found.foot[i];
  }
}

Sweeps::Deepest CavityWalls::deepest(const SweptRuns& runs, Vec3 x) const noexcept {
  Sweeps::Deepest out = sweeps_.deepest({runs.run, static_cast<std::size_t>(runs.count)}, x);
  if (!cutting_.any()) return out;
  const Sweeps::Deepest uncarved = sweeps_.deepest(cutting_.uncarved, x);
  return uncarved.depth_mm > out.depth_mm ? uncarved : out;
}

bool CavityWalls::move_out(const Volume& volume, SweepRun uncarved, double most_mm, Vec3& place) noexcept {
  const bool any = uncarved.to >= uncarved.from;
  if (!void_.runs_at(volume, place, cutting_.end).known) return !any;
  const int before = work_;
  Descent d;
  d.x = place;
  if (any) add_run(uncarved, d);
  const bool found = settle(volume, place, d);
  work_ = before;  // caches decide how often it is asked
  const Vec3 by = d.x - place;
  place = d.x;
  return found && glm::dot(by, by) <= most_mm * most_mm;
}

/// Keeps the place of what is left that is about the nearest to `at`. False if there is none within reach.
bool CavityWalls::sample_at(const Volume& volume, Vec3 at) noexcept {
  Vec3 x = at, inwards(0.0);
  double curved = 0.0;
  bool met = false;
  for (int pass = 0; pass < kPlacePasses && !met; ++pass) {
    work_ += kPlaceWork;
    const SweptRuns& runs = void_.runs_at(volume, x, cutting_.end);
    if (!runs.known) return false;
    const Sweeps::Deepest deep = sweeps_.deepest({runs.run, static_cast<std::size_t>(runs.count)}, x);
    if (pass == 0) note_nearby(deep.sweep);
    inwards = deep.inwards;
    curved = 1.0 / sweeps_.radius_mm(deep.sweep);
    double depth = deep.depth_mm;
    if (runs.near_base) {
      const FieldPoint base = void_.base(volume, x);
      if (base.known && base.d_mm > depth) {
        inwards = base.normal;
        curved = 0.0;
        depth = base.d_mm;
      }
    }
    x -= inwards * depth;
    // What another sweep takes of so short a way is a tenth of it.
    met = std::fabs(depth) < kPlaceMetMm;
  }
  if (!met) {
    Descent d;
    d.x = x;
    if (!settle(volume, at, d)) return false;
    x = d.x;
  }
  const Vec3 off = x - sampled_.at;
  const double far = sampled_.radius_mm + sampled_.slack_mm;
  if (glm::dot(off, off) > far * far) return false;
  places_[place_count_++] = {x, false, inwards, curved};
  return true;
}

/// Looks on the ridge where the walls of two places meet between them.
void CavityWalls::sample_between(const Volume& volume, const Place& a, const Place& b) noexcept {
  const Vec3 way = b.at - a.at;
  const double length = length_of(way);
  if (length < kPlaceMetMm || place_count_ == places_.size()) return;
  const Vec3 along = way / length;
  Vec3 up = sampled_.at - 0.5 * (a.at + b.at);
  up -= along * glm::dot(along, up);
  up /= length_of(up);
  const double up_a = glm::dot(a.inwards, up), up_b = glm::dot(b.inwards, up);
  if (up_a < kLeastFacing || up_b < kLeastFacing) return;
  // How the walls rise towards each other, as chords of their arcs.
  const double rise_a = 0.25 * length * a.curved - glm::dot(a.inwards, along) / up_a;
  const double rise_b = 0.25 * length * b.curved + glm::dot(b.inwards, along) / up_b;
  if (rise_a <= 0.0 || rise_b <= 0.0) return;
  const double from_a = length * rise_b / (rise_a + rise_b), high = from_a * rise_a;
  if (high < kRidgeMm || high > length) return;
  sample_at(volume, a.at + along * from_a + up * high);
}

void CavityWalls::sample(const Volume& volume) noexcept {
  const Ball ball = sampled_;
  place_count_ = 0;
  nearby_count_ = 0;
  places_made_ = true;
  const int side = std::clamp(static_cast<int>(0.7236 * ball.radius_mm / (kSpacingVoxels * voxel_mm_)) + 1, BallDirections::kLeastSide,
                              BallDirections::kMostSide);
  const BallDirections& directions = BallDirections::of(side);
  std::fill_n(place_at_.begin(), 4 * directions.fours.size(), std::int16_t{-1});
  const double far = ball.slack_mm + SweptVoid::kOffMm, middle_far = far + kMiddleOff * ball.radius_mm / side;
  for (std::size_t k = 0; k < directions.fours.size(); ++k) {
    const BallDirections::Four& four = directions.fours[k];
    work_ += kSampleWork;
    if (void_.about_mm(volume, ball.at + ball.radius_mm * four.middle) > middle_far) continue;
    work_ += 4 * kSampleWork;
    for (std::size_t q = 0; q < 4; ++q) {
      const Vec3 d = four.of[q], at = ball.at + ball.radius_mm * d;
      const double about = void_.about_mm(volume, at);
      if (about < far && sample_at(volume, about > kPlaceFarMm ? at + about * d : at))
        place_at_[4 * k + q] = static_cast<std::int16_t>(place_count_ - 1);
    }
  }
  for (const BallDirections::Pair& pair : directions.pairs) {
    const std::int16_t a = place_at_[static_cast<std::size_t>(pair.a)], b = place_at_[static_cast<std::size_t>(pair.b)];
    if (a >= 0 && b >= 0) sample_between(volume, places_[static_cast<std::size_t>(a)], places_[static_cast<std::size_t>(b)]);
  }
}

/// Keeps a sweep that owns surface about the ball and passes its centre closely: the voxels of wide voids name others.
void CavityWalls::note_nearby(std::int32_t sweep) noexcept {
  if (nearby_count_ == kMostNearby) return;
  for (int i = 0; i < nearby_count_; ++i)
    if (nearby_[i] == sweep) return;
  const Vec3 off = sweeps_[sweep].nearest_on(sampled_.at) - sampled_.at;
  const double far = kPastMm + sampled_.slack_mm;
  if (glm::dot(off, off) < far * far) nearby_[nearby_count_++] = sweep;
}

void CavityWalls::find_past(const Volume& volume, const Ball& ball) noexcept {
  // Those of the tick's earlier passes stay: constraints that come and go would keep a search from ending.
  if (past_count_ > kMostPast / 2) past_count_ = past_sweeps_ = 0;
  if (cutting_.any()) {
    note_past(ball, cutting_.uncarved.to);
    note_past(ball, sweeps_.nearest(cutting_.uncarved, ball.at).sweep);
  }
  for (int i = 0; i < nearby_count_; ++i) note_past(ball, nearby_[i]);
  SweepRun run[8];
  const int runs = void_.near(volume, ball.at, cutting_.end, run);
  for (int k = 0; k < runs; ++k) note_past(ball, sweeps_.nearest(run[k], ball.at).sweep);
}

/// The piece of a sweep's way within kPastMm of the ball, by its ends.
void CavityWalls::note_past(const Ball& ball, std::int32_t sweep) noexcept {
  if (past_count_ + 2 > kMostPast) return;
  const Sweep s = sweeps_[sweep];
  if (s.radius_mm < ball.radius_mm) return;
  const Vec3 on = s.nearest_on(ball.at), off = on - ball.at;
  if (glm::dot(off, off) >= kPastMm * kPastMm) return;
  bool noted = false;
  for (int i = 0; i < past_sweeps_; ++i) noted = noted || past_sweep_[i] == sweep;
  if (!noted && past_sweeps_ < kMostPast / 2) {
    past_way_[past_sweeps_] = s;
    past_sweep_[past_sweeps_++] = sweep;
  }
  for (const Vec3 end : {s.a, s.b}) {
    const Vec3 way = end - on;
    const double length = length_of(way);
    const Vec3 at = length > kPastMm ? on + way * (kPastMm / length) : end;
    bool known = false;
    for (int i = 0; i < past_count_; ++i) known = known || past_[i] == at;
    if (!known) past_[past_count_++] = at;
  }
}

void CavityWalls::keep(const Ball& ball) noexcept {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < feature_count_; ++i) {
    const double far = ball.radius_mm + ball.slack_mm;
    const Vec3 off = features_[i].foot - ball.at;
    if (glm::dot(off, off) <= far * far) features_[kept++] = features_[i];
  }
  // The newest are kept: they held the ball last.
  const std::size_t first = kept > kMostKept ? kept - kMostKept : 0;
  std::copy(features_.begin() + static_cast<std::ptrdiff_t>(first), features_.begin() + static_cast<std::ptrdiff_t>(kept), features_.begin());
  feature_count_ = kept - first;
}

/// A feature that was made for another pose counts by its foot.
void CavityWalls::add_feature(const Ball& ball, std::size_t i) noexcept {
  CavityConstraint out = features_[i];
  if (cutting_.any() && sweeps_.holds(cutting_.uncarved, out.foot, SweptVoid::kTakenMm)) return;
  out.from = static_cast<std::int32_t>(i);
  const Vec3 moved = ball.at - out.seen_from;
  out.seen = out.seen && glm::dot(moved, moved) < kSeenMm * kSeenMm;
  if (!out.seen) {
    const Vec3 off = ball.at - out.foot;
    const double far = length_of(off);
    if (far > ball.radius_mm + ball.slack_mm || far < kNoWayMm) return;
    out.n = off / far;
    out.c = glm::dot(out.n, out.foot) + ball.radius_mm;
    out.bend = glm::dmat3(0.0);
  }
  constraints_[count_++] = out;
}

void CavityWalls::add_place(const Ball& ball, std::int32_t i) noexcept {
  const double r = ball.radius_mm;
  if (places_[static_cast<std::size_t>(i)].dropped) return;
  Vec3 at = places_[static_cast<std::size_t>(i)].at;
  const Vec3 before = ball.at - at;
  const double most = r + ball.slack_mm;
  if (glm::dot(before, before) > most * most) return;  // a sweep moves it away from its way, so from the ball
  if (cutting_.any()) {
    // What is not carved has moved it on.
    Place& place = places_[static_cast<std::size_t>(i)];
    if (place.moved_for != cuttings_) {
      const Sweeps::Deepest deep = sweeps_.deepest(cutting_.uncarved, at);
      place.moved = deep.depth_mm > 0.0 ? at - deep.inwards * deep.depth_mm : at;
      place.moved_for = cuttings_;
    }
    at = place.moved;
  }
  // Not all sweeps about a place are named there.
  for (int k = 0; k < past_sweeps_; ++k) {
    const Sweep& past = past_way_[k];
    const Vec3 on = past.nearest_on(at), off = at - on;
    const double distance2 = glm::dot(off, off);
    if (distance2 < past.radius_mm * past.radius_mm && distance2 > kNoWayMm) at = on + off * (past.radius_mm / std::sqrt(distance2));
  }
  const Vec3 off = ball.at - at;
  const double far = length_of(off);
  if (far > r + ball.slack_mm || far < kNoWayMm) return;
  const Vec3 n = off / far;
  constraints_[count_++] = {n, glm::dot(n, at) + r, glm::dmat3(0.0), at, ball.at, false, false, true, i};
}

/// Looks for the surface where what was found does not reach.
void CavityWalls::look(const Volume& volume, const Ball& ball) noexcept {
  const bool further = room_mm(ball) < ball.slack_mm;
  if (further) {
    const double margin = std::clamp(ball.slack_mm, kMarginMm, kMostMarginMm);
    sampled_ = {ball.at, ball.radius_mm, ball.slack_mm + margin};
    places_made_ = false;
  }
  if (places_made_) return;
  const int before = work_;
  sample(volume);
  // Places that a discarded cache held were counted when they were looked for.
  if (!further) work_ = before;
}

bool CavityWalls::near(const Volume& volume, const Ball& ball) noexcept {
  look(volume, ball);
  return place_count_ > 0 || cutting_.any();
}

void CavityWalls::build(const Volume& volume, const Ball& ball) noexcept {
  look(volume, ball);
  count_ = 0;
  find_past(volume, ball);
  for (std::size_t i = 0; i < feature_count_; ++i) add_feature(ball, i);
  for (std::size_t i = 0; i < place_count_; ++i) add_place(ball, static_cast<std::int32_t>(i));
  work_ += static_cast<int>(place_count_ / 4);
}

}  // namespace cusp::engine
