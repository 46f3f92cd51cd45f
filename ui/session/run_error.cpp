#include "ui/session/run_error.h"

namespace cusp::ui {

std::string_view key_of(RunError code) noexcept {
  switch (code) {
    case RunError::specimen: return "specimen";
    case RunError::scene: return "scene";
    case RunError::device: return "device";
    case RunError::device_class: return "device_class";
    case RunError::scenario: return "scenario";
    case RunError::storage: return "storage";
    case RunError::recording_failed: return "recording_failed";
    case RunError::not_deterministic: return "not_deterministic";
    case RunError::fell_behind: return "fell_behind";
    case RunError::wrong_state: return "wrong_state";
    case RunError::other_engine: return "other_engine";
    case RunError::specimen_changed: return "specimen_changed";
  }
  return "storage";
}

}  // namespace cusp::ui
