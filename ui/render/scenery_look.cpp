#include "ui/render/scenery_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <mutex>

#include "scenarios/specimens/specimens.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

constexpr float kPieceMm = 4.0f;  // on a side: a side of a crown, so that the far one can be skipped

constexpr float kRimEnamelMm = 0.35f, kMostEnamelMm = 1.9f;  // where enamel ends, and over the cusps

/// Depth of the enamel at each point, for a surface that knows nothing of what lies under it: it grows with the way to
/// where enamel ends.
std::vector<float> enamel_depths(const SceneryMesh& mesh) {
  constexpr int kMostRounds = 40;
  constexpr float kGrowth = 0.32f;
  std::vector<float> out(mesh.points_mm.size(), kMostEnamelMm);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (!is_enamel(mesh.tissue[i])) out[i] = kRimEnamelMm;
  bool changed = true;
  for (int round = 0; changed && round < kMostRounds; ++round) {
    changed = false;
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t i = mesh.triangles[t + k], j = mesh.triangles[t + (k + 1) % 3];
        const float most = kGrowth * glm::distance(mesh.points_mm[i], mesh.points_mm[j]);
        for (const auto& [from, to] : {std::pair{i, j}, {j, i}})
          if (out[to] > out[from] + most) out[to] = out[from] + most, changed = true;
      }
  }
  return out;
}

/// What the points look like.
std::vector<PackedVertex> packed(const SceneryMesh& mesh) {
  const std::vector<float> depth = enamel_depths(mesh);
  std::vector<PackedVertex> out(mesh.points_mm.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Vec3f at = mesh.points_mm[i];
    const bool enamel = is_enamel(mesh.tissue[i]);
    const float thin = 0.45f * glm::smoothstep(0.9f, kMostEnamelMm, depth[i]) * static_cast<float>(mesh.ambient[i]) / 255.0f;
    const float mottled = depth[i] * (1.0f + 0.16f * noise(at, 1.7f));
    put_look({.position_mm = at,
              .normal = mesh.normals[i],
              .colour = enamel ? ridge_colour(enamel_colour(mottled), thin) : body_colour(mesh.tissue[i], at),
              .enamel = enamel ? 1.0f : 0.0f,
              .thin = enamel ? thin : 0.0f},
             out[i]);
    out[i].tissue = static_cast<std::uint8_t>(mesh.tissue[i]);
    out[i].ambient = mesh.ambient[i];
  }
  return out;
}

/// One patch of a mesh, numbered anew.
BakedPatch patch_of(const SceneryMesh& mesh, const std::vector<PackedVertex>& packed, const std::vector<std::size_t>& triangles,
                    int number) {
  BakedPatch out;
  out.brick = number;
  std::map<std::uint32_t, std::uint16_t> place;
  Vec3f sum(0.0f);
  for (const std::size_t t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t i = mesh.triangles[t + k];
      const auto [it, fresh] = place.try_emplace(i, static_cast<std::uint16_t>(out.vertices.size()));
      if (fresh) {
        if (out.vertices.empty()) out.low_mm = out.high_mm = mesh.points_mm[i];
        out.low_mm = glm::min(out.low_mm, mesh.points_mm[i]);
        out.high_mm = glm::max(out.high_mm, mesh.points_mm[i]);
        sum += mesh.normals[i];
        out.vertices.push_back(packed[i]);
      }
      out.indices.push_back(it->second);
    }
  }
  const float length = glm::length(sum);
  if (length > 1e-6f) {
    out.cone_axis = sum / length;
    out.cone_cos = 1.0f;
    for (const auto& [i, at] : place) out.cone_cos = std::min(out.cone_cos, glm::dot(out.cone_axis, mesh.normals[i]));
  }
  return out;
}

/// By place, and by the way that they face: a patch that faces away as a whole is skipped.
using Key = std::array<int, 4>;
Key key_of(const SceneryMesh& mesh, std::size_t triangle) {
  Vec3f middle(0.0f), normal(0.0f);
  for (std::size_t k = 0; k < 3; ++k) {
    middle += mesh.points_mm[mesh.triangles[triangle + k]] / 3.0f;
    normal += mesh.normals[mesh.triangles[triangle + k]];
  }
  int way = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(normal[axis]) > std::abs(normal[way])) way = axis;
  const auto cell = [&](int axis) { return static_cast<int>(std::floor(middle[axis] / kPieceMm)); };
  return {cell(0), cell(1), cell(2), 2 * way + (normal[way] < 0 ? 1 : 0)};
}

}  // namespace

SceneryLook::SceneryLook(std::vector<SceneryMesh> meshes) : meshes_(std::move(meshes)) {
  bool first = true;
  for (const SceneryMesh& mesh : meshes_) {
    Box box{Vec3(0.0), Vec3(0.0)};
    if (!mesh.points_mm.empty()) box = {Vec3(mesh.points_mm.front()), Vec3(mesh.points_mm.front())};
    for (const glm::vec3& p : mesh.points_mm) box = {glm::min(box.low, Vec3(p)), glm::max(box.high, Vec3(p))};
    bounds_ = first ? box : Box{glm::min(bounds_.low, box.low), glm::max(bounds_.high, box.high)};
    first = false;
    boxes_.push_back(box);
    const std::vector<PackedVertex> points = packed(mesh);
    std::map<Key, std::vector<std::size_t>> groups;
    for (std::size_t t = 0; t + 2 < mesh.seen; t += 3) groups[key_of(mesh, t)].push_back(t);
    for (const auto& [key, triangles] : groups) patches_.push_back(patch_of(mesh, points, triangles, static_cast<int>(patches_.size())));
  }
}

std::size_t SceneryLook::bytes() const noexcept {
  std::size_t out = 0;
  for (const SceneryMesh& mesh : meshes_) out += mesh.bytes();
  for (const BakedPatch& patch : patches_) out += patch.bytes();
  return out;
}

std::shared_ptr<const SceneryLook> scenery_of(const SpecimenSource& source, ToothCancel cancel, const GrowScenery& grow) {
  static std::mutex mutex;  // held while growing: a second asker of the same waits for it
  static SpecimenSource last;
  static std::shared_ptr<const SceneryLook> kept;
  if (std::ranges::find(source.around, "jaw") == source.around.end()) return nullptr;
  const std::lock_guard lock(mutex);
  if (kept && last == source) return kept;
  auto standing = grow ? grow() : make_scenery(source, cancel);
  if (!standing || standing->empty()) return nullptr;
  std::vector<SceneryMesh> meshes;
  for (JawSurface& one : *standing) meshes.push_back(std::move(one.mesh));
  kept = std::make_shared<const SceneryLook>(std::move(meshes));
  last = source;
  return kept;
}

}  // namespace cusp::ui
