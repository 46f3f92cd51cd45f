/// What a report shows, gathered once from a go's result and the records. No widget.
#pragma once

#include <QDateTime>
#include <QImage>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "storage/store.h"
#include "ui/session/burr_use.h"
#include "ui/session/exercise_run.h"

namespace cusp {

struct ReportData {
  RunResult result;
  QString title;                  // of the exercise, in the installed language
  QString student;                // empty for a go that nobody signed in for
  QDateTime when;                 // local time of the go's start; null when nothing was kept
  SessionKind kind = SessionKind::try_it;
  int go = 0;                     // 0 = nothing was kept
  std::optional<double> peak_push_n;
  std::vector<BurrSpan> burrs;    // what was in the handpiece when; empty when nothing was kept
  std::optional<Grade> before;    // the best go before, of the same exercise and device class
  QDateTime before_when;
};

/// `store` and `reader` may be null: then only the result itself is shown.
ReportData gather_report(const RunResult& result, Store* store, const Actor* reader);

/// Points: a smaller loss does not show in figures with one decimal.
inline constexpr double kLeastLoss = 0.05;

/// Criteria that lost points, the dearest first; after them those that lost theirs only because little was drilled.
std::vector<const CriterionGrade*> lost_points(const Grade& grade);

/// "Fri 20 Nov, 10:14 · Practice, go 7".
QString occasion_text(const ReportData& data);
/// "7:38 min · peak push 2.1 N · Mouse and keys".
QString circumstances_text(const ReportData& data);

/// "Burr 2, round, 1.0 mm: 0:00 to 1:12, 3:05 to 4:10", a line for each burr that was used; empty when nothing was kept.
QStringList burrs_used_text(const ReportData& data);

/// The tooth coloured by deviation, drawn without a window; null where there is no OpenGL.
QImage draw_report_tooth(const RunResult& result, int side_px);

}  // namespace cusp
