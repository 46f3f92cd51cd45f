/// Version and commit of this program, as stored with a session.
#pragma once

#include <string>

namespace cusp::ui {

std::string build_info();

}  // namespace cusp::ui
