#include "ui/admin/log_page.h"

#include <QApplication>
#include <QBoxLayout>
#include <QComboBox>
#include <QDateEdit>
#include <QHeaderView>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>
#include <algorithm>

#include "ui/text/audit_log_text.h"
#include "ui/text/failure_text.h"
#include "ui/text/incident_text.h"
#include "ui/text/names.h"
#include "ui/widgets/busy.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/head_row.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kEntriesAtOnce = 200;     // a page of the table
constexpr int kLookMs = 100;            // between two looks at how far a verification is
constexpr int kMostWho = 180, kMostAbout = 220;  // px at 100 %: a longer name is elided, and What stays on the screen
constexpr int kBetweenDays = -1;        // data of the period that the two dates set

QDateEdit* make_day(const QString& name, const QDate& day) {
  auto* field = new QDateEdit(day);
  field->setLocale(QLocale());  // the language may be another than when the window was made
  field->setCalendarPopup(true);
  field->setDisplayFormat(date_pattern());
  field->setAccessibleName(name);
  return field;
}

std::int64_t begin_us(const QDate& day) { return day.startOfDay().toMSecsSinceEpoch() * 1000; }

}  // namespace

LogPage::LogPage(Store& store, const Actor& actor, const Ports& ports, QWidget* parent)
    : QWidget(parent), store_(store), actor_(actor), ports_(ports), model_(new LogModel(this)), look_(new QTimer(this)) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(12));
  auto* head = new PageHead(tr("Audit log"));
  verify_ = make_button(tr("Verify now"), ButtonKind::primary, u"shield"_qs);
  QPushButton* csv = make_button(tr("Export CSV"), ButtonKind::standard, u"export"_qs, QKeySequence::Save);
  head->buttons()->addWidget(csv);
  head->buttons()->addWidget(verify_);
  outer->addWidget(head);
  outer->addWidget(make_filters());
  band_ = new Band;
  outer->addWidget(band_);
  QWidget* entries = make_table();
  unread_ = make_unread_band(table_, [this] { model_->rowCount() == 0 ? read() : model_->fetch_again(); });
  outer->addWidget(unread_);
  busy_ = new Busy;
  busy_->hide();
  outer->addWidget(busy_);
  outer->addWidget(make_export_progress());
  outer->addWidget(entries, 1);
  connect(csv, &QPushButton::clicked, this, &LogPage::export_csv);
  connect(verify_, &QPushButton::clicked, this, &LogPage::verify);
  connect(busy_, &Busy::cancelled, this, &LogPage::cancel_verification);
  connect(busy_, &Busy::shown, this, [this] {
    if (window()->focusWidget() == verify_) busy_->focus_cancel();
  });
  connect(look_, &QTimer::timeout, this, &LogPage::show_progress);
  fill_people();
  read();
  for (QComboBox* box : {kind_, person_, period_}) connect(box, &QComboBox::currentIndexChanged, this, &LogPage::read);
  for (QDateEdit* day : {first_day_, last_day_}) connect(day, &QDateEdit::dateChanged, this, &LogPage::read);
  setFocusProxy(table_);
}

QWidget* LogPage::make_filters() {
  auto* bar = new QWidget;
  auto* row = new HeadRow(HeadRow::Kind::buttons);
  bar->setLayout(row);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(8));
  kind_ = make_choice(tr("Kind"));
  person_ = make_choice(tr("Person"));
  period_ = make_choice(tr("Date"));
  kind_->addItem(tr("All kinds"));
  for (int i = 0; i < kLogKinds; ++i) kind_->addItem(log_kind_name(static_cast<LogKind>(i)), i);
  period_->addItem(tr("All dates"));
  for (const int days : {1, 7, 30, 365}) period_->addItem(tr("Last %n day(s)", nullptr, days), days);
  period_->addItem(tr("Between two days"), kBetweenDays);
  for (QComboBox* box : {kind_, person_, period_}) row->addWidget(box);
  days_ = new QWidget;
  auto* days = new QHBoxLayout(days_);
  days->setContentsMargins(0, 0, 0, 0);
  days->setSpacing(px(8));
  const QDate today = ports_.now().date();
  first_day_ = make_day(tr("First day"), today.addDays(-30));
  last_day_ = make_day(tr("Last day"), today);
  days->addWidget(first_day_);
  days->addWidget(make_label(u"–"_qs));
  days->addWidget(last_day_);
  row->addWidget(days_);
  return bar;
}

QWidget* LogPage::make_table() {
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  table_ = new Table;
  table_->setAccessibleName(tr("Entries of the audit log"));
  table_->setModel(model_);
  table_->set_stretch_column(LogModel::kWhat);
  for (const int column : {LogModel::kWho, LogModel::kAbout}) table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::Interactive);
  below_ = new QStackedWidget;
  below_->addWidget(table_);
  auto* none = new EmptyState(u"list"_qs, tr("No entry fits"), tr("The log has no entry of this kind, person and date."), tr("Show all entries"));
  connect(none, &EmptyState::acted, this, &LogPage::show_all);
  below_->addWidget(none);
  card->body()->addWidget(below_);
  return card;
}

/// The people of the filter.
void LogPage::fill_people() {
  person_->addItem(tr("All people"));
  person_->addItem(u"Cusp"_qs, QString::fromStdString(UserId{}.text()));
  std::vector<Account> people = read_names();
  std::ranges::sort(people, stands_before, &Account::name);
  for (const Account& account : people) person_->addItem(QString::fromStdString(account.name), QString::fromStdString(account.id.text()));
}

/// Another window may have added or erased a person since.
std::vector<Account> LogPage::read_names() {
  auto people = store_.accounts.list(actor_);
  if (!people) {
    show_failure(people.error());
    return {};
  }
  names_.clear();
  for (const Account& account : *people) names_[account.id.uuid] = QString::fromStdString(account.name);
  if (const auto cohorts = store_.cohorts.list()) {
    for (const Cohort& cohort : *cohorts) names_[cohort.id.uuid] = QString::fromStdString(cohort.name);
  }
  names_[store_.context().station] = tr("this station");
  model_->set_names(names_);
  return std::move(*people);
}

QString LogPage::message() const {
  for (const Band* band : {band_, unread_})
    if (band->isVisibleTo(this)) return band->text();
  return {};
}
bool LogPage::shows_none() const { return below_->currentIndex() == 1; }

AuditFilter LogPage::filter() const {
  AuditFilter out;
  if (const QVariant kind = kind_->currentData(); kind.isValid()) out.actions = actions_of(static_cast<LogKind>(kind.toInt()));
  if (const QString id = person_->currentData().toString(); !id.isEmpty()) out.person = UserId::parse(id.toStdString());
  const QVariant days = period_->currentData();
  if (!days.isValid()) return out;
  if (days.toInt() == kBetweenDays) {
    out.from_utc_us = begin_us(first_day_->date());
    out.to_utc_us = begin_us(last_day_->date().addDays(1));
  } else {
    out.from_utc_us = ports_.now().addDays(-days.toInt()).toMSecsSinceEpoch() * 1000;
  }
  return out;
}

std::optional<std::vector<AuditEntry>> LogPage::newest_before(std::int64_t number) {
  auto entries = store_.audit.list(actor_, 1, number);
  if (entries) return std::move(*entries);
  show_failure(entries.error());
  return std::nullopt;
}

void LogPage::read() {
  days_->setVisible(period_->currentData() == kBetweenDays);
  read_names();
  unread_->clear();
  model_->begin([this, shown = filter()](std::int64_t before_number) -> std::optional<std::vector<AuditEntry>> {
    auto entries = store_.audit.list(actor_, kEntriesAtOnce, before_number, shown);
    if (entries) return std::move(*entries);
    unread_->show_message(Band::Kind::bad,
                          before_number == INT64_MAX ? tr("The entries could not be read.")
                                                     : tr("Older entries are not shown: they could not be read."),
                          describe(entries.error()).line());
    return std::nullopt;
  });
  below_->setCurrentIndex(model_->rowCount() == 0 && !model_->failed() ? 1 : 0);  // after a failure it is not known that none fits
  for (const int column : {LogModel::kNumber, LogModel::kWhen, LogModel::kWho, LogModel::kAbout}) table_->resizeColumnToContents(column);
  table_->setColumnWidth(LogModel::kProof, px(140));
  table_->setColumnWidth(LogModel::kWho, std::min(table_->columnWidth(LogModel::kWho), px(kMostWho)));
  table_->setColumnWidth(LogModel::kAbout, std::min(table_->columnWidth(LogModel::kAbout), px(kMostAbout)));
  table_->choose_row(0);
}

void LogPage::show_all() {
  for (QComboBox* box : {kind_, person_, period_}) box->setCurrentIndex(0);
}

/// verify_ stays enabled, as with ButtonWait, until Cancel takes the focus: a disabled button hands it on.
void LogPage::verify() {
  if (verifying()) return;
  const auto newest = newest_before(INT64_MAX);
  if (!newest) return;
  entries_ = newest->empty() ? 0 : newest->front().number + 1;
  progress_ = std::make_shared<LogProgress>();
  band_->clear();
  busy_->start(tr("Verifying the audit log"), Busy::Cancel::offered);
  look_->start(kLookMs);
  task_ = verify_log(records_of(store_), actor_, progress_, [self = QPointer(this), asked = progress_](Stored<Verification> proof) {
    auto shared = std::make_shared<Stored<Verification>>(std::move(proof));
    QMetaObject::invokeMethod(
        qApp,
        [self, asked, shared] {
          if (self && self->progress_ == asked) self->show_verified(*shared);
        },
        Qt::QueuedConnection);
  });
}

void LogPage::show_progress() {
  if (!verifying() || entries_ == 0) return;
  const std::int64_t holding = progress_->holding;
  busy_->set_progress(static_cast<double>(holding) / static_cast<double>(entries_),
                      tr("%1 of %2 entries").arg(QLocale().toString(static_cast<qlonglong>(holding)), QLocale().toString(static_cast<qlonglong>(entries_))));
}

void LogPage::cancel_verification() {
  const bool on_cancel = busy_->isAncestorOf(window()->focusWidget());
  progress_.reset();
  task_ = BackgroundTask();
  look_->stop();
  busy_->finish();
  if (on_cancel) verify_->setFocus(Qt::OtherFocusReason);  // a button that is hidden hands the focus on
}

/// "It says: Lena Brandt, Account disabled."; empty if the entry is gone.
QString LogPage::entry_line(std::int64_t number) {
  const auto found = newest_before(number + 1);
  if (!found || found->empty() || found->front().number != number) return {};
  return tr("It says: %1, %2.").arg(actor_text(found->front(), names_), entry_text(found->front()));
}

void LogPage::show_verified(const Stored<Verification>& proof) {
  const std::int64_t holding = progress_->holding;
  cancel_verification();
  if (!proof) return show_failure(proof.error());
  if (proof->intact()) {
    model_->set_proof({entries_, holding});
    band_->show_message(Band::Kind::good, tr("The log is whole: %n entry(ies) hold.", nullptr, static_cast<int>(holding)),
                        tr("Verified %1.").arg(ports_.now().toString(u"HH:mm:ss"_qs)));
    return;
  }
  const ChainFinding& first = proof->findings.front();
  if (first.table != "audit_log") {  // the signature over the end
    model_->set_proof({entries_, 0});
    band_->show_message(Band::Kind::bad, tr("The end of the log does not hold: entries were changed, added or taken out."), finding_text(first));
    return;
  }
  model_->set_proof({entries_, first.row, first.row});
  const std::int64_t number = shown_number(first.row);
  const QString what = first.code == FindingCode::row_missing ? tr("Entry %1 is missing: the chain breaks there.").arg(number)
                                                              : tr("Entry %1 breaks the chain: it was changed.").arg(number);
  band_->show_message(Band::Kind::bad, what, (tr("The entries before it hold.") + u' ' + entry_line(first.row)).trimmed());
}

void LogPage::show_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

}  // namespace cusp::ui
