/// How running, opening and replaying an attempt can fail. Codes only; ui/text has their text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "engine/base/haptic_port.h"
#include "engine/base/result.h"
#include "scenarios/format/format_error.h"
#include "scenarios/import/import_error.h"
#include "storage/base/error.h"
#include "ui/modules.h"

namespace cusp::ui {

enum class SessionError : std::uint8_t {
  specimen,           // the scenario's volume cannot be made or read; cause: ImportError
  scene,              // where: the key of scenario.json whose value the engine refuses
  device,             // the port did not open; cause: PortError
  device_class,       // the scenario does not admit this class of device; where: the class
  device_axes,        // the device senses fewer axes than the scenario needs; where: its class; detail: how many it needs
  scenario,           // the stored version cannot be read; cause: FormatError
  storage,            // cause: StorageError
  recording_failed,   // the record could not be written; what stands in the database is whole; cause: StorageError
  not_deterministic,  // loop and mirror came to different states; where: the tick
  fell_behind,        // inputs were not taken off in time; the attempt ended as interrupted
  wrong_state,        // finish() of an attempt that is over; grading one that still runs
  other_engine,       // recorded by another engine version: only its stored results open; where: that version
  specimen_changed,   // what is stored is not the specimen that the attempt began with
  no_tooth,           // no tooth was drawn that the exercise suits; where: JSON pointer to what held it
  driver_silent,      // at the end the driver did not come back; the attempt is kept as interrupted; where: the device
};

/// PortFailure::detail of a driver that did not come back: from open(), or at the end of an attempt of which nothing is kept.
inline constexpr std::string_view kStandsStill = "stands_still";

/// Stable keys, for --json.
std::string_view key_of(SessionError code) noexcept;

struct SessionFailure {
  SessionError code = SessionError::storage;
  std::string where;     // file, key or device; never text for people
  std::string detail{};  // a library's own message, or a number
  /// The code of the module below, where it has one.
  std::variant<std::monostate, StorageError, ImportError, PortError, FormatError> cause{};
};

template <class T>
using Outcome = Result<T, SessionFailure>;

inline std::unexpected<SessionFailure> session_fail(SessionError code, std::string where, std::string detail = {}) {
  return std::unexpected(SessionFailure{code, std::move(where), std::move(detail), {}});
}
/// Carries a failure of a module below upwards.
template <class Code>
std::unexpected<SessionFailure> session_fail(SessionError code, const Failure<Code>& below) {
  return std::unexpected(SessionFailure{code, below.where, below.detail, below.code});
}

}  // namespace cusp::ui
