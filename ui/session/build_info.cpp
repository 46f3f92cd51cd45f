#include "ui/session/build_info.h"

namespace cusp::ui {

std::string build_info() { return "cusp " CUSP_VERSION; }

}  // namespace cusp::ui
