#include "ui/editor/audit_page.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "ui/text/audit_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kSide = 16;  // px at 100 %, as in the other forms

QLabel* figure(const QString& text, const QString& name) {
  QLabel* out = make_label(text);
  out->setAlignment(Qt::AlignTrailing | Qt::AlignTop);
  out->setAccessibleName(name);
  return out;
}

/// A difference, with its sign.
QString signed_number(double value, int decimals) {
  const QString text = format_number(value, decimals);
  return value > 0 && text != format_number(0, decimals) ? u'+' + text : text;
}

constexpr double kLeastShare = 0.04, kLeastElapsed_s = 5.0;  // from which the rest is reckoned [M]

const char* ink_of(Verdict verdict) { return verdict == Verdict::not_needed ? "look" : "text2"; }

}  // namespace

QString share_and_rest(double share, double elapsed_s) {
  const QString percent = QLocale().toString(qRound(100 * share)) + QChar(0x00A0) + u'%';
  if (share < kLeastShare || elapsed_s < kLeastElapsed_s) return percent;
  const double rest_min = elapsed_s * (1.0 - share) / share / 60.0;
  //: %1: a share in per cent, %2: a number
  if (rest_min < 1.0) return AuditPage::tr("%1, less than a minute left").arg(percent);
  return AuditPage::tr("%1, about %2 min left").arg(percent, QLocale().toString(static_cast<int>(std::ceil(rest_min))));
}

AuditPage::AuditPage(EditorModel& model, std::function<AuditRunner(const std::string& folder)> runner_of, QWidget* parent)
    : QWidget(parent), model_(model), runner_of_(std::move(runner_of)), job_(new AuditJob(this)) {
  setAccessibleName(tr("Audit"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(px(kSide), px(12), px(kSide), px(16));
  column->setSpacing(px(8));
  column->addWidget(make_label(tr("What this exercise costs"), TextRole::section, Weight::bold));
  about_ = make_label(tr("Scripted operators drill the exercise once for each choice below, with that choice left out or halved. That takes "
                         "minutes, between neighbouring teeth hours; you can go on working meanwhile."),
                      TextRole::caption, Weight::regular, "text2");
  about_->setWordWrap(true);
  column->addWidget(about_);
  measure_ = make_button(tr("Measure"), ButtonKind::standard, u"chart"_qs);
  auto* row = new QHBoxLayout;
  row->addWidget(measure_);
  row->addStretch();
  column->addLayout(row);
  busy_place_ = new QVBoxLayout;
  column->addLayout(busy_place_);
  aside_ = make_label({}, TextRole::caption, Weight::regular, "text2");
  aside_->setWordWrap(true);
  column->addWidget(aside_);
  table_place_ = new QVBoxLayout;
  column->addLayout(table_place_);
  legend_ = make_label(tr("µs: of each update of 1 ms, more or less than now. Score: the largest change of an attempt."), TextRole::caption,
                       Weight::regular, "text2");
  legend_->setWordWrap(true);
  column->addWidget(legend_);
  leanest_title_ = make_label(tr("Leanest that marks the same"), TextRole::section, Weight::bold);
  column->addWidget(leanest_title_);
  leanest_ = make_label({});
  leanest_->setWordWrap(true);
  column->addWidget(leanest_);
  use_ = make_button(tr("Use the leanest"), ButtonKind::standard);
  auto* under = new QHBoxLayout;
  under->addWidget(use_);
  under->addStretch();
  column->addLayout(under);
  column->addStretch();
  connect(measure_, &QPushButton::clicked, this, &AuditPage::measure);
  connect(use_, &QPushButton::clicked, this, &AuditPage::use_leanest);
  connect(&model_, &EditorModel::changed, this, &AuditPage::follow_model);
  follow_job();
  show_report();
}

void AuditPage::follow_job() {
  connect(job_, &AuditJob::progressed, this, [this](double share) {
    if (busy_) busy_->set_progress(share, share_and_rest(share, static_cast<double>(since_.elapsed()) / 1000));
  });
  connect(job_, &AuditJob::done, this, [this](const std::shared_ptr<const AuditReport>& report) {
    stop();
    model_.now_tried(report->scenario);
    report_ = report;
    show_report();
    announce(this, leanest_->text());
  });
  connect(job_, &AuditJob::failed, this, [this](const AuditFailure& failure) {
    stop();
    report_.reset();
    show_report();
    const Message message = describe(failure);
    aside_->setText(message.line());
    aside_->show();
    announce(this, aside_->text());
  });
}

AuditPage::~AuditPage() = default;

void AuditPage::measure() {
  stop();
  measure_->setEnabled(false);
  busy_ = new Busy;
  busy_place_->addWidget(busy_);
  busy_->start(tr("Measuring"), Busy::Cancel::offered);
  connect(busy_, &Busy::cancelled, this, [this] {
    job_->cancel();
    stop();
  });
  since_.start();
  job_->start(model_.scenario(), {}, runner_of_(model_.folder()));
}

/// The progress is hidden; the last report stays.
void AuditPage::stop() {
  if (busy_) {
    busy_->hide();
    busy_->deleteLater();
    busy_ = nullptr;
  }
  follow_model();
}

void AuditPage::use_leanest() {
  if (!report_ || !report_->changed()) return;
  const Scenario& leaner = report_->leanest;
  model_.end_gesture();
  model_.stack().beginMacro(tr("Leanest model"));
  model_.set_specimen(leaner.specimen, model_.scenario().tissues);
  for (const std::string& key : report_->scenario.phenomena) {
    if (std::ranges::find(leaner.phenomena, key) != leaner.phenomena.end()) continue;
    if (key.starts_with("spindle-")) {
      model_.set_handpiece({});
    } else {
      model_.set_phenomenon(key, EditorModel::Listed::no);
    }
  }
  model_.stack().endMacro();
  model_.end_gesture();
}

void AuditPage::follow_model() {
  measure_->setEnabled(!job_->running());
  if (!report_) return list_choices();
  Scenario now = model_.scenario();
  now.version = report_->scenario.version;  // publishing changes nothing else
  const bool same = now == report_->scenario;
  use_->setEnabled(same && report_->changed());
  const int attempts = static_cast<int>(report_->operators.size());
  aside_->setText(same ? tr("Each choice was left out or halved once, with %n scripted attempt(s) each.", nullptr, attempts)
                       : tr("The exercise was changed since this was measured."));
}

/// What the next measurement will leave out or halve.
void AuditPage::list_choices() {
  std::vector<Choice> choices = choices_of(model_.scenario());
  if (table_ != nullptr && !listed_.empty() && choices == listed_ && model_.tissue_names() == listed_names_) return;
  listed_ = std::move(choices);
  listed_names_ = model_.tissue_names();  // known once the tooth is read
  show_table();
}

void AuditPage::show_report() {
  const bool there = report_ != nullptr;
  for (QWidget* part : std::initializer_list<QWidget*>{aside_, leanest_title_, leanest_, use_}) part->setVisible(there);
  if (!there) listed_.clear();
  follow_model();
  if (!there) return;
  leanest_->setText(leanest_sentence(*report_, model_.tissue_names()));
  use_->setVisible(report_->changed());
  show_table();
}

void AuditPage::add_line(QGridLayout& grid, const Line& line) {
  const int at = grid.rowCount();
  grid.addWidget(make_rule(), at, 0, 1, 4);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(0);
  QLabel* title = make_label(line.name);
  title->setWordWrap(true);
  texts->addWidget(title);
  if (!line.verdict.isEmpty()) texts->addWidget(make_label(line.verdict, TextRole::caption, Weight::regular, line.ink));
  grid.addLayout(texts, at + 1, 0);
  grid.addWidget(figure(line.us, tr("%1: microseconds").arg(line.name)), at + 1, 1);
  grid.addWidget(figure(line.mb, tr("%1: megabytes").arg(line.name)), at + 1, 2);
  grid.addWidget(figure(line.score, tr("%1: change of the score").arg(line.name)), at + 1, 3);
}

/// Before the measurement it holds what will be measured.
void AuditPage::show_table() {
  delete table_;
  table_ = new QWidget;
  auto* grid = new QGridLayout(table_);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(px(10));
  grid->setVerticalSpacing(px(4));
  grid->setColumnStretch(0, 1);
  const QString heads[] = {tr("Choice"), tr("µs"), tr("MB"), tr("Score")};
  for (int i = 0; i < 4; ++i) {
    QLabel* head = make_label(heads[i], TextRole::caption, Weight::bold, "text2");
    if (i > 0) head->setAlignment(Qt::AlignTrailing);
    grid->addWidget(head, 0, i);
  }
  const QString open(QChar(0x2013));  // not measured yet
  if (!report_)
    for (const Choice& choice : listed_) add_line(*grid, {choice_name(choice, model_.tissue_names()), {}, "text2", open, open, open});
  else
    add_results(*grid);
  table_place_->addWidget(table_);
}

void AuditPage::add_results(QGridLayout& grid) {
  const auto mb = [](const ModelResult& r) { return static_cast<double>(r.cost.bytes) / 1e6; };
  const ModelResult& now = report_->as_set;
  add_line(grid, {tr("As it is set"), tr("for comparison"), "text2", format_number(now.cost.us_a_tick, 0), format_number(mb(now), 0), {}});
  for (const AuditRow& row : report_->rows) {
    Line line{choice_name(row.choice, model_.tissue_names()), verdict_name(row.verdict), ink_of(row.verdict), {}, {}, {}};
    if (row.result) {
      line.us = signed_number(row.result->cost.us_more, 0);
      line.mb = signed_number(mb(*row.result) - mb(now), 0);
      line.score = row.change.measures_alike ? signed_number(row.change.score, 1) : tr("needed");
    }
    add_line(grid, line);
  }
}

}  // namespace cusp::ui
