#include "ui/student/exercises_page.h"

#include <QBoxLayout>
#include <QCollator>
#include <QHeaderView>
#include <QLineEdit>
#include <QShortcut>
#include <QSortFilterProxyModel>
#include <QStackedWidget>
#include <algorithm>

#include "ui/text/failure_text.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

/// Sorts numbers by value and names by the language; numbers inside names count ("level 2" before "level 10").
class Sorted : public QSortFilterProxyModel {
 public:
  explicit Sorted(QObject* parent) : QSortFilterProxyModel(parent) {
    names_.setNumericMode(true);
    names_.setCaseSensitivity(Qt::CaseInsensitive);
    setFilterKeyColumn(CourseModel::kExercise);
    setFilterCaseSensitivity(Qt::CaseInsensitive);
  }

 protected:
  bool lessThan(const QModelIndex& a, const QModelIndex& b) const override {
    const QVariant left = a.data(SortRole), right = b.data(SortRole);
    if (left.userType() != QMetaType::QString) return left.toDouble() < right.toDouble();
    return names_.compare(left.toString(), right.toString()) < 0;
  }

 private:
  QCollator names_;
};

}  // namespace

ExercisesPage::ExercisesPage(Store& store, const Actor& actor, QWidget* parent) : QWidget(parent) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(16));
  auto* head = new PageHead(tr("Exercises"), tr("Enter opens the briefing"));
  outer->addWidget(head);
  const auto course = load_course(store, actor);
  if (!course) {
    const Message message = describe(course.error());
    outer->addWidget(new EmptyState(u"warning"_qs, message.what, message.more, {}, Ink::bad), 1);
    return;
  }
  if (!course->unreadable.empty()) {
    auto* band = new Band;
    outer->addWidget(band);
    band->show_message(Band::Kind::look, tr("%n exercise(s) cannot be read.", nullptr, static_cast<int>(course->unreadable.size())),
                       tr("The others are below. Publish them again from the editor."));
  }
  make_table(*course);
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  card->body()->addWidget(make_shown());
  outer->addWidget(card, 1);
  make_search();
  head->buttons()->addWidget(search_);
  setFocusProxy(table_);
}

void ExercisesPage::make_table(const Course& course) {
  table_ = new Table;
  table_->setAccessibleName(tr("Exercises"));
  model_ = new CourseModel(course.rows, this);
  sorted_ = new Sorted(this);
  sorted_->setSourceModel(model_);
  table_->setModel(sorted_);
  // Without a chosen column the order is that of the course; the third click on a head restores it.
  table_->horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
  table_->horizontalHeader()->setSortIndicatorClearable(true);
  table_->setSortingEnabled(true);
  table_->set_stretch_column(CourseModel::kExercise);
  const bool due = std::ranges::any_of(course.rows, [](const CourseRow& row) { return row.due_utc_us.has_value(); });
  table_->setColumnHidden(CourseModel::kDue, !due);
  table_->choose_row(std::max(course.next(), 0));
  connect(table_, &Table::row_opened, this, &ExercisesPage::open);
  connect(table_, &QTableView::clicked, this, [this](const QModelIndex& index) {
    if (index.column() == CourseModel::kOpen) open(index);
  });
}

QWidget* ExercisesPage::make_shown() {
  shown_ = new QStackedWidget;
  shown_->addWidget(table_);
  auto* none = new EmptyState(u"search"_qs, tr("No exercise fits"), tr("No exercise has this text in its name."),
                              tr("Show all exercises"));
  connect(none, &EmptyState::acted, this, [this] {
    search_->clear();
    table_->setFocus();
  });
  shown_->addWidget(none);
  return shown_;
}

void ExercisesPage::make_search() {
  search_ = new QLineEdit;
  search_->setPlaceholderText(tr("Find an exercise"));
  search_->setAccessibleName(tr("Find an exercise"));
  search_->addAction(icon(u"search"_qs, Ink::text2), QLineEdit::LeadingPosition);
  search_->setClearButtonEnabled(true);
  search_->setFixedWidth(px(240));
  connect(search_, &QLineEdit::textChanged, this, [this](const QString& text) {
    sorted_->setFilterFixedString(text.trimmed());
    shown_->setCurrentIndex(sorted_->rowCount() == 0 ? 1 : 0);
    if (table_->chosen_row() < 0) table_->choose_row(0);
  });
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    if (sorted_->rowCount() > 0) open(sorted_->index(std::max(table_->chosen_row(), 0), 0));
  });
  auto* find = new QShortcut(QKeySequence::Find, this);
  connect(find, &QShortcut::activated, search_, [this] { search_->setFocus(Qt::ShortcutFocusReason); });
}

void ExercisesPage::open(const QModelIndex& index) {
  Q_EMIT briefing_wanted(model_->row(sorted_->mapToSource(index).row()).exercise);
}

}  // namespace cusp::ui
