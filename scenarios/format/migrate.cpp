#include "scenarios/format/migrate.h"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "scenarios/format/json_text.h"
#include "scenarios/format/keys.h"

namespace cusp::scenarios {
namespace {

using nlohmann::json;

constexpr std::string_view kOldRemainder = "undercut", kRemainder = "uncut_remainder";

/// The keys of format 1 in the objects that format 2 extends.
using Keys = std::span<const std::string_view>;
constexpr std::string_view kTargetKeys[] = {"shape",  "paths",            "width_mm",   "depth_mm",
                                            "top_mm", "corner_radius_mm", "box_size_mm"};
constexpr std::string_view kLeewayKeys[] = {"floor_mm", "side_mm"};
constexpr std::string_view kProtectedKeys[] = {"tissue"};  // the object's one key stands for format 1's bare text
constexpr const char* kLaterKeys[] = {"level", "expected_time_s", "self_assessment", "template"};  // of the document itself
constexpr const char* kLandmarks = "landmarks";                                                     // of the specimen
constexpr std::string_view kCriterionKeys[] = {"metric", "weight", "bands"};

/// First key of an object that is not of the list; none where it is no object.
std::optional<std::string> key_beyond(const json& node, Keys keys) {
  if (!node.is_object()) return std::nullopt;
  for (auto it = node.begin(); it != node.end(); ++it)
    if (std::ranges::find(keys, std::string_view(it.key())) == keys.end()) return it.key();
  return std::nullopt;
}

const json* find(const json& document, const char* key) {
  const auto it = document.find(key);
  return it == document.end() ? nullptr : &*it;
}

const json* criteria_of(const json& rubric) {
  const json* criteria = rubric.is_object() ? find(rubric, "criteria") : nullptr;
  return criteria != nullptr && criteria->is_array() ? criteria : nullptr;
}

/// What format 1 does not know; values of wrong types are the reader's to refuse.
Result<void, FormatFailure> refuse_later_words(const json& document) {
  const auto check = [](const json* node, const std::string& where,
                        Keys keys) -> Result<void, FormatFailure> {
    if (node == nullptr) return {};
    if (const auto key = key_beyond(*node, keys)) return fail(FormatError::unknown_key, where + json_text::pointer_step(*key));
    return {};
  };
  for (const char* key : kLaterKeys)
    if (document.contains(key)) return fail(FormatError::unknown_key, json_text::pointer_step(key));
  const json* specimen = find(document, "specimen");
  if (specimen != nullptr && specimen->is_object() && specimen->contains(kLandmarks))
    return fail(FormatError::unknown_key, std::string("/specimen/") + kLandmarks);
  if (auto done = check(find(document, "target"), "/target", kTargetKeys); !done) return done;
  if (auto done = check(find(document, "leeway"), "/leeway", kLeewayKeys); !done) return done;
  const json* rubric = find(document, "rubric");
  const json* criteria = rubric == nullptr ? nullptr : criteria_of(*rubric);
  if (criteria == nullptr) return {};
  for (std::size_t i = 0; i < criteria->size(); ++i) {
    const std::string where = "/rubric/criteria/" + std::to_string(i);
    const json& one = (*criteria)[i];
    if (auto done = check(&one, where, kCriterionKeys); !done) return done;
    const json* metric = one.is_object() ? find(one, "metric") : nullptr;
    if (metric != nullptr && *metric == kRemainder)
      return fail(FormatError::unknown_metric, where + "/metric", std::string(kRemainder));
  }
  return {};
}

void rename_metric(json& rubric, std::string_view from, std::string_view to) {
  if (criteria_of(rubric) == nullptr) return;
  for (json& one : rubric["criteria"])
    if (one.is_object() && one.contains("metric") && one["metric"] == from) one["metric"] = to;
}

void from_format_1(json& document) {
  document["format"] = 2;
  if (document.contains("target") && document["target"].is_object()) document["target"]["kind"] = "outline";
  if (document.contains("protected") && document["protected"].is_array())
    for (json& tissue : document["protected"]) tissue = json{{"tissue", std::move(tissue)}};
  if (document.contains("rubric")) migrate_rubric(document["rubric"]);
}

}  // namespace

Result<void, FormatFailure> migrate(json& document) {
  const auto format = document.find("format");
  if (format == document.end()) return fail(FormatError::missing_key, "/format");
  if (!format->is_number_integer()) return fail(FormatError::wrong_type, "/format", "integer");
  // Unsigned numbers beyond 2^63 are newer too; get<long long> would wrap.
  if (format->is_number_unsigned() && format->get<std::uint64_t>() > static_cast<std::uint64_t>(kScenarioFormat)) {
    return fail(FormatError::newer_format, "/format", format->dump());
  }
  const auto number = format->get<std::int64_t>();
  if (number < 1) return fail(FormatError::out_of_range, "/format", ">= 1");
  if (number == 1) {
    if (auto done = refuse_later_words(document); !done) return done;
    from_format_1(document);
  }
  return {};
}

void migrate_rubric(json& rubric) { rename_metric(rubric, kOldRemainder, kRemainder); }

std::optional<json> in_format_1(const json& document) {
  for (const char* key : kLaterKeys)
    if (document.contains(key)) return std::nullopt;
  if (document["specimen"].contains(kLandmarks)) return std::nullopt;
  json out = document;
  json& target = out["target"];
  if (target["kind"] != "outline") return std::nullopt;
  target.erase("kind");
  if (key_beyond(target, kTargetKeys) || key_beyond(out["leeway"], kLeewayKeys)) return std::nullopt;
  for (json& one : out["protected"]) {
    if (key_beyond(one, kProtectedKeys)) return std::nullopt;
    json tissue = std::move(one["tissue"]);
    one = std::move(tissue);
  }
  for (const json& one : out["rubric"]["criteria"])
    if (key_beyond(one, kCriterionKeys)) return std::nullopt;
  rename_metric(out["rubric"], kRemainder, kOldRemainder);
  out["format"] = 1;
  return out;
}

}  // namespace cusp::scenarios
