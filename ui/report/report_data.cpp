#include "ui/report/report_data.h"

#include <QCoreApplication>
#include <algorithm>

#include "ui/app/burr_words.h"
#include "ui/app/sentences.h"
#include "ui/render/snapshot.h"
#include "ui/render/target_look.h"
#include "ui/widgets/format.h"

namespace cusp {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(cusp::Report)
};

QDateTime moment(std::int64_t utc_us) { return QDateTime::fromMSecsSinceEpoch(utc_us / 1000, Qt::UTC).toLocalTime(); }

}  // namespace

ReportData gather_report(const RunResult& result, Store* store, const Actor* reader) {
  ReportData data;
  data.result = result;
  data.title = local(result.scenario.title);
  for (const Measure& m : result.measures) {
    if (m.metric == "force_peak" && m.measured) data.peak_push_n = m.value;
  }
  for (const CriterionGrade& c : result.grade.criteria) {
    if (c.id == "force_peak" && c.measure.measured) data.peak_push_n = c.measure.value;
  }
  if (!store || !reader || result.session.is_nil()) return data;
  if (const auto details = store->history.details(*reader, result.session)) {
    data.student = QString::fromStdString(details->row.student_name);
    data.when = moment(details->row.started_utc_us);
    data.kind = details->row.kind;
    data.go = details->row.go;
  }
  if (const auto chunks = store->traces.chunks(result.session)) {
    BurrUse use;
    for (const ChunkInfo& chunk : *chunks)
      if (const auto inputs = store->traces.inputs(result.session, chunk.number)) use.add(*inputs);
    data.burrs = use.spans();
  }
  if (!data.peak_push_n) {
    if (const auto seconds = store->metrics.over_time(result.session); seconds && !seconds->empty()) {
      double peak = 0;
      for (const MetricsRow& row : *seconds) peak = std::max(peak, row.metrics.force_peak_n);
      data.peak_push_n = peak;
    }
  }
  const auto best = store->history.best_before(*reader, result.session);
  if (best && *best) {
    if (const auto grade = store->grades.newest((*best)->session); grade && *grade) {
      data.before = (*grade)->grade;
      data.before_when = moment((*best)->started_utc_us);
    }
  }
  return data;
}

std::vector<const CriterionGrade*> lost_points(const Grade& grade) {
  std::vector<const CriterionGrade*> lost;
  for (const CriterionGrade& c : grade.criteria) {
    if (c.points_max - c.points >= kLeastLoss) lost.push_back(&c);
  }
  const auto follows = [](const CriterionGrade* c) { return c->reason_code == "little_drilled"; };
  std::stable_sort(lost.begin(), lost.end(), [&](const CriterionGrade* a, const CriterionGrade* b) {
    if (follows(a) != follows(b)) return follows(b);
    return a->points_max - a->points > b->points_max - b->points;
  });
  return lost;
}

QString occasion_text(const ReportData& data) {
  if (data.go == 0) return Words::tr("Nothing of this go is kept");
  return Words::tr("%1 · %2, go %3").arg(format_day_time(data.when), kind_name(data.kind)).arg(data.go);
}

QString circumstances_text(const ReportData& data) {
  QStringList parts;
  parts += Words::tr("%1 min").arg(format_clock(data.result.seconds));
  if (data.peak_push_n) parts += Words::tr("peak push %1").arg(format({*data.peak_push_n, std::nullopt, u"N"_qs, 1}));
  parts += device_name(data.result.device.device_class);
  if (data.result.stiffness_share < 1.0) {
    parts += Words::tr("tissues at %1 of their stiffness")
                 .arg(format({data.result.stiffness_share * 100, std::nullopt, u"%"_qs, 0}));
  }
  return parts.join(u" · "_qs);
}

QStringList burrs_used_text(const ReportData& data) {
  constexpr int kMostSpans = 4;  // of a line; a go with more changes says so
  QStringList lines;
  const std::vector<Burr>& burrs = data.result.scenario.instruments;
  for (std::size_t i = 0; i < burrs.size(); ++i) {
    QStringList spans;
    int more = 0;
    for (const BurrSpan& span : data.burrs) {
      if (span.burr != i) continue;
      if (spans.size() == kMostSpans) {
        ++more;
        continue;
      }
      const auto clock = [](std::uint64_t us) { return format_clock(static_cast<double>(us) * 1e-6); };
      //: From one moment of a go to another, as "1:12 to 3:05".
      spans += Words::tr("%1 to %2").arg(clock(span.from_us), clock(span.to_us));
    }
    if (spans.isEmpty()) continue;
    if (more > 0) spans += Words::tr("and %n more", nullptr, more);
    //: A burr, and when it was used.
    lines += Words::tr("Burr %1: %2").arg(burr_text(burrs[i]), spans.join(Words::tr(", ")));
  }
  return lines;
}

QImage draw_report_tooth(const RunResult& result, int side_px) {
  if (!result.volume) return {};
  const TargetLook look(result.scenario.target, result.scenario.leeway);
  PictureRequest request;
  request.width_px = request.height_px = side_px;
  request.colouring = Colouring::deviation;
  request.deviation = look.deviation();
  request.leeway_mm = result.scenario.leeway.side_mm;
  request.view = PresetView::occlusal;
  request.scenery = scenery_of(result.scenario.specimen);
  const auto picture = draw_tooth(*result.volume, request);
  if (!picture) return {};
  const QImage view(picture->rgba.data(), picture->width, picture->height, picture->width * 4, QImage::Format_RGBX8888);
  return view.convertToFormat(QImage::Format_RGB32);
}

}  // namespace cusp
