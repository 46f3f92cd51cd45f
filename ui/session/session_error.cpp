#include "ui/session/session_error.h"

namespace cusp::ui {

std::string_view key_of(SessionError code) noexcept {
  switch (code) {
    case SessionError::specimen: return "specimen";
    case SessionError::scene: return "scene";
    case SessionError::device: return "device";
    case SessionError::device_class: return "device_class";
    case SessionError::device_axes: return "device_axes";
    case SessionError::scenario: return "scenario";
    case SessionError::storage: return "storage";
    case SessionError::recording_failed: return "recording_failed";
    case SessionError::not_deterministic: return "not_deterministic";
    case SessionError::fell_behind: return "fell_behind";
    case SessionError::wrong_state: return "wrong_state";
    case SessionError::other_engine: return "other_engine";
    case SessionError::specimen_changed: return "specimen_changed";
    case SessionError::no_tooth: return "no_tooth";
    case SessionError::driver_silent: return "driver_silent";
  }
  return "storage";
}

}  // namespace cusp::ui
