/// What a report shows, gathered once from an attempt's result and the records. No widget.
#pragma once

#include <QDateTime>
#include <QImage>
#include <QPointF>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "scenarios/grading/maxima.h"
#include "storage/store.h"
#include "ui/modules.h"
#include "ui/report/criteria_model.h"
#include "ui/render/snapshot.h"
#include "ui/session/bur_use.h"
#include "ui/session/exercise_session.h"
#include "ui/text/critical_events.h"
#include "ui/text/names.h"

namespace cusp::ui {

/// What an instructor or examiner said of the attempt, and still stands.
struct Remark {
  Uuid id;              // of the statement; nil: a comment of an older program, which stays
  QString who;
  QDateTime when;
  QString what;         // "Floor depth, deepest: 4 to 6 points", "Result confirmed"; empty for a comment
  QString text;         // comment or reason
  std::optional<Vec3> place_mm{};
  bool superseded = false;  // a later change of the same criterion or critical event counts
};

struct ReportData {
  SessionResult result;
  QString title;                  // of the exercise, in the installed language
  QString student;                // candidate number in an assessment; empty for an attempt that nobody signed in for
  bool of_reader = false;         // the reader's own attempt
  QDateTime when;                 // local time of the attempt's start; null when nothing was kept
  SessionKind kind = SessionKind::try_it;
  int attempt = 0;                     // 0 = nothing was kept
  int exercise_version = 0;            // likewise
  std::optional<double> peak_push_n;
  std::vector<BurSpan> burs;    // times of each bur; empty without records, and where the recording was thinned
  QString thinned;              // when that was, as a sentence; empty: it was not
  std::vector<CriticalEvent> critical;  // an opened pulp first
  std::optional<EffectiveGrade> counts;  // with what examiners changed; none without records
  std::vector<PointsChange> changes;     // by examiners, of points that count
  std::vector<Remark> remarks;           // oldest first
  std::optional<SelfAssessment> own;     // the student's own assessment; none without one
  std::optional<std::uint64_t> drawn_tooth;  // seed of a tooth that was drawn for this candidate
  bool released = true;                  // false: an assessment whose result the student does not see yet
  std::optional<Grade> before;    // the best attempt before, of the same exercise and device class
  QDateTime before_when;
  bool before_read = true;        // false: whether there is one could not be read
  bool alone = false;             // of an appeal pack: its records hold no other attempt
  /// Why remarks, changed points, the own assessment or an earlier result may be missing; none: all was read.
  std::optional<StorageFailure> unread;
};

/// With a null `store` or `reader` the data holds the result alone.
ReportData gather_report(const SessionResult& result, Store* store, const Actor* reader);

/// The names that the tooth's volume gives its tissues; empty for a result without a volume.
const TissueNames& tissue_names_of(const SessionResult& result);

/// "Bur 1, round, 0.8 mm, 3.9 mm deep": what is known of a critical event besides its time; empty: nothing.
QString critical_circumstances(const ReportData& data, const CriticalEvent& event);

/// One entry of "Next time".
struct Advice {
  QString head;                  // "The pulp was exposed after 1:12 min", "Floor depth, deepest: 6 points lost"
  QString why, what_to_do;       // one sentence each, or empty
  std::optional<Vec3> place_mm;  // where on the tooth
  bool grave = false;            // a critical event, or a loss of more than half of the points
  std::string metric{};          // of the criterion, or the key of the critical event: its patch is painted
};
/// Critical events first, then the largest losses. Leaves out criteria that count only with the target; counted_text() names them
/// in one sentence. Leaves out criteria whose points an examiner changed: the remarks have their reasons.
std::vector<Advice> next_time(const ReportData& data);
/// What stands under "Next time" if next_time() and counted_text() are empty.
QString no_advice_text(const ReportData& data);

enum class Medium { screen, paper };
/// "Fri 20 Nov, 10:14 · Practice, attempt 7"; on paper with year and time zone.
QString occasion_text(const ReportData& data, Medium medium);
/// "7:38 min · peak force 2.1 N · Mouse and keys · version 3 of the exercise".
QString circumstances_text(const ReportData& data);

/// "Bur 2, round, 1.0 mm: 0:00 to 1:12, 3:05 to 4:10", one line for each used bur; of a thinned recording one line that says so; empty
/// without records.
QStringList burs_used_text(const ReportData& data);

/// "Own assessment: 75 of 100 on 8 rated criteria, measured 82", or that it was skipped; empty without one.
QString own_assessment_text(const ReportData& data);

/// A place on the tooth seen close by.
struct CloseUp {
  QImage image;
  std::optional<QPointF> at_px;  // of the place; nullopt: no side shows it
};
/// The tooth coloured by deviation, with the pixel of each asked place; nullopt if the tooth hides it.
struct ToothDrawing {
  QImage image;
  std::vector<std::optional<QPointF>> places_px;
  std::vector<CloseUp> closeups;
};
using DrawnTooth = Result<ToothDrawing, PictureFailure>;
struct DrawingOrder {
  struct Place {
    Vec3 where_mm{0.0};
    std::string metric{};  // whose place it is; empty: of none that has a patch
  };
  int side_px = 1200;
  std::vector<Place> places{};  // each in a picture of its own, with its patch
  std::size_t numbered = 0;     // the first of them, marked on the picture of the whole too
};
/// Draws without a window, in about one second; the first of a jaw takes longer.
DrawnTooth draw_report_tooth(const SessionResult& result, const DrawingOrder& order);
/// "The tooth could not be drawn: OpenGL 3.3 did not start (eglMakeCurrent 0x3002)."
QString picture_failure_text(const PictureFailure& failure);

}  // namespace cusp::ui
