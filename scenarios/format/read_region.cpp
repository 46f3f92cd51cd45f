// Regions: the target, and what an attempt is to spare.

#include <algorithm>

#include "scenarios/format/keys.h"
#include "scenarios/format/read_sections.h"

namespace cusp::scenarios::format_reader {
namespace {

constexpr Range kLength{0, 1000};

Outline read_outline(Object& object) {
  Outline out;
  out.shape = object.need("shape").key(FormatError::unknown_shape, one_of(kShapeKeys));
  object.need("paths").list(1, 64, [&](const Value& path) {
    auto& points = out.paths.emplace_back();
    path.list(1, 1000, [&](const Value& point) { points.push_back(point.point()); });
  });
  out.width_mm = object.need("width_mm").number({0, 100, true});
  out.depth_mm = object.need("depth_mm").number({0, 100, true});
  out.top_mm = object.need("top_mm").number(kCoordinate);
  out.corner_radius_mm = object.need("corner_radius_mm").number({0, 10});
  object.maybe("box_size_mm", [&](const Value& v) { out.box_size_mm = v.point(); });
  object.maybe("taper_deg", [&](const Value& v) {
    Object taper(v.node(), v.where(), v.problems());
    for (std::size_t side = 0; side < kTaperKeys.size(); ++side)
      taper.maybe(kTaperKeys[side], [&](const Value& deg) { out.taper_deg[side] = deg.number({-45, 45}); });
    taper.nothing_else();
  });
  return out;
}

std::optional<RegionKind> kind_from_key(std::string_view key) {
  for (std::size_t i = 0; i < kRegionKeys.size(); ++i)
    if (kRegionKeys[i] == key) return static_cast<RegionKind>(i);
  return std::nullopt;
}

void read_faces(Object& object, Region& out) {
  object.maybe("faces", [&](const Value& v) {
    Object faces(v.node(), v.where(), v.problems());
    const auto slots = face_slots(out.kind);
    for (std::size_t slot = 0; slot < slots.size(); ++slot)
      faces.maybe(slots[slot].data(), [&](const Value& name) {
        const FaceName face = read_face(name);
        if (face != default_face(out.kind, slot)) out.faces[std::string(slots[slot])] = face;
      });
    faces.nothing_else();
  });
}

void read_leaf(Object& object, Region& out) {
  const RegionKind k = out.kind;
  const bool ends = k == RegionKind::cylinder || k == RegionKind::cone || k == RegionKind::capsule;
  if (k == RegionKind::outline) {
    out.outline = read_outline(object);
    return;
  }
  if (k == RegionKind::tissue) {
    out.tissue = read_tissue(object.need("tissue"));
    return;
  }
  if (k == RegionKind::lesion) {
    out.down_to = object.need("down_to").key(FormatError::unknown_hardness, [](std::string_view key) -> std::optional<Hardness> {
      for (std::size_t i = 0; i < kHardnessKeys.size(); ++i)
        if (kHardnessKeys[i] == key) return static_cast<Hardness>(i);
      return std::nullopt;
    });
    return;
  }
  out.from_mm = object.need("from_mm").point();
  if (ends) out.to_mm = object.need("to_mm").point();
  if (ends || k == RegionKind::sphere) out.radius_mm = object.need("radius_mm").number(kLength);
  if (k == RegionKind::cone) out.end_radius_mm = object.need("end_radius_mm").number(kLength);
  if (k == RegionKind::box || k == RegionKind::ellipsoid) out.size_mm = object.need("size_mm").point();
  if (k == RegionKind::box) object.maybe("x_axis", [&](const Value& v) { out.x_axis = v.point(); });
  if (k == RegionKind::box) object.maybe("z_axis", [&](const Value& v) { out.z_axis = v.point(); });
  if (k == RegionKind::half_space) out.z_axis = object.need("z_axis").point();
}

void read_name(Object& object, Region& out) {
  object.maybe("name", [&](const Value& v) {
    out.name = v.text(1, 32);
    if (!is_target_name(out.name)) v.refuse(FormatError::bad_target_name, out.name);
  });
  if (!out.name.empty()) object.maybe("title", [&](const Value& v) { out.title = v.texts(); });
}

/// `left`: how many leaves and nodes the tree may still have. `naming`: what may have a name, the region's parts or nothing.
enum class Naming : std::uint8_t { parts, own, none };
Region read_part(const Value& value, Naming naming, int& left) {
  Region out;
  Object object(value.node(), value.where(), value.problems());
  if (--left < 0) {
    value.refuse(FormatError::out_of_range, Range{1, kMostRegionParts}.text());
    return out;
  }
  out.kind = object.need("kind").key(FormatError::unknown_shape, kind_from_key);
  if (is_node(out.kind)) {
    const std::size_t least = out.kind == RegionKind::offset ? 1 : 2, most = out.kind == RegionKind::offset ? 1 : 32;
    const Naming of_parts = naming == Naming::parts && out.kind == RegionKind::joined ? Naming::own : Naming::none;
    object.need("parts").list(least, most, [&](const Value& part) {
      if (left < 0) return;
      out.parts.push_back(read_part(part, of_parts, left));
      const std::string& name = out.parts.back().name;
      const auto named_so = [&name](const Region& one) { return one.name == name; };
      if (!name.empty() && std::ranges::count_if(out.parts, named_so) > 1) part.refuse(FormatError::duplicate_value, name);
    });
    if (out.kind == RegionKind::offset) out.by_mm = object.need("by_mm").number({-10, 10});
    else object.maybe("rounding_mm", [&](const Value& v) { out.rounding_mm = v.number({0, 10}); });
  } else {
    read_leaf(object, out);
    read_faces(object, out);
  }
  if (naming == Naming::own) read_name(object, out);
  object.nothing_else();
  return out;
}

}  // namespace

FaceName read_face(const Value& value) {
  return value.key(FormatError::unknown_face, [](std::string_view key) -> std::optional<FaceName> {
    for (std::size_t i = 0; i < kFaceKeys.size(); ++i)
      if (kFaceKeys[i] == key) return static_cast<FaceName>(i);
    return std::nullopt;
  });
}

Region read_region(const Value& value, RegionUse use) {
  int left = kMostRegionParts;
  return read_part(value, use == RegionUse::target ? Naming::parts : Naming::none, left);
}

Leeway read_leeway(const Value& value) {
  Leeway out;
  Object leeway(value.node(), value.where(), value.problems());
  out.floor_mm = leeway.need("floor_mm").number({0, 10});
  out.side_mm = leeway.need("side_mm").number({0, 10});
  leeway.maybe("faces", [&](const Value& v) {
    Object faces(v.node(), v.where(), v.problems());
    for (std::size_t i = 0; i < kFaceKeys.size(); ++i)
      faces.maybe(kFaceKeys[i].data(), [&](const Value& mm) { out.faces[static_cast<FaceName>(i)] = mm.number({0, 10}); });
    faces.nothing_else();
  });
  leeway.nothing_else();
  return out;
}

Protected read_protected(const Value& value) {
  Object one(value.node(), value.where(), value.problems());
  Protected out(Tissue::empty);
  if (one.has("region")) {
    out.tissue.reset();
    out.region = read_region(one.need("region"), RegionUse::spared);
  } else {
    out.tissue = read_tissue(one.need("tissue"));
  }
  one.maybe("severity", [&](const Value& v) {
    out.severity = v.key(FormatError::unknown_severity, [](std::string_view key) -> std::optional<Damage> {
      for (std::size_t i = 0; i < kDamageKeys.size(); ++i)
        if (kDamageKeys[i] == key) return static_cast<Damage>(i);
      return std::nullopt;
    });
  });
  if (out.severity == Damage::depth && !out.region) one.need("region");  // of a tissue nobody knows how deep
  if (out.severity == Damage::depth) out.depth_mm = one.need("depth_mm").number({0, 100});
  one.nothing_else();
  return out;
}

}  // namespace cusp::scenarios::format_reader
