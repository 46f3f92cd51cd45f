/// Why an attempt did not start or go on, by the device that it was to be drilled with.
#pragma once

#include <string_view>

#include "ui/modules.h"
#include "ui/text/failure_text.h"

namespace cusp::ui {

/// `kind`: DeviceKind::key of the chosen device; empty for a script.
Message describe_on_device(const SessionFailure& failure, std::string_view kind);

}  // namespace cusp::ui
