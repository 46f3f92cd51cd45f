/// Text for an exported gradebook: what the file holds, and what it leaves out. Thread: any.
#pragma once

#include <QStringList>

#include "storage/export/gradebook.h"
#include "ui/modules.h"

namespace cusp::ui {

/// "2 results exported.", then a sentence each on failed, withheld and ungraded ones, where there are any.
QStringList gradebook_text(const GradebookFile& file);

}  // namespace cusp::ui
