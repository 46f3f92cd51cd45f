#include "ui/editor/region_parts.h"

#include <algorithm>
#include <ranges>
#include <utility>

namespace cusp::ui {
namespace {

void collect(const Region& region, PartPath& at, std::vector<PartPath>& out) {
  out.push_back(at);
  for (std::size_t i = 0; i < region.parts.size(); ++i) {
    at.push_back(i);
    collect(region.parts[i], at, out);
    at.pop_back();
  }
}

bool joins(const Region& region) { return is_node(region.kind) && region.kind != RegionKind::offset; }

}  // namespace

const Region* part_at(const Region& root, const PartPath& path) {
  const Region* at = &root;
  for (const std::size_t i : path) {
    if (i >= at->parts.size()) return nullptr;
    at = &at->parts[i];
  }
  return at;
}

Region* part_at(Region& root, const PartPath& path) { return const_cast<Region*>(part_at(std::as_const(root), path)); }

std::vector<PartPath> parts_of(const Region& root) {
  std::vector<PartPath> out;
  PartPath at;
  collect(root, at, out);
  return out;
}

PartPath first_outline(const Region& root) {
  for (PartPath& path : parts_of(root))
    if (part_at(root, path)->kind == RegionKind::outline) return std::move(path);
  return {};
}

PartPath clamped(const Region& root, PartPath path) {
  while (!path.empty() && part_at(root, path) == nullptr) path.pop_back();
  return path;
}

Region new_part(RegionKind kind, Vec3 middle_mm) {
  constexpr double kHalfMm = 1.0;
  Region out;
  out.kind = kind;
  out.from_mm = middle_mm;
  if (kind == RegionKind::outline) {
    out.outline.shape = "box";
    out.outline.paths = {{middle_mm - Vec3(0, 0, kHalfMm)}};
    out.outline.box_size_mm = {2 * kHalfMm, 2 * kHalfMm, 0};
    out.outline.depth_mm = 2 * kHalfMm;
    out.outline.top_mm = middle_mm.z + kHalfMm;
    out.outline.corner_radius_mm = 0.3;
  }
  if (kind == RegionKind::box || kind == RegionKind::ellipsoid) out.size_mm = Vec3(2 * kHalfMm);
  if (kind == RegionKind::sphere || has_ends(kind)) out.radius_mm = kHalfMm;
  if (kind == RegionKind::cone) out.end_radius_mm = 0.5 * kHalfMm;
  if (has_ends(kind)) out.to_mm = middle_mm + Vec3(0, 0, 2 * kHalfMm);
  return out;
}

Region with_part(const Region& root, PartPath& path, const Region& added) {
  Region out = root;
  PartPath node = path;
  while (!node.empty() && !joins(*part_at(out, node))) node.pop_back();
  Region& parent = *part_at(out, node);
  if (joins(parent)) {
    parent.parts.push_back(added);
    path = node;
    path.push_back(parent.parts.size() - 1);
    return out;
  }
  Region both;
  both.kind = RegionKind::joined;
  both.parts = {std::move(out), added};
  path = {1};
  return both;
}

std::optional<Region> without_part(const Region& root, PartPath& path) {
  if (path.empty()) return std::nullopt;
  Region out = root;
  const std::size_t index = path.back();
  path.pop_back();
  Region* parent = part_at(out, path);
  parent->parts.erase(parent->parts.begin() + static_cast<std::ptrdiff_t>(index));
  // An offset of nothing goes with its part.
  if (parent->parts.empty()) return without_part(out, path);
  if (parent->parts.size() == 1 && joins(*parent)) {
    Region last = std::move(parent->parts.front());
    *parent = std::move(last);
  }
  return out;
}

}  // namespace cusp::ui
