/// Tolerances of the laboratory's tests. CUSP_TOLERANCE_ZERO=1 prints the residuals by failing every bound.
#pragma once

#include <cstdlib>

namespace cusp::engine::lab {

inline double bound(double value) { return std::getenv("CUSP_TOLERANCE_ZERO") ? 0.0 : value; }

}  // namespace cusp::engine::lab
