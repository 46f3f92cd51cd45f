#include "scenarios/templates/fill.h"

#include <charconv>
#include <cmath>
#include <set>

#include "scenarios/format/keys.h"
#include "scenarios/format/validate.h"
#include "scenarios/shapes/outline_size.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/templates/outline_paths.h"
#include "scenarios/templates/scope.h"
#include "scenarios/templates/templates.h"

namespace cusp::scenarios {

namespace {

using Json = nlohmann::ordered_json;

/// Hundredths of a millimetre: what a bur can keep, and a file can be read in.
double rounded(double value) noexcept { return std::floor(100.0 * value + 0.5) / 100.0; }

/// Adds floor and wall of each outline along lines within `region`.
void add_outlines(const Json& region, Scope& scope) {
  if (!region.is_object()) return;
  if (region.value("shape", "") == "outline" && region.contains("paths")) {
    Outline outline;
    outline.shape = "outline";
    outline.width_mm = region.at("width_mm").get<double>();
    outline.depth_mm = region.at("depth_mm").get<double>();
    for (const Json& path : region.at("paths")) {
      auto& line = outline.paths.emplace_back();
      for (const Json& p : path) line.emplace_back(p.at(0).get<double>(), p.at(1).get<double>(), 0.0);
    }
    const OutlineSize size = size_of(outline);
    scope["outline.floor"] += size.floor_mm2;
    scope["outline.wall"] += size.wall_mm2;
  }
  for (const Json& part : region.value("parts", Json::array())) add_outlines(part, scope);
}

/// A target with a name that follows a groove which the tooth has not.
bool is_missing(const Json& region) { return region.is_object() && region.contains("name") && region.contains("paths") && region.at("paths").empty(); }

class Filler {
 public:
  Filler(const ToothLandmarks& landmarks, Scope scope) : landmarks_(landmarks), scope_(std::move(scope)) {}

  /// The template's target on the tooth. Adds to the scope has.NAME for each part that has a name: whether the tooth has it; and
  /// outline.floor and outline.wall (mm²) of all outlines along lines.
  Json target(const Json& node);

  /// Adds the names of a template to the scope, each by those before it.
  void add_names(const Json& names) {
    for (const auto& [name, value] : names.items())
      for (const Json& one : value.is_array() ? value : Json::array({{{"value", value}}}))
        if (wanted(one, "/names/" + name)) scope_[name] = number(one.at("value"), "/names/" + name);
  }
  /// Key of the first of a template's needs that its values do not keep.
  std::optional<std::string> unmet(const Json& needs) {
    for (const auto& [key, need] : needs.items())
      if (number(need.at("value"), "/needs/" + key) == 0.0 && !failure_) return key;
    return std::nullopt;
  }
  /// Strings at `keys_kept` stay; every other one is an expression.
  Json filled(const Json& node, const std::string& where);
  bool wanted(const Json& node, const std::string& where) {
    return !node.is_object() || !node.contains("when") || number(node.at("when"), where + "/when") != 0.0;
  }
  const std::optional<FitFailure>& failure() const noexcept { return failure_; }

 private:
  double number(const Json& node, const std::string& where) {
    if (node.is_number()) return node.get<double>();
    const auto value = evaluate(node.get<std::string>(), scope_);
    if (value) return *value;
    const Failure<ExpressionError>& why = value.error();
    if (why.code == ExpressionError::unknown_name && is_of_tooth(why.where)) refuse({FitError::missing_landmark, why.where, {}});
    else refuse({FitError::bad_template, where, why.where});
    return 0.0;
  }
  Json paths(const Json& node, double floor, const std::string& where);
  Json object(const Json& node, const std::string& where);
  void refuse(FitFailure failure) {
    if (!failure_) failure_ = std::move(failure);
  }

  const ToothLandmarks& landmarks_;
  Scope scope_;
  std::optional<FitFailure> failure_;
};

Json Filler::paths(const Json& node, double floor, const std::string& where) {
  Json out = Json::array();
  for (std::size_t i = 0; i < node.size(); ++i) {
    const Json& item = node.at(i);
    const std::string at = where + "/" + std::to_string(i);
    if (!wanted(item, at)) continue;
    std::vector<std::vector<Vec3>> lines;
    if (item.contains("fissures")) {
      FissurePaths asked;
      for (const Json& name : item.at("fissures")) asked.names.push_back(name.get<std::string>());
      if (item.contains("most_x")) asked.most_x = number(item.at("most_x"), at + "/most_x");
      if (item.contains("least_x")) asked.least_x = number(item.at("least_x"), at + "/least_x");
      if (item.contains("longest_mm")) asked.longest_mm = number(item.at("longest_mm"), at + "/longest_mm");
      lines = fissure_paths(landmarks_, asked);
      if (lines.empty() && item.value("needed", false)) {
        const bool there = !fissure_paths(landmarks_, {.names = asked.names}).empty();
        refuse({FitError::missing_landmark, asked.names.front(), there ? "no_room" : ""});
      }
    } else {
      auto& line = lines.emplace_back();
      for (const Json& point : item.at("points")) line.emplace_back(number(point.at(0), at), number(point.at(1), at), 0.0);
    }
    for (const auto& line : lines) {
      Json points = Json::array();
      for (const Vec3& p : line) points.push_back({rounded(p.x), rounded(p.y), floor});
      out.push_back(std::move(points));
    }
  }
  return out;
}

Json Filler::object(const Json& node, const std::string& where) {
  static const std::set<std::string, std::less<>> kWords = {"kind", "shape", "metric", "tissue", "faces", "severity", "site", "down_to",
                                                              "name", "title"};
  Json out = Json::object();
  for (const auto& [key, value] : node.items()) {
    if (key == "when" || key == "paths") continue;
    out[key] = kWords.contains(key) ? value : filled(value, where + "/" + key);
  }
  if (node.contains("paths")) {
    const double floor = rounded(out.value("top_mm", 0.0) - out.value("depth_mm", 0.0));
    out["paths"] = paths(node.at("paths"), floor, where + "/paths");
  }
  if (!out.contains("parts") || out["parts"].size() != 1 || out.value("kind", "") == "offset") return out;
  Json alone = out["parts"][0];
  for (const char* key : {"name", "title"}) alone.erase(key);
  return alone;
}

Json Filler::filled(const Json& node, const std::string& where) {
  if (node.is_object()) return object(node, where);
  if (node.is_string()) return rounded(number(node, where));
  if (!node.is_array()) return node;
  Json out = Json::array();
  for (std::size_t i = 0; i < node.size(); ++i) {
    const std::string at = where + "/" + std::to_string(i);
    if (!wanted(node.at(i), at)) continue;
    Json one = filled(node.at(i), at);
    if (!is_missing(one)) out.push_back(std::move(one));
  }
  return out;
}

Json Filler::target(const Json& node) {
  const auto named = [](const Json& of) {
    std::set<std::string> out;
    for (const Json& part : of.value("parts", Json::array()))
      if (part.contains("name")) out.insert(part.at("name").get<std::string>());
    return out;
  };
  Json out = filled(node, "/target");
  const std::set<std::string> found = named(out);
  for (const std::string& name : named(node)) scope_["has." + name] = found.contains(name) ? 1.0 : 0.0;
  add_outlines(out, scope_);
  return out;
}

std::string replaced(std::string text, const std::map<std::string, std::string>& marks) {
  for (const auto& [mark, value] : marks)
    for (auto at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size())) text.replace(at, mark.size(), value);
  return text;
}

LesionSource lesion_of(const Json& one) {
  LesionSource out;
  out.kind = one.at("kind").get<std::string>();
  out.site = one.at("site").get<std::string>();
  out.radius_mm = one.at("radius_mm").get<double>();
  out.depth_mm = one.at("depth_mm").get<double>();
  out.softness = one.at("softness").get<double>();
  return out;
}

/// The tooth that a template asks the generator for, and the same as JSON.
SpecimenSource grown_source(const Json& body, const Json& common, const FitRequest& request, Filler& filler, Json& out) {
  SpecimenSource source;
  source.generator = "tooth";
  source.fdi = request.fdi;
  source.seed = request.seed;
  source.around = body.at("around").get<std::vector<std::string>>();
  source.voxel_mm = common.at("voxel_mm").get<double>();
  out = {{"generator", "tooth"}, {"fdi", source.fdi}, {"seed", source.seed}, {"voxel_mm", source.voxel_mm}};
  if (!source.around.empty()) out["around"] = source.around;
  if (!body.contains("lesions")) return source;
  out["lesions"] = filler.filled(body.at("lesions"), "/lesions");
  for (const Json& one : out["lesions"]) source.lesions.push_back(lesion_of(one));
  return source;
}

/// Whose the codes from 16 on are.
enum class Codes : std::uint8_t { of_generator, of_file };

/// Each with the templates' figures; one that they do not name has its usual ones.
Json tissues_json(const std::vector<Tissue>& tissues, const Json& common, Codes names) {
  Json out = Json::array();
  for (const Tissue tissue : tissues) {
    const std::string key(key_of_scenario_tissue(tissue));
    const bool known = names == Codes::of_generator || index_of(tissue) < kTissueKeys.size();
    Json one = known ? common.at("tissues").value(key, Json::object()) : Json::object();
    one["tissue"] = key;
    out.push_back(std::move(one));
  }
  return out;
}

/// Protects no tissue that a file does not hold.
void spare_what_is_held(const std::vector<Tissue>& tissues, Json& out) {
  const auto is_held = [&tissues](const std::string& key) {
    return std::ranges::any_of(tissues, [&key](Tissue t) { return key_of_scenario_tissue(t) == key; });
  };
  Json spared = Json::array(), critical = Json::array();
  for (const Json& one : out["protected"])
    if (!one.contains("tissue") || is_held(one["tissue"].get<std::string>())) spared.push_back(one);
  for (const Json& event : out["rubric"]["critical"])
    if (event != "pulp_exposure" || is_held("pulp")) critical.push_back(event);
  out["protected"] = std::move(spared);
  out["rubric"]["critical"] = std::move(critical);
}

/// A text or a key, or its parts: strings, and objects with "when" and "text".
std::string joined(const Json& node, Filler& filler) {
  if (node.is_string()) return node.get<std::string>();
  std::string out;
  for (const Json& part : node)
    if (filler.wanted(part, "/briefing")) out += (part.is_string() ? part : part.at("text")).get<std::string>();
  return out;
}

/// Title or briefing in each language.
Json texts(const Json& node, const FitRequest& request, const Scope& scope, Filler& filler) {
  Json out = Json::object();
  const auto on = [&](const char* box) { return scope.contains(box) && scope.at(box) != 0.0; };
  const std::string boxes = std::string(on("mesial") ? "M" : "") + "O" + (on("distal") ? "D" : "");
  for (const auto& [language, text] : node.items()) {
    std::map<std::string, std::string> marks = {{"{tooth}", std::to_string(request.fdi)},
                                                {"{boxes}", boxes == "OD" && language == "en" ? "DO" : boxes}};
    for (const auto& [name, value] : scope) marks["{" + name + "}"] = figure_text(rounded(value), language);
    out[language] = replaced(joined(text, filler), marks);
  }
  return out;
}

}  // namespace

std::string figure_text(double value, std::string_view language) {
  char digits[512];  // 309 before the decimal sign
  const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 2).ptr;  // as every locale has it
  std::string out(digits, end);
  if (out.ends_with('0')) out.pop_back();
  if (language == "de") std::ranges::replace(out, '.', ',');
  return out;
}

Result<Json, FitFailure> fill_template(const Json& body, const Json& common, const FitRequest& request, const ToothLandmarks& landmarks,
                                       const Scope& scope) {
  Filler filler(landmarks, scope);
  filler.add_names(body.value("names", Json::object()));
  const Json needs = body.value("needs", Json::object());
  if (const auto need = filler.unmet(needs)) return fail(FitError::unmet_need, *need);
  Json target = filler.target(body.at("target"));
  Json out = Json::object();
  out["format"] = 2;
  out["id"] = request.id.text();
  out["version"] = 1;
  out["title"] = texts(body.at("title"), request, scope, filler);
  out["briefing"] = texts(body.at("briefing"), request, scope, filler);
  out["level"] = joined(body.at("level"), filler);
  out["expected_time_s"] = filler.filled(body.at("expected_time_s"), "/expected_time_s");
  std::vector<Tissue> tissues;
  if (request.imported) {
    const double voxel_mm = request.imported->voxel_mm;
    out["specimen"] = {{"volume", request.imported->volume}, {"voxel_mm", stated_voxel_mm(voxel_mm).value_or(voxel_mm)}};
    tissues = request.imported->tissues;
  } else {
    const SpecimenSource source = grown_source(body, common, request, filler, out["specimen"]);
    tissues = tissues_of(source);
  }
  out["tissues"] = tissues_json(tissues, common, request.imported ? Codes::of_file : Codes::of_generator);
  out["instruments"] = body.at("instruments");
  for (const char* key : {"device", "method", "phenomena", "limits", "tolerance"}) out[key] = common.at(key);
  for (const char* key : {"target", "leeway", "protected", "rubric"}) out[key] = Json();
  out["target"] = std::move(target);
  out["leeway"] = body.at("leeway");
  out["protected"] = filler.filled(body.at("protected"), "/protected");
  out["rubric"] = filler.filled(Json{{"pass", body.at("rubric").at("pass")}, {"criteria", body.at("rubric").at("criteria")}}, "/rubric");
  out["rubric"]["critical"] = body.at("rubric").at("critical");
  if (request.imported) spare_what_is_held(tissues, out);
  if (filler.failure()) return std::unexpected(*filler.failure());
  return out;
}

}  // namespace cusp::scenarios
