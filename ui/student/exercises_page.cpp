#include "ui/student/exercises_page.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QStackedWidget>
#include <algorithm>

#include "ui/student/exercise_cards.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/parts.h"

namespace cusp::ui {
namespace {

enum class Shown { all, open, passed };  // in the order of the filter

/// The exercises of one group and standing whose name has the text, by level; those of one level in the order of the course.
class OfGroup : public QSortFilterProxyModel {
 public:
  OfGroup(ExerciseGroup group, QObject* parent) : QSortFilterProxyModel(parent), group_(group) {
    setFilterKeyColumn(CourseModel::kExercise);
    setFilterCaseSensitivity(Qt::CaseInsensitive);
    setSortRole(CourseModel::LevelRole);
    sort(CourseModel::kExercise);
  }
  void show_only(Shown shown) {
    shown_ = shown;
    invalidateFilter();
  }

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
    const QModelIndex index = sourceModel()->index(row, CourseModel::kExercise, parent);
    if (index.data(CourseModel::GroupRole).toInt() != static_cast<int>(group_)) return false;
    const bool passed = index.data(CourseModel::PassedRole).toBool();
    return (shown_ == Shown::all || passed == (shown_ == Shown::passed)) && QSortFilterProxyModel::filterAcceptsRow(row, parent);
  }

 private:
  ExerciseGroup group_;
  Shown shown_ = Shown::all;
};

}  // namespace

ExercisesPage::ExercisesPage(Store& store, const Actor& actor, ThumbnailCache& pictures, std::filesystem::path volumes, QWidget* parent)
    : QWidget(parent), store_(store), actor_(actor), pictures_(pictures), volumes_(std::move(volumes)) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), 0, 0);
  outer->setSpacing(px(16));
  auto* head = new PageHead(tr("Exercises"), tr("Enter opens the briefing"));
  head->setContentsMargins(0, 0, px(24), 0);
  outer->addWidget(head);
  const auto course = load_course(store, actor);
  if (!course) {
    const Message message = describe(course.error());
    auto* unread = new EmptyState(u"warning"_qs, message.what, message.more, tr("Try again"), Ink::bad);
    connect(unread, &EmptyState::acted, this, &ExercisesPage::again_wanted);
    outer->addWidget(unread, 1);
    setFocusProxy(unread->button());
    return;
  }
  if (!course->unreadable.empty()) {
    auto* band = new Band;
    outer->addWidget(band);
    band->show_message(Band::Kind::look, tr("%n exercise(s) cannot be read.", nullptr, static_cast<int>(course->unreadable.size())),
                       tr("An instructor publishes them again from the editor. All others are below."));
  }
  make_search();
  standing_ = make_choice(tr("Standing"));
  standing_->addItems({tr("All"), tr("Not passed yet"), tr("Passed")});  // in the order of Shown
  connect(standing_, &QComboBox::currentIndexChanged, this, &ExercisesPage::filter);
  for (QWidget* part : std::initializer_list<QWidget*>{standing_, search_}) head->buttons()->addWidget(part);  // before the cards: Tab follows
  outer->addWidget(make_shown(*course), 1);
  connect(&pictures_, &ThumbnailCache::ready, this, [this] {
    for (const Section& section : sections_) section.cards->pictures_came();
  });
}

QWidget* ExercisesPage::make_shown(const Course& course) {
  model_ = new CourseModel(course.rows, this);
  auto* page = new QWidget;
  auto* body = new QVBoxLayout(page);
  body->setContentsMargins(0, 0, px(12), px(12));
  body->setSpacing(px(16));
  for (const ExerciseGroup group : kExerciseGroups) make_section(group, *page);
  body->addStretch();
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setWidget(page);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  shown_ = new QStackedWidget;
  shown_->addWidget(scroll);
  auto* none = new EmptyState(u"search"_qs, tr("No exercise fits"), tr("No exercise of this standing has this text in its name."),
                              tr("Show all exercises"));
  connect(none, &EmptyState::acted, this, [this] {
    standing_->setCurrentIndex(0);
    search_->clear();
    if (!sections_.empty()) sections_.front().cards->setFocus();
  });
  shown_->addWidget(none);
  if (!sections_.empty()) setFocusProxy(sections_.front().cards);
  return shown_;
}

void ExercisesPage::make_section(ExerciseGroup group, QWidget& body) {
  auto* shown = new OfGroup(group, this);
  shown->setSourceModel(model_);
  if (shown->rowCount() == 0) {
    delete shown;
    return;
  }
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(px(8));
  auto* title = new QHBoxLayout;
  title->setSpacing(px(8));
  title->addWidget(make_label(group_name(group), TextRole::section, Weight::bold));
  int passed = 0;
  for (int row = 0; row < shown->rowCount(); ++row) passed += shown->index(row, 0).data(CourseModel::PassedRole).toBool();
  title->addWidget(make_label(tr("%1 of %2 passed").arg(passed).arg(shown->rowCount()), TextRole::body, Weight::regular, "text2"), 0, Qt::AlignBottom);
  title->addStretch();
  column->addLayout(title);
  auto* cards = new ExerciseCards([this, shown](const QModelIndex& index) { return picture_of(*shown, index); });
  cards->setAccessibleName(group_name(group));
  cards->setModel(shown);
  connect(cards, &ExerciseCards::opened, this, [this, shown](const QModelIndex& index) { open(*shown, index); });
  column->addWidget(cards);
  static_cast<QVBoxLayout*>(body.layout())->addWidget(box);
  sections_.push_back({group, box, shown, cards});
}

void ExercisesPage::make_search() {
  search_ = make_search_field(tr("Find an exercise"), px(240));
  connect(search_, &QLineEdit::textChanged, this, &ExercisesPage::filter);
  connect(search_, &QLineEdit::returnPressed, this, [this] {
    for (const Section& section : sections_) {
      if (section.shown->rowCount() > 0) return open(*section.shown, section.shown->index(0, 0));
    }
  });
  auto* find = new QShortcut(QKeySequence::Find, this);
  connect(find, &QShortcut::activated, search_, [this] { search_->setFocus(Qt::ShortcutFocusReason); });
}

void ExercisesPage::filter() {
  bool any = false;
  for (const Section& section : sections_) {
    section.shown->setFilterFixedString(search_->text().trimmed());
    static_cast<OfGroup*>(section.shown)->show_only(static_cast<Shown>(standing_->currentIndex()));
    section.box->setVisible(section.shown->rowCount() > 0);
    any = any || section.shown->rowCount() > 0;
  }
  shown_->setCurrentIndex(any ? 0 : 1);
}

ExerciseCards* ExercisesPage::cards(ExerciseGroup group) const {
  const auto it = std::ranges::find(sections_, group, &Section::group);
  return it == sections_.end() ? nullptr : it->cards;
}

QImage ExercisesPage::picture_of(const QSortFilterProxyModel& shown, const QModelIndex& index) {
  const int row = shown.mapToSource(index).row();
  QImage& drawn = drawn_[row];
  if (!drawn.isNull()) return drawn;
  const Exercise& exercise = model_->row(row).exercise;
  if (const auto folder = exercise_folder(store_, exercise, volumes_)) drawn = pictures_.picture(exercise, *folder, ThumbnailCache::Use::card);
  return drawn;
}

void ExercisesPage::open(const QSortFilterProxyModel& shown, const QModelIndex& index) {
  const Exercise exercise = model_->row(shown.mapToSource(index).row()).exercise;
  opened_ = exercise.scenario.id;
  Q_EMIT briefing_wanted(exercise);
}

bool ExercisesPage::read_again() {
  const auto course = load_course(store_, actor_);
  if (!course || shown_ == nullptr || !course->unreadable.empty()) return false;
  delete shown_;
  for (const Section& section : sections_) delete section.shown;
  delete model_;
  sections_.clear();
  drawn_.clear();
  static_cast<QVBoxLayout*>(layout())->addWidget(make_shown(*course), 1);
  filter();
  shown_->show();  // the layout does it later, and the keyboard goes to what is seen
  for (const auto& [group, box, shown, cards] : sections_) {
    for (int row = 0; row < shown->rowCount(); ++row) {
      const QModelIndex card = shown->index(row, CourseModel::kExercise);
      if (model_->row(shown->mapToSource(card).row()).exercise.scenario.id != opened_) continue;
      cards->setCurrentIndex(card);
      setFocusProxy(nullptr);  // the page has begun already
      cards->setFocus(Qt::OtherFocusReason);
      // After the layout has placed the cards.
      QMetaObject::invokeMethod(cards, [view = cards] { scroll_pages_to_current(*view, 0); }, Qt::QueuedConnection);
    }
  }
  return true;
}

}  // namespace cusp::ui
