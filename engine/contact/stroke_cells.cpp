#include "engine/contact/stroke_cells.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace cusp::engine {

namespace {
constexpr double kReach = 2.6;        // voxels: what is further from a surface is not looked at, it may be clamped
constexpr double kAsDeep = 5e-4;      // voxels: some steps of s
constexpr double kExplained = 0.01;   // voxels: a corner may differ by a straightened stroke, a rounded s
constexpr double kTaken = 0.002;      // voxels: strokes that follow each other overlap by no more than they were straightened
constexpr double kSmooth = 0.985;     // cosine: what turns by less than 10 degrees is one surface
constexpr double kOutside = 0.1;      // a cell's features may stand this far outside it
constexpr double kBeside = 2.5;       // voxels: what is further from a point does not end its plane
constexpr double kStrongBend = 0.08;  // per voxel: a radius of six voxels
constexpr int kBase = -1;             // the specimen's own surface among surfaces

bool in_cell(Vec3 x) noexcept {
  for (int i = 0; i < 3; ++i)
    if (!(x[i] > -kOutside && x[i] < 1.0 + kOutside)) return false;
  return true;
}
Vec3 into_cell(Vec3 x) noexcept {
  for (int i = 0; i < 3; ++i) x[i] = x[i] < 0.0 ? 0.0 : x[i] > 1.0 ? 1.0 : x[i];
  return x;
}
/// The samples that a cell's field is made of: its corners, and the next ones along each axis.
struct SampleAt {
  int x, y, z;
};
constexpr SampleAt kSamples[32] = {
    {0, 0, -1}, {1, 0, -1}, {0, 1, -1}, {1, 1, -1}, {0, -1, 0}, {1, -1, 0}, {-1, 0, 0}, {0, 0, 0},
    {1, 0, 0},  {2, 0, 0},  {-1, 1, 0}, {0, 1, 0},  {1, 1, 0},  {2, 1, 0},  {0, 2, 0},  {1, 2, 0},
    {0, -1, 1}, {1, -1, 1}, {-1, 0, 1}, {0, 0, 1},  {1, 0, 1},  {2, 0, 1},  {-1, 1, 1}, {0, 1, 1},
    {1, 1, 1},  {2, 1, 1},  {0, 2, 1},  {1, 2, 1},  {0, 0, 2},  {1, 0, 2},  {0, 1, 2},  {1, 1, 2}};

double length_of(Vec3 v) noexcept { return std::sqrt(glm::dot(v, v)); }
}  // namespace

StrokeCells::StrokeCells() : segments_(kMostInBrick), capsules_(kMostInBrick) {}

/// Depth below the swept ball's surface, positive where it has been; the gradient points to its middle.
double StrokeCells::Capsule::operator()(Vec3 x, Vec3& gradient) const noexcept {
  const Vec3 v = x - a;
  double t = glm::dot(v, along) * inverse2;
  t = t < 0.0 ? 0.0 : t > 1.0 ? 1.0 : t;
  const Vec3 off = v - along * t;
  const double distance = length_of(off);
  gradient = distance > 1e-9 ? off / -distance : Vec3(0.0);
  return r - distance;
}
double StrokeCells::Capsule::depth(Vec3 x) const noexcept {
  Vec3 gradient;
  return (*this)(x, gradient);
}

void StrokeCells::turn_to(const CutMemory& memory, const Grid& grid, IVec3 corner) noexcept {
  memory_ = &memory;
  grid_ = grid;
  corner_ = corner;
  found_ = false;
}

void StrokeCells::find(const CutMemory& memory, const Grid& grid, IVec3 corner) noexcept {
  found_ = true;
  capsule_count_ = 0;
  const Vec3 low = grid.origin_mm + grid.voxel_mm * Vec3(corner);
  const int count = memory.reaching(low, low + grid.voxel_mm * 8.0, (kReach + 1.0) * grid.voxel_mm, segments_);
  usable_ = count > 0;
  std::fill(std::begin(deepest_), std::end(deepest_), kUnknown);
  const double per_mm = 1.0 / grid.voxel_mm;
  for (int i = 0; i < count; ++i) {
    const CutMemory::Segment& s = segments_[static_cast<std::size_t>(i)];
    Capsule& c = capsules_[static_cast<std::size_t>(capsule_count_++)];
    c.a = (s.a - low) * per_mm;
    c.along = (s.b - s.a) * per_mm;
    c.r = s.by.radius_mm * per_mm;
    const double square = glm::dot(c.along, c.along);
    c.inverse2 = square > 1e-12 ? 1.0 / square : 0.0;
  }
}

/// The deepest stroke at a sample of the brick (-1 to 9 each); kOff where the field is not as it says.
std::uint8_t StrokeCells::deepest(IVec3 at, double has) noexcept {
  if (has <= -kReach || has >= kReach) return kFar;
  const Vec3 x(at);
  // Of those as deep the oldest: one that took nothing away changes no answer.
  double most = -1e300;
  int which = 0;
  for (int i = 0; i < capsule_count_; ++i) {
    const double d = depth_[i] = capsules_[static_cast<std::size_t>(i)].depth(x);
    most = d > most ? d : most;
  }
  while (depth_[which] < most - kAsDeep) ++which;
  return std::fabs(most - has) > kExplained ? kOff : static_cast<std::uint8_t>(which);
}

bool StrokeCells::explain(IVec3 local, const CellField& cut, int least) noexcept {
  if (!found_) find(*memory_, grid_, corner_);
  near_count_ = 0;
  if (!usable_ || capsule_count_ < least) return false;
  std::uint64_t shaping[2] = {0, 0};
  std::uint8_t* known = &deepest_[(local.x + 1) + kSide * ((local.y + 1) + kSide * (local.z + 1))];
  for (const SampleAt& sample : kSamples) {
    std::uint8_t& which = known[sample.x + kSide * (sample.y + kSide * sample.z)];
    if (which == kUnknown)
      which = deepest(local + IVec3(sample.x, sample.y, sample.z), cut.sample(sample.x, sample.y, sample.z));
    if (which == kOff) return false;
    if (which != kFar) shaping[which >> 6] |= std::uint64_t{1} << (which & 63);
  }
  for (int word = 0; word < 2; ++word)
    for (std::uint64_t left = shaping[word]; left != 0; left &= left - 1) {
      if (near_count_ == kMostShaping) return false;
      near_[near_count_] = capsules_[static_cast<std::size_t>(word * 64 + std::countr_zero(left))];
      near_[near_count_++].a -= Vec3(local);
    }
  return near_count_ >= least;
}

double StrokeCells::depth(int surface, Vec3 x, Vec3& gradient) const noexcept {
  return surface == kBase ? base_->eval(x, gradient) : near_[surface](x, gradient);
}

/// True where one of the other surfaces has void.
bool StrokeCells::taken(Vec3 x, int but, int but_other) const noexcept {
  Vec3 g;
  if (base_ != nullptr && but != kBase && but_other != kBase && base_->eval(x, g) > kTaken) return true;
  for (int i = 0; i < near_count_; ++i)
    if (i != but && i != but_other && near_[i].depth(x) > kTaken) return true;
  return false;
}

/// The two nearest surfaces that x, on `but` with this normal, lies below.
void StrokeCells::note_beside(Vec3 x, Vec3 normal, int but, Beside (&out)[2], int& count) const noexcept {
  count = 0;
  const auto plane = [&](Vec3 y, Vec3& gradient) {
    gradient = normal;
    return glm::dot(normal, y - x);
  };
  const auto offer = [&](double d, Vec3 g, int surface) {
    const double length = length_of(g);
    if (d < -kBeside * length || length < 0.25) return;
    const Vec3 n = g / length;
    if (glm::dot(n, normal) > kSmooth) return;
    // Pieces of one stroke go over into each other: where they meet there is no edge.
    Vec3 at, tangent, there;
    if (!meet(plane, [&](Vec3 y, Vec3& to) { return depth(surface, y, to); }, x, at, tangent)) return;
    depth(surface, at, there);
    if (glm::dot(there, normal) > kSmooth * length_of(there)) return;
    // One smooth surface counts once, with its nearest piece.
    for (int k = 0; k < count; ++k)
      if (glm::dot(out[k].normal, n) > kSmooth) {
        if (d / length > out[k].d) out[k] = {d / length, n};
        return;
      }
    if (count < 2) {
      out[count++] = {d / length, n};
      return;
    }
    const int further = out[0].d < out[1].d ? 0 : 1;
    if (d / length > out[further].d) out[further] = {d / length, n};
  };
  Vec3 g;
  if (base_ != nullptr && but != kBase) {
    const double d = base_->eval(x, g);
    offer(d, g, kBase);
  }
  for (int i = 0; i < near_count_; ++i) {
    if (i == but) continue;
    const double d = near_[i](x, g);
    offer(d, g, i);
  }
}

void StrokeCells::add_point(int surface, Vec3 from) noexcept {
  if (feature_count_ == kMostFeatures) return;
  Vec3 x = from, g(0.0);
  for (int pass = 0; pass < 4; ++pass) {
    const double d = depth(surface, x, g);
    const double square = glm::dot(g, g);
    if (!(square > 0.04)) return;
    const Vec3 to = x - g * (d / square);
    if (pass < 3) {
      x = into_cell(to);
    } else {
      x = to;
    }
  }
  if (!in_cell(x) || std::fabs(depth(surface, x, g)) > 1e-6 || taken(x, surface, surface)) return;
  StrokeFeature& out = features_[feature_count_];
  out = StrokeFeature{};
  out.at = x;
  out.normal = g / length_of(g);
  // A stroke's piece may say the same as the one before.
  for (int k = 0; k < feature_count_; ++k) {
    const Vec3 off = features_[k].at - x;
    if (!features_[k].edge && glm::dot(off, off) < 0.01 && glm::dot(features_[k].normal, out.normal) > kSmooth) return;
  }
  note_beside(x, out.normal, surface, out.beside, out.besides);
  ++feature_count_;
}

void StrokeCells::add_edges(int one, int other) noexcept {
  const auto a = [&](Vec3 x, Vec3& g) { return depth(one, x, g); };
  const auto b = [&](Vec3 x, Vec3& g) { return depth(other, x, g); };
  Vec3 ga, gb;
  SharpEdge edge;
  a(Vec3(0.5), ga);
  b(Vec3(0.5), gb);
  if (glm::dot(ga, gb) > kSmooth * length_of(ga) * length_of(gb) || !edge_of(a, b, Vec3(0.5), edge)) return;
  a(edge.at, ga);
  b(edge.at, gb);
  if (glm::dot(ga, gb) > kSmooth * length_of(ga) * length_of(gb)) return;
  if (glm::dot(edge.bend, edge.bend) < kStrongBend * kStrongBend) {
    add_edge(one, other, edge, kHalfEdge);
    return;
  }
  // Strongly bent: as two pieces.
  for (const double side : {-0.5, 0.5}) {
    SharpEdge piece;
    if (meet(a, b, edge.at + edge.tangent * (side * kHalfEdge), piece.at, piece.tangent)) add_edge(one, other, piece, 0.55 * kHalfEdge);
  }
}

/// A piece of the edge between two surfaces, as far as no other one has taken it.
void StrokeCells::add_edge(int one, int other, SharpEdge edge, double half) noexcept {
  if (feature_count_ == kMostFeatures) return;
  fit_curve([&](Vec3 x, Vec3& g) { return depth(one, x, g); }, [&](Vec3 x, Vec3& g) { return depth(other, x, g); }, half, edge);
  double from = -half, to = half;
  const auto place = [&](double t) { return edge.at + t * (edge.tangent + t * (edge.bend + t * (edge.twist + t * edge.fourth))); };
  const auto limit = [&](auto&& others) {
    constexpr int kPlaces = 9;
    const double apart = 2.0 * half / (kPlaces - 1);
    double d[kPlaces];
    int middle = -1;
    for (int k = 0; k < kPlaces; ++k) {
      d[k] = others(place(-half + k * apart));
      const int off = k < 4 ? 4 - k : k - 4, best = middle < 0 ? 99 : middle < 4 ? 4 - middle : middle - 4;
      if (d[k] <= kTaken && off < best) middle = k;
    }
    if (middle < 0) {
      to = from;
      return;
    }
    // Where the sign changes: between two places by false position, four times.
    const auto end_between = [&](int in, int out) {
      double ti = -half + in * apart, fi = d[in], to_ = -half + out * apart, fo = d[out];
      double t = ti;
      for (int pass = 0; pass < 4; ++pass) {
        if (fi > -1e-12 && fi < 1e-12) return ti;
        if (fi > 0.0) return ti;
        t = ti + (to_ - ti) * (fi / (fi - fo));
        const double f = others(place(t));
        if (f > 0.0) {
          to_ = t;
          fo = f;
        } else {
          ti = t;
          fi = f;
        }
      }
      return t;
    };
    for (int k = middle; k > 0; --k)
      if (d[k - 1] > kTaken) {
        const double t = end_between(k, k - 1);
        from = t > from ? t : from;
        break;
      }
    for (int k = middle; k + 1 < kPlaces; ++k)
      if (d[k + 1] > kTaken) {
        const double t = end_between(k, k + 1);
        to = t < to ? t : to;
        break;
      }
  };
  Vec3 g;
  if (base_ != nullptr && one != kBase && other != kBase) limit([&](Vec3 x) { return base_->eval(x, g); });
  for (int i = 0; i < near_count_ && from < to; ++i)
    if (i != one && i != other) limit([&](Vec3 x) { return near_[i].depth(x); });
  if (!(from < to)) return;
  StrokeFeature& out = features_[feature_count_++];
  out = StrokeFeature{};
  out.edge = true;
  out.at = edge.at;
  out.normal = edge.tangent;
  out.bend = edge.bend;
  out.twist = edge.twist;
  out.fourth = edge.fourth;
  out.from = from;
  out.to = to;
}

std::span<const StrokeFeature> StrokeCells::features(const CellField* base) noexcept {
  base_ = base;
  feature_count_ = 0;
  for (int k = 0; k < near_count_; ++k) add_point(k, Vec3(0.5));
  for (int k = base != nullptr && base->crossed() ? kBase : 0; k < near_count_; ++k)
    for (int j = k + 1; j < near_count_; ++j) add_edges(k, j);
  base_ = nullptr;
  return {features_, static_cast<std::size_t>(feature_count_)};
}

bool StrokeCells::beside(Vec3 place, Vec3 normal, Beside (&out)[2], int& count) const noexcept {
  count = 0;
  for (int i = 0; i < near_count_; ++i)
    if (near_[i].depth(place) > 0.0) return false;
  note_beside(place, normal, kBase, out, count);
  return true;
}

}  // namespace cusp::engine
