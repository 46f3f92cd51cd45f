#include "ui/admin/recordings_card.h"

#include <QBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "ui/admin/on_window.h"
#include "ui/text/failure_text.h"
#include "ui/text/incident_text.h"
#include "ui/text/thinning_text.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/number_field.h"

namespace cusp::ui {

namespace {

/// How many stay and why; the first attempt that does not verify by its id.
QString left_text(const ThinningReport& report) {
  QString text = kept_text(report.kept);
  if (!report.broken.empty()) text += u' ' + QString::fromStdString(report.broken.front().owner.text()) + QStringLiteral(": ") + finding_text(report.broken.front());
  return text;
}

}  // namespace

RecordingsCard::RecordingsCard(RecordsBeside records, const Actor& actor, const Ports& ports, QWidget* parent)
    : Card(tr("Recordings of practice"), {}, parent), records_(std::move(records)), actor_(actor), ports_(ports), run_(new WorkRun(this)) {
  found_ = make_label({});
  found_->setWordWrap(true);
  body()->addWidget(found_);
  auto* note = make_label(tr("Thinning takes out what a replay needs. Grade, report and final tooth stay, and verify. Assessments and "
                             "results that an examiner has stated something about stay whole."),
                          TextRole::body, Weight::regular, "text2");
  note->setWordWrap(true);
  body()->addWidget(note);
  days_ = new NumberField;
  days_->setRange(1, kMostThinAfterDays);
  days_->setDecimals(0);
  days_->setSuffix(tr(" days"));
  days_->show_value(kThinAfterDays);
  thin_ = make_button(tr("Thin recordings"), ButtonKind::erase);
  auto* row = new QHBoxLayout;
  row->addWidget(labelled(tr("Ended so many days ago, or more"), days_), 1);
  row->addWidget(thin_, 0, Qt::AlignBottom);
  body()->addLayout(row);
  body()->addWidget(run_->busy());
  connect(days_, &QDoubleSpinBox::valueChanged, this, &RecordingsCard::count);
  connect(thin_, &QPushButton::clicked, this, &RecordingsCard::thin);
  count();
}

int RecordingsCard::days() const { return static_cast<int>(days_->value()); }
QString RecordingsCard::found() const { return found_->text(); }
void RecordingsCard::choose_days(int days) { days_->setValue(days); }

void RecordingsCard::count() {
  found_->clear();
  thin_->setEnabled(false);
  counting_ = look_for_old_traces(records_, actor_, days(), [self = QPointer(this), asked = days()](Stored<OldTraces> old) {
    auto shared = std::make_shared<Stored<OldTraces>>(std::move(old));
    QMetaObject::invokeMethod(
        QCoreApplication::instance(),
        [self, asked, shared] {
          if (self && self->days() == asked) self->show_count(*shared);
        },
        Qt::QueuedConnection);
  });
}

void RecordingsCard::show_count(const Stored<OldTraces>& old) {
  if (!old) return report_failure(old.error());
  const int number = static_cast<int>(old->thinnable.size());
  found_->setText(number == 0 ? tr("No recording is that old.")
                              : tr("%n recording(s), %1", nullptr, number).arg(recording_size_text(old->bytes)));
  thin_->setEnabled(number > 0 && !working());
}

void RecordingsCard::begin(ThinningMode mode, ClockTrust trust) {
  auto progress = run_->start(mode == ThinningMode::dry_run ? tr("Verifying the attempts") : tr("Thinning recordings"),
                              [](std::size_t done, std::size_t all) { return tr("%1 of %2 attempts").arg(count_text(done), count_text(all)); });
  for (QWidget* part : {static_cast<QWidget*>(thin_), static_cast<QWidget*>(days_)}) part->setEnabled(false);
  auto then = mode == ThinningMode::dry_run ? on_window<Stored<ThinningReport>>(this, &RecordingsCard::ask_first)
                                            : on_window<Stored<ThinningReport>>(this, &RecordingsCard::show_thinned);
  task_ = thin_in_background(records_, actor_, {days(), mode, trust}, std::move(progress), std::move(then));
}

void RecordingsCard::end() {
  days_->setEnabled(true);
  thin_->setEnabled(true);
  run_->finish();
}

void RecordingsCard::thin() {
  if (!working()) begin(ThinningMode::dry_run);
}

void RecordingsCard::ask_first(const Stored<ThinningReport>& would) {
  end();
  if (!would) return report_failure(would.error());
  if (would->stopped) return;
  if (would->attempts == 0) {
    emit reported(Band::Kind::look, tr("Nothing can be thinned."), left_text(*would));
    return;
  }
  QString more = tr("%1 on the disk are given free. %2 It cannot be undone; backups made before still hold the recordings.")
                     .arg(recording_size_text(would->bytes), left_text(*would));
  if (would->doubt) more.prepend(clock_question_text(*would->doubt) + u' ');
  ports_.ask(this, {tr("Thin %n recording(s)?", nullptr, static_cast<int>(would->attempts)), more.simplified(), tr("Thin recordings"), true},
             [self = QPointer(this), trust = would->doubt ? ClockTrust::confirmed : ClockTrust::checked](bool yes) {
               if (self && yes && !self->working()) self->begin(ThinningMode::carry_out, trust);
             });
}

void RecordingsCard::show_thinned(const Stored<ThinningReport>& report) {
  end();
  count();
  if (!report || report->failed) {
    const Message why = describe(report ? *report->failed : report.error());
    const QString done = report ? thinned_text(*report, ThinningMode::carry_out) : tr("No recording was thinned.");
    emit reported(Band::Kind::bad, done, why.line() + u' ' + tr("The other recordings are whole."));
    return;
  }
  QString more = left_text(*report);
  if (report->stopped) more = tr("You stopped it; the other recordings are whole.") + u' ' + more;
  const bool broken = !report->broken.empty();
  emit reported(broken ? Band::Kind::bad : Band::Kind::good, thinned_text(*report, ThinningMode::carry_out), more);
}

void RecordingsCard::report_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  emit reported(Band::Kind::bad, message.what, message.more);
}

}  // namespace cusp::ui
