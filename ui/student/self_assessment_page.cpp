#include "ui/student/self_assessment_page.h"

#include <QAbstractButton>
#include <QBoxLayout>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "ui/text/grade_text.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

constexpr int kMostWidth = 800, kStepsWidth = 300;  // px at 100 %
constexpr OwnRating kSteps[] = {OwnRating::met, OwnRating::partly, OwnRating::not_met};

QString capital(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

}  // namespace

SelfAssessmentPage::SelfAssessmentPage(const Scenario& scenario, Then then, const TissueNames& tissues, QWidget* parent) : QWidget(parent) {
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Own assessment"));
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  QVBoxLayout* page = nullptr;
  outer->addWidget(make_scroll_page(&page));
  auto* inside = new QWidget;
  inside->setMaximumWidth(px(kMostWidth));
  auto* centred = new QHBoxLayout;
  centred->addStretch();
  centred->addWidget(inside, 100);
  centred->addStretch();
  page->addLayout(centred);
  page->addStretch();
  auto* column = new QVBoxLayout(inside);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(12));
  column->addWidget(make_label(tr("How did it go?"), TextRole::page_title, Weight::bold));
  QLabel* why = make_label(tr("Rate each criterion before you see what was measured. It earns and costs no points."), TextRole::body,
                           Weight::regular, "text2");
  why->setWordWrap(true);
  column->addWidget(why);
  band_ = new Band;
  column->addWidget(band_);
  add_rows(*column, scenario, tissues);
  add_buttons(*column, then);
  count();
  if (!rows_.empty()) setFocusProxy(rows_.front().steps->button(0));
}

void SelfAssessmentPage::add_rows(QVBoxLayout& column, const Scenario& scenario, const TissueNames& tissues) {
  auto* card = new Card;
  card->setAccessibleName(tr("Criteria"));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(px(16));
  grid->setVerticalSpacing(px(8));
  grid->setColumnStretch(0, 1);
  for (const Criterion& c : scenario.rubric.criteria) {
    const QString name = metric_name(c.metric, &scenario.target, tissues);
    auto* text = new QVBoxLayout;
    text->setSpacing(0);
    for (QLabel* label : {make_label(name), make_label(tr("Full points: %1").arg(wanted_text(c)), TextRole::caption, Weight::regular, "text2")}) {
      label->setWordWrap(true);
      text->addWidget(label);
    }
    QStringList steps;
    for (const OwnRating step : kSteps) steps += capital(own_rating_name(step));
    auto* row = new Segments(steps, nullptr, Segments::Begin::none_chosen);
    row->setFixedWidth(px(kStepsWidth));
    for (int i = 0; i < steps.size(); ++i) row->button(i)->setAccessibleName(tr("%1: %2").arg(name, own_rating_name(kSteps[i])));
    connect(row, &Segments::changed, this, &SelfAssessmentPage::count);
    const int at = static_cast<int>(rows_.size());
    grid->addLayout(text, at, 0);
    grid->addWidget(row, at, 1, Qt::AlignVCenter);
    rows_.push_back({c.metric, row});
  }
  card->body()->addLayout(grid);
  column.addWidget(card);
}

void SelfAssessmentPage::add_buttons(QVBoxLayout& column, Then then) {
  auto* line = new QHBoxLayout;
  line->setSpacing(px(12));
  counted_ = make_label({}, TextRole::body, Weight::regular, "text2");
  counted_->setWordWrap(true);
  skip_ = make_large_button(tr("Skip"), ButtonKind::quiet);
  skip_->setToolTip(tr("The records then say that you rated nothing"));
  go_on_ = make_large_button(then == Then::result ? tr("Show the result") : tr("Hand in"), ButtonKind::primary);
  line->addWidget(counted_, 1);
  line->addWidget(skip_);
  line->addWidget(go_on_);
  column.addLayout(line);
  connect(go_on_, &QPushButton::clicked, this, [this] { Q_EMIT decided(own()); });
  connect(skip_, &QPushButton::clicked, this, [this] { failed_ ? Q_EMIT passed_over() : Q_EMIT decided({}); });
}

SelfAssessment SelfAssessmentPage::own() const {
  SelfAssessment out;
  for (const Row& row : rows_) {
    if (const int step = row.steps->chosen(); step >= 0) out.ratings[row.criterion] = kSteps[step];
  }
  return out;
}

void SelfAssessmentPage::count() {
  const auto rated = own().ratings.size();
  go_on_->setEnabled(rated > 0);
  //: Of an own assessment: %1 of %2 criteria have a rating.
  counted_->setText(tr("%1 of %2 rated. Keys 1, 2 and 3 rate a row and go on.")
                        .arg(format_number(static_cast<double>(rated), 0), format_number(static_cast<double>(rows_.size()), 0)));
}

void SelfAssessmentPage::show_failure(const Message& message) {
  failed_ = true;
  band_->show_message(Band::Kind::bad, message.what, message.more);
  skip_->setText(tr("Go on without it"));
  skip_->setToolTip({});
}

void SelfAssessmentPage::focus_row(std::size_t index) {
  const Segments& steps = *rows_[index].steps;
  steps.button(std::max(steps.chosen(), 0))->setFocus(Qt::TabFocusReason);
}

/// The row with the focus, else the first one without a rating.
void SelfAssessmentPage::rate_next(int step) {
  const auto focused = std::ranges::find_if(rows_, [this](const Row& row) { return row.steps->isAncestorOf(focusWidget()); });
  const auto at = focused != rows_.end() ? focused : std::ranges::find(rows_, -1, [](const Row& row) { return row.steps->chosen(); });
  if (at == rows_.end()) return;
  at->steps->choose(step);
  const auto next = static_cast<std::size_t>(at - rows_.begin()) + 1;
  if (next < rows_.size()) return focus_row(next);
  go_on_->setFocus(Qt::TabFocusReason);
}

void SelfAssessmentPage::keyPressEvent(QKeyEvent* event) {
  const bool plain = (event->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
  if (plain && event->key() >= Qt::Key_1 && event->key() <= Qt::Key_3) {
    // A key that is held since the drilling, or too long, rates no further row.
    if (!event->isAutoRepeat()) rate_next(event->key() - Qt::Key_1);
    return;
  }
  QWidget::keyPressEvent(event);
}

}  // namespace cusp::ui
