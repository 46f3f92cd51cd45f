// What is drilled: the specimen and its tissues.

#include "scenarios/format/keys.h"
#include "scenarios/format/read_sections.h"
#include "scenarios/tissues/tissue_facts.h"

namespace cusp::scenarios::format_reader {
namespace {

/// A file name beside scenario.json: no folder, no drive, nothing hidden.
bool is_plain_file_name(std::string_view name) {
  return !name.empty() && name.front() != '.' && name.find_first_of("/\\:") == std::string_view::npos &&
         std::ranges::all_of(name, [](char c) { return static_cast<unsigned char>(c) >= 0x20; });
}

LesionSource read_lesion(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  LesionSource out;
  out.kind = object.need("kind").key(FormatError::unknown_generator, one_of(kLesionKeys));
  out.site = object.need("site").text(1, 64);
  out.radius_mm = object.need("radius_mm").number({0.2, 4});
  out.depth_mm = object.need("depth_mm").number({0, 5});
  out.softness = object.need("softness").number({0, 1});
  object.nothing_else();
  return out;
}

template <class Key, std::size_t n>
auto among(const std::array<std::string_view, n>& keys) {
  return [&keys](std::string_view key) -> std::optional<Key> {
    const auto at = std::ranges::find(keys, key);
    return at == keys.end() ? std::nullopt : std::optional(static_cast<Key>(at - keys.begin()));
  };
}

Landmark read_landmark(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  Landmark out;
  out.kind = object.need("kind").key(FormatError::unknown_landmark, among<MarkKind>(kMarkKeys));
  object.maybe("name", [&](const Value& v) { out.name = v.text(1, 64); });
  out.state = object.need("state").key(FormatError::unknown_landmark, among<MarkState>(kMarkStateKeys));
  const PointCount count = point_count(out.kind);
  object.need("points_mm").list(count.least, count.most, [&](const Value& v) { out.points_mm.push_back(v.point()); });
  const bool open = out.kind == MarkKind::cej && !out.points_mm.empty() && out.points_mm.front() != out.points_mm.back();
  if (open) value.refuse(FormatError::out_of_range, "a closed line");
  object.nothing_else();
  return out;
}

int read_fdi(const Value& value) {
  const int fdi = value.integer({11, 48});
  if (fdi != 0 && !is_fdi(fdi)) value.refuse(FormatError::out_of_range, "FDI");
  return fdi;
}

SpecimenLandmarks read_landmarks(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  SpecimenLandmarks out;
  object.maybe("fdi", [&](const Value& v) { out.fdi = read_fdi(v); });
  object.need("marks").list(0, kMostMarks, [&](const Value& v) {
    Landmark mark = read_landmark(v);
    if (out.find(mark.kind, mark.name) != nullptr) v.refuse(FormatError::duplicate_value, std::string(key_of(mark.kind)) + " " + mark.name);
    out.marks.push_back(std::move(mark));
  });
  object.nothing_else();
  return out;
}

}  // namespace

Tissue read_tissue(const Value& value) {
  const Tissue tissue = value.key(FormatError::unknown_tissue, scenario_tissue_from_key);
  if (tissue == Tissue::empty && value.node().is_string() && value.node() == "empty")
    value.refuse(FormatError::unknown_tissue, "empty");
  return tissue;
}

SpecimenSource read_specimen(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  SpecimenSource out;
  if (object.has("volume")) {
    const Value name = object.need("volume");
    out.volume = name.text(1, 255);
    if (name.node().is_string() && !is_plain_file_name(out.volume)) name.refuse(FormatError::bad_file_name, out.volume);
    object.maybe("landmarks", [&](const Value& v) { out.landmarks = read_landmarks(v); });
  } else {
    out.generator = object.need("generator").key(FormatError::unknown_generator, one_of(kGeneratorKeys));
  }
  if (out.generator == "tooth") {
    out.fdi = read_fdi(object.need("fdi"));
    object.maybe("seed", [&](const Value& v) { out.seed = v.seed(); });
    object.maybe("typodont", [&](const Value& v) { out.typodont = v.yes(); });
    object.maybe("around", [&](const Value& list) {
      list.list(0, kAroundKeys.size(), [&](const Value& v) {
        out.around.push_back(v.key(FormatError::unknown_generator, one_of(kAroundKeys)));
      });
    });
    object.maybe("lesions", [&](const Value& list) {
      list.list(0, 16, [&](const Value& v) { out.lesions.push_back(read_lesion(v)); });
    });
  }
  object.maybe("voxel_mm", [&](const Value& v) { out.voxel_mm = v.number({0.04, 1}); });
  object.nothing_else();
  return out;
}

ScenarioTissue read_scenario_tissue(const Value& value) {
  Object object(value.node(), value.where(), value.problems());
  ScenarioTissue out;
  out.tissue = read_tissue(object.need("tissue"));
  // What is left out is the tissue's usual figure; written back, both stand there.
  const TissueFacts& usual = tissue_facts(out.tissue);
  out.stiffness_n_per_mm = usual.stiffness_n_per_mm.value;
  out.speed_mm_s = usual.speed_mm_s.value;
  object.maybe("stiffness_n_per_mm", [&](const Value& v) { out.stiffness_n_per_mm = v.number({0, 20, true}); });
  object.maybe("speed_mm_s", [&](const Value& v) { out.speed_mm_s = v.number({0, 100}); });
  object.nothing_else();
  return out;
}

}  // namespace cusp::scenarios::format_reader
