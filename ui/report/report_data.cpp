#include "ui/report/report_data.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "scenarios/grading/grader.h"
#include "scenarios/grading/maxima.h"
#include "scenarios/metrics/evidence_patch.h"
#include "scenarios/shapes/target.h"
#include "ui/modules.h"
#include "ui/render/target_look.h"
#include "ui/session/operator_cut.h"
#include "ui/text/bur_text.h"
#include "ui/text/failure_text.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"

namespace cusp::ui {
namespace {

struct ReportText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::Report)
};

constexpr double kCrownMm = 4.0;  // below the specimen's top: the part of a molar that is drilled

QImage image_of(const Picture& picture) {
  const QImage view(picture.rgba.data(), picture.width, picture.height, picture.width * 4, QImage::Format_RGBX8888);
  return view.convertToFormat(QImage::Format_RGB32);
}

std::vector<std::optional<QPointF>> places_of(const Picture& picture) {
  std::vector<std::optional<QPointF>> out;
  for (const auto& at : picture.places_px) out.push_back(at ? std::optional(QPointF(at->x, at->y)) : std::nullopt);
  return out;
}

}  // namespace

namespace {

/// Of the score, as the grade was stored; 0 without such a criterion.
double measured_points(const Grade& stored, const std::string& id) {
  const auto criterion = std::ranges::find(stored.criteria, id, &CriterionGrade::id);
  return criterion == stored.criteria.end() ? 0 : points_of_score(stored, id, criterion->points);
}

QString remark_head(const SignedStatement& s, const Grade& stored, const SessionResult& result) {
  switch (s.kind) {
    case StatementKind::comment:
    case StatementKind::withdrawal:
    case StatementKind::self_assessment: return {};
    case StatementKind::override_points: {
      const double before = measured_points(stored, s.criterion);
      return ReportText::tr("%1: %2 instead of %3 point(s)", nullptr, point_forms(before))
          .arg(metric_name(s.criterion, &result.scenario.target, tissue_names_of(result)), format_points(points_of_score(stored, s.criterion, s.points.value_or(0))), format_points(before));
    }
    case StatementKind::override_critical: return ReportText::tr("Does not count: %1").arg(critical_name(s.criterion));
    case StatementKind::confirmation: return ReportText::tr("Result confirmed");
    case StatementKind::release: return ReportText::tr("Result released");
  }
  return {};
}

template <class Range, class Field, class Value>
bool among(const Range& range, Field field, const Value& value) {
  return std::ranges::find(range, value, field) != std::ranges::end(range);
}

bool changes_result(const SignedStatement& s) {
  return s.kind == StatementKind::override_points || s.kind == StatementKind::override_critical;
}

/// Keeps the first reason. A right that the reader lacks is none, nor is what the records never held.
void note_unread(ReportData& data, const StorageFailure& why) {
  const bool is_reason = why.code != StorageError::not_allowed && why.code != StorageError::not_found;
  if (is_reason && !data.unread) data.unread = why;
}

/// Comments first come from older programs, then everything that is stated.
void add_remarks(ReportData& data, Store& store, const Actor& reader, const SessionDetails& details) {
  std::vector<Remark>& out = data.remarks;
  const auto name_of = [&](UserId id) {
    const auto account = store.accounts.find(id);
    return account ? QString::fromStdString(account->name) : QString();
  };
  const auto statements = store.statements.of(reader, details.row.session);
  if (!statements) note_unread(data, statements.error());
  for (const Comment& c : details.comments) {
    const bool stated = statements && std::ranges::any_of(*statements, [&](const SignedStatement& s) { return s.id == c.id; });
    if (!stated) out.push_back({{}, name_of(c.author), local_time(c.at_utc_us), {}, QString::fromStdString(c.text), c.place_mm, false});
  }
  if (!statements || !details.grade) return;
  for (const SignedStatement& s : in_force(*statements)) {
    if (s.kind == StatementKind::self_assessment) continue;  // it stands beside the criteria
    if (s.grade && *s.grade != details.grade->stored.number) continue;
    const bool of_procedure = s.kind == StatementKind::confirmation || s.kind == StatementKind::release;
    if (of_procedure && !may(reader.role, Action::comment)) continue;
    const QString head = remark_head(s, details.grade->stored.grade, data.result);
    const bool superseded = changes_result(s) && !among(details.grade->overrides, &SignedStatement::id, s.id);
    out.push_back({s.id, name_of(s.author), local_time(s.at_utc_us), superseded ? ReportText::tr("%1 (superseded)").arg(head) : head,
                   QString::fromStdString(s.text), s.place_mm, superseded});
  }
}

/// Points that count in place of measured ones, with who changed them and why.
std::vector<PointsChange> changes_of(Store& store, const EffectiveGrade& counts) {
  std::vector<PointsChange> out;
  const Grade& stored = counts.stored.grade;
  for (const SignedStatement& s : counts.overrides) {
    if (s.kind != StatementKind::override_points) continue;
    const auto account = store.accounts.find(s.author);
    const QString who = account ? QString::fromStdString(account->name) : QString();
    const double before = measured_points(stored, s.criterion);
    //: %1: points that count, %2: measured points, %3: an examiner, %4: the reason.
    out.push_back({s.criterion, ReportText::tr("%1 instead of %2 point(s), changed by %3: %4", nullptr, point_forms(before))
                                    .arg(format_points(points_of_score(stored, s.criterion, s.points.value_or(0))), format_points(before), isolate(who), isolate(QString::fromStdString(s.text)))});
  }
  return out;
}

/// Times of the burs, and the peak force unless a criterion measured it.
void add_use(ReportData& data, Store& store) {
  if (const auto chunks = store.traces.chunks(data.result.session)) {
    BurUse use;
    for (const ChunkInfo& chunk : *chunks) {
      const auto inputs = store.traces.inputs(data.result.session, chunk.number);
      if (inputs) use.add(*inputs);
      if (!inputs && inputs.error().where == "thinned") data.thinned = describe(inputs.error()).what;
    }
    data.burs = use.spans();
  }
  if (data.peak_push_n) return;
  if (const auto seconds = store.metrics.over_time(data.result.session); seconds && !seconds->empty()) {
    double peak = 0;
    for (const MetricsRow& row : *seconds) peak = std::max(peak, row.metrics.force_peak_n);
    data.peak_push_n = peak;
  }
}

void add_before(ReportData& data, Store& store, const Actor& reader) {
  const auto note = [&data](const StorageFailure& why) {
    note_unread(data, why);
    data.before_read = false;
  };
  const auto best = store.history.best_before(reader, data.result.session);
  if (!best) return note(best.error());
  if (!*best) return;
  const auto earlier = store.history.details(reader, (*best)->session);
  if (!earlier) return note(earlier.error());
  if (!earlier->grade) return;
  data.before = earlier->grade->grade;
  data.before_when = local_time((*best)->started_utc_us);
}

bool changed_by_hand(const ReportData& data, const CriterionGrade& c) { return among(data.changes, &PointsChange::criterion, c.id); }

}  // namespace

const TissueNames& tissue_names_of(const SessionResult& result) {
  static const TissueNames none;
  return result.volume ? result.volume->specimen().names() : none;
}

ReportData gather_report(const SessionResult& result, Store* store, const Actor* reader) {
  ReportData data;
  data.result = result;
  const bool kept = store && reader && !result.session.is_nil();
  const auto details = kept ? store->history.details(*reader, result.session) : Stored<SessionDetails>(SessionDetails{});
  if (kept && details && details->grade) {
    data.counts = details->grade;
    if (!details->grade->overrides.empty()) data.result.grade = details->grade->grade;
    data.changes = changes_of(*store, *details->grade);
  }
  mark_counted_with_target(data.result.grade, result.scenario.rubric);  // the records do not hold this flag
  for (CriterionGrade& c : data.result.grade.criteria)
    if (changed_by_hand(data, c)) c.counts_with_target = false;
  data.critical = critical_events(data.result.grade, store, result.session);
  data.title = local(result.scenario.title);
  for (const Measure& m : result.measures) {
    if (m.metric == "force_peak" && m.measured) data.peak_push_n = m.value;
  }
  for (const CriterionGrade& c : result.grade.criteria) {
    if (c.id == "force_peak" && c.measure.measured) data.peak_push_n = c.measure.value;
  }
  if (!kept) return data;
  if (!details) note_unread(data, details.error());
  if (details) {
    add_remarks(data, *store, *reader, *details);
    data.released = details->row.released;
    data.of_reader = details->row.student == reader->id;
    if (!details->session.header.exercise.empty()) data.drawn_tooth = result.scenario.specimen.seed;
    auto own = store->statements.self_assessment(*reader, result.session);
    if (own) data.own = std::move(*own);
    if (!own) note_unread(data, own.error());
    // An assessment is marked without the name.
    data.student = details->row.kind == SessionKind::assessment && details->session.assignment
                       ? ReportText::tr("Candidate %1")
                             .arg(QString::fromStdString(candidate_number(*details->session.assignment, details->row.student)))
                       : QString::fromStdString(details->row.student_name);
    data.when = local_time(details->row.started_utc_us);
    data.kind = details->row.kind;
    data.attempt = details->row.attempt;
    data.exercise_version = details->row.version_number;
  }
  add_use(data, *store);
  add_before(data, *store, *reader);
  return data;
}

QString critical_circumstances(const ReportData& data, const CriticalEvent& event) {
  QStringList parts;
  const std::vector<Bur>& burs = data.result.scenario.instruments;
  if (event.at_s) {
    const auto at_us = static_cast<std::uint64_t>(std::max(0.0, *event.at_s) * 1e6);
    const auto in_use = std::ranges::find_if(data.burs, [&](const BurSpan& span) { return span.from_us < at_us && at_us <= span.to_us; });
    if (in_use != data.burs.end() && in_use->bur < burs.size()) parts += ReportText::tr("Bur %1").arg(bur_text(burs[in_use->bur]));
  }
  const TargetShape shape(data.result.scenario.target);
  // Damage of a neighbour is not as deep as it lies below the target's plane.
  if (event.key == "pulp_exposure" && event.place_mm && shape.has_plane() && event.place_mm->z < shape.top_mm())
    parts += ReportText::tr("%1 deep").arg(format({shape.top_mm() - event.place_mm->z, std::nullopt, u"mm"_qs, 1}));
  return parts.join(ReportText::tr(", "));
}

std::vector<Advice> next_time(const ReportData& data) {
  std::vector<Advice> out;
  for (const CriticalEvent& event : data.critical) {
    const QString how = critical_circumstances(data, event);
    out.push_back({critical_text(event, data.result.scenario.specimen),
                   ReportText::tr("This fails the attempt, whatever its points.") + (how.isEmpty() ? how : u' ' + how + u'.'),
                   critical_advice(event.key), event.place_mm, true, event.key});
  }
  const Grade& grade = data.result.grade;
  for (const LossReason& reason : loss_reasons(grade)) {
    if (!reason.critical.empty()) continue;
    const CriterionGrade& c = grade.criteria[reason.criterion];
    if (c.reason_code == "little_drilled" || changed_by_hand(data, c)) continue;
    const QString head = lost_text(c, reason.lost, &data.result.scenario.target, tissue_names_of(data.result));
    out.push_back({head, reason_text(c) + u'.', advice_text(c), c.measure.where_mm,
                   c.points < c.points_max / 2, c.id});
  }
  return out;
}

QString no_advice_text(const ReportData& data) {
  const Grade& grade = data.result.grade;
  const bool changed = std::ranges::any_of(loss_reasons(grade), [&](const LossReason& reason) {
    return reason.critical.empty() && changed_by_hand(data, grade.criteria[reason.criterion]);
  });
  if (changed) return ReportText::tr("Each criterion without its full points was changed by hand; the remarks give the reasons.");
  const auto brings_points = [](const CriterionGrade& c) { return c.points_max > 0; };
  if (std::ranges::all_of(grade.criteria, brings_points)) return ReportText::tr("Every criterion has its full points.");
  return std::ranges::any_of(grade.criteria, brings_points) ? ReportText::tr("Every marked criterion has its full points.")
                                                            : ReportText::tr("No criterion could be marked.");
}

QString occasion_text(const ReportData& data, Medium medium) {
  if (cut_at_once(data.result)) return operator_name(data.result.operator_name);
  if (of_a_file(data.result)) return ReportText::tr("A volume from a file");
  if (data.attempt == 0) return data.unread ? ReportText::tr("The records of this attempt could not be read") : ReportText::tr("Nothing of this attempt is kept");
  const QString when = medium == Medium::paper ? format_date_time_zone(data.when) : format_day_time(data.when);
  return ReportText::tr("%1 · %2, attempt %3").arg(when, kind_name(data.kind)).arg(data.attempt);
}

QString circumstances_text(const ReportData& data) {
  if (cut_at_once(data.result)) {
    return ReportText::tr("%1, its cuts made at once: time, force and heat are not measured").arg(operator_name(data.result.operator_name));
  }
  if (of_a_file(data.result)) return ReportText::tr("Time, force and heat are not measured");
  QStringList parts;
  parts += duration_text(data.result.seconds);
  if (data.peak_push_n) parts += ReportText::tr("peak force %1").arg(format({*data.peak_push_n, std::nullopt, u"N"_qs, 1}));
  parts += device_name(data.result.device.device_class);
  if (data.exercise_version > 0) parts += ReportText::tr("version %1 of the exercise").arg(data.exercise_version);
  //: A tooth that an assessment drew for one candidate; the number makes it again.
  if (data.drawn_tooth) parts += ReportText::tr("drawn tooth, seed %1").arg(*data.drawn_tooth);
  if (data.result.stiffness_share < 1.0) {
    parts += ReportText::tr("tissues at %1 of their stiffness")
                 .arg(format({data.result.stiffness_share * 100, std::nullopt, u"%"_qs, 0}));
  }
  if (data.unread) parts += ReportText::tr("parts of the records could not be read");
  return parts.join(u" · "_qs);
}

QStringList burs_used_text(const ReportData& data) {
  constexpr int kMostSpans = 4;  // of a line; with more changes the line ends in a remark
  //: %1: the sentence that says when the recording was thinned.
  if (!data.thinned.isEmpty()) return {ReportText::tr("%1 When each bur was used is no longer known.").arg(data.thinned)};
  QStringList lines;
  const std::vector<Bur>& burs = data.result.scenario.instruments;
  for (std::size_t i = 0; i < burs.size(); ++i) {
    QStringList spans;
    int more = 0;
    for (const BurSpan& span : data.burs) {
      if (span.bur != i || span.cutting_us == 0) continue;
      if (spans.size() == kMostSpans) {
        ++more;
        continue;
      }
      const auto clock = [](std::uint64_t us) { return format_clock(static_cast<double>(us) * 1e-6); };
      //: From one moment of an attempt to another, as "1:12 to 3:05".
      spans += ReportText::tr("%1 to %2").arg(clock(span.from_us), clock(span.to_us));
    }
    if (spans.isEmpty()) continue;
    if (more > 0) spans += ReportText::tr("and %n more", nullptr, more);
    //: A bur, and when it was used.
    lines += ReportText::tr("Bur %1: %2").arg(bur_text(burs[i]), spans.join(ReportText::tr(", ")));
  }
  return lines;
}

QString own_assessment_text(const ReportData& data) {
  if (!data.own) return {};
  if (data.own->skipped()) return ReportText::tr("Own assessment: skipped");
  const RatedPoints points = rated_points(*data.own, data.result.grade);
  return ReportText::tr("Own assessment: %1 of 100 on %n rated criterion(s), measured %2", nullptr, points.criteria)
      .arg(format_points(std::round(points.own)), format_points(std::round(points.measured)));
}

DrawnTooth draw_report_tooth(const SessionResult& result, const DrawingOrder& order) {
  if (!result.volume) return fail(PictureError::drawing, "volume", "no volume");
  const TargetLook look(result.scenario.target, result.scenario.leeway, result.volume->specimen_ptr());
  PictureRequest request;
  request.width_px = request.height_px = order.side_px;
  request.colouring = Colouring::deviation;
  request.deviation = look.deviation();
  request.leeway_mm = result.scenario.leeway.side_mm;
  request.view = PresetView::occlusal;
  // The crown fills the picture; roots show no cut.
  const Grid& grid = result.volume->grid();
  const Vec3 top = grid.centre_mm(grid.size);
  request.look_at = {{grid.origin_mm.x, grid.origin_mm.y, top.z - kCrownMm}, top};
  request.scenery = scenery_of(result.scenario.specimen);
  if (!order.places.empty()) {
    const EvidencePatches patches(std::make_shared<const Reference>(result.scenario, result.volume->specimen_ptr()), result.volume);
    for (const auto& [where_mm, metric] : order.places) {
      const EvidencePatch patch = patches.of(metric);
      request.closeups_mm.push_back(shown_place(metric, patch, where_mm));
      request.closeup_marks.push_back(marks_of(patch));
      if (request.places_mm.size() < order.numbered) request.places_mm.push_back(request.closeups_mm.back());
    }
  }
  const auto picture = draw_tooth(*result.volume, request);
  if (!picture) return std::unexpected(picture.error());
  ToothDrawing out{image_of(*picture), places_of(*picture), {}};
  for (const Picture& closeup : picture->closeups) out.closeups.push_back({image_of(closeup), places_of(closeup).front()});
  return out;
}

QString picture_failure_text(const PictureFailure& failure) {
  const QString cause = isolate(QString::fromStdString(failure.detail.empty() ? failure.where : failure.detail));
  if (failure.code == PictureError::no_opengl) return ReportText::tr("The tooth could not be drawn: OpenGL 3.3 did not start (%1).").arg(cause);
  return ReportText::tr("The tooth could not be drawn (%1).").arg(cause);
}

}  // namespace cusp::ui
