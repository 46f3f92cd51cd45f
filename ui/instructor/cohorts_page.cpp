#include "ui/instructor/cohorts_page.h"

#include <QBoxLayout>
#include <QGridLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <algorithm>
#include <set>

#include "ui/instructor/number_list.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/table.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr int kNarrow = 1020;     // px at 100 %; three columns need as much
constexpr int kNamedUnknown = 5;  // unknown numbers that the message names

}  // namespace

CohortsPage::CohortsPage(Store& store, const Actor& actor, const Ports& ports, QWidget* parent)
    : QWidget(parent),
      store_(store),
      actor_(actor),
      ports_(ports),
      cohorts_(new CohortsModel(this)),
      students_(new CohortStudentsModel(this)),
      assignments_(new AssignmentsModel(this)) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(12));
  auto* head = new PageHead(tr("Cohorts"));
  name_ = new QLineEdit;
  name_->setPlaceholderText(tr("Name of a new cohort"));
  name_->setAccessibleName(tr("Name of a new cohort"));
  name_->setFixedWidth(px(240));
  head->buttons()->addWidget(name_);
  QPushButton* make = make_button(tr("New cohort"), ButtonKind::standard, u"plus"_qs);
  head->buttons()->addWidget(make);
  outer->addWidget(head);
  band_ = new Band;
  outer->addWidget(band_);
  columns_ = new QGridLayout;
  columns_->setSpacing(px(16));
  columns_->setColumnStretch(1, 1);
  columns_->addWidget(make_list(), 0, 0);
  columns_->addWidget(make_students(), 0, 1);
  columns_->addWidget(make_assignments(), 1, 0, 1, 2);
  columns_->setRowStretch(0, 3);
  columns_->setRowStretch(1, 2);
  if (may(actor.role, Action::assign)) {
    if (auto list = load_exercises(store_)) {
      form_ = new AssignmentForm(std::move(list->exercises), ports_.now());
      connect(form_, &AssignmentForm::assign_wanted, this, &CohortsPage::assign);
      columns_->addWidget(form_, 0, 2, 2, 1, Qt::AlignTop);
    } else {
      show_failure(list.error());
    }
  }
  outer->addLayout(columns_, 1);
  const auto make_named = [this] { make_cohort(name_->text()); };
  connect(make, &QPushButton::clicked, this, make_named);
  connect(name_, &QLineEdit::returnPressed, this, make_named);
  read();
  connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &CohortsPage::show_chosen);
  if (form_ != nullptr) connect(list_->selectionModel(), &QItemSelectionModel::selectionChanged, form_, &AssignmentForm::enable_act);
  list_->choose_row(0);
  show_chosen();
  setFocusProxy(cohorts_->rowCount() > 0 ? static_cast<QWidget*>(list_) : name_);
}

/// A narrow page has what is assigned next below the rest.
void CohortsPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (form_ == nullptr) return;
  columns_->removeWidget(form_);
  if (width() < px(kNarrow)) {
    columns_->addWidget(form_, 2, 0, 1, 2, Qt::AlignTop | Qt::AlignLeft);
  } else {
    columns_->addWidget(form_, 0, 2, 2, 1, Qt::AlignTop);
  }
}

QString CohortsPage::message() const { return band_->isVisibleTo(this) ? band_->text() : QString(); }

QWidget* CohortsPage::make_list() {
  auto* card = new Card;
  card->setFixedWidth(px(268));  // the least name, the longest head of the other column, and a scroll bar
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  list_ = new Table;
  list_->setAccessibleName(tr("Cohorts"));
  list_->setModel(cohorts_);
  list_->set_stretch_column(CohortsModel::kName);
  below_ = new QStackedWidget;
  below_->addWidget(list_);
  below_->addWidget(new EmptyState(u"people"_qs, tr("No cohort yet"), tr("Make one with a name, for a year or a group.")));
  card->body()->addWidget(below_);
  return card;
}

QWidget* CohortsPage::make_students() {
  students_card_ = new Card(tr("Students"));
  students_card_->elide_aside();
  table_ = new Table;
  table_->setAccessibleName(tr("Students of the cohort"));
  table_->setModel(students_);
  table_->set_stretch_column(CohortStudentsModel::kName);
  students_card_->body()->addWidget(table_, 1);
  numbers_ = new QPlainTextEdit;
  numbers_->setPlaceholderText(tr("Student numbers, one a line; names may stand beside them"));
  numbers_->setAccessibleName(tr("Student numbers to add"));
  numbers_->setFixedHeight(px(72));
  numbers_->setTabChangesFocus(true);
  students_card_->body()->addWidget(numbers_);
  auto* row = new QHBoxLayout;
  add_ = make_button(tr("Add students"), ButtonKind::standard, u"plus"_qs);
  remove_ = make_button(tr("Take out"), ButtonKind::erase);
  row->addWidget(add_);
  row->addStretch();
  row->addWidget(remove_);
  students_card_->body()->addLayout(row);
  connect(add_, &QPushButton::clicked, this, [this] { add_numbers(numbers_->toPlainText()); });
  connect(remove_, &QPushButton::clicked, this, &CohortsPage::remove_chosen_student);
  const auto fit = [this] { remove_->setEnabled(table_->chosen_row() >= 0); };
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, fit);
  connect(students_, &QAbstractItemModel::modelReset, this, fit);
  return students_card_;
}

QWidget* CohortsPage::make_assignments() {
  assignments_card_ = new Card(tr("Assigned exercises"), QStringLiteral(" "));
  assignments_card_->wrap_aside();
  assigned_ = new Table;
  assigned_->setAccessibleName(tr("Assigned exercises"));
  assigned_->setModel(assignments_);
  assigned_->set_stretch_column(AssignmentsModel::kExercise);
  assignments_card_->body()->addWidget(assigned_);
  results_ = make_button(tr("Results"), ButtonKind::standard, u"chart"_qs);
  auto* row = new QHBoxLayout;
  withdraw_ = make_button(tr("Withdraw"), ButtonKind::erase);
  withdraw_->setVisible(may(actor_.role, Action::assign));
  row->addWidget(results_);
  row->addStretch();
  row->addWidget(withdraw_);
  assignments_card_->body()->addLayout(row);
  const auto open = [this] {
    if (assigned_->chosen_row() >= 0) Q_EMIT results_wanted(assignments_->row(assigned_->chosen_row()).assignment.id);
  };
  connect(results_, &QPushButton::clicked, this, open);
  connect(withdraw_, &QPushButton::clicked, this, &CohortsPage::withdraw_chosen_assignment);
  connect(assigned_, &Table::row_opened, this, open);
  connect(assigned_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &CohortsPage::fit_assignment);
  connect(assignments_, &QAbstractItemModel::modelReset, this, &CohortsPage::fit_assignment);
  fit_assignment();
  return assignments_card_;
}

/// The devices of the chosen assignment, and its start code for who invigilates.
void CohortsPage::fit_assignment() {
  const int row = assigned_->chosen_row();
  results_->setEnabled(row >= 0 && may(actor_.role, Action::see_all_results));
  const bool chosen = row >= 0 && may(actor_.role, Action::assign);
  withdraw_->setEnabled(chosen && !assignments_->row(row).assignment.withdrawn);
  QString code;
  if (chosen) {  // an interrupted attempt of a withdrawn one is resumed with it
    const auto known = store_.assignments.start_code(actor_, assignments_->row(row).assignment.id);
    if (!known) code = tr("The start code could not be read");
    if (known && !known->empty()) code = tr("Start code %1").arg(QString::fromStdString(*known));
  }
  QStringList aside;
  if (row >= 0 && !assignments_->row(row).assignment.device_classes.empty()) {
    aside += tr("only with %1").arg(device_names(assignments_->row(row).assignment.device_classes));
  }
  if (!code.isEmpty()) aside += code;
  assignments_card_->set_aside(aside.join(u" · "_qs));
}

void CohortsPage::show_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

void CohortsPage::show_unread(const StorageFailure& failure) {
  show_failure(failure);
  unread_ = message();
}

std::optional<Cohort> CohortsPage::chosen() {
  const int row = list_->chosen_row();
  if (row >= 0) return cohorts_->cohort(row);
  band_->show_message(Band::Kind::look, tr("No cohort is chosen."), tr("Make one with a name, for a year or a group."));
  return std::nullopt;
}

void CohortsPage::read() {
  auto list = store_.cohorts.list();
  if (!list) return show_failure(list.error());
  std::ranges::sort(*list, stands_before, &Cohort::name);
  const int row = list_->chosen_row();
  const std::optional<CohortId> kept = row >= 0 ? std::optional(cohorts_->cohort(row).id) : std::nullopt;
  const bool assigned = form_ != nullptr && !form_->act()->isEnabled();
  cohorts_->set_cohorts(std::move(*list));
  below_->setCurrentIndex(cohorts_->rowCount() == 0 ? 1 : 0);
  if (!kept) return;
  list_->choose_row(cohorts_->row_of(*kept));
  // Choosing a cohort enables the form's button, also the one that was chosen.
  if (const int now = list_->chosen_row(); assigned && now >= 0 && cohorts_->cohort(now).id == *kept) form_->disable_act();
}

bool CohortsPage::read_again() {
  const AssignmentId kept = assignments_->id_at(assigned_->chosen_row());
  read();
  show_chosen();
  assigned_->choose_row(assignments_->row_of(kept));
  read_exercises();
  return true;
}

bool CohortsPage::half_filled() const {
  return !name_->text().isEmpty() || !numbers_->toPlainText().isEmpty() || (form_ != nullptr && form_->changed());
}

void CohortsPage::show_chosen() {
  if (!unread_.isEmpty() && message() == unread_) band_->clear();
  unread_.clear();
  const int row = list_->chosen_row();
  for (QWidget* part : {static_cast<QWidget*>(numbers_), static_cast<QWidget*>(add_)}) part->setEnabled(row >= 0);
  if (form_ != nullptr) form_->setEnabled(row >= 0);
  if (row < 0) {
    students_->set_students({});
    assignments_->set_rows({});
    return;
  }
  const Cohort cohort = cohorts_->cohort(row);
  students_card_->set_aside(QString::fromStdString(cohort.name));
  // What stands there is of the cohort before: under this one's name it would be taken out and withdrawn.
  const auto show_none = [this](const StorageFailure& why) {
    students_->set_students({});
    assignments_->set_rows({});
    show_unread(why);
  };
  const auto inside = store_.cohorts.students(cohort.id);
  if (!inside) return show_none(inside.error());
  auto accounts = store_.accounts.list(actor_);
  if (!accounts) return show_none(accounts.error());
  const std::set<UserId> ids(inside->begin(), inside->end());
  std::erase_if(*accounts, [&](const Account& account) { return !ids.contains(account.id); });
  students_->set_students(std::move(*accounts));
  show_assignments();
}

void CohortsPage::show_assignments() {
  const auto list = store_.assignments.for_cohort(cohorts_->cohort(list_->chosen_row()).id);
  if (!list) {
    assignments_->set_rows({});
    return show_unread(list.error());
  }
  std::vector<AssignmentRow> rows;
  for (const Assignment& assignment : *list) {
    const auto version = store_.scenarios.version(assignment.version);
    rows.push_back({assignment, version ? version->title : LocalText{}});
  }
  const bool any_opens = std::ranges::any_of(rows, [](const AssignmentRow& row) { return row.assignment.opens_utc_us.has_value(); });
  assignments_->set_rows(std::move(rows));
  assigned_->setColumnHidden(AssignmentsModel::kOpens, !any_opens);
}

void CohortsPage::make_cohort(const QString& name) {
  const QString wanted = name.trimmed();
  if (wanted.isEmpty()) {
    band_->show_message(Band::Kind::bad, tr("A cohort needs a name."), {});
    name_->setFocus();
    return;
  }
  const auto made = store_.cohorts.create(actor_, wanted.toStdString());
  if (!made) {
    if (made.error().code != StorageError::duplicate) return show_failure(made.error());
    band_->show_message(Band::Kind::bad, tr("There is a cohort %1 already.").arg(wanted), {});
    return;
  }
  name_->clear();
  read();
  list_->choose_row(cohorts_->row_of(made->id));
  band_->show_message(Band::Kind::good, tr("The cohort %1 is made.").arg(wanted), tr("Paste the numbers of its students below the table."));
}

void CohortsPage::add_numbers(const QString& text) {
  const auto cohort = chosen();
  if (!cohort) return;
  if (text.trimmed().isEmpty()) {
    band_->show_message(Band::Kind::bad, tr("No student number is there to add."), tr("Type or paste the numbers, one a line."));
    numbers_->setFocus();
    return;
  }
  auto accounts = store_.accounts.list(actor_);
  if (!accounts) return show_failure(accounts.error());
  std::erase_if(*accounts, [](const Account& account) { return account.role != Role::student; });
  const auto inside = store_.cohorts.students(cohort->id);
  if (!inside) return show_failure(inside.error());
  const NumberList numbers = read_numbers(text, *accounts, {inside->begin(), inside->end()});
  std::vector<UserId> found;
  for (const Account& student : numbers.found) found.push_back(student.id);
  if (const auto added = store_.cohorts.add_all(actor_, cohort->id, found); !added) return show_failure(added.error());
  read_again();
  QStringList more;
  if (numbers.already > 0) more += tr("%n student(s) were in it already.", nullptr, numbers.already);
  if (!numbers.unknown.isEmpty()) {
    more += tr("No student has: %1.").arg(numbers.unknown.mid(0, kNamedUnknown).join(tr(", ")));
    if (numbers.unknown.size() > kNamedUnknown)
      more += tr("Nor %n more.", nullptr, static_cast<int>(numbers.unknown.size()) - kNamedUnknown);
  }
  // What was not found stays to be mended.
  numbers_->setPlainText(numbers.unknown.join(u'\n'));
  band_->show_message(numbers.unknown.isEmpty() ? Band::Kind::good : Band::Kind::look,
                      tr("%n student(s) added.", nullptr, static_cast<int>(numbers.found.size())), more.join(u' '));
}

void CohortsPage::remove_chosen_student() {
  const auto cohort = chosen();
  if (table_->chosen_row() < 0 || !cohort) return;
  const Account student = students_->student(table_->chosen_row());
  ports_.ask(this,
             {tr("Take %1 out of %2?").arg(QString::fromStdString(student.name), QString::fromStdString(cohort->name)),
              tr("Account and results are kept. What is assigned to the cohort no longer stands on the student's start page."),
              tr("Take out"), true},
             [this, student, cohort](bool yes) {
               if (!yes) return;
               const auto done = store_.cohorts.remove(actor_, cohort->id, student.id);  // not_found: another desk was faster
               if (!done && done.error().code != StorageError::not_found) return show_failure(done.error());
               read_again();
               band_->show_message(Band::Kind::good, tr("%1 is taken out.").arg(QString::fromStdString(student.name)), {});
             });
}

void CohortsPage::withdraw_chosen_assignment() {
  const int row = assigned_->chosen_row();
  if (row < 0) return;
  const Assignment chosen = assignments_->row(row).assignment;
  const QString title = local(assignments_->row(row).title);
  ports_.ask(this,
             {tr("Withdraw %1?").arg(title),
              tr("No further attempt can begin, and it no longer stands on the start pages of its students. Attempts that were begun can be "
                 "finished; their results are kept."),
              tr("Withdraw"), true},
             [this, chosen, title](bool yes) {
               if (!yes) return;
               const auto done = store_.assignments.withdraw(actor_, chosen.id);
               if (!done && done.error().code != StorageError::duplicate) return show_failure(done.error());
               show_assignments();
               band_->show_message(Band::Kind::good, tr("%1 is withdrawn.").arg(title), tr("It can be assigned again."));
             });
}

}  // namespace cusp::ui
