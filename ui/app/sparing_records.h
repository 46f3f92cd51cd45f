/// A file picker that saves nothing over the records. Thread: GUI.
#pragma once

#include <filesystem>

#include "ui/modules.h"
#include "ui/widgets/ports.h"

namespace cusp::ui {

/// `ports`, whose picker takes no file of a database for saving (ui/session/database_files.h): it says so and offers another choice.
Ports sparing_records(Ports ports, const std::filesystem::path& database);

}  // namespace cusp::ui
