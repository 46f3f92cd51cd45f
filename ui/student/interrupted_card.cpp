#include "ui/student/interrupted_card.h"

#include <QBoxLayout>
#include <QDateTime>
#include <QLabel>
#include <QPushButton>

#include "ui/render/opengl_allowed.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

/// "It broke off after 1:12 min, with 8.4 mm³ cut. All of that is kept." An assessment shows no volumes.
QString how_far(Store& store, const HistoryRow& row) {
  const QString time = duration_text(static_cast<double>(row.elapsed_us) * 1e-6);
  if (row.kind == SessionKind::assessment) return InterruptedCard::tr("It broke off after %1. All of it is kept.").arg(time);
  const auto removed = store.metrics.removed(row.session);
  if (!removed) return InterruptedCard::tr("It broke off after %1. All of it is kept.").arg(time);  // how much was cut is not known
  double mm3 = 0;
  for (const RemovedTissue& tissue : *removed) mm3 += tissue.mm3;
  if (!(mm3 > 0)) return InterruptedCard::tr("It broke off after %1, before anything was cut.").arg(time);
  return InterruptedCard::tr("It broke off after %1, with %2 cut. All of that is kept.")
      .arg(time, format({mm3, std::nullopt, QStringLiteral("mm3"), 1}));
}

QString why_not_on(InterruptedWay way, const HistoryRow& row, const std::string& device_class) {
  if (way == InterruptedWay::other_device) {
    return InterruptedCard::tr("It was cut with: %1. This station drills with: %2. To continue it here, ask the staff to choose the first one on the page Device.")
        .arg(device_name(row.device_class), device_name(device_class));
  }
  if (way == InterruptedWay::volume_kept) {
    return InterruptedCard::tr("An older version of Cusp ended it without a grade, so it cannot be continued.");
  }
  return InterruptedCard::tr("A scripted operator cut it, so it cannot be continued by hand.");
}

}  // namespace

Stored<InterruptedWay> way_of(Store& store, const HistoryRow& row, const std::string& device_class) {
  const auto session = store.sessions.find(row.session);
  if (!session) return std::unexpected(session.error());
  if (session->header.engine_version != kEngineVersion) return InterruptedWay::other_engine;
  if (session->operator_name != kUserOperator) return InterruptedWay::scripted;
  const auto kept = store.traces.keeps_volume(row.session);
  if (!kept) return std::unexpected(kept.error());
  if (*kept) return InterruptedWay::volume_kept;
  return row.device_class == device_class ? InterruptedWay::resume : InterruptedWay::other_device;
}

InterruptedCard::InterruptedCard(Store& store, const HistoryRow& row, InterruptedWay way, const std::string& device_class,
                                 ButtonKind kind, QWidget* parent)
    : Card(row.kind == SessionKind::assessment ? tr("Interrupted assessment") : tr("Interrupted attempt"),
           format_day_time(local_time(row.started_utc_us)), parent) {
  setAccessibleName(row.kind == SessionKind::assessment ? tr("Interrupted assessment") : tr("Interrupted attempt"));
  auto* line = new QHBoxLayout;
  line->setSpacing(px(12));
  body()->addLayout(line);
  auto* sign = new QLabel;
  sign->setPixmap(icon_pixmap(u"pause"_qs, Ink::look, 20, devicePixelRatioF()));
  line->addWidget(sign, 0, Qt::AlignTop);
  auto* text = new QVBoxLayout;
  text->setSpacing(px(2));
  line->addLayout(text, 1);
  QLabel* title = make_label(tr("%1, attempt %2").arg(local(row.title), QString::number(row.attempt)), TextRole::section, Weight::bold);
  title->setWordWrap(true);
  text->addWidget(title);
  QString remark = how_far(store, row);
  if (way != InterruptedWay::resume) {
    remark += u' ' + why_not_on(way, row, device_class);
  } else if (!opengl_allowed()) {
    remark += u' ' + ToothView::pictures_off();
  }
  QLabel* what = make_label(remark, TextRole::body, Weight::regular, "text2");
  what->setWordWrap(true);
  text->addWidget(what);
  auto* acts = new QHBoxLayout;
  acts->setSpacing(px(12));
  acts->setContentsMargins(0, px(8), 0, 0);
  text->addLayout(acts);
  const QString grade = row.kind == SessionKind::assessment ? tr("Hand in") : tr("Grade as it stands");
  if (way == InterruptedWay::resume) {
    primary_ = make_large_button(tr("Continue"), kind, u"play"_qs);
    primary_->setEnabled(opengl_allowed());
    connect(primary_, &QPushButton::clicked, this, &InterruptedCard::resume_wanted);
    acts->addWidget(primary_);
    QPushButton* second = make_large_button(grade, ButtonKind::standard);
    connect(second, &QPushButton::clicked, this, &InterruptedCard::grade_wanted);
    acts->addWidget(second);
  } else {
    primary_ = make_large_button(grade, kind);
    connect(primary_, &QPushButton::clicked, this, &InterruptedCard::grade_wanted);
    acts->addWidget(primary_);
  }
  primary_->setAutoDefault(true);
  acts->addStretch();
}

}  // namespace cusp::ui
