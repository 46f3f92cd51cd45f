#include "engine/mirror/surface_patches.h"

#include <algorithm>
#include <array>
#include <bitset>

namespace cusp::engine {
namespace {

/// Samples of a patch along one axis: every `step`-th voxel; edges start at samples `first` to `last`.
struct Lattice {
  IVec3 corner;   // voxel of sample 0
  int step;       // voxels between samples
  int own;        // samples 0..own-1 belong to this brick
  int seam;       // samples beyond it on either side whose edges are taken too
  int first() const noexcept { return -seam; }
  int last() const noexcept { return own - 1 + seam; }
  int below() const noexcept { return first() - 1; }      // lowest sample read
  int samples() const noexcept { return own + 2 + 2 * seam; }
  int index(IVec3 c) const noexcept {                     // of a sample, or of the cell above it
    const int n = samples(), from = below();
    return (c.x - from) + n * ((c.y - from) + n * (c.z - from));
  }
};

constexpr int kMostSamples = 10;  // fine: -1 to 8; coarse: -2 to 5

/// The coarse vertex: the mean of the fine points in its eight cells, so that it needs no field of its own.
bool coarse_point(const Volume& volume, IVec3 cell, SurfacePoint& out) noexcept {
  std::array<SurfacePoint, 8> found;
  std::size_t n = 0;
  for (int i = 0; i < 8; ++i) {
    if (surface_point(volume, cell + IVec3(i & 1, i >> 1 & 1, i >> 2), found[n])) ++n;
  }
  if (n == 0) return false;
  Vec3 point(0.0), normal(0.0);
  for (std::size_t i = 0; i < n; ++i) {
    point += found[i].point_mm;
    normal += found[i].normal;
  }
  point /= static_cast<double>(n);
  // Tissue and origin are those of the fine point nearest the mean.
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (glm::dot(found[i].point_mm - point, found[i].point_mm - point) <
        glm::dot(found[nearest].point_mm - point, found[nearest].point_mm - point))
      nearest = i;
  }
  out = found[nearest];
  out.point_mm = point;
  const double length = glm::length(normal);
  if (length > 1e-9) out.normal = normal / length;
  return true;
}

class Builder {
 public:
  Builder(const Volume& volume, int brick, int level, Patch& out)
      : volume_{volume}, out_{out}, lattice_{volume.specimen().brick_at(brick) * kBrickEdge, level, kBrickEdge / level, level == kCoarsePatch ? 1 : 0} {
    at_low_edge_ = {lattice_.corner.x == 0, lattice_.corner.y == 0, lattice_.corner.z == 0};
    vertex_.fill(kNone);
  }

  void run() {
    if (!read_occupancy()) return;
    quads(Edges::own);
    out_.own = out_.indices.size();
    if (lattice_.seam > 0) quads(Edges::of_neighbours);
  }

 private:
  /// Lattice edges: those of this brick, or those beyond it that close the seam.
  enum class Edges : std::uint8_t { own, of_neighbours };
  /// The end of a lattice edge that lies outside the tissue.
  enum class Outside : std::uint8_t { lower, upper };

  static constexpr std::uint16_t kNone = 0xffff;
  static constexpr std::size_t kMost = kMostSamples * kMostSamples * kMostSamples;

  /// False if all samples are alike.
  bool read_occupancy() {
    std::size_t set = 0, all = 0;
    IVec3 c;
    for (c.z = lattice_.below(); c.z <= lattice_.last() + 1; ++c.z)
      for (c.y = lattice_.below(); c.y <= lattice_.last() + 1; ++c.y)
        for (c.x = lattice_.below(); c.x <= lattice_.last() + 1; ++c.x) {
          const bool there = volume_.occupied(lattice_.corner + lattice_.step * c);
          solid_[static_cast<std::size_t>(lattice_.index(c))] = there;
          set += there ? 1u : 0u;
          ++all;
        }
    return set != 0 && set != all;
  }

  bool solid(IVec3 c) const { return solid_[static_cast<std::size_t>(lattice_.index(c))]; }

  void quads(Edges edges) {
    const int from = std::min(lattice_.first(), -1);
    IVec3 c;
    for (c.z = from; c.z <= lattice_.last(); ++c.z)
      for (c.y = from; c.y <= lattice_.last(); ++c.y)
        for (c.x = from; c.x <= lattice_.last(); ++c.x) {
          for (int axis = 0; axis < 3; ++axis) {
            // An edge that enters the box from outside belongs to the brick it enters.
            if (is_own(c, axis) != (edges == Edges::own)) continue;
            IVec3 up = c;
            ++up[axis];
            const bool here = solid(c);
            if (here != solid(up)) quad(c, axis, here ? Outside::upper : Outside::lower);
          }
        }
  }

  bool is_own(IVec3 c, int axis) const {
    for (int i = 0; i < 3; ++i) {
      if (c[i] >= lattice_.own) return false;
      if (c[i] < 0 && (c[i] < -1 || i != axis || !at_low_edge_[static_cast<std::size_t>(i)])) return false;
    }
    return true;
  }

  void quad(IVec3 c, int axis, Outside outside) {
    const int b = (axis + 1) % 3, d = (axis + 2) % 3;
    std::array<std::uint16_t, 4> v;
    IVec3 cell = c;
    --cell[b];
    --cell[d];
    v[0] = vertex(cell);
    ++cell[b];
    v[1] = vertex(cell);
    ++cell[d];
    v[2] = vertex(cell);
    --cell[b];
    v[3] = vertex(cell);
    if (v[0] == kNone || v[1] == kNone || v[2] == kNone || v[3] == kNone) return;
    if (outside == Outside::lower) std::swap(v[1], v[3]);
    const auto apart = [this](std::uint16_t i, std::uint16_t j) {
      const Vec3f step = out_.vertices[i].position_mm - out_.vertices[j].position_mm;
      return glm::dot(step, step);
    };
    auto& to = out_.indices;
    if (apart(v[0], v[2]) <= apart(v[1], v[3])) {
      to.insert(to.end(), {v[0], v[1], v[2], v[0], v[2], v[3]});
    } else {
      to.insert(to.end(), {v[0], v[1], v[3], v[1], v[2], v[3]});
    }
  }

  std::uint16_t vertex(IVec3 cell) {
    std::uint16_t& slot = vertex_[static_cast<std::size_t>(lattice_.index(cell))];
    if (slot != kNone) return slot;
    SurfacePoint p;
    const IVec3 at = lattice_.corner + lattice_.step * cell;
    if (!(lattice_.step == 1 ? surface_point(volume_, at, p) : coarse_point(volume_, at, p))) return kNone;
    slot = static_cast<std::uint16_t>(out_.vertices.size());
    out_.vertices.push_back({Vec3f(p.point_mm), Vec3f(p.normal), p.tissue, p.cut});
    return slot;
  }

  const Volume& volume_;
  Patch& out_;
  Lattice lattice_;
  std::array<bool, 3> at_low_edge_{};
  std::bitset<kMost> solid_;
  std::array<std::uint16_t, kMost> vertex_;
};

}  // namespace

bool may_have_surface(const Volume& volume, int brick) noexcept {
  const Specimen& specimen = volume.specimen();
  const IVec3 at = specimen.brick_at(brick);
  if (!specimen.uniform(brick)) return true;
  const bool there = specimen.s_in(brick, 0) != 0;
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const int b = specimen.brick_index(at + IVec3(x, y, z));
        if (b < 0) {
          if (there) return true;
          continue;
        }
        if (!specimen.uniform(b) || volume.has_cut(b) || (specimen.s_in(b, 0) != 0) != there) return true;
      }
  return false;
}

Patch build_patch(const Volume& volume, int brick, int level) {
  Patch out;
  out.brick = brick;
  out.level = level == kCoarsePatch ? kCoarsePatch : kFinePatch;
  if (may_have_surface(volume, brick)) Builder(volume, brick, out.level, out).run();
  return out;
}

std::vector<int> patches_touched_by(const Specimen& specimen, int brick) {
  const IVec3 at = specimen.brick_at(brick);
  std::vector<int> out;
  out.reserve(27);
  for (int z = -1; z <= 1; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        const int b = specimen.brick_index(at + IVec3(x, y, z));
        if (b >= 0) out.push_back(b);
      }
  return out;
}

}  // namespace cusp::engine
