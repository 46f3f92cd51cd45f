#include "ui/report/report_page.h"

#include <QBoxLayout>
#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <algorithm>

#include "ui/render/opengl_allowed.h"
#include "ui/report/against_before.h"
#include "ui/report/criteria_model.h"
#include "ui/report/marking_card.h"
#include "ui/report/pinned_tooth.h"
#include "ui/report/report_section.h"
#include "ui/text/grade_text.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/bar_top.h"
#include "ui/widgets/chip.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kNarrow = 1200;        // px at 100 %; a narrower page gives the text more width, in one column
constexpr int kLeast = 760;          // px at 100 %; a page below it leaves out what the card on the tooth has as well
constexpr int kLeastTextPercent = 55, kMostTextPercent = 64;  // of the page; the rest shows the tooth
constexpr int kTableSide = 8, kCardSide = 16, kBorder = 1, kGap = 12;  // px at 100 %

}  // namespace

ReportPage::ReportPage(ReportData data, const Ports& ports, TryAgain again, const QString& back_name, QWidget* parent)
    : QWidget(parent), data_(std::move(data)), ports_(ports) {
  setProperty("kind", u"page"_qs);
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Report"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_bar(again, back_name));
  halves_ = new QHBoxLayout;
  halves_->setSpacing(0);
  halves_->addWidget(make_tooth(), 100 - kLeastTextPercent);
  QVBoxLayout* body = nullptr;
  halves_->addWidget(make_scroll_page(&body), kLeastTextPercent);
  body_ = body;
  body->setSpacing(px(kGap));
  band_ = new Band;
  body->addWidget(band_);
  news_ = new Band;
  body->addWidget(news_);
  fill();
  body->addStretch();
  column->addLayout(halves_, 1);
  show_state();
  choose_first();
}

void ReportPage::fill() {
  const auto container = [](QWidget** slot) {
    *slot = new QWidget;
    auto* column = new QVBoxLayout(*slot);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(px(kGap));
    return column;
  };
  QWidget *old_head = head_, *old_main = main_;
  against_ = nullptr;
  QVBoxLayout* head = container(&head_);
  head_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);  // a high window leaves its room below
  if (data_.unread) head->addWidget(make_unread());
  head->addWidget(make_score());
  if (QWidget* remarks = make_remarks()) head->addWidget(remarks);
  QVBoxLayout* main = container(&main_);
  main->addWidget(make_criteria());
  below_ = new QHBoxLayout;
  below_->setSpacing(px(kGap));
  below_->addWidget(make_next_time(), 1);
  below_->addWidget(make_against(), 1);
  main->addLayout(below_);
  const auto put = [this](QWidget* old, QWidget* fresh) {
    if (old == nullptr) return body_->addWidget(fresh);
    delete body_->replaceWidget(old, fresh);
    old->hide();
    old->deleteLater();
  };
  put(old_head, head_);
  put(old_main, main_);
  setFocusProxy(table_);
  order_tabs();
}

/// Tab follows reading, whatever was made last.
void ReportPage::order_tabs() {
  QWidget* before = nullptr;
  for (QWidget* part : {head_, card_.data(), main_}) {
    if (part == nullptr) continue;
    for (QWidget* stop : part->findChildren<QWidget*>()) {
      // The list of a combo box has a window of its own.
      if (!(stop->focusPolicy() & Qt::TabFocus) || stop->focusProxy() || stop->window() != window()) continue;
      if (before) QWidget::setTabOrder(before, stop);
      before = stop;
    }
  }
}

void ReportPage::set_card(QWidget* card) {
  card_ = card;
  body_->insertWidget(body_->indexOf(main_), card);
  order_tabs();
}

void ReportPage::leave_for(void (ReportPage::*wanted)()) {
  const auto* marking = qobject_cast<const MarkingCard*>(card_.data());
  if (marking == nullptr || !marking->unsaved()) return (this->*wanted)();
  const Question question{marking->has_comment() ? tr("Leave without the comment?") : tr("Leave without the changed points?"),
                          tr("What is written under Marking is not kept yet."), tr("Leave"), true};
  ports_.ask(this, question, [self = QPointer(this), wanted](bool yes) {
    if (self && yes) (self.data()->*wanted)();
  });
}

void ReportPage::offer_pack(const QString& why_not) {
  pack_->show();
  pack_->setEnabled(why_not.isEmpty());
  if (!why_not.isEmpty()) pack_->setToolTip(why_not);
  pack_->setAccessibleDescription(why_not);
}
void ReportPage::show_message(Band::Kind kind, const QString& what, const QString& more) { news_->show_message(kind, what, more); }

void ReportPage::show_data(ReportData data) {
  const int row = table_->chosen_row();
  data_ = std::move(data);
  drawing_.reset();
  fill();
  show_state();
  table_->choose_row(row);
  QResizeEvent same(size(), size());
  resizeEvent(&same);
}

const CriterionGrade* ReportPage::chosen_criterion() const {
  return table_->chosen_row() < 0 ? nullptr : &model_->criterion(table_->chosen_row());
}

/// What fails the attempt, or that it broke off.
void ReportPage::show_state() {
  const QString standing = data_.result.state == SessionState::interrupted ? tr("It is not graded yet; the points show how it stands now.")
                                                                           : tr("It is marked as it stands.");
  if (!data_.critical.empty()) {
    QStringList what;
    for (const CriticalEvent& event : data_.critical) {
      what += critical_text(event, data_.result.scenario.specimen) + u'.';
      if (const QString how = critical_circumstances(data_, event); !how.isEmpty()) what += how + u'.';
    }
    QString more = tr("This fails the attempt, whatever its points; the points still stand.");
    if (data_.result.interrupted) more += u' ' + tr("This attempt broke off.") + u' ' + standing;
    band_->show_message(Band::Kind::bad, what.join(u' '), more);
  } else if (data_.result.interrupted) {
    band_->show_message(Band::Kind::look, tr("This attempt broke off."), standing);
  } else {
    band_->clear();
  }
}

/// Selects the largest loss of points. A critical event with a place is pinned instead.
void ReportPage::choose_first() {
  const Grade& g = data_.result.grade;
  const bool opened_pulp = !data_.critical.empty() && data_.critical.front().key == "pulp_exposure";
  for (const LossReason& reason : loss_reasons(g)) {
    if (!reason.critical.empty()) continue;
    if (table_->chosen_row() < 0 || (opened_pulp && g.criteria[reason.criterion].id == "remaining_over_pulp")) {
      table_->choose_row(static_cast<int>(reason.criterion));
    }
  }
  if (const auto opened = std::ranges::find_if(data_.critical, [](const CriticalEvent& e) { return e.place_mm.has_value(); });
      opened != data_.critical.end()) {
    tooth_->pin(opened->place_mm, critical_text(*opened, data_.result.scenario.specimen), critical_advice(opened->key), opened->key);
  }
}

void ReportPage::resizeEvent(QResizeEvent* event) {
  const bool narrow = width() < px(kNarrow);
  const int side = px(narrow ? 12 : 20);
  body_->setContentsMargins(side, px(16), side, px(16));
  model_->set_detail(narrow ? CriteriaModel::Detail::narrow : CriteriaModel::Detail::whole);
  // Buttons lose their text to the date and the attempt number, and keep name and tooltip.
  for (const auto& [button, text] : saves_) {
    const QKeySequence key = button->shortcut();  // a new text takes the shortcut away
    button->setText(narrow ? QString() : text);
    button->setShortcut(key);
  }
  table_->setColumnHidden(CriteriaModel::kPlace, narrow);
  const bool least = width() < px(kLeast);
  table_->setColumnHidden(CriteriaModel::kWanted, least);
  aside_->setVisible(!least);
  occasion_->setVisible(least);
  outcome_->setDirection(least ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  fit_bar(width());
  // The text is as wide as the names of its criteria need, within limits; beyond them the names take two lines.
  const int around = 2 * (side + px(kTableSide + kBorder)) + style()->pixelMetric(QStyle::PM_ScrollBarExtent);
  const int most = width() * kMostTextPercent / 100;
  const int text = narrow ? most : std::clamp(table_->whole_width() + around, width() * kLeastTextPercent / 100, most);
  halves_->setStretch(0, width() - text);
  halves_->setStretch(1, text);
  fit_tools(width() - text);
  const int column = (text - 2 * side - px(kGap) - style()->pixelMetric(QStyle::PM_ScrollBarExtent)) / 2 - 2 * px(kCardSide + kBorder);
  const bool stacked = narrow || (against_ && against_->whole_width() > column);
  below_->setDirection(stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  QWidget::resizeEvent(event);
}

/// A title that leaves the buttons no room is elided.
void ReportPage::fit_bar(int width) {
  title_->setText(data_.title);
  title_->setToolTip({});
  const int over = bar_->sizeHint().width() - width;
  if (over <= 0) return;
  title_->setToolTip(tool_tip_text(data_.title));
  title_->setText(title_->fontMetrics().elidedText(data_.title, Qt::ElideRight, title_->sizeHint().width() - over));
}

QWidget* ReportPage::make_bar(TryAgain again, const QString& back_name) {
  const auto [bar, row] = make_bar_top();
  bar_ = bar;
  QPushButton* back = add_way_back({bar, row}, back_name);
  connect(back, &QPushButton::clicked, this, [this] { leave_for(&ReportPage::back_wanted); });
  // Staff write on this page: Escape is no wish to leave it.
  if (again != TryAgain::hidden) let_escape_go_back(back);
  row->addWidget(title_ = make_label(data_.title, TextRole::section, Weight::bold));
  QString aside = occasion_text(data_, Medium::screen);
  if (!data_.student.isEmpty() && again == TryAgain::hidden) aside = data_.student + u" · "_qs + aside;
  row->addWidget(aside_ = make_label(aside, TextRole::body, Weight::regular, "text2"));
  row->addStretch(1);
  QPushButton* paper = make_button(tr("Print"), ButtonKind::standard, u"print"_qs, QKeySequence::Print);
  QPushButton* pdf = make_button(tr("Save as PDF"), ButtonKind::standard, u"export"_qs, QKeySequence::Save);
  connect(paper, &QPushButton::clicked, this, &ReportPage::print);
  connect(pdf, &QPushButton::clicked, this, &ReportPage::save_pdf);
  row->addWidget(paper);
  row->addWidget(pdf);
  pack_ = make_button(tr("Appeal pack"), ButtonKind::standard, u"shield"_qs);
  pack_->setToolTip(tr("Save records, report and tooth in one file that another station verifies"));
  pack_->hide();
  connect(pack_, &QPushButton::clicked, this, &ReportPage::pack_wanted);
  row->addWidget(pack_);
  for (QPushButton* button : {paper, pdf, pack_}) saves_.emplace_back(button, button->text());
  if (again == TryAgain::offered) row->addWidget(make_again());
  return bar;
}

/// An assessment is not begun from its report.
QPushButton* ReportPage::make_again() {
  const bool assessed = data_.kind == SessionKind::assessment;
  QPushButton* out = make_button(assessed ? tr("Practise it") : tr("Try again"), ButtonKind::primary);
  if (assessed) out->setToolTip(tr("Begins a practice attempt. It does not count for the assessment."));
  if (!opengl_allowed()) {
    out->setEnabled(false);
    out->setToolTip(ToothView::pictures_off());
  }
  out->setAccessibleDescription(out->toolTip());
  connect(out, &QPushButton::clicked, this, [this] { leave_for(&ReportPage::try_again_wanted); });
  return out;
}

QWidget* ReportPage::make_score() {
  const Grade& g = data_.result.grade;
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(16));
  QLabel* score = make_label(format_points(g.score), TextRole::score, Weight::bold);
  score->setObjectName(u"score"_qs);
  row->addWidget(score);
  auto* text = new QVBoxLayout;
  text->setSpacing(px(2));
  text->addStretch();
  occasion_ = make_label(aside_->text(), TextRole::caption, Weight::regular, "text2");
  occasion_->setWordWrap(true);
  occasion_->hide();
  text->addWidget(occasion_);
  auto* line = outcome_ = new QBoxLayout(QBoxLayout::LeftToRight);
  line->setSpacing(px(8));
  line->addWidget(new Chip(g.passed ? tr("Passed") : tr("Not passed"), g.passed ? Chip::Kind::good : Chip::Kind::bad), 0, Qt::AlignLeading);
  QLabel* of = make_label(tr("of %1 points, pass mark %2").arg(format_points(g.score_max), format_points(g.pass_mark)),
                          TextRole::body, Weight::regular, "text2");
  of->setWordWrap(true);  // no sideways scrolling on a narrow page
  line->addWidget(of, 1);
  text->addLayout(line);
  QLabel* circumstances = make_label(circumstances_text(data_), TextRole::caption, Weight::regular, "text2");
  circumstances->setWordWrap(true);
  text->addWidget(circumstances);
  QStringList further = burs_used_text(data_);
  if (const QString own = own_assessment_text(data_); !own.isEmpty()) further.prepend(own);
  for (const QString& used : further) {
    QLabel* label = make_label(used, TextRole::caption, Weight::regular, "text2");
    label->setWordWrap(true);
    text->addWidget(label);
  }
  text->addStretch();
  row->addLayout(text, 1);
  if (data_.before) {
    auto* best = new QVBoxLayout;
    best->setSpacing(0);
    QLabel* name = make_label(tr("Best before"), TextRole::caption, Weight::regular, "text2");
    QLabel* value = make_label(format_points(data_.before->score), TextRole::section, Weight::bold);
    name->setAlignment(Qt::AlignTrailing);
    value->setAlignment(Qt::AlignTrailing);
    best->addStretch();
    best->addWidget(name);
    best->addWidget(value);
    best->addStretch();
    row->addLayout(best);
  }
  return box;
}

QWidget* ReportPage::make_criteria() {
  auto* card = new Card;
  card->setAccessibleName(tr("Criteria"));
  card->body()->setContentsMargins(px(kTableSide), px(6), px(kTableSide), px(6));
  model_ = new CriteriaModel(data_.result.grade, data_.result.scenario, data_.changes, this);
  model_->set_own(data_.own);
  model_->set_tissue_names(tissue_names_of(data_.result));
  table_ = new Table;
  table_->setAccessibleName(tr("Criteria"));
  table_->setModel(model_);
  table_->setColumnHidden(CriteriaModel::kOwn, !data_.own || data_.own->skipped());
  table_->set_stretch_column(CriteriaModel::kName);
  table_->setTextElideMode(Qt::ElideMiddle);  // names differ at their end: floor or walls
  table_->setWordWrap(true);
  table_->set_rows_shown(model_->rowCount());  // the page scrolls, the table does not
  card->body()->addWidget(table_);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { choose(table_->chosen_row()); });
  return card;
}

void ReportPage::choose(int row) {
  if (row < 0) return;
  const CriterionGrade& c = model_->criterion(row);
  const Measure& m = c.measure;
  const QString value = m.measured ? measure_text(m) : tr("not measured");
  QString why = model_->change(row);
  if (why.isEmpty()) why = reason_text(c);
  tooth_->pin(m.where_mm, metric_name(c.id, &data_.result.scenario.target, tissue_names_of(data_.result)) + u": "_qs + value, why, c.id);
  if (section_) section_->go_through(m.where_mm);
  Q_EMIT criterion_chosen();
}

}  // namespace cusp::ui
