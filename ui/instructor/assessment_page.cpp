#include "ui/instructor/assessment_page.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QKeySequence>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <algorithm>
#include <utility>

#include "ui/student/course.h"
#include "ui/text/failure_text.h"
#include "ui/text/gradebook_text.h"
#include "ui/text/language.h"
#include "ui/text/names.h"
#include "ui/widgets/bar_top.h"
#include "ui/widgets/format.h"
#include "ui/widgets/menu_button.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/save_csv.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

/// One that runs has no report yet.
bool has_report(const CandidateRow& row) { return row.attempt && row.attempt->state != SessionState::running; }

/// The examiner's own attempt is another's to release.
bool may_be_released(const CandidateRow& row, UserId examiner) {
  return row.attempt && row.student != examiner && !row.attempt->released && row.grade && !row.grade->needs_confirmation();
}

bool waits_for_confirmation(const CandidateRow& row) {
  return row.attempt && !row.attempt->released && row.grade && row.grade->needs_confirmation();
}

QString marked_text(const CandidateRow& row) {
  if (!row.grade_read) return CandidatesModel::tr("could not be read");
  if (!row.grade) return {};
  if (row.grade->needs_confirmation()) return CandidatesModel::tr("to be confirmed");
  if (row.grade->confirmation) return CandidatesModel::tr("confirmed");
  return row.grade->overrides.empty() ? CandidatesModel::tr("by the program") : CandidatesModel::tr("changed");
}

/// "25 % more time, large text".
QString adjustment_text(const Adjustment& adjustment) {
  QStringList out;
  if (adjustment.extra_time_percent > 0) out += CandidatesModel::tr("%1 % more time").arg(adjustment.extra_time_percent);
  if (adjustment.large_text) out += CandidatesModel::tr("large text");
  return out.join(u", "_qs);
}

}  // namespace

void CandidatesModel::set_rows(std::vector<CandidateRow> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int CandidatesModel::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(rows_.size()); }
int CandidatesModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant CandidatesModel::data(const QModelIndex& index, int role) const {
  const CandidateRow& r = row(index.row());
  const int column = index.column();
  if (role == BoldRole) return column == kCandidate;
  if (role == Qt::TextAlignmentRole && column == kScore) return static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter);
  if (role == IconRole && column == kOpen && has_report(r)) return u"chevron_right"_qs;
  if (role == Qt::AccessibleTextRole && column == kOpen) return has_report(r) ? tr("Report") : QString();
  if (role == QuietRole) return !r.attempt && column != kCandidate;
  if (role == ChipRole && column == kResult && r.attempt) return result_chip(*r.attempt);
  if (role == ChipRole && column == kMarked && !r.grade_read) return static_cast<int>(Chip::Kind::bad);
  if (role == ChipRole && column == kMarked && r.grade && r.grade->needs_confirmation()) return static_cast<int>(Chip::Kind::look);
  if (role != Qt::DisplayRole) return {};
  switch (column) {
    case kCandidate: return r.candidate;
    case kName: return r.name;
    case kAdjusted: return adjustment_text(r.adjustment);
    case kDate: return r.attempt ? format_day_time(local_time(r.attempt->started_utc_us)) : tr("not begun");
    case kScore: return r.attempt && r.attempt->score ? format_points(*r.attempt->score) : QString();
    case kResult: return r.attempt ? result_text(*r.attempt) : QString();
    case kMarked: return marked_text(r);
    case kReleased: return !r.attempt || !r.grade ? QString() : r.attempt->released ? tr("yes") : tr("no");
    default: return {};
  }
}

QVariant CandidatesModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole && section == kScore) return static_cast<int>(Qt::AlignTrailing | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kCandidate: return tr("Candidate");
    case kName: return tr("Name");
    case kAdjusted: return tr("Adjustments");
    case kDate: return tr("Begun");
    case kScore: return tr("Points");
    case kResult: return tr("Result");
    case kMarked: return tr("Marked");
    case kReleased: return tr("Released");
    default: return {};
  }
}

AssessmentPage::AssessmentPage(Store& store, const Actor& actor, AssignmentId assignment, const Ports& ports, QWidget* parent)
    : QWidget(parent), store_(store), actor_(actor), ports_(ports), model_(new CandidatesModel(this)) {
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Results of an assignment"));
  QString title, aside;
  const auto found = store.assignments.find(assignment);
  if (found) {
    assignment_ = *found;
    if (const auto version = store.scenarios.version(found->version)) title = local(version->title);
    aside = kind_name(found->kind);
    if (const auto cohorts = store.cohorts.list()) {
      const auto cohort = std::ranges::find(*cohorts, found->cohort, &Cohort::id);
      if (cohort != cohorts->end()) aside += u" · "_qs + QString::fromStdString(cohort->name);
    }
    if (!found->device_classes.empty()) aside += u" · "_qs + tr("only with %1").arg(device_names(found->device_classes));
    if (found->self_test_days) aside += u" · "_qs + self_test_age(*found->self_test_days);
    if (found->withdrawn) aside += u" · "_qs + tr("withdrawn");
    if (found->drawn_tooth) aside += u" · "_qs + drawn_tooth_text();
  }
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_bar(title));
  QVBoxLayout* body = nullptr;
  column->addWidget(make_scroll_page(&body), 1);
  QLabel* about = make_label(aside, TextRole::caption, Weight::regular, "text2");
  about->setWordWrap(true);
  body->addWidget(about);
  band_ = new Band;
  body->addWidget(band_);
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  table_ = new Table;
  table_->setAccessibleName(tr("Candidates"));
  table_->setModel(model_);
  table_->set_stretch_column(CandidatesModel::kMarked);
  table_->set_rows_shown(16);
  card->body()->addWidget(table_);
  card->body()->addWidget(make_adjustments());
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &AssessmentPage::show_chosen);
  body->addWidget(card);
  body->addStretch();
  connect(table_, &Table::row_opened, this, &AssessmentPage::open_chosen);
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& at) {
    if (at.column() == CandidatesModel::kOpen) open_chosen();
  });
  read();
  if (!found) show_failure(found.error());
  setFocusProxy(table_);
}

QWidget* AssessmentPage::make_bar(const QString& title) {
  const auto [bar, row] = make_bar_top();
  connect(add_way_back({bar, row}, tr("Back")), &QPushButton::clicked, this, &AssessmentPage::leave);
  add_title({bar, row}, title);
  // An assessment is marked without names.
  names_ = make_button(tr("Show names"), ButtonKind::quiet, u"person"_qs);
  names_->setCheckable(true);
  names_->setChecked(assignment_.kind == SessionKind::practice);
  names_->setVisible(assignment_.kind == SessionKind::assessment);
  connect(names_, &QPushButton::toggled, this, [this](bool on) { table_->setColumnHidden(CandidatesModel::kName, !on); });
  row->addWidget(names_);
  row->addWidget(make_gradebook_button());
  release_ = make_button(tr("Release results"), ButtonKind::primary, u"eye"_qs);
  if (assignment_.kind != SessionKind::assessment || !may(actor_.role, Action::assign)) release_->hide();
  connect(release_, &QPushButton::clicked, this, &AssessmentPage::release_all);
  row->addWidget(release_);
  return bar;
}

QPushButton* AssessmentPage::make_gradebook_button() {
  QPushButton* button = make_button(tr("Gradebook"), ButtonKind::standard, u"export"_qs);
  button->setToolTip(tr("Save the released results as a column for another system"));
  auto* menu = new QMenu(button);
  menu->addAction(tr("For Moodle"), this, [this] { export_gradebook(Gradebook::moodle); });
  menu->addAction(tr("For Canvas"), this, [this] { export_gradebook(Gradebook::canvas); });
  if (!may(actor_.role, Action::export_results)) button->hide();
  return put_menu(button, menu);
}

void AssessmentPage::export_gradebook(Gradebook system) {
  // The audit log names an export, so there is none before a file is chosen and written.
  const auto make = [this, system]() -> std::optional<CsvText> {
    const auto file = make_gradebook(store_.context(), actor_, assignment_.id, system, current_language().toStdString());
    if (!file) {
      show_failure(file.error());
      return std::nullopt;
    }
    const auto log = [this, file = *file] {
      const auto logged = log_gradebook(store_.context(), actor_, assignment_.id, file);
      if (!logged) show_failure(logged.error());
      return logged.has_value();
    };
    return CsvText{file->text, gradebook_text(*file).join(u' '), log};
  };
  save_csv(*band_, ports_, {tr("Save for the gradebook"), (system == Gradebook::moodle ? u"moodle-"_qs : u"canvas-"_qs) + ports_.now().toString(u"yyyy-MM-dd"_qs), make});
}

QWidget* AssessmentPage::make_adjustments() {
  extra_row_ = new QWidget;
  auto* row = new QHBoxLayout(extra_row_);
  row->setContentsMargins(px(8), px(4), px(8), px(4));
  row->setSpacing(px(8));
  extra_of_ = make_label({});
  extra_ = new NumberField;
  extra_->setRange(0, kMostExtraTimePercent);
  extra_->setDecimals(0);
  extra_->setSingleStep(5);
  extra_->setSuffix(u" %"_qs);
  extra_->setFixedWidth(px(96));
  large_ = new QCheckBox(tr("Large text"));
  large_->setToolTip(tr("Drilling screen and report at 150 % at least"));
  QPushButton* keep = make_button(tr("Keep the adjustment"), ButtonKind::standard, u"check"_qs);
  row->addWidget(extra_of_);
  row->addWidget(extra_);
  row->addWidget(large_);
  row->addWidget(keep);
  QLabel* from = make_label(tr("for attempts that begin from now on"), TextRole::body, Weight::regular, "text2");
  from->setWordWrap(true);
  row->addWidget(from, 1);
  connect(keep, &QPushButton::clicked, this, [this] { adjust(set_here()); });
  return extra_row_;
}

void AssessmentPage::show_chosen() {
  const int row = table_->chosen_row();
  const bool offered = row >= 0 && assignment_.kind == SessionKind::assessment && may(actor_.role, Action::assign);
  if (half_filled() && (row < 0 || model_->row(row).student != edited_->student)) return leave_adjustment([this] { show_chosen(); });
  extra_row_->setVisible(offered);
  if (!offered) return edited_.reset();
  show_adjustment(model_->row(row));
}

/// A list that is read anew keeps what is set here, unless another desk has changed it.
void AssessmentPage::show_adjustment(const CandidateRow& row) {
  const bool stays = edited_ && edited_->student == row.student && edited_->adjustment == row.adjustment;
  edited_ = {row.student, row.adjustment};
  const QString name = tr("Extra time of %1").arg(row.candidate);
  extra_of_->setText(name);
  extra_->setAccessibleName(name);
  if (stays) return;
  extra_->show_value(row.adjustment.extra_time_percent);
  large_->setChecked(row.adjustment.large_text);
}

Adjustment AssessmentPage::set_here() const { return {static_cast<int>(extra_->value()), large_->isChecked()}; }

bool AssessmentPage::half_filled() const { return edited_ && set_here() != edited_->adjustment; }

void AssessmentPage::leave_adjustment(std::function<void()> then) {
  ports_.ask(this, leave_form_question(), [self = QPointer(this), then = std::move(then)](bool yes) {
    if (!self || !self->edited_) return;
    if (yes) {
      self->edited_.reset();
      return then();
    }
    for (int row = 0; row < self->model_->rowCount(); ++row)
      if (self->model_->row(row).student == self->edited_->student) return self->table_->choose_row(row);
  });
}

void AssessmentPage::leave() {
  extra_->interpretText();  // a shortcut leaves the focus in the field
  if (!half_filled()) return Q_EMIT back_wanted();
  leave_adjustment([this] { Q_EMIT back_wanted(); });
}

void AssessmentPage::adjust(const Adjustment& adjustment) {
  const int row = table_->chosen_row();
  if (row < 0) return;
  const QString candidate = model_->row(row).candidate;
  const auto there = store_.assignments.adjustment(assignment_.id, model_->row(row).student);
  if (!there) return show_failure(there.error());
  if (*there != model_->row(row).adjustment) {
    read();
    return band_->show_message(Band::Kind::look, tr("The adjustment of %1 was changed at another desk meanwhile.").arg(candidate),
                               tr("It is shown as it is now. What you set here was not kept."));
  }
  const auto done = store_.assignments.adjust(actor_, assignment_.id, model_->row(row).student, adjustment);
  if (!done && done.error().code == StorageError::not_allowed && done.error().where == "assignment") {
    return band_->show_message(Band::Kind::look, tr("%1 is no longer in the cohort.").arg(candidate), tr("Nothing was changed."));
  }
  if (!done) return show_failure(done.error());
  read();
  const QString text = adjustment_text(adjustment);
  band_->show_message(Band::Kind::good, text.isEmpty() ? tr("%1 has no adjustment.").arg(candidate) : tr("%1 has %2.").arg(candidate, text), {});
}

QString AssessmentPage::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

void AssessmentPage::show_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

void AssessmentPage::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  read();
}

/// Fails if the adjustment cannot be read. A grade that cannot be read is marked as such.
Stored<void> AssessmentPage::complete(CandidateRow& row) {
  row.candidate = QString::fromStdString(candidate_number(assignment_.id, row.student));
  const auto adjustment = store_.assignments.adjustment(assignment_.id, row.student);
  if (!adjustment) return std::unexpected(adjustment.error());
  row.adjustment = *adjustment;
  if (row.attempt) {
    const auto details = store_.history.details(actor_, row.attempt->session);
    row.grade_read = details.has_value();
    if (details) row.grade = details->grade;
  }
  if (const auto account = store_.accounts.find(row.student)) row.name = QString::fromStdString(account->name);
  return {};
}

void AssessmentPage::read() {
  const auto attempts = store_.history.of_assignment(actor_, assignment_.id);
  if (!attempts) return show_failure(attempts.error());
  const auto students = store_.cohorts.students(assignment_.cohort);
  if (!students) return show_failure(students.error());
  const int before = table_->chosen_row();
  const auto same = [kept = before >= 0 ? std::optional(model_->row(before)) : std::nullopt](const CandidateRow& row) {
    if (!kept || row.student != kept->student) return false;
    return !kept->attempt || (row.attempt && row.attempt->session == kept->attempt->session);
  };
  std::vector<CandidateRow> rows;
  for (const HistoryRow& attempt : *attempts) rows.push_back({.student = attempt.student, .attempt = attempt});
  for (const UserId student : *students) {
    if (std::ranges::find(*attempts, student, &HistoryRow::student) == attempts->end()) rows.push_back({.student = student});
  }
  for (CandidateRow& row : rows) {
    // A row without its extra time would say that there is none, and the next adjustment would end it.
    if (const auto completed = complete(row); !completed) return show_failure(completed.error());
  }
  std::ranges::stable_sort(rows, {}, &CandidateRow::candidate);
  release_->setEnabled(std::ranges::any_of(rows, [this](const CandidateRow& row) { return may_be_released(row, actor_.id); }));
  const auto chosen = std::ranges::find_if(rows, same);
  const int row = chosen == rows.end() ? std::max(before, 0) : static_cast<int>(chosen - rows.begin());
  if (edited_ && std::ranges::find(rows, edited_->student, &CandidateRow::student) == rows.end()) edited_.reset();
  model_->set_rows(std::move(rows));
  table_->setColumnHidden(CandidatesModel::kName, !names_->isChecked());
  table_->choose_row(row);
  show_chosen();
}

void AssessmentPage::open_chosen() {
  const int row = table_->chosen_row();
  if (row >= 0 && has_report(model_->row(row))) Q_EMIT report_wanted(model_->row(row).attempt->session);
}

void AssessmentPage::release_all() {
  int ready = 0;
  for (int i = 0; i < model_->rowCount(); ++i) ready += may_be_released(model_->row(i), actor_.id) ? 1 : 0;
  ports_.ask(this,
             {tr("Release %n result(s)?", nullptr, ready),
              tr("Their students can then read points, criteria and remarks. Failed results that nobody has confirmed stay withheld."),
              tr("Release")},
             [this](bool yes) {
               if (yes) release_now();
             });
}

void AssessmentPage::release_now() {
  read();  // another desk may have marked or released while the question was open
  int released = 0, waiting = 0;
  for (int i = 0; i < model_->rowCount(); ++i) {
    const CandidateRow& row = model_->row(i);
    waiting += waits_for_confirmation(row) ? 1 : 0;
    if (!may_be_released(row, actor_.id)) continue;
    if (const auto done = store_.statements.release(actor_, row.attempt->session); !done) {
      if (done.error().code == StorageError::wrong_state) continue;  // another desk was faster
      show_failure(done.error());
      return read();
    }
    ++released;
  }
  read();
  band_->show_message(waiting > 0 ? Band::Kind::look : Band::Kind::good, tr("%n result(s) released.", nullptr, released),
                      waiting > 0 ? tr("%n failed result(s) wait for confirmation.", nullptr, waiting) : QString());
}

}  // namespace cusp::ui
