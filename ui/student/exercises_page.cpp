#include "ui/student/exercises_page.h"

#include <QBoxLayout>

#include "ui/app/sentences.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp {

ExercisesPage::ExercisesPage(Store& store, const Actor& actor, QWidget* parent) : QWidget(parent) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(16));
  outer->addWidget(new PageHead(tr("Exercises"), tr("Enter opens the briefing")));
  const auto course = load_course(store, actor);
  if (!course) {
    const Told told = tell(course.error());
    outer->addWidget(new EmptyState(u"warning"_qs, told.what, told.more, {}, Ink::bad), 1);
    return;
  }
  if (!course->unreadable.empty()) {
    auto* band = new Band;
    outer->addWidget(band);
    band->show_message(Band::Kind::look, tr("%n exercise(s) cannot be read.", nullptr, static_cast<int>(course->unreadable.size())),
                       tr("The others are below. Publish them again from the editor."));
  }
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  table_ = new Table;
  table_->setAccessibleName(tr("Exercises"));
  auto* model = new CourseModel(course->rows, this);
  table_->setModel(model);
  table_->set_stretch_column(CourseModel::kExercise);
  bool due = false;
  for (const CourseRow& row : course->rows) due = due || row.due_utc_us.has_value();
  table_->setColumnHidden(CourseModel::kDue, !due);
  table_->choose_row(std::max(course->next(), 0));
  card->body()->addWidget(table_);
  outer->addWidget(card, 1);
  const auto open = [this, model](const QModelIndex& index) { Q_EMIT briefing_wanted(model->row(index.row()).exercise); };
  connect(table_, &Table::row_opened, this, open);
  connect(table_, &QTableView::clicked, this, [open](const QModelIndex& index) {
    if (index.column() == CourseModel::kOpen) open(index);
  });
  setFocusProxy(table_);
}

}  // namespace cusp
