#include "scenarios/format/migrate.h"

#include <nlohmann/json.hpp>

namespace cusp::scenarios {

Result<void, FormatFailure> migrate(nlohmann::json& document) {
  const auto format = document.find("format");
  if (format == document.end()) return fail(FormatError::missing_key, "/format");
  if (!format->is_number_integer()) return fail(FormatError::wrong_type, "/format", "integer");
  // Unsigned numbers beyond 2^63 are newer too; get<long long> would wrap.
  if (format->is_number_unsigned() && format->get<std::uint64_t>() > static_cast<std::uint64_t>(kScenarioFormat)) {
    return fail(FormatError::newer_format, "/format", format->dump());
  }
  if (format->get<std::int64_t>() < 1) return fail(FormatError::out_of_range, "/format", ">= 1");
  return {};
}

}  // namespace cusp::scenarios
