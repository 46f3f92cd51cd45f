#include "scenarios/format/schema.h"

#include <memory>

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "scenarios/format/json_text.h"

namespace cusp::scenarios {
namespace embedded {
extern const std::string_view scenario_schema;
}
namespace {

using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// The embedded schema, ready to use. It is part of the build: a test reads it, so it parses here.
const valijson::Schema& parsed_schema() {
  static const nlohmann::json document = nlohmann::json::parse(scenario_schema());
  static const std::unique_ptr<valijson::Schema> schema = [] {
    auto out = std::make_unique<valijson::Schema>();
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(document), *out);
    return out;
  }();
  return *schema;
}

/// ["<root>", "[\"target\"]", "[0]"] -> "/target/0".
std::string pointer_of(const std::vector<std::string>& context) {
  std::string out;
  for (const std::string& step : context) {
    if (step.size() < 3 || step.front() != '[') continue;
    std::string inner = step.substr(1, step.size() - 2);
    if (inner.size() >= 2 && inner.front() == '"') inner = inner.substr(1, inner.size() - 2);
    out += json_text::pointer_step(inner);
  }
  return out;
}

}  // namespace

std::string_view scenario_schema() noexcept { return embedded::scenario_schema; }

std::vector<Finding> check_schema(std::string_view text) {
  const auto document = json_text::parse(text);
  if (!document) return {};
  std::vector<Finding> out;
  try {
    valijson::ValidationResults results;
    valijson::Validator validator(valijson::Validator::kStrongTypes);
    if (!validator.validate(parsed_schema(), Adapter(*document), &results)) {
      for (const auto& error : results) {
        // Its cause further in is in the list itself.
        if (error.description.starts_with("Failed to validate against schema associated")) continue;
        out.push_back({Severity::error, pointer_of(error.context), "schema", {}, error.description});
      }
    }
  } catch (const std::exception& error) {
    out.push_back({Severity::error, "", "schema", {}, error.what()});
  }
  return out;
}

}  // namespace cusp::scenarios
