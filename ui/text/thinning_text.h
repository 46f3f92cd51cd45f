/// Text for thinning: what went or would go, and why others stay. Thread: any.
#pragma once

#include <QString>

#include "storage/retention/thinning.h"
#include "ui/modules.h"

namespace cusp::ui {

/// "12 recordings were thinned: 34.1 MB."; of a dry run "would be".
QString thinned_text(const ThinningReport& report, ThinningMode mode);
/// "Kept whole: 3 of assessments, 2 without a grade."; empty if none is kept.
QString kept_text(const KeptTraces& kept);
/// "34.1 MB".
QString recording_size_text(std::uint64_t bytes);

}  // namespace cusp::ui
