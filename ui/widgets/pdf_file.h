/// An A4 PDF, written beside its name and renamed, so that no half file is left. Needs a QGuiApplication; without a display its
/// platform is "offscreen" ("minimal" has no fonts). Thread: GUI.
#pragma once

#include <QMarginsF>
#include <QString>
#include <filesystem>
#include <functional>

#include "engine/base/result.h"

class QPainter;
class QPdfWriter;

namespace cusp::ui {

enum class PdfError : std::uint8_t { cannot_write };
using PdfFailure = Failure<PdfError>;

inline constexpr double kPdfUnit = 300.0 / 84.0;  // dots to a pixel of the screen; 84 of these an inch fill the page's width

struct PdfSheet {
  QString title{};
  QMarginsF margins_mm{18, 16, 18, 16};
};

/// `draw` paints at 300 dots an inch; writer.newPage() begins another sheet.
Result<void, PdfFailure> write_pdf(const std::filesystem::path& file, const PdfSheet& sheet,
                                   const std::function<void(QPainter& painter, QPdfWriter& writer)>& draw);

}  // namespace cusp::ui
