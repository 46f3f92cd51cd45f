#include "ui/session/build_info.h"

namespace cusp {

std::string build_info() { return "cusp " CUSP_VERSION; }

}  // namespace cusp
