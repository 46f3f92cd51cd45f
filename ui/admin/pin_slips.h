/// Slips of paper with number and PIN, ten on an A4 sheet, to be cut apart. Thread: GUI.
#pragma once

#include <QString>
#include <filesystem>
#include <vector>

#include "ui/modules.h"
#include "ui/widgets/pdf_file.h"

namespace cusp::ui {

struct PinSlip {
  QString name, number, pin, cohort;
};

/// A PDF in the light colours, which its owner alone may read.
Result<void, PdfFailure> write_pin_slips(const std::filesystem::path& file, const std::vector<PinSlip>& slips);

}  // namespace cusp::ui
