/// A PDF of A4 sheets unless others are asked for, written beside its name and renamed, so that no half file is left. Needs a QGuiApplication; without a display its
/// platform is "offscreen" ("minimal" has no fonts). Thread: GUI.
#pragma once

#include <QMarginsF>
#include <QPageLayout>
#include <QString>
#include <filesystem>
#include <functional>
#include <optional>

#include "engine/base/result.h"
#include "ui/widgets/save_bytes.h"

class QPainter;
class QPdfWriter;

namespace cusp::ui {

enum class PdfError : std::uint8_t { cannot_write };
using PdfFailure = Failure<PdfError>;

inline constexpr double kPdfUnit = 300.0 / 84.0;  // dots to a pixel of the screen; 84 of these an inch fill the page's width

struct PdfSheet {
  QString title{};
  QMarginsF margins_mm{18, 16, 18, 16};
  std::optional<QPageLayout> layout{};  // of the sheet with its margins, in place of A4 and margins_mm
  Readers readers = Readers::usual;     // of the file
};

/// A failure's detail is the cause as save_bytes() gives it. `draw` paints at 300 dots an inch; writer.newPage() begins another sheet.
Result<void, PdfFailure> write_pdf(const std::filesystem::path& file, const PdfSheet& sheet,
                                   const std::function<void(QPainter& painter, QPdfWriter& writer)>& draw);

}  // namespace cusp::ui
