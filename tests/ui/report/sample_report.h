/// Reports of a channel in a block, made up and of records, and a tooth that could not be drawn.
#pragma once

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/report/report_data.h"

namespace cusp::test {

inline ReportData sample(double score = 81) {
  ReportData data;
  data.result.scenario = *load_builtin("channel-1");
  data.result.grade = test::sample_grade(score);
  data.result.seconds = 458;
  data.result.device.device_class = "pointer";
  data.title = QStringLiteral("Straight channel");
  data.student = QStringLiteral("Lena Brandt");
  data.when = QDateTime(QDate(2026, 11, 20), QTime(10, 14));
  data.kind = SessionKind::practice;
  data.attempt = 7;
  data.peak_push_n = 2.1;
  return data;
}

/// Of a graded attempt at channel-1, as the reader sees it.
inline ReportData report_of(DeskRecords& records, SessionId session, const Account& reader) {
  SessionResult result;
  result.session = session;
  result.scenario = *load_builtin("channel-1");
  result.grade = (*records.store().grades.newest(session))->grade;
  const Actor actor = reader.actor();
  return gather_report(result, &records.store(), &actor);
}

inline DrawnTooth no_picture() { return fail(PictureError::no_opengl, "EGL", "eglMakeCurrent 0x3002"); }

}  // namespace cusp::test
