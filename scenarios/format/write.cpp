#include "scenarios/format/write.h"

#include <nlohmann/json.hpp>

#include "scenarios/format/json_text.h"
#include "scenarios/format/keys.h"
#include "scenarios/format/migrate.h"
#include "scenarios/format/write_document.h"

namespace cusp::scenarios {
namespace {

template <class Json>
Json json_of(const Vec3& v) {
  return Json::array({v.x, v.y, v.z});
}

template <class Json>
Json json_of(const LocalText& text) {
  Json out = Json::object();
  for (const auto& [language, sentence] : text) out[language] = sentence;
  return out;
}

template <class Json>
Json json_of(const SpecimenLandmarks& landmarks) {
  Json out = Json::object();
  if (landmarks.fdi != 0) out["fdi"] = landmarks.fdi;
  Json marks = Json::array();
  for (const Landmark& mark : landmarks.marks) {
    Json one = Json::object();
    one["kind"] = key_of(mark.kind);
    if (!mark.name.empty()) one["name"] = mark.name;
    one["state"] = key_of(mark.state);
    Json points = Json::array();
    for (const Vec3& p : mark.points_mm) points.push_back(json_of<Json>(p));
    one["points_mm"] = std::move(points);
    marks.push_back(std::move(one));
  }
  out["marks"] = std::move(marks);
  return out;
}

template <class Json>
Json json_of(const SpecimenSource& specimen) {
  Json out = Json::object();
  if (specimen.generator.empty()) {
    out["volume"] = specimen.volume;
    if (!specimen.landmarks.empty()) out["landmarks"] = json_of<Json>(specimen.landmarks);
  } else {
    out["generator"] = specimen.generator;
  }
  if (specimen.generator == "tooth") {
    out["fdi"] = specimen.fdi;
    out["seed"] = specimen.seed;
    // Left out at their defaults: exercises published without these keys keep their hash.
    if (specimen.typodont) out["typodont"] = true;
    if (!specimen.around.empty()) out["around"] = specimen.around;
    for (const LesionSource& lesion : specimen.lesions) {
      Json one = Json::object();
      one["kind"] = lesion.kind;
      one["site"] = lesion.site;
      one["radius_mm"] = lesion.radius_mm;
      one["depth_mm"] = lesion.depth_mm;
      one["softness"] = lesion.softness;
      out["lesions"].push_back(std::move(one));
    }
  }
  out["voxel_mm"] = specimen.voxel_mm;
  return out;
}

template <class Json>
Json json_of(const TemplateUse& use) {
  Json values = Json::array();
  for (const auto& [parameter, value] : use.values) {
    Json one = Json::object();
    one["parameter"] = parameter;
    one["value"] = value;
    values.push_back(std::move(one));
  }
  Json out = Json::object();
  out["key"] = use.key;
  out["values"] = std::move(values);
  return out;
}

template <class Json>
Json json_of(const Bur& bur) {
  Json out = Json::object();
  out["name"] = bur.name;
  out["radius_mm"] = bur.radius_mm;
  out["neck_radius_mm"] = bur.neck_radius_mm;
  out["neck_length_mm"] = bur.neck_length_mm;
  out["shank_radius_mm"] = bur.shank_radius_mm;
  out["shank_length_mm"] = bur.shank_length_mm;
  // Written out, wherever it came from: what was published stays as it was, whatever becomes of the catalogue.
  if (!bur.head.ball()) {
    Json head = Json::array();
    for (int i = 0; i < bur.head.size(); ++i) {
      const OutlinePiece& p = bur.head.piece(i);
      Json piece = Json::array({p.from.t, p.from.rho, p.to.t, p.to.rho});
      if (p.radius > 0.0)
        for (const double figure : {p.centre.t, p.centre.rho, p.radius}) piece.push_back(figure);
      head.push_back(std::move(piece));
    }
    out["head"] = std::move(head);
  }
  return out;
}

template <class Json>
void put_outline(const Outline& outline, Json& out) {
  out["shape"] = outline.shape;
  Json paths = Json::array();
  for (const std::vector<Vec3>& path : outline.paths) {
    Json points = Json::array();
    for (const Vec3& point : path) points.push_back(json_of<Json>(point));
    paths.push_back(std::move(points));
  }
  out["paths"] = std::move(paths);
  out["width_mm"] = outline.width_mm;
  out["depth_mm"] = outline.depth_mm;
  out["top_mm"] = outline.top_mm;
  out["corner_radius_mm"] = outline.corner_radius_mm;
  out["box_size_mm"] = json_of<Json>(outline.box_size_mm);
  // Left out at their defaults, as all that format 1 has no word for: see in_format_1.
  for (std::size_t side = 0; side < kTaperKeys.size(); ++side)
    if (outline.taper_deg[side] != 0.0) out["taper_deg"][kTaperKeys[side]] = outline.taper_deg[side];
}

template <class Json>
void put_leaf(const Region& region, Json& out) {
  const RegionKind k = region.kind;
  const bool ends = k == RegionKind::cylinder || k == RegionKind::cone || k == RegionKind::capsule;
  const Region plain;
  if (k == RegionKind::tissue) {
    out["tissue"] = key_of_scenario_tissue(region.tissue);
    return;
  }
  if (k == RegionKind::lesion) {
    out["down_to"] = kHardnessKeys[static_cast<std::size_t>(region.down_to)];
    return;
  }
  out["from_mm"] = json_of<Json>(region.from_mm);
  if (ends) out["to_mm"] = json_of<Json>(region.to_mm);
  if (ends || k == RegionKind::sphere) out["radius_mm"] = region.radius_mm;
  if (k == RegionKind::cone) out["end_radius_mm"] = region.end_radius_mm;
  if (k == RegionKind::box || k == RegionKind::ellipsoid) out["size_mm"] = json_of<Json>(region.size_mm);
  if (k == RegionKind::box && region.x_axis != plain.x_axis) out["x_axis"] = json_of<Json>(region.x_axis);
  if (k == RegionKind::half_space || (k == RegionKind::box && region.z_axis != plain.z_axis))
    out["z_axis"] = json_of<Json>(region.z_axis);
}

template <class Json>
Json json_of(const Region& region) {
  Json out = Json::object();
  out["kind"] = key_of(region.kind);
  if (region.kind == RegionKind::outline) {
    put_outline(region.outline, out);
  } else if (!is_node(region.kind)) {
    put_leaf(region, out);
  } else {
    if (region.kind == RegionKind::offset) out["by_mm"] = region.by_mm;
    else if (region.rounding_mm != 0.0) out["rounding_mm"] = region.rounding_mm;
    Json parts = Json::array();
    for (const Region& part : region.parts) parts.push_back(json_of<Json>(part));
    out["parts"] = std::move(parts);
  }
  for (const auto& [slot, face] : region.faces) out["faces"][slot] = key_of(face);
  if (!region.name.empty()) out["name"] = region.name;
  if (!region.title.empty()) out["title"] = json_of<Json>(region.title);
  return out;
}

template <class Json>
Json json_of(const Leeway& leeway) {
  Json out = Json::object();
  out["floor_mm"] = leeway.floor_mm;
  out["side_mm"] = leeway.side_mm;
  for (const auto& [face, mm] : leeway.faces) out["faces"][std::string(key_of(face))] = mm;
  return out;
}

template <class Json>
Json json_of(const Protected& one) {
  Json out = Json::object();
  if (one.tissue) out["tissue"] = key_of_scenario_tissue(*one.tissue);
  if (one.region) out["region"] = json_of<Json>(*one.region);
  if (one.severity != Damage::removal) out["severity"] = kDamageKeys[static_cast<std::size_t>(one.severity)];
  if (one.severity == Damage::depth) out["depth_mm"] = one.depth_mm;
  return out;
}

template <class Json>
Json json_of(const Rubric& rubric) {
  Json criteria = Json::array();
  for (const Criterion& criterion : rubric.criteria) {
    Json bands = Json::object();
    bands["fail_lo"] = criterion.bands.fail_lo;
    bands["acc_lo"] = criterion.bands.acc_lo;
    bands["ideal_lo"] = criterion.bands.ideal_lo;
    bands["ideal_hi"] = criterion.bands.ideal_hi;
    bands["acc_hi"] = criterion.bands.acc_hi;
    bands["fail_hi"] = criterion.bands.fail_hi;
    Json one = Json::object();
    one["metric"] = criterion.metric;
    one["weight"] = criterion.weight;
    one["bands"] = std::move(bands);
    if (criterion.needs_dof != 3) one["needs_dof"] = criterion.needs_dof;
    criteria.push_back(std::move(one));
  }
  Json out = Json::object();
  out["pass"] = rubric.pass;
  out["criteria"] = std::move(criteria);
  out["critical"] = rubric.critical;
  return out;
}

template <class Json>
Json json_of(const Scenario& scenario) {
  Json out = Json::object();
  out["format"] = scenario.format;
  out["id"] = scenario.id.text();
  out["version"] = scenario.version;
  if (!scenario.key.empty()) out["key"] = scenario.key;
  out["title"] = json_of<Json>(scenario.title);
  out["briefing"] = json_of<Json>(scenario.briefing);
  if (scenario.level) out["level"] = kLevelKeys[static_cast<std::size_t>(*scenario.level)];
  if (scenario.expected_time_s != 0.0) out["expected_time_s"] = scenario.expected_time_s;
  if (scenario.self_assessment) out["self_assessment"] = true;
  if (scenario.made_with) out["template"] = json_of<Json>(*scenario.made_with);
  out["specimen"] = json_of<Json>(scenario.specimen);
  Json tissues = Json::array();
  for (const ScenarioTissue& tissue : scenario.tissues) {
    Json one = Json::object();
    one["tissue"] = key_of_scenario_tissue(tissue.tissue);
    one["stiffness_n_per_mm"] = tissue.stiffness_n_per_mm;
    one["speed_mm_s"] = tissue.speed_mm_s;
    tissues.push_back(std::move(one));
  }
  out["tissues"] = std::move(tissues);
  Json instruments = Json::array();
  for (const Bur& bur : scenario.instruments) instruments.push_back(json_of<Json>(bur));
  out["instruments"] = std::move(instruments);
  Json device = Json::object();
  device["needs_dof"] = scenario.device.needs_dof;
  device["admitted"] = scenario.device.admitted;
  device["full_force_n"] = scenario.device.full_force_n;
  device["tool_tilt_deg"] = scenario.tool_tilt_deg;
  if (scenario.tool_turn_deg > 0) device["tool_turn_deg"] = scenario.tool_turn_deg;
  out["device"] = std::move(device);
  out["method"] = key_of(scenario.method);
  out["phenomena"] = scenario.phenomena;
  out["target"] = json_of<Json>(scenario.target);
  out["leeway"] = json_of<Json>(scenario.leeway);
  Json guarded = Json::array();
  for (const Protected& one : scenario.protected_parts) guarded.push_back(json_of<Json>(one));
  out["protected"] = std::move(guarded);
  Json limits = Json::object();
  limits["time_s"] = scenario.time_limit_s;
  out["limits"] = std::move(limits);
  out["rubric"] = json_of<Json>(scenario.rubric);
  Json tolerance = Json::object();
  tolerance["points"] = scenario.tolerance_points;
  out["tolerance"] = std::move(tolerance);
  return out;
}

}  // namespace

nlohmann::json document_of(const Scenario& scenario) { return json_of<nlohmann::json>(scenario); }

std::string write_scenario(const Scenario& scenario) {
  std::string out;
  json_text::append(out, json_of<nlohmann::ordered_json>(scenario), 0);
  out += '\n';
  return out;
}

std::string canonical_json(const Scenario& scenario) {
  std::string out;
  json_text::append(out, document_of(scenario), -1);
  return out;
}

std::string hashed_json(const Scenario& scenario) {
  const nlohmann::json document = document_of(scenario);
  std::string out;
  json_text::append(out, in_format_1(document).value_or(document), -1);
  return out;
}

Result<std::string, FormatFailure> canonical_json(std::string_view text) {
  const auto document = json_text::parse(text);
  if (!document) return std::unexpected(document.error());
  std::string out;
  json_text::append(out, *document, -1);
  return out;
}

}  // namespace cusp::scenarios
