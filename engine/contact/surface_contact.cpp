// Planes from candidates, the search among them, and the polish; surface_gather.cpp finds the candidates.
#include "engine/contact/surface_contact.h"

#include <algorithm>
#include <cmath>


namespace cusp {

namespace {

double length_of(Vec3 v) noexcept { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

constexpr double kTolerance = 1e-7;         // mm: planes closer than a tenth of a nanometre count as met
constexpr double kSameNormal = 0.9396926;   // cos 20 deg: planes of one smooth surface
constexpr double kTurned = 0.8480481;       // cos 32 deg: a normal that turns further belongs to something else
constexpr double kFootReach = 1.2;          // voxels from its point within which a polished foot is that surface's
constexpr int kSearches = 64;               // steps of the proxy in a tick (5 mm), the rest next tick
constexpr double kTogether = 2e-3;          // mm: slack that a polished pose may take from a plane it leaves out
constexpr double kMemorySlack = 5e-4;       // mm
constexpr double kPredicted = 0.35;         // of a step: how far a burr may be from where its device's move takes it
constexpr double kArrivedMm = 2e-5;         // mm: a pose that would move less in another pass has arrived
constexpr double kRollsMm = 1e-7;           // mm: the same where it is about to roll over an edge
constexpr double kSettledMm = 1e-3;         // mm: after a move this small planes laid before are good to 2 nm
constexpr double kLongestLeap = 10.0;       // of the last pass's move
constexpr double kFarthestLeapMm = 0.3, kCloseLeapMm = 0.02;
constexpr double kPolishedMm = 1e-6;        // mm: a polish that would move less has arrived

/// Crossing cells within reach of the widest burr: the ball's own area twice over (two fields), and the shank's.
std::size_t candidate_room(const Scene& scene) {
  const double h = scene.specimen->grid().voxel_mm;
  double most = 0.0;
  for (const Burr& burr : scene.burrs) {
    const double r = (burr.radius_mm + 0.2) / h;
    const double shank = (burr.neck_radius_mm + 0.2) * burr.neck_length_mm / (h * h);
    most = std::max(most, 4.0 * 3.15 * r * r * 3.0 + 6.3 * shank * 1.5);
  }
  return std::clamp<std::size_t>(static_cast<std::size_t>(most) + 2048, 4096, 65536);
}

}  // namespace

SurfaceContact::SurfaceContact(const Scene& scene, const Volume& volume, const CutMemory* memory)
    : voxel_mm_(scene.specimen->grid().voxel_mm),
      memory_(memory),
      candidates_(candidate_room(scene)),
      features_(candidates_.size()),
      sources_(candidates_.size()),
      place_x_(candidates_.size() + 7),
      place_y_(candidates_.size() + 7),
      place_z_(candidates_.size() + 7),
      planes_(candidates_.size()),
      origins_(candidates_.size()),
      cut_(volume, memory) {
  const Specimen& specimen = volume.specimen();
  const IVec3 n = specimen.brick_count();
  boxes_.resize(static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y) * static_cast<std::size_t>(n.z));
  bricks_low_ = n;
  bricks_high_ = IVec3(-1);
  for (int b = 0; b < static_cast<int>(boxes_.size()); ++b) {
    const BasePoints points = specimen.surface().in(b);
    PointsBox& box = boxes_[static_cast<std::size_t>(b)];
    for (int i = 0; i < points.count; ++i) {
      box.add({points.x[i], points.y[i], points.z[i]});
      box.edges = box.edges || points.normal[i].edge();
    }
    if (!volume.cuttable(b)) continue;
    bricks_low_ = glm::min(bricks_low_, specimen.brick_at(b));
    bricks_high_ = glm::max(bricks_high_, specimen.brick_at(b));
  }
}

void SurfaceContact::PointsBox::add(Vec3f p) noexcept {
  for (int a = 0; a < 3; ++a) {
    const int below = static_cast<int>((p[a] + 0.25f) * 16.0f);
    from[a] = static_cast<std::uint8_t>(std::min<int>(from[a], below));
    to[a] = static_cast<std::uint8_t>(std::max<int>(to[a], below + 1));
  }
}

void SurfaceContact::forget() noexcept {
  cut_.forget();
  fields_.forget_cut();
  gathered_.valid = free_.valid = false;
  free_pause_ = 0;
}

/// The nearest place of an edge's piece. `off`: from the edge's middle to a place; then from that nearest place to it.
/// along, curved: the curve's derivative there, and half the second derivative of the squared distance along it. False at
/// the piece's end, and where all of it is further than far_mm (then nothing else is told).
bool SurfaceContact::nearest_on(const Candidate& edge, double voxel_mm, double far_mm, Vec3& off, Vec3& along,
                                double& curved) noexcept {
  const Vec3 d = off;
  const CutFeature& f = *edge.feature;
  const Vec3 tangent = edge.normal, bend(f.other_normal), twist(f.third_normal), fourth(f.fourth);
  const double from = f.other_d_mm, to = f.third_d_mm;
  double t = glm::dot(d, tangent);
  t = t < from ? from : t > to ? to : t;
  // A piece leaves its tangent by a quarter of a voxel at most.
  const Vec3 straight = d - t * tangent;
  const double reach = far_mm + 0.25 * voxel_mm;
  curved = 1e300;
  off = straight;
  if (glm::dot(straight, straight) > reach * reach) return false;
  const auto look = [&](double at) {
    const Vec3 turn = twist + at * fourth;
    off = d - at * (tangent + at * (bend + at * turn));
    along = tangent + at * (2.0 * bend + at * (3.0 * turn + at * fourth));
    curved = glm::dot(along, along) - glm::dot(2.0 * bend + at * (6.0 * turn + (6.0 * at) * fourth), off);
  };
  // Newton from the tangent's nearest place.
  const double close = 1e-4 * voxel_mm;  // leaves the distance off by 1e-8, the normal by 2e-6 degrees
  for (int pass = 0; pass < 4; ++pass) {
    look(t);
    if (!(curved > 0.2)) break;
    const double step = glm::dot(off, along) / curved;
    const double next = t + step < from ? from : t + step > to ? to : t + step;
    if (std::fabs(next - t) < close) return t > from && t < to;
    t = next;
  }
  if (curved > 0.2) {
    look(t);
    return t > from && t < to;
  }
  // The edge bends about the place about as the ball does: the nearest of three, then between its neighbours.
  constexpr int kPlaces = 2;
  double nearest2 = 1e300;
  int best = 0;
  for (int k = 0; k <= kPlaces; ++k) {
    look(from + (to - from) * k / kPlaces);
    const double square = glm::dot(off, off);
    if (square < nearest2) {
      nearest2 = square;
      best = k;
    }
  }
  if (nearest2 > (far_mm + 0.01 * voxel_mm) * (far_mm + 0.01 * voxel_mm)) return false;
  double low = from + (to - from) * (best > 0 ? best - 1 : 0) / kPlaces;
  double high = from + (to - from) * (best < kPlaces ? best + 1 : kPlaces) / kPlaces;
  t = from + (to - from) * best / kPlaces;
  for (int pass = 0; pass < 5; ++pass) {
    look(t);
    const double down = glm::dot(off, along);
    (down > 0.0 ? low : high) = t;
    const double next = curved > 1e-3 ? t + down / curved : low;
    const double kept = next > low && next < high ? next : 0.5 * (low + high);
    const bool there = std::fabs(kept - t) < close;
    t = kept;
    if (there) break;
  }
  look(t);
  return t > from && t < to;
}

/// The plane of a point of a surface, seen from y; false where it is further than slack_mm off.
inline bool SurfaceContact::plane_of_surface(double r, const Candidate& c, Vec3 y, double slack_mm, Plane& plane,
                                             bool& trusted) const noexcept {
  const double beside = kPlaneReach * voxel_mm_;
  const double far = r + slack_mm;
  const Vec3 d = y - c.point;
  const double square = glm::dot(d, d);
  if (square > far * far + beside * beside) return false;
  const double height = glm::dot(c.normal, y) - c.level;
  if (height > 0.0 && square - height * height <= beside * beside) {
    const auto past = [&](Vec3 other, double other_d) {
      return other_d + glm::dot(other, d) - height * glm::dot(other, c.normal) > 0.0;
    };
    const bool beyond = c.others > 0 && (past(Vec3(c.feature->other_normal), c.feature->other_d_mm) ||
                                         (c.others > 1 && past(Vec3(c.feature->third_normal), c.feature->third_d_mm)));
    if (!beyond) {
      if (height > far) return false;
      plane.n = c.normal;
      plane.c = c.level + r;
      trusted = true;
      return true;
    }
  }
  trusted = false;
  if (square > far * far || square < 1e-18) return false;
  const double distance = std::sqrt(square);
  plane.n = d / distance;
  plane.c = glm::dot(plane.n, y) - (distance - r);
  return true;
}

/// The plane that keeps the burr off one candidate, seen from y; false where it is further than slack_mm off.
bool SurfaceContact::plane_of(const Tool& tool, const Candidate& c, Vec3 y, double slack_mm, Plane& plane,
                              bool& trusted) const noexcept {
  const double r = c.field == Field::base ? tool.r_base : tool.r_cut;
  if (c.kind == Kind::surface) return plane_of_surface(r, c, y, slack_mm, plane, trusted);
  trusted = false;
  if (c.kind == Kind::shank) {
    // Neck and shank: capsules along the axis; the nearer of the two holds the point off.
    const Burr& burr = *tool.burr;
    const double along = glm::dot(c.point - y, tool.axis);
    bool any = false;
    double best = 0.0;
    for (int part = 0; part < 2; ++part) {
      const double from = part == 0 ? 0.0 : burr.neck_length_mm + burr.shank_radius_mm;
      const double to = part == 0 ? burr.neck_length_mm : burr.neck_length_mm + burr.shank_length_mm;
      const double radius = part == 0 ? burr.neck_radius_mm : burr.shank_radius_mm;
      const double t = along < from ? from : along > to ? to : along;
      const Vec3 d = y + tool.axis * t - c.point;
      const double distance = length_of(d);
      if (distance < 1e-9) continue;
      const double gap = distance - radius;
      if (any && gap >= best) continue;
      any = true;
      best = gap;
      plane.n = d / distance;
    }
    if (!any || best > slack_mm) return false;
    plane.c = glm::dot(plane.n, y) - best;
    return true;
  }
  Vec3 d = y - c.point, along;
  double curved = 0.0;
  nearest_on(c, voxel_mm_, r + slack_mm, d, along, curved);
  const double square = glm::dot(d, d);
  const double far = r + slack_mm;
  if (square > far * far || square < 1e-18) return false;
  const double distance = std::sqrt(square);
  plane.n = d / distance;
  plane.c = glm::dot(plane.n, y) - (distance - r);
  return true;
}

/// Planes of candidates from..to - 1, added to those that are there.
void SurfaceContact::planes(const Tool& tool, Vec3 y, std::size_t from, std::size_t to, double slack_mm) noexcept {
  for (std::size_t i = from; i < to; ++i) {
    Plane plane;
    bool trusted = false;
    if (!plane_of(tool, candidates_[i], y, slack_mm, plane, trusted)) continue;
    origins_[planes_.size()] = {static_cast<std::int32_t>(i), trusted, false};
    planes_.add(plane.n, plane.c);
  }
}

void SurfaceContact::relax_by_memory(std::size_t from, std::size_t to) noexcept {
  // An edge that the strokes themselves told needs no mending.
  planes_.recede_to({past_.data(), static_cast<std::size_t>(past_count_)}, kMemorySlack, from, to,
                    [&](std::size_t i) { return !sharp_ || candidates_[static_cast<std::size_t>(origins_[i].candidate)].kind != Kind::edge; },
                    [&](std::size_t i) { origins_[i].relaxed = true; });
}

/// A tangent follows its pose; planes of the field and of the foot stay.
void SurfaceContact::turn(const Tool& tool, Vec3 y, std::size_t i) noexcept {
  if (origins_[i].trusted_plane) return;
  Plane plane;
  bool trusted = false;
  const Candidate& c = candidates_[static_cast<std::size_t>(origins_[i].candidate)];
  if (!plane_of(tool, c, y, 1.0, plane, trusted)) return;
  planes_.set(i, plane.n, plane.c);
  origins_[i].trusted_plane = trusted;
  relax_by_memory(i, i + 1);
}

/// Where a burr rolls over edges and points its planes turn with it, and each pass leaves a share of the way: what the
/// passes to come would add to off_by, the move of the last one from where its planes were laid. rolls: they would not come
/// to rest.
Vec3 SurfaceContact::leap_of(const PlaneSearch& found, Vec3 at, Vec3 off_by, bool& rolls) const noexcept {
  if (found.active == 0 || found.active > 2) return Vec3(0.0);
  // Along what is left free: one direction between two planes, two on one.
  Vec3 free[2] = {Vec3(0.0), Vec3(0.0)};
  const Vec3 n = planes_.n(static_cast<std::size_t>(found.index[0]));
  if (found.active == 2) {
    const Vec3 along = glm::cross(n, planes_.n(static_cast<std::size_t>(found.index[1])));
    const double length = length_of(along);
    if (length < 1e-3) return Vec3(0.0);
    free[0] = along / length;
  } else {
    const Vec3 along = std::fabs(n.x) < 0.6 ? Vec3(0.0, n.z, -n.y) : Vec3(-n.z, 0.0, n.x);
    free[0] = along / length_of(along);
    free[1] = glm::cross(n, free[0]);
  }
  const int directions = 3 - found.active;
  const bool close = glm::dot(off_by, off_by) < kCloseLeapMm * kCloseLeapMm;
  // m = sum of weight times the second derivative of the distance to what each plane stands for.
  double m[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
  for (int a = 0; a < found.active; ++a) {
    const auto i = static_cast<std::size_t>(found.index[a]);
    const Origin& origin = origins_[i];
    const Candidate& c = candidates_[static_cast<std::size_t>(origin.candidate)];
    // Of a point of a face it is believed only close by: there the face itself soon takes over.
    if (origin.trusted_plane || origin.relaxed || c.kind == Kind::shank || (c.kind == Kind::surface && !close)) continue;
    Vec3 off = at - c.point, along(0.0);
    double curved = 0.0;
    if (c.kind == Kind::edge && !nearest_on(c, voxel_mm_, 1e3, off, along, curved)) curved = 0.0;
    const double distance = length_of(off);
    if (distance < 1e-6) continue;
    const Vec3 out = off / distance;
    for (int j = 0; j < directions; ++j)
      for (int k = 0; k <= j; ++k) {
        double h = (j == k ? 1.0 : 0.0) - glm::dot(free[j], out) * glm::dot(free[k], out);
        if (curved > 0.0) h -= glm::dot(free[j], along) * glm::dot(free[k], along) / curved;
        m[j][k] += found.weight[a] * h / distance;
      }
  }
  m[0][1] = m[1][0];
  // The geometric series m + m^2 + ..: m (1 - m)^-1, where it converges.
  constexpr double kLeast = 0.03;
  const Vec3 moved(glm::dot(off_by, free[0]), directions > 1 ? glm::dot(off_by, free[1]) : 0.0, 0.0);
  const double a = 1.0 - m[0][0], b = -m[0][1], d = directions > 1 ? 1.0 - m[1][1] : 1.0;
  const double det = a * d - b * b;
  rolls = !(a > kLeast && d > kLeast && det > kLeast * kLeast);
  const double size = length_of(moved);
  if (size > kFarthestLeapMm) return Vec3(0.0);  // what the second order says of so long a way is not to be believed
  const double most = std::min(kLongestLeap * size, kFarthestLeapMm);
  if (rolls) return size > 0.0 ? (free[0] * moved.x + free[1] * moved.y) * (most / size) : Vec3(0.0);
  const double u = (d * moved.x - b * moved.y) / det - moved.x;
  const double v = (a * moved.y - b * moved.x) / det - moved.y;
  const double length = std::sqrt(u * u + v * v);
  const double share = length > most ? most / length : 1.0;
  return (free[0] * u + (directions > 1 ? free[1] * v : Vec3(0.0))) * share;
}

/// The search among planes_, begun with those that held the pose before.
PlaneSearch SurfaceContact::search_planes(Vec3 y, Vec3 device, bool& infeasible) noexcept {
  PlaneSearch found = closest_point(device, planes_, kTolerance, {held_.plane, static_cast<std::size_t>(held_.count)});
  if (!found.feasible) {
    // Tangents of points contradict each other: what the pose already stands in cannot be asked of it.
    infeasible = true;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      const double at = glm::dot(planes_.n(i), y);
      if (at < planes_.c(i)) planes_.set_c(i, at);
    }
    found = closest_point(device, planes_, kTolerance, {});
  }
  held_.count = found.active;
  for (int a = 0; a < found.active; ++a) held_.plane[a] = found.index[a];
  return found;
}

SurfaceContact::Polished SurfaceContact::polish(const Volume& volume, const Tool& tool, Vec3 y, Vec3 device,
                                                const PlaneSearch& found) noexcept {
  Polished out;
  // Active planes of one smooth surface stand for one contact: their mean normal, corrected on the field itself.
  struct Group {
    Vec3 normal{0.0};
    double weight = 0.0, heaviest = -1.0;
    Field field = Field::base;
    std::int32_t candidate = 0;
  };
  Group group[3];
  int groups = 0;
  for (int a = 0; a < found.active; ++a) {
    const Origin& origin = origins_[static_cast<std::size_t>(found.index[a])];
    const Candidate& c = candidates_[static_cast<std::size_t>(origin.candidate)];
    if (c.kind != Kind::surface || origin.relaxed || c.others > 0) return out;
    int g = 0;
    while (g < groups && !(group[g].field == c.field && glm::dot(candidates_[static_cast<std::size_t>(group[g].candidate)].normal, c.normal) > kSameNormal)) ++g;
    if (g == groups) {
      group[groups] = Group{};
      group[groups].field = c.field;
      ++groups;
    }
    const double w = found.weight[a] > 1e-12 ? found.weight[a] : 1e-12;
    group[g].normal += c.normal * w;
    group[g].weight += w;
    if (w > group[g].heaviest) {
      group[g].heaviest = w;
      group[g].candidate = origin.candidate;
    }
  }
  for (int g = 0; g < groups; ++g) group[g].normal = group[g].normal / length_of(group[g].normal);

  // Wholly enclosed contact has no single foot to correct.
  int tight = 0;
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_.slack(i, found.y) > 0.003) continue;
    bool apart = true;
    for (int g = 0; g < groups; ++g) apart = apart && glm::dot(planes_.n(i), group[g].normal) < kSameNormal;
    if (apart && ++tight >= 4) return out;
  }

  Plane corrected[3];
  Vec3 at = found.y;
  PlaneSearch search = found;
  double before = 0.01;
  for (int pass = 0; pass < 5; ++pass) {
    for (int g = 0; g < groups; ++g) {
      const double r = group[g].field == Field::base ? tool.r_base : tool.r_cut;
      const Vec3 x = at - group[g].normal * r;
      const FieldPoint field = fields_.at(volume, group[g].field, x);
      if (!field.known || (field.creased && (sharp_ || group[g].field == Field::base)) || std::fabs(field.d_mm) > 0.3 * voxel_mm_ || glm::dot(field.normal, group[g].normal) < kTurned)
        return out;
      group[g].normal = field.normal;
      corrected[g].n = field.normal;
      corrected[g].c = glm::dot(field.normal, x - field.normal * field.d_mm) + r;
      corrected[g].from = group[g].candidate;
    }
    search = closest_point(device, {corrected, static_cast<std::size_t>(groups)}, kTolerance);
    if (!search.feasible) return out;
    const double moved = length_of(search.y - at);
    at = search.y;
    if (length_of(at - y) > kLongestStep + voxel_mm_ || length_of(at - found.y) > voxel_mm_) return out;
    // Each pass leaves the same share of the error before: the next one would move by moved^2 / before.
    if (moved * moved < kPolishedMm * before || moved < kPolishedMm) break;
    before = moved;
  }
  // The foot belongs to the cell that it came from (a wide ball's foot is nearer to it than its centre is beside it).
  for (int g = 0; g < groups; ++g) {
    const Vec3 off = at - corrected[g].n * (group[g].field == Field::base ? tool.r_base : tool.r_cut) -
                     candidates_[static_cast<std::size_t>(group[g].candidate)].point;
    if (glm::dot(off, off) > kFootReach * kFootReach * voxel_mm_ * voxel_mm_) return out;
  }
  // What the polish left out must still be clear of the ball.
  for (std::size_t i = 0; i < planes_.size(); ++i) {
    if (planes_.slack(i, at) >= -kTogether) continue;
    const Candidate& c = candidates_[static_cast<std::size_t>(origins_[i].candidate)];
    bool same = false;
    for (int g = 0; g < groups; ++g)
      same = same || (c.kind == Kind::surface && group[g].field == c.field &&
                      glm::dot(c.normal, group[g].normal) > kTurned);
    if (!same) return out;
  }
  out.accepted = true;
  out.search = search;
  for (int a = 0; a < search.active; ++a) {
    out.normal[a] = corrected[search.index[a]].n;
    out.candidate[a] = corrected[search.index[a]].from;
  }
  return out;
}

void SurfaceContact::note(const PlaneSearch& found, const Polished& polished, Contact& out) const noexcept {
  out.shank = false;
  out.active = found.active;
  for (int a = 0; a < found.active; ++a) {
    const auto i = static_cast<std::size_t>(found.index[a]);
    const Candidate& c = candidates_[static_cast<std::size_t>(origins_[i].candidate)];
    out.normal[a] = planes_.n(i);
    out.weight[a] = found.weight[a];
    out.tissue[a] = c.tissue;
    if (c.kind == Kind::shank) {
      out.shank = true;
      out.shank_normal = out.normal[a];
    }
  }
  if (!polished.accepted) return;
  out.active = polished.search.active;
  for (int a = 0; a < out.active; ++a) {
    out.normal[a] = polished.normal[a];
    out.weight[a] = polished.search.weight[a];
    out.tissue[a] = candidates_[static_cast<std::size_t>(polished.candidate[a])].tissue;
  }
}

Contact SurfaceContact::solve(const Volume& volume, const Scene& scene, std::uint16_t burr_index, Vec3 axis,
                              Vec3 from, Vec3 device, Vec3 ahead, double reach_mm) noexcept {
  const Burr& burr = scene.burrs[burr_index];
  Contact out;
  out.pose_mm = device;
  if (free_.valid && free_.burr == burr_index && free_.holds(from) && free_.holds(device)) {
    ++answered_free_;
    return out;
  }
  const Tool tool{&burr, axis, burr_index, burr.radius_mm, burr.radius_mm - kClearanceMm};
  if (free_.valid && free_.burr == burr_index && free_.holds(from)) {
    // It leaves the free space that is known: there may be more.
    find_free(volume, tool, from);
    if (free_.valid && free_.holds(device)) {
      ++answered_free_;
      return out;
    }
  }
  if (clear_path(volume, burr, axis, from, device)) return out;
  overflow_ = false;
  double step = std::min(kLongestStep, std::max(0.004, reach_mm));
  Vec3 y = from;
  bool arrived = false;
  bool with_foot = false;

  for (int search = 0; search < kSearches && !arrived; ++search) {
    const Vec3 centre = y;
    gather(volume, tool, y, step);
    const std::size_t at_hand_count = count_;
    held_.count = 0;
    double before = 0.0, last_moved = 1.0;
    double limit = kPredicted * step + 0.005;
    Vec3 at = y;        // where planes are laid: first where the device's own move would take the burr, then where it is
    if (search == 0) {
      const double length = length_of(ahead);
      if (length > 2.0 * kSettledMm) at += length > step ? ahead * (step / length) : ahead;
    }
    bool left = false;  // the step ends before the search does
    bool rolling = false;
    for (int pass = 0; pass < 10; ++pass) {
      if (last_moved > kSettledMm) {
        held_.count = 0;
        near_planes(volume, tool, centre, step, at, limit);
        // Surfaces that a burr left, and edges, may hug it: then the point under the push is asked for from the beginning.
        with_foot = with_foot || near_cut_;
        if (with_foot) {
          foot(volume, tool, at, device);
          planes(tool, at, at_hand_count, count_, limit);
          count_ = at_hand_count;
        }
        past_count_ = memory_ ? memory_->near(at, burr.radius_mm, past_) : 0;
        relax_by_memory(0, planes_.size());
      } else {
        // It has nearly come to rest: only the tangents that hold it need to turn with it.
        for (int a = 0; a < held_.count; ++a) turn(tool, at, static_cast<std::size_t>(held_.plane[a]));
      }
      const PlaneSearch found = search_planes(y, device, out.infeasible);
      if (!found.feasible) {
        arrived = true;
        break;
      }
      if (planes_.size() == 0 && inside_tissue(volume, y)) {
        // Deep in tissue where there is no surface to follow.
        out.infeasible = true;
        arrived = true;
        break;
      }
      const double off = length_of(found.y - at);
      if (off > limit && limit < 2.0 * step) {
        // Further than planes were laid for: all that the step can reach.
        limit = 2.0 * step;
        last_moved = 1.0;
        continue;
      }
      Vec3 target = found.y;
      const double whole = length_of(target - centre);
      left = whole > step;
      Polished polished;
      if (!left && found.active > 0) polished = polish(volume, tool, y, device, found);
      if (found.active > 0 && !polished.accepted && !with_foot) {
        // Not one smooth foot for each plane: from here on the point under the push is asked for as well.
        with_foot = true;
        left = false;
        last_moved = 1.0;
        at = y;
        limit = 2.0 * step;
        continue;
      }
      if (left) target = centre + (target - centre) * (step / whole);
      if (polished.accepted) target = polished.search.y;
      y = target;
      held_.fresh = !polished.accepted && !left;
      note(found, polished, out);
      if (left) break;
      const Vec3 off_by = target - at;
      const double moved = length_of(off_by);
      // Where it creeps towards its rest, as on an edge that it rolls over, the next planes are laid where the creeping
      // leads; the answer still is of the planes.
      bool rolls = false;
      const Vec3 leap = polished.accepted ? Vec3(0.0) : leap_of(found, at, off_by, rolls);
      // Passes shrink the error like moved / before; a plane that was laid moved away is off by moved^2 / 2r only.
      if ((polished.accepted && moved < 0.06) || moved < (rolls ? kRollsMm : kArrivedMm) ||
          (!rolls && moved * moved < kArrivedMm * before)) {
        arrived = true;
        break;
      }
      at = y + leap;
      rolling = rolls;
      before = moved;
      last_moved = length_of(off_by + leap);
    }
    // What still rolls on goes further in the next search.
    if (!left && !(rolling && last_moved > kSettledMm)) arrived = true;
    step = kLongestStep;
  }
  out.pose_mm = y;
  out.deferred = !arrived;
  out.overflow = overflow_;
  if (out.active == 0 && arrived && !out.infeasible) {
    if (free_pause_ > 0) {
      --free_pause_;
    } else {
      find_free(volume, tool, y);
    }
  }
  return out;
}

Contact SurfaceContact::after_cut(const Volume& volume, const Scene& scene, std::uint16_t burr_index, Vec3 axis,
                                  const Contact& before, Vec3 device, double advance_mm) noexcept {
  // The field is the same: only the stroke's memory lets planes recede that are laid already.
  if (held_.fresh && gathered_.valid && !before.infeasible && before.active > 0) {
    Contact out;
    past_count_ = memory_ ? memory_->near(before.pose_mm, scene.burrs[burr_index].radius_mm, past_) : 0;
    relax_by_memory(0, planes_.size());
    const PlaneSearch found = search_planes(before.pose_mm, device, out.infeasible);
    if (found.feasible && !out.infeasible && length_of(found.y - before.pose_mm) <= 2.0 * advance_mm + kSettledMm) {
      out.pose_mm = found.y;
      note(found, Polished{}, out);
      return out;
    }
  }
  return solve(volume, scene, burr_index, axis, before.pose_mm, device, Vec3(0.0), advance_mm + 0.004);
}

bool SurfaceContact::fits(const Volume& volume, const Burr& burr, Vec3 axis, Vec3 pose) noexcept {
  if (clear_path(volume, burr, axis, pose, pose)) return true;
  if (inside_tissue(volume, pose)) return false;
  const Tool tool{&burr, axis, kNoBurr, burr.radius_mm, burr.radius_mm - kClearanceMm};
  gathered_.valid = false;
  gather(volume, tool, pose, voxel_mm_);
  near_planes(volume, tool, pose, voxel_mm_, pose, 0.0);
  gathered_.valid = false;
  return planes_.size() == 0;
}

bool SurfaceContact::push_out(const Volume& volume, Vec3 pose, double radius_mm, Vec3& out) noexcept {
  constexpr double kMost = 0.02;
  Burr ball;
  ball.radius_mm = radius_mm;
  const Tool tool{&ball, Vec3(0.0, 0.0, 1.0), kNoBurr, radius_mm, radius_mm};
  count_ = 0;
  gathered_.valid = false;
  gather_ball(volume, tool, pose, kMost + 0.01);
  for (std::size_t i = 0; i < count_; ++i) made(volume, i);
  Vec3 y = pose;
  for (int pass = 0; pass < 4; ++pass) {
    planes_.clear();
    planes(tool, y, 0, count_, 0.1);
    const PlaneSearch found = closest_point(pose, planes_, kTolerance, {});
    if (!found.feasible || length_of(found.y - pose) > kMost) return false;
    const double moved = length_of(found.y - y);
    y = found.y;
    if (moved < 1e-6) break;
  }
  out = y;
  return true;
}

}  // namespace cusp
