#include "ui/editor/node_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "scenarios/shapes/region.h"
#include "ui/editor/region_parts.h"

namespace cusp::ui {
namespace {

constexpr int kSeeds = 20;               // places along each side of the searched box: 0.1 to 0.5 mm apart in a tooth
constexpr int kMostSteps = 12;           // Newton's; faces at a right angle take one or two
constexpr double kOnSurfaceMm = 1e-3;    // a tenth of a handle's step
constexpr double kDifferenceMm = 0.02;   // for a gradient: below a voxel, far above rounding
constexpr double kRoomMm = 0.3;          // below a face, so that a part grown inwards by so much still has it
constexpr double kLeastSine2 = 0.01;     // squared: faces that lean less to each other have no edge, but a seam

using Kind = TargetHandle::Kind;

/// Sums of steps stay on the same side of a half: the place moves exactly as the leaves do.
double on_stable_step(double mm) { return tidy(std::floor(mm / kHandleStepMm + 0.5 + 1e-6) * kHandleStepMm); }

std::optional<Vec3> place_of_leaf(const Region& leaf) {
  if (is_of_voxels(leaf.kind)) return std::nullopt;
  if (has_ends(leaf.kind)) return 0.5 * (leaf.from_mm + leaf.to_mm);
  if (leaf.kind != RegionKind::outline) return leaf.from_mm;
  Vec3 low(std::numeric_limits<double>::max()), high(-low);
  for (const auto& path : leaf.outline.paths)
    for (const Vec3& p : path) low = glm::min(low, p), high = glm::max(high, p);
  if (low.x > high.x) return std::nullopt;
  return Vec3(0.5 * (low.x + high.x), 0.5 * (low.y + high.y), leaf.outline.top_mm);
}

struct Sum {
  Vec3 mm{0.0};
  int leaves = 0;
  void add(Vec3 place) { mm += place, ++leaves; }
};
void add_leaves(const Region& part, Sum& bounded, Sum& half_spaces) {
  for (const Region& below : part.parts) add_leaves(below, bounded, half_spaces);
  if (is_node(part.kind)) return;
  const auto place = place_of_leaf(part);
  if (place) (part.kind == RegionKind::half_space ? half_spaces : bounded).add(*place);
}

/// The surfaces of a node's parts, signed so that all are negative within the node without its rounding, or outside a union.
class PartSurfaces {
 public:
  PartSurfaces(const Region& node, const std::shared_ptr<const Specimen>& specimen) : kind_(node.kind) {
    for (const Region& part : node.parts) shapes_.emplace_back(part, specimen);
  }
  double at(std::size_t part, Vec3 p) const {
    const double d = shapes_[part].near(p).distance_mm;
    const bool turned = kind_ == RegionKind::joined || (kind_ == RegionKind::difference && part > 0);
    return turned ? -d : d;
  }
  Vec3 gradient(std::size_t part, Vec3 p) const {
    Vec3 out;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 step(0.0);
      step[axis] = kDifferenceMm;
      out[axis] = (at(part, p + step) - at(part, p - step)) / (2 * kDifferenceMm);
    }
    return out;
  }
  /// The two parts whose surfaces lie furthest out of a place; the same one twice if there is one.
  std::array<std::size_t, 2> outermost(Vec3 p) const {
    std::array<std::size_t, 2> out{0, 0};
    std::array<double, 2> most{-std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
      const double d = at(i, p);
      if (d > most[0]) {
        most = {d, most[0]};
        out = {i, out[0]};
      } else if (d > most[1]) {
        most[1] = d;
        out[1] = i;
      }
    }
    return out;
  }

 private:
  RegionKind kind_;
  std::vector<RegionShape> shapes_;
};

// Both end at a shape without a size, whose distances are no numbers.

std::optional<NodeAnchor> on_face(const PartSurfaces& surfaces, Vec3 seed, double reach_mm) {
  if (!(std::abs(surfaces.at(0, seed)) <= reach_mm)) return std::nullopt;
  Vec3 p = seed;
  for (int i = 0; i < kMostSteps && glm::length(p - seed) <= 2 * reach_mm; ++i) {
    const double d = surfaces.at(0, p);
    const Vec3 out = surfaces.gradient(0, p);
    const double steep2 = glm::dot(out, out);
    if (!(steep2 >= kLeastSine2)) return std::nullopt;
    if (std::abs(d) < kOnSurfaceMm) return NodeAnchor{p, out / std::sqrt(steep2)};
    p -= d / steep2 * out;
  }
  return std::nullopt;
}

/// By the shortest step to the line where the planes of both faces meet.
std::optional<NodeAnchor> on_edge(const PartSurfaces& surfaces, Vec3 seed, double reach_mm) {
  const auto [a, b] = surfaces.outermost(seed);
  if (!(std::abs(surfaces.at(a, seed)) <= reach_mm && std::abs(surfaces.at(b, seed)) <= reach_mm)) return std::nullopt;
  Vec3 p = seed;
  for (int i = 0; i < kMostSteps && glm::length(p - seed) <= 2 * reach_mm; ++i) {
    const double da = surfaces.at(a, p), db = surfaces.at(b, p);
    const Vec3 na = surfaces.gradient(a, p), nb = surfaces.gradient(b, p);
    const double aa = glm::dot(na, na), bb = glm::dot(nb, nb), ab = glm::dot(na, nb);
    const double det = aa * bb - ab * ab;
    if (!(det >= kLeastSine2)) return std::nullopt;
    if (std::abs(da) < kOnSurfaceMm && std::abs(db) < kOnSurfaceMm) {
      const auto [first, second] = surfaces.outermost(p);  // another part may cover the edge
      if (surfaces.at(first, p) > kOnSurfaceMm) return std::nullopt;
      return NodeAnchor{p, -glm::normalize(na + nb)};
    }
    p -= ((da * bb - db * ab) * na + (db * aa - da * ab) * nb) / det;
  }
  return std::nullopt;
}

/// False beside a part's corner. A cone's and an ellipsoid's distances fall short of the depth.
bool has_room(const PartSurfaces& surfaces, const NodeAnchor& face) {
  const double rise = surfaces.at(0, face.at_mm + kRoomMm * face.along), fall = -surfaces.at(0, face.at_mm - kRoomMm * face.along);
  return fall > 0.9 * rise;
}

struct Searched {
  Vec3 low{0.0}, high{0.0};
  bool contains(Vec3 p) const {
    return glm::all(glm::greaterThanEqual(p, low - kOnSurfaceMm)) && glm::all(glm::lessThanEqual(p, high + kOnSurfaceMm));
  }
};
/// The node without its rounding and growth, as far as the specimen's grid goes.
Searched box_of(const Region& node, const std::shared_ptr<const Specimen>& specimen) {
  Region plain = node;
  plain.rounding_mm = plain.by_mm = 0;
  const RegionBounds bounds = RegionShape(plain, specimen).bounds();
  const Grid& grid = specimen->grid();
  const Vec3 last = grid.origin_mm + grid.voxel_mm * Vec3(specimen->brick_count() * kBrickEdge);
  return {glm::max(bounds.low, grid.origin_mm), glm::min(bounds.high, last)};
}

bool in_tooth(const Specimen& specimen, Vec3 p) {
  const Grid& grid = specimen.grid();
  return specimen.tissue(IVec3(glm::floor((p - grid.origin_mm) / grid.voxel_mm + 0.5))) != Tissue::empty;
}

}  // namespace

std::optional<Vec3> middle_of_leaves(const Region& part) {
  Sum bounded, half_spaces;
  add_leaves(part, bounded, half_spaces);
  const Sum& sum = bounded.leaves > 0 ? bounded : half_spaces;
  if (sum.leaves == 0) return std::nullopt;
  const Vec3 mean = sum.mm / static_cast<double>(sum.leaves);
  return Vec3(on_stable_step(mean.x), on_stable_step(mean.y), on_stable_step(mean.z));
}

Region shifted(const Region& part, Vec3 by_mm) {
  Region out = part;
  for (Region& below : out.parts) below = shifted(below, by_mm);
  if (is_node(part.kind) || is_of_voxels(part.kind)) return out;
  if (part.kind == RegionKind::outline) {
    out.outline.top_mm = tidy(out.outline.top_mm + by_mm.z);
    for (auto& path : out.outline.paths)
      for (Vec3& p : path) p = tidy(p + by_mm);
    return out;
  }
  out.from_mm = tidy(out.from_mm + by_mm);
  if (has_ends(part.kind)) out.to_mm = tidy(out.to_mm + by_mm);
  return out;
}

std::optional<NodeAnchor> node_anchor(const Region& node, const std::shared_ptr<const Specimen>& specimen) {
  if (!is_node(node.kind) || node.parts.empty()) return std::nullopt;
  const bool offset = node.kind == RegionKind::offset;
  if (!offset && node.parts.size() < 2) return std::nullopt;
  const Searched box = box_of(node, specimen);
  const Vec3 cell = (box.high - box.low) / static_cast<double>(kSeeds);
  if (!(cell.x > 0 && cell.y > 0 && cell.z > 0)) return std::nullopt;
  const PartSurfaces surfaces(node, specimen);
  std::optional<NodeAnchor> best;
  int best_rank = -1;
  for (int z = kSeeds; z-- > 0;)
    for (int y = 0; y < kSeeds; ++y)
      for (int x = 0; x < kSeeds; ++x) {
        const Vec3 seed = box.low + cell * (Vec3(x, y, z) + 0.5);
        const auto found = offset ? on_face(surfaces, seed, glm::length(cell)) : on_edge(surfaces, seed, glm::length(cell));
        if (!found || !box.contains(found->at_mm)) continue;
        const int rank = (in_tooth(*specimen, found->at_mm) ? 2 : 0) + (!offset || has_room(surfaces, *found) ? 1 : 0);
        if (rank == 3) return found;
        if (rank <= best_rank) continue;
        best = found;
        best_rank = rank;
      }
  return best;
}

std::vector<TargetHandle> handles_of_node(const Region& node, const std::optional<NodeAnchor>& anchor) {
  if (!is_node(node.kind)) return {};
  std::vector<TargetHandle> out;
  if (const auto middle = middle_of_leaves(node)) out.push_back({.kind = Kind::whole, .at_mm = *middle});
  if (!anchor) return out;
  const bool offset = node.kind == RegionKind::offset;
  const double far = offset ? node.by_mm : node.rounding_mm;
  out.push_back({.kind = offset ? Kind::growth : Kind::rounding, .at_mm = anchor->at_mm + far * anchor->along, .along = anchor->along});
  return out;
}

}  // namespace cusp::ui
