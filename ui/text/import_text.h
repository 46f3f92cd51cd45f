/// Text for what an import did to a file. Needs no window.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/remarks.h"
#include "ui/modules.h"

namespace cusp::ui {

/// "Two holes were closed in crown, the widest of 0.4 mm." Empty for a remark that makes no sentence alone (precedence).
QString describe(const ImportRemark& remark);
/// All sentences of an import; the order in which meshes win is one.
QStringList describe(const std::vector<ImportRemark>& remarks);
/// "It is 155 mm long …": for the question, without a way out.
QString odd_size_text(double longest_mm);
/// What a limit refused, as a headline.
QString limit_title(LimitKind kind);
/// Why a limit refused a file: figures, and a way out. `where` names the file.
QString limit_text(const QString& where, const LimitFigures& figures);

/// "7.2 × 8.1 × 21.6 mm", in the locale's digits; no unit when `unit` is empty.
QString size_text(Vec3 size, const QString& unit, int decimals = 1);
/// "(1.2, 3.4, -5.6) mm"
QString place_text(Vec3 at_mm);

}  // namespace cusp::ui
