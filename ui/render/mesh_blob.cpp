#include "ui/render/mesh_blob.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>

namespace cusp::ui {
namespace {

// Numbers as this machine has them: the bytes stay on it, for the build that wrote them.
static_assert(std::endian::native == std::endian::little);

/// What a patch is but for its arrays.
struct PatchHead {
  std::int32_t brick, level;
  Vec3f low_mm, high_mm, cone_axis;
  float cone_cos;
  std::uint32_t vertices, indices;
};
static_assert(sizeof(PatchHead) == 56);

template <class T>
void put_bytes(std::vector<std::byte>& out, std::span<const T> values) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto bytes = std::as_bytes(values);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// False when less is left.
template <class T>
bool take_bytes(std::span<const std::byte>& left, std::span<T> values) {
  if (left.size() < values.size_bytes()) return false;
  if (!values.empty()) std::memcpy(values.data(), left.data(), values.size_bytes());
  left = left.subspan(values.size_bytes());
  return true;
}

std::optional<BakedPatch> take_patch(std::span<const std::byte>& left, std::size_t bricks) {
  PatchHead head;
  if (!take_bytes(left, std::span(&head, 1))) return std::nullopt;
  if (head.brick < 0 || static_cast<std::size_t>(head.brick) >= bricks) return std::nullopt;
  const std::size_t bytes = head.vertices * sizeof(PackedVertex) + head.indices * sizeof(std::uint16_t);
  if (bytes > left.size() || head.indices % 3 != 0) return std::nullopt;
  BakedPatch out;
  out.brick = head.brick;
  out.level = head.level;
  out.low_mm = head.low_mm;
  out.high_mm = head.high_mm;
  out.cone_axis = head.cone_axis;
  out.cone_cos = head.cone_cos;
  out.vertices.resize(head.vertices);
  out.indices.resize(head.indices);
  if (!take_bytes(left, std::span(out.vertices)) || !take_bytes(left, std::span(out.indices))) return std::nullopt;
  if (!std::ranges::all_of(out.indices, [&out](std::uint16_t at) { return at < out.vertices.size(); })) return std::nullopt;
  return out;
}

}  // namespace

std::vector<std::byte> mesh_bytes(const WholeMesh& mesh) {
  std::vector<std::byte> out;
  put_bytes<std::uint8_t>(out, mesh.level);
  for (const BakedPatch& p : mesh.patches) {
    const PatchHead head{p.brick, p.level, p.low_mm, p.high_mm, p.cone_axis, p.cone_cos, static_cast<std::uint32_t>(p.vertices.size()),
                         static_cast<std::uint32_t>(p.indices.size())};
    put_bytes<PatchHead>(out, {&head, 1});
    put_bytes<PackedVertex>(out, p.vertices);
    put_bytes<std::uint16_t>(out, p.indices);
  }
  return out;
}

std::optional<WholeMesh> mesh_from_bytes(std::span<const std::byte> bytes, std::size_t bricks) {
  WholeMesh out;
  if (bytes.size() < bricks) return std::nullopt;
  out.level.resize(bricks);
  take_bytes(bytes, std::span(out.level));
  while (!bytes.empty()) {
    auto patch = take_patch(bytes, bricks);
    if (!patch) return std::nullopt;
    out.patches.push_back(std::move(*patch));
  }
  return out;
}

}  // namespace cusp::ui
