#include "ui/render/overlay_line.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "engine/mirror/surface_patches.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

/// Where the field crosses an edge of the mesh: the same place from both triangles, known by its quantised position.
using NodeKey = std::array<std::int64_t, 3>;

struct Crossing {
  Vec3f at, normal;
};

struct Node {
  Vec3f at, normal;
  std::vector<std::size_t> next;  // joined nodes
};

class Chains {
 public:
  void join(const Crossing& a, const Crossing& b) {
    const std::size_t i = node(a), j = node(b);
    if (i == j) return;
    nodes_[i].next.push_back(j);
    nodes_[j].next.push_back(i);
  }

  std::vector<OverlayLine> lines(const LineStyle& style) {
    std::vector<OverlayLine> out;
    used_.clear();
    // Open lines from their ends first, then what is left is closed.
    for (const bool ends : {true, false}) {
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (ends && nodes_[i].next.size() != 1) continue;
        for (const std::size_t j : nodes_[i].next) {
          if (used_.count(edge(i, j))) continue;
          OverlayLine line{{}, {}, style};
          add(line, i);
          std::size_t from = i, to = j;
          while (true) {
            used_[edge(from, to)] = true;
            add(line, to);
            std::size_t onward = to;
            for (const std::size_t k : nodes_[to].next) {
              if (!used_.count(edge(to, k))) onward = k;
            }
            if (onward == to) break;
            from = to;
            to = onward;
          }
          if (line.points_mm.size() > 2) out.push_back(std::move(line));
        }
      }
    }
    return out;
  }

 private:
  static std::pair<std::size_t, std::size_t> edge(std::size_t a, std::size_t b) {
    return a < b ? std::pair{a, b} : std::pair{b, a};
  }
  std::size_t node(const Crossing& crossing) {
    const auto& [at, normal] = crossing;
    // A tenth of a micrometre: two triangles reckon the same crossing to the last bits of a float.
    const NodeKey key = {std::llround(at.x * 1e4), std::llround(at.y * 1e4), std::llround(at.z * 1e4)};
    const auto [it, made] = index_.try_emplace(key, nodes_.size());
    if (made) nodes_.push_back({at, normal, {}});
    return it->second;
  }
  void add(OverlayLine& line, std::size_t i) const {
    line.points_mm.push_back(nodes_[i].at);
    line.normals.push_back(nodes_[i].normal);
  }

  std::map<NodeKey, std::size_t> index_;
  std::vector<Node> nodes_;
  std::map<std::pair<std::size_t, std::size_t>, bool> used_;
};

}  // namespace

std::vector<OverlayLine> contour_lines(std::span<const BakedPatch* const> patches,
                                       const std::function<double(Vec3 mm)>& field, double level, double least_up,
                                       const LineStyle& style) {
  Chains chains;
  std::vector<double> value;
  for (const BakedPatch* patch : patches) {
    value.clear();
    for (const PackedVertex& v : patch->vertices)
      value.push_back(field({v.position_mm[0], v.position_mm[1], v.position_mm[2]}) - level);
    for (std::size_t t = 0; t + 2 < patch->indices.size(); t += 3) {
      std::array<Vec3f, 3> at, normal;
      std::size_t n = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint16_t i = patch->indices[t + k], j = patch->indices[t + (k + 1) % 3];
        if ((value[i] < 0) == (value[j] < 0)) continue;
        if (value[i] >= 0) std::swap(i, j);  // from inside to outside, so that both triangles reckon alike
        const PackedVertex &a = patch->vertices[i], &b = patch->vertices[j];
        const auto f = static_cast<float>(value[i] / (value[i] - value[j]));
        for (int c = 0; c < 3; ++c) {
          at[n][c] = a.position_mm[c] + f * (b.position_mm[c] - a.position_mm[c]);
          normal[n][c] = (static_cast<float>(a.normal[c]) + f * static_cast<float>(b.normal[c] - a.normal[c])) / 32767.0f;
        }
        ++n;
      }
      if (n == 2 && static_cast<double>(normal[0].z) > least_up && static_cast<double>(normal[1].z) > least_up)
        chains.join({at[0], normal[0]}, {at[1], normal[1]});
    }
  }
  return chains.lines(style);
}

std::vector<OverlayLine> target_lines(const Volume& uncut, const std::function<double(Vec3 mm)>& sideways_mm,
                                      double leeway_mm) {
  // Steeper than about 78 degrees is a wall, not the face that the outline is drawn on.
  constexpr double kLeastUp = 0.2;
  const IVec3 n = uncut.specimen().brick_count();
  const Grid& grid = uncut.grid();
  const double reach = kBrickEdge * grid.voxel_mm;
  std::vector<BakedPatch> patches;
  for (int b = 0; b < n.x * n.y * n.z; ++b) {
    if (!may_have_surface(uncut, b)) continue;
    // The outline passes only where the field at the brick's middle is near one of the levels.
    const Vec3 middle = grid.centre_mm(uncut.specimen().brick_at(b) * kBrickEdge + kBrickEdge / 2);
    const double d = sideways_mm(middle);
    if (d < -reach || d > leeway_mm + reach) continue;
    const Patch patch = build_patch(uncut, b, kFinePatch);
    if (patch.indices.empty()) continue;
    BakedPatch plain;
    plain.brick = b;
    plain.indices = patch.indices;
    for (const PatchVertex& v : patch.vertices) {
      PackedVertex p{};
      for (int k = 0; k < 3; ++k) {
        p.position_mm[k] = v.position_mm[k];
        p.normal[k] = static_cast<std::int16_t>(v.normal[k] * 32767.0f);
      }
      plain.vertices.push_back(p);
    }
    patches.push_back(std::move(plain));
  }
  std::vector<const BakedPatch*> list;
  for (const BakedPatch& p : patches) list.push_back(&p);
  std::vector<OverlayLine> out = contour_lines(list, sideways_mm, 0.0, kLeastUp, kTargetStyle);
  if (leeway_mm > 0.0) {
    for (OverlayLine& line : contour_lines(list, sideways_mm, leeway_mm, kLeastUp, kLeewayStyle))
      out.push_back(std::move(line));
  }
  return out;
}

}  // namespace cusp::ui
