/// What an import did to a file, put into words. Needs no window.
#pragma once

#include <QString>

#include "engine/base/vec.h"
#include "scenarios/import/remarks.h"

namespace cusp {

/// "Two holes were closed in crown, the widest of 0.4 mm."
QString tell(const ImportRemark& remark);

/// "7.2 × 8.1 × 21.6 mm", in the locale's digits; no unit when `unit` is empty.
QString size_text(Vec3 size, const QString& unit, int decimals = 1);
/// "(1.2, 3.4, -5.6) mm"
QString place_text(Vec3 at_mm);

}  // namespace cusp
