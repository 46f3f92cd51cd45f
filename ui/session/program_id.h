/// Which build of the program runs.
#pragma once

#include <optional>
#include <string>

namespace cusp::ui {

/// The linker's hash of the program's code and data, in hex: any change of a generator changes it. nullopt: linked without one.
std::optional<std::string> program_id();

}  // namespace cusp::ui
