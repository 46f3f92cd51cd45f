#include "ui/instructor/exercise_card.h"

#include <QBoxLayout>
#include <QLabel>

#include "ui/student/briefing.h"
#include "ui/student/exercise_groups.h"
#include "ui/text/grade_text.h"
#include "ui/text/names.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

constexpr QSize kPicture{132, 96};  // px at 100 %
constexpr int kRadius = 4;

QLabel* line(TextRole role, Weight weight, const char* ink) {
  QLabel* out = make_label({}, role, weight, ink);
  out->setWordWrap(true);
  return out;
}

}  // namespace

ExerciseCard::ExerciseCard(QWidget* parent) : QFrame(parent) {
  set_kind(this, "card");
  setAccessibleName(tr("The chosen exercise"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(px(12), px(12), px(16), px(12));
  row->setSpacing(px(16));
  picture_ = new QLabel;
  picture_->setFixedSize(px(kPicture.width()), px(kPicture.height()));
  row->addWidget(picture_, 0, Qt::AlignTop);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(px(4));
  texts->addWidget(title_ = line(TextRole::section, Weight::bold, ""));
  texts->addWidget(facts_ = line(TextRole::body, Weight::regular, "text2"));
  texts->addWidget(use_ = line(TextRole::body, Weight::regular, ""));
  texts->addStretch();
  row->addLayout(texts, 1);
}

void ExerciseCard::show_exercise(const Scenario& exercise) {
  title_->setText(isolate(local(exercise.title)));
  QStringList facts{group_name(group_of(exercise))};
  if (const QString level = level_and_time_text(exercise); !level.isEmpty()) facts << level;
  facts << tr("pass mark %1").arg(format_points(exercise.rubric.pass));
  facts_->setText(facts.join(u" · "_qs) + u'\n' + tr("Burs: %1").arg(burs_text(exercise)));
}

void ExerciseCard::show_picture(const QImage& picture) { show_covering(picture_, picture, px(kRadius)); }

void ExerciseCard::show_use(const QString& use) { use_->setText(use); }

void ExerciseCard::fold(bool on) {
  picture_->setVisible(!on);
  facts_->setVisible(!on);
}

}  // namespace cusp::ui
