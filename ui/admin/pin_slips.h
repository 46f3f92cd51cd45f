/// Slips of paper with number and PIN, ten on an A4 sheet, to be cut apart. Thread: GUI.
#pragma once

#include <QRectF>
#include <QString>
#include <filesystem>
#include <vector>

#include "ui/modules.h"
#include "ui/widgets/pdf_file.h"

class QPainter;

namespace cusp::ui {

struct PinSlip {
  QString name, number, pin, cohort;
};

/// One slip, to be cut out along the box. A name that is too long for it is cut off, number and PIN never. `unit`: as of Paper.
void draw_slip(QPainter& painter, const QRectF& box, const PinSlip& slip, double unit);

/// A PDF in the light colours, which its owner alone may read.
Result<void, PdfFailure> write_pin_slips(const std::filesystem::path& file, const std::vector<PinSlip>& slips);

}  // namespace cusp::ui
