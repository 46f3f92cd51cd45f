#include "ui/student/start_page.h"

#include <QBoxLayout>
#include <QDateTime>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <algorithm>
#include <utility>

#include "ui/modules.h"
#include "ui/render/opengl_allowed.h"
#include "ui/student/briefing.h"
#include "ui/student/interrupted_card.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kSideWidth = 356, kPictureWidth = 281, kStackBelow = 1000;  // px at 100 %, of the page
constexpr int kSmallPictureWidth = 200, kSmallPictureBelow = 760;  // of the page without the side; the text needs the rest
constexpr int kShortText = 120;  // characters: about two lines beside the picture
constexpr std::int64_t kLongestWaitMs = 86'400'000;  // a day: no page stands longer

/// A wrapping value takes the rest of the line and wraps below.
enum class Value { one_line, wraps };

QWidget* fact(const QString& name, const QString& value, Value length = Value::one_line) {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(make_label(name, TextRole::caption, Weight::regular, "text2"));
  QLabel* text = make_label(value);
  text->setWordWrap(length == Value::wraps);
  column->addWidget(text);
  column->addStretch();
  return box;
}

/// The briefing has the whole text.
QString first_sentence(QString text) {
  if (const auto end = text.indexOf(u". "_qs); end > 0 && text.size() > kShortText) text.truncate(end + 1);
  return text;
}

void add_band(QBoxLayout& body, const Message& message) {
  auto* band = new Band;
  body.addWidget(band);
  band->show_message(Band::Kind::bad, message.what, message.more);
}

}  // namespace

StartPage::StartPage(Store& store, const Account& account, ThumbnailCache& pictures, const QDateTime& now,
                     std::string device_class, std::filesystem::path volumes, QWidget* parent)
    : QWidget(parent), store_(store), pictures_(pictures), device_class_(std::move(device_class)), volumes_(std::move(volumes)) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  // A process that died leaves its attempt in the state running. A database that cannot be written keeps it so.
  static_cast<void>(store.sessions.mark_interrupted());
  auto course = load_course(store, account.actor());
  if (!course) {
    const Message message = describe(course.error());
    auto* unread = new EmptyState(u"warning"_qs, message.what, message.more, tr("Try again"), Ink::bad);
    connect(unread, &EmptyState::acted, this, &StartPage::assessment_opened);
    outer->addWidget(unread);
    setFocusProxy(unread->button());
    return;
  }
  course_ = std::move(*course);
  auto assessments = load_assessments(store, account.actor(), now, device_class_);
  if (assessments) assessments_ = std::move(assessments->shown);
  const int next = course_.next();
  if (next >= 0) {
    next_ = course_.rows[static_cast<std::size_t>(next)];
    if (const auto why = why_no_practice(store, account.actor(), next_->exercise.scenario.id)) refusal_ = why->line();
  }

  QVBoxLayout* body = nullptr;
  outer->addWidget(make_scroll_page(&body));
  bool due = std::ranges::any_of(assessments_, [](const auto& a) { return a.state != AssignedAssessment::State::missed && a.state != AssignedAssessment::State::handed_in; });
  due = due || std::ranges::any_of(course_.rows, &CourseRow::due);
  body->addWidget(new PageHead(due ? tr("Due next") : tr("Your practice"), format_day(now)));
  if (!assessments) {
    add_band(*body, {tr("Your assessments could not be read."), describe(assessments.error()).line()});
  } else if (assessments->unreadable > 0) {
    add_band(*body, {tr("%n assessment(s) cannot be shown.", nullptr, assessments->unreadable), tr("This station cannot read the exercise. Ask the invigilator.")});
  }
  columns_ = new QBoxLayout(QBoxLayout::LeftToRight);
  columns_->setSpacing(px(16));
  body->addLayout(columns_);
  body->addStretch();

  columns_->addWidget(make_main(account), 1);
  side_ = make_side(account);
  columns_->addWidget(side_);
  connect(&pictures_, &ThumbnailCache::ready, this, &StartPage::show_picture);
  QPushButton* first = interrupted_ != nullptr ? interrupted_->primary() : start_;
  for (const AssessmentCard* card : findChildren<AssessmentCard*>()) {
    if (card->start_button() == nullptr) continue;
    first = card->start_button();
    break;
  }
  if (first != nullptr && first->isEnabled()) {
    setFocusProxy(first);
  } else if (table_ != nullptr) {
    setFocusProxy(table_);
  }
  wait_for_opening(now);
}

void StartPage::wait_for_opening(const QDateTime& now) {
  for (const AssignedAssessment& a : assessments_) {
    if (a.state != AssignedAssessment::State::later) continue;
    const std::int64_t opens_ms = (*a.assignment.opens_utc_us + 999) / 1000;
    opens_ms_ = std::min(opens_ms_.value_or(opens_ms), opens_ms);
  }
  if (!opens_ms_) return;
  const std::int64_t wait_ms = *opens_ms_ - now.toMSecsSinceEpoch();
  if (wait_ms < kLongestWaitMs) QTimer::singleShot(std::chrono::milliseconds(wait_ms), Qt::PreciseTimer, this, &StartPage::note_opened);
}

void StartPage::note_opened() {
  if (std::exchange(opens_ms_, std::nullopt)) Q_EMIT assessment_opened();
}

void StartPage::look_at_clock(const QDateTime& now) {
  if (opens_ms_ && now.toMSecsSinceEpoch() >= *opens_ms_) note_opened();
}

QWidget* StartPage::make_main(const Account& account) {
  auto* main = new QWidget;
  auto* column = new QVBoxLayout(main);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(16));
  make_assessments(*column, account);
  make_interrupted(*column);
  if (next_) {
    column->addWidget(make_next(*next_));
  } else {
    auto* card = new Card;
    card->body()->addWidget(new EmptyState(u"list"_qs, tr("No exercise yet"),
                                           tr("This station has no exercise that can be read. Ask your instructor.")));
    column->addWidget(card);
  }
  if (!course_.rows.empty()) column->addWidget(make_list());
  add_comment(*column, account);
  auto* note = new QHBoxLayout;
  note->setSpacing(px(8));
  auto* sign = new QLabel;
  sign->setPixmap(icon_pixmap(u"info"_qs, Ink::text2, 16, devicePixelRatioF()));
  note->addWidget(sign);
  note->addWidget(make_label(tr("Every attempt is kept, also one that broke off."), TextRole::caption, Weight::regular, "text2"), 1);
  column->addLayout(note);
  column->addStretch();
  return main;
}

void StartPage::make_assessments(QBoxLayout& column, const Account& account) {
  for (const AssignedAssessment& assessment : assessments_) {
    auto* card = new AssessmentCard(assessment, account.id, device_class_);
    connect(card, &AssessmentCard::start_wanted, this, [this, assessment] { Q_EMIT assessment_wanted(assessment); });
    column.addWidget(card);
  }
}

void StartPage::make_interrupted(QBoxLayout& column) {
  for (const HistoryRow& row : course_.interrupted) {
    const auto way = way_of(store_, row, device_class_);
    if (!way) add_band(column, {tr("An interrupted attempt could not be read."), describe(way.error()).line()});
    if (!way || *way == InterruptedWay::other_engine) continue;
    auto* card = new InterruptedCard(store_, row, *way, device_class_, interrupted_ == nullptr && !assessed() ? ButtonKind::primary : ButtonKind::standard);
    connect(card, &InterruptedCard::resume_wanted, this, [this, id = row.session] { Q_EMIT resume_wanted(id); });
    connect(card, &InterruptedCard::grade_wanted, this, [this, id = row.session] { Q_EMIT grade_wanted(id); });
    column.addWidget(card);
    if (interrupted_ == nullptr) interrupted_ = card;
  }
}

QWidget* StartPage::make_next(const CourseRow& row) {
  const Scenario& s = row.exercise.scenario;
  auto* card = new Card;
  card->setAccessibleName(tr("Next exercise"));
  card->body()->setContentsMargins(1, 1, 1, 1);
  auto* line = new QHBoxLayout;
  line->setSpacing(0);
  card->body()->addLayout(line);
  picture_ = new QLabel;
  picture_->setFixedWidth(px(kPictureWidth));
  picture_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);  // as high as the text beside it, whatever it shows
  picture_->installEventFilter(this);
  picture_->setAccessibleName(tr("The tooth with its target"));
  line->addStrut(px(226));
  line->addWidget(picture_);
  auto* text = new QVBoxLayout;
  text->setContentsMargins(px(24), px(16), px(24), px(16));
  text->setSpacing(px(4));
  line->addLayout(text, 1);
  const QString due = row.due() ? tr("Next, due %1").arg(format_day_time(local_time(*row.due_utc_us))) : tr("Next");
  text->addWidget(make_label(due, TextRole::caption, Weight::regular, "text2"));
  QLabel* title = make_label(local(s.title), TextRole::live, Weight::bold);
  title->setWordWrap(true);
  text->addWidget(title);
  QLabel* what = make_label(first_sentence(briefing_text(s)), TextRole::body, Weight::regular, "text2");
  what->setWordWrap(true);
  text->addWidget(what);
  add_notes(*text, row);
  text->addStretch();
  auto* facts = new QHBoxLayout;
  facts->setSpacing(px(20));
  facts->addWidget(fact(tr("Attempts"), row.attempts_allowed ? tr("%1 of %2 used").arg(row.attempts_counted).arg(*row.attempts_allowed)
                                                     : format_number(row.attempts, 0)));
  facts->addWidget(fact(tr("Best so far"), row.best && row.best->score ? tr("%1 of 100").arg(format_points(*row.best->score))
                                                                       : tr("none yet")));
  facts->addWidget(fact(tr("Burs"), burs_text(s), Value::wraps), 1);
  text->addLayout(facts);
  text->addStretch();
  text->addSpacing(px(4));
  auto* acts = new QHBoxLayout;
  acts->setSpacing(px(12));
  // One primary button a page: that of an assessment or an interrupted attempt comes first.
  start_ = make_large_button(tr("Start"), interrupted_ != nullptr || assessed() ? ButtonKind::standard : ButtonKind::primary, u"play"_qs);
  start_->setMinimumWidth(px(106));
  QPushButton* briefing = make_large_button(tr("Briefing"), ButtonKind::standard);
  for (QPushButton* one : {start_, briefing}) acts->addWidget(one);
  // The hint gives way to long buttons. With an interrupted attempt Enter continues that.
  start_->setEnabled(opengl_allowed() && refusal_.isEmpty());
  const QString enter = interrupted_ == nullptr && !assessed() && refusal_.isEmpty() ? tr("Enter starts") : QString();
  QLabel* hint = make_label(opengl_allowed() ? enter : ToothView::pictures_off(), TextRole::caption, Weight::regular, "text3");
  hint->setWordWrap(true);
  hint->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  hint->setAlignment(Qt::AlignTrailing | Qt::AlignVCenter);
  acts->addWidget(hint, 1);
  text->addLayout(acts);
  start_->setAutoDefault(true);
  connect(start_, &QPushButton::clicked, this, [this] { Q_EMIT start_wanted(next_->exercise); });
  connect(briefing, &QPushButton::clicked, this, [this] { Q_EMIT briefing_wanted(next_->exercise); });
  show_picture();
  return card;
}

void StartPage::add_notes(QVBoxLayout& text, const CourseRow& row) {
  for (const QString& note : {refusal_, uncounted_text(row, device_class_)})
    if (!note.isEmpty()) text.addWidget(make_limit_note(note));
}

QWidget* StartPage::make_list() {
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(12), px(8), px(8));
  QLabel* title = make_label(tr("Your exercises"), TextRole::section, Weight::bold);
  title->setContentsMargins(px(8), 0, 0, 0);
  card->body()->addWidget(title);
  table_ = new Table;
  table_->setAccessibleName(tr("Your exercises"));
  auto* model = new CourseModel(course_.rows, this);
  table_->setModel(model);
  table_->set_stretch_column(CourseModel::kExercise);
  const bool due = std::ranges::any_of(course_.rows, [](const CourseRow& row) { return row.due_utc_us.has_value(); });
  table_->setColumnHidden(CourseModel::kDue, !due);
  table_->set_rows_shown(model->rowCount());  // the page scrolls, the table does not
  table_->choose_row(course_.next());
  card->body()->addWidget(table_);
  const auto open = [this, model](const QModelIndex& at) { Q_EMIT briefing_wanted(model->row(at.row()).exercise); };
  connect(table_, &Table::row_opened, this, open);
  connect(table_, &QTableView::clicked, this, [open](const QModelIndex& at) {
    if (at.column() == CourseModel::kOpen) open(at);
  });
  return card;
}

void StartPage::add_comment(QBoxLayout& column, const Account& account) {
  const auto newest = store_.history.newest_comment(account.actor(), account.id);
  if (!newest) return add_band(column, {tr("The newest comment could not be read."), describe(newest.error()).line()});
  if (!*newest) return;
  const Comment& c = (*newest)->comment;
  const auto author = store_.accounts.find(c.author);
  auto* card = new Card(tr("From your instructor"), tr("on your attempt of %1").arg(format_day(local_time((*newest)->started_utc_us))));
  const QString who = author ? QString::fromStdString(author->name) : tr("Instructor");
  const QString said = QString::fromStdString(c.text).toHtmlEscaped().replace(u'\n', u"<br>"_qs);
  QLabel* text = make_label(u"<b>%1:</b> %2"_qs.arg(who.toHtmlEscaped(), said));
  text->setTextFormat(Qt::RichText);
  text->setWordWrap(true);
  card->body()->addWidget(text);
  column.addWidget(card);
}

void StartPage::show_picture() {
  if (!picture_ || !next_) return;
  const auto folder = exercise_folder(store_, next_->exercise, volumes_);
  show_covering(picture_, folder ? pictures_.picture(next_->exercise, *folder, ThumbnailCache::Use::card) : QImage(), px(7));
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == picture_ && event->type() == QEvent::Resize) show_picture();
  return QWidget::eventFilter(watched, event);
}

void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!columns_) return;
  const bool narrow = width() < px(kStackBelow);
  columns_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  const int beside = narrow ? 0 : px(kSideWidth) + columns_->spacing();
  if (picture_) picture_->setFixedWidth(px(width() - beside < px(kSmallPictureBelow) ? kSmallPictureWidth : kPictureWidth));
  side_->setMinimumWidth(narrow ? 0 : px(kSideWidth));
  side_->setMaximumWidth(narrow ? QWIDGETSIZE_MAX : px(kSideWidth));
}

}  // namespace cusp::ui
