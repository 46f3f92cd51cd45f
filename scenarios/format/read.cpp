#include "scenarios/format/read.h"

#include <algorithm>
#include <fstream>

#include "scenarios/format/keys.h"
#include "scenarios/format/migrate.h"
#include "scenarios/format/read_sections.h"

namespace cusp::scenarios {
namespace {

using namespace format_reader;

std::optional<Method> method_from_key(std::string_view key) {
  for (const Method method : kMethods) {
    if (key_of(method) == key) return method;
  }
  return std::nullopt;
}

std::optional<Level> level_from_key(std::string_view key) {
  const auto at = std::ranges::find(kLevelKeys, key);
  return at == kLevelKeys.end() ? std::nullopt : std::optional(static_cast<Level>(at - kLevelKeys.begin()));
}

bool is_key(std::string_view key) {
  return !key.empty() && key.size() <= 64 &&
         std::ranges::all_of(key, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

void read_identity(Object& root, Scenario& out) {
  const Value id = root.need("id");
  if (const auto parsed = ScenarioId::parse(id.text(0, 64))) {
    out.id = *parsed;
  } else {
    id.refuse(FormatError::bad_id);
  }
  out.version = root.need("version").integer({1, 1e9});
  root.maybe("key", [&](const Value& v) {
    out.key = v.text(1, 64);
    if (v.node().is_string() && !is_key(out.key)) v.refuse(FormatError::out_of_range, "a-z 0-9 -");
  });
}

void read_tissues_and_burs(Object& root, Scenario& out) {
  root.need("tissues").list(0, kTissueCodes, [&](const Value& v) {
    const ScenarioTissue tissue = read_scenario_tissue(v);
    for (const ScenarioTissue& other : out.tissues) {
      if (other.tissue == tissue.tissue)
        v.refuse(FormatError::duplicate_value, std::string(key_of_scenario_tissue(tissue.tissue)));
    }
    out.tissues.push_back(tissue);
  });
  root.need("instruments").list(0, 64, [&](const Value& v) {
    const Bur bur = read_bur(v);
    for (const Bur& other : out.instruments) {
      if (other.name == bur.name) v.refuse(FormatError::duplicate_value, bur.name);
    }
    out.instruments.push_back(bur);
  });
}

void read_device(const Value& value, Scenario& out) {
  Object device(value.node(), value.where(), value.problems());
  out.device.needs_dof = device.need("needs_dof").integer({3, 6});
  device.maybe("admitted", [&](const Value& list) {
    list.list(0, 16, [&](const Value& v) {
      out.device.admitted.push_back(v.text(1, 64));
      if (v.node().is_string() && !is_key(out.device.admitted.back())) v.refuse(FormatError::out_of_range, "a-z 0-9 -");
    });
  });
  out.device.full_force_n = device.need("full_force_n").number({0, 50, true});
  device.maybe("tool_tilt_deg", [&](const Value& v) { out.tool_tilt_deg = v.number({-80, 80}); });
  device.maybe("tool_turn_deg", [&](const Value& v) { out.tool_turn_deg = v.number({0, 60}); });
  device.nothing_else();
}

TemplateUse read_template(const Value& value) {
  Object use(value.node(), value.where(), value.problems());
  TemplateUse out;
  const Value key = use.need("key");
  out.key = key.text(1, 64);
  if (key.node().is_string() && !is_key(out.key)) key.refuse(FormatError::out_of_range, "a-z 0-9 -");
  use.need("values").list(0, 64, [&](const Value& v) {
    Object one(v.node(), v.where(), v.problems());
    const std::string parameter = one.need("parameter").text(1, 64);
    if (!out.values.emplace(parameter, one.need("value").number(kCoordinate)).second) v.refuse(FormatError::duplicate_value, parameter);
    one.nothing_else();
  });
  use.nothing_else();
  return out;
}

Scenario read_document(const json& document, Problems& problems) {
  Object root(document, "", problems);
  Scenario out;
  out.format = root.need("format").integer({kScenarioFormat, kScenarioFormat});
  read_identity(root, out);
  out.title = root.need("title").texts();
  out.briefing = root.need("briefing").texts();
  root.maybe("level", [&](const Value& v) { out.level = v.key(FormatError::unknown_level, level_from_key); });
  root.maybe("expected_time_s", [&](const Value& v) { out.expected_time_s = v.number({0, 86400}); });
  root.maybe("self_assessment", [&](const Value& v) { out.self_assessment = v.yes(); });
  root.maybe("template", [&](const Value& v) { out.made_with = read_template(v); });
  out.specimen = read_specimen(root.need("specimen"));
  read_tissues_and_burs(root, out);
  read_device(root.need("device"), out);
  out.method = root.need("method").key(FormatError::unknown_method, method_from_key);
  root.maybe("phenomena", [&](const Value& list) {
    list.list(0, 16, [&](const Value& v) {
      out.phenomena.push_back(v.key(FormatError::unknown_phenomenon, one_of(kPhenomenonKeys)));
    });
  });
  out.target = read_region(root.need("target"), RegionUse::target);
  out.leeway = read_leeway(root.need("leeway"));
  root.maybe("protected", [&](const Value& list) {
    list.list(0, kTissueCodes, [&](const Value& v) { out.protected_parts.push_back(read_protected(v)); });
  });
  root.maybe("limits", [&](const Value& v) {
    Object limits(v.node(), v.where(), v.problems());
    limits.maybe("time_s", [&](const Value& time) { out.time_limit_s = time.number({0, 86400}); });
    limits.nothing_else();
  });
  out.rubric = read_rubric(root.need("rubric"));
  root.maybe("tolerance", [&](const Value& v) {
    Object tolerance(v.node(), v.where(), v.problems());
    out.tolerance_points = tolerance.need("points").number({0, 100});
    tolerance.nothing_else();
  });
  root.nothing_else();
  return out;
}

}  // namespace

Result<Scenario, FormatFailure> read_scenario(std::string_view text) {
  auto document = json_text::parse(text);
  if (!document) return std::unexpected(document.error());
  if (!document->is_object()) return fail(FormatError::wrong_type, "", "object");
  if (const auto migrated = migrate(*document); !migrated) return std::unexpected(migrated.error());
  Problems problems;
  Scenario scenario = read_document(*document, problems);
  if (problems.first()) return std::unexpected(*problems.first());
  return scenario;
}

Result<Scenario, FormatFailure> read_scenario_file(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path file_path = std::filesystem::is_directory(path, ignored) ? path / "scenario.json" : path;
  if (!std::filesystem::is_regular_file(file_path, ignored)) return fail(FormatError::unreadable, file_path.string());
  std::ifstream file(file_path, std::ios::binary);
  if (!file) return fail(FormatError::unreadable, file_path.string());
  std::string text(kMaxScenarioBytes + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) return fail(FormatError::unreadable, file_path.string());
  text.resize(static_cast<std::size_t>(file.gcount()));
  auto scenario = read_scenario(text);
  if (!scenario) {
    FormatFailure failure = scenario.error();
    const bool in_text = !failure.where.empty() && failure.where.front() != '/';
    failure.where = file_path.string() + (in_text ? ":" : "#") + failure.where;
    return std::unexpected(std::move(failure));
  }
  return scenario;
}

}  // namespace cusp::scenarios
