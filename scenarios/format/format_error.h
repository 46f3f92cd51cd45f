/// What can be wrong with a scenario file, as codes. `where` of the failure is a JSON pointer ("/target/depth_mm"),
/// for broken JSON "line:column"; reading a file puts "<file>#" or "<file>:" before it.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/base/result.h"

namespace cusp::scenarios {

enum class FormatError : std::uint8_t {
  unreadable,          // file: missing, no permission, not a file
  too_large,           // above kMaxScenarioBytes, or nested deeper than kMaxDepth
  broken_json,         // where = line:column
  duplicate_key,
  newer_format,        // detail = the format that the file names
  unknown_key,
  missing_key,
  wrong_type,          // detail = the type that is wanted
  out_of_range,        // detail = the range that is wanted
  not_finite,          // NaN, Infinity, or a number beyond double
  bad_id,              // not a UUID
  bad_language,        // not a language code, or "en" is missing
  bad_file_name,       // a path that leaves the scenario's folder
  duplicate_value,     // a tissue, metric or instrument named twice
  unknown_tissue,
  unknown_metric,
  unknown_critical,
  unknown_method,
  unknown_generator,
  unknown_shape,
  unknown_phenomenon,
  unknown_face,       // a face of a region, or of the tolerance zone
  unknown_severity,
  unknown_hardness,   // of a leaf lesion
  unknown_level,
  bad_target_name,    // other than small letters, digits and '_' after a letter
  unknown_landmark,   // its kind or its state
  unknown_bur,        // a number that the catalogue has not
  unknown_builtin,     // library: no scenario of that key
  // Of an exercise file (scenarios/library/exercise_file.h):
  foreign_file,        // something else than an exercise file
  truncated,           // it ends before its parts do
  damaged,             // a check sum differs
  missing_file,        // it lacks a part
  unnamed_file,        // it holds a part that the exercise does not name
  unwritable,          // detail = the reason, if the system gave one
};

using FormatFailure = Failure<FormatError>;

/// Stable key of a code ("missing_key"), for --json and for findings.
std::string_view key_of(FormatError code) noexcept;

}  // namespace cusp::scenarios
