#include "scenarios/format/format_error.h"

namespace cusp::scenarios {

std::string_view key_of(FormatError code) noexcept {
  switch (code) {
    case FormatError::unreadable: return "unreadable";
    case FormatError::too_large: return "too_large";
    case FormatError::broken_json: return "broken_json";
    case FormatError::duplicate_key: return "duplicate_key";
    case FormatError::newer_format: return "newer_format";
    case FormatError::unknown_key: return "unknown_key";
    case FormatError::missing_key: return "missing_key";
    case FormatError::wrong_type: return "wrong_type";
    case FormatError::out_of_range: return "out_of_range";
    case FormatError::not_finite: return "not_finite";
    case FormatError::bad_id: return "bad_id";
    case FormatError::bad_language: return "bad_language";
    case FormatError::bad_file_name: return "bad_file_name";
    case FormatError::duplicate_value: return "duplicate_value";
    case FormatError::unknown_tissue: return "unknown_tissue";
    case FormatError::unknown_metric: return "unknown_metric";
    case FormatError::unknown_critical: return "unknown_critical";
    case FormatError::unknown_method: return "unknown_method";
    case FormatError::unknown_generator: return "unknown_generator";
    case FormatError::unknown_shape: return "unknown_shape";
    case FormatError::unknown_phenomenon: return "unknown_phenomenon";
    case FormatError::unknown_face: return "unknown_face";
    case FormatError::bad_target_name: return "bad_target_name";
    case FormatError::unknown_severity: return "unknown_severity";
    case FormatError::unknown_hardness: return "unknown_hardness";
    case FormatError::unknown_level: return "unknown_level";
    case FormatError::unknown_landmark: return "unknown_landmark";
    case FormatError::unknown_bur: return "unknown_bur";
    case FormatError::unknown_builtin: return "unknown_builtin";
    case FormatError::foreign_file: return "foreign_file";
    case FormatError::truncated: return "truncated";
    case FormatError::damaged: return "damaged";
    case FormatError::missing_file: return "missing_file";
    case FormatError::unnamed_file: return "unnamed_file";
    case FormatError::unwritable: return "unwritable";
  }
  return "unreadable";
}

}  // namespace cusp::scenarios
