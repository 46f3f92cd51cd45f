#include "ui/instructor/library_page.h"

#include <QAction>
#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <algorithm>
#include <array>

#include "scenarios/library/library.h"
#include "scenarios/templates/templates.h"
#include "ui/editor/draft_folder.h"
#include "ui/editor/editor_records.h"
#include "ui/editor/template_dialog.h"
#include "ui/editor/texts_form.h"
#include "ui/instructor/exercise_card.h"
#include "ui/instructor/exercise_use.h"
#include "ui/instructor/withdrawal.h"
#include "ui/modules.h"
#include "ui/student/exercise_groups.h"
#include "ui/student/thumbnail_cache.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/empty_state.h"
#include "ui/widgets/format.h"
#include "ui/widgets/head_row.h"
#include "ui/widgets/menu_button.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr const char* kBlankExercise = "channel-1";  // pattern of a new exercise: the plain block
constexpr int kFoldsBelow = 560;  // px at 100 % of height: the chosen exercise to its name and use
constexpr int kGroupFrom = 900;   // px at 100 % of width

/// Whether an instructor has a draft of it, for their drafts share a folder; true if the records give no answer.
bool may_have_draft(Store& store, ScenarioId id) { return store.scenarios.has_draft(id).value_or(true); }

}  // namespace

LibraryPage::LibraryPage(Store& store, const Actor& actor, const Ports& ports, std::filesystem::path database,
                         std::filesystem::path cache, ThumbnailCache* pictures, QWidget* parent)
    : QWidget(parent),
      store_(store),
      actor_(actor),
      ports_(ports),
      database_(std::move(database)),
      cache_(std::move(cache)),
      model_(new LibraryModel(this)),
      pictures_(pictures) {
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(px(24), px(16), px(24), px(24));
  outer->setSpacing(px(12));
  auto* head = new PageHead(tr("Library"));
  QPushButton* import = make_button(tr("Import a specimen"), ButtonKind::standard, u"import"_qs);
  QPushButton* more = make_more_button();
  QPushButton* fresh = make_new_button();
  QPushButton* open = make_button(tr("Open in the editor"), ButtonKind::primary, u"edit"_qs);
  for (QPushButton* button : {import, more, fresh, open}) head->buttons()->addWidget(button);
  outer->addWidget(head);
  band_ = new Band;
  outer->addWidget(band_);
  outer->addWidget(make_filters());
  auto* card = new Card;
  card->body()->setContentsMargins(px(8), px(8), px(8), px(8));
  table_ = new Table;
  table_->setAccessibleName(tr("Exercises"));
  table_->setModel(model_);
  table_->set_stretch_column(LibraryModel::kExercise);
  below_ = new QStackedWidget;
  below_->addWidget(table_);
  auto* none = new EmptyState(u"search"_qs, tr("No exercise fits"), tr("No exercise and no tooth of this group and state has this text."), tr("Show all exercises"));
  connect(none, &EmptyState::acted, this, [this] {
    for (QComboBox* box : {group_, state_}) box->setCurrentIndex(0);
    search_->clear();
  });
  below_->addWidget(none);
  card->body()->addWidget(below_);
  outer->addWidget(card, 1);
  chosen_ = new ExerciseCard;
  outer->addWidget(chosen_);
  if (pictures_ != nullptr) connect(pictures_, &ThumbnailCache::ready, this, &LibraryPage::show_picture);
  connect(import, &QPushButton::clicked, this, &LibraryPage::import_wanted);
  connect(open, &QPushButton::clicked, this, &LibraryPage::open_chosen);
  connect(table_, &Table::row_opened, this, &LibraryPage::open_chosen);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &LibraryPage::fit_buttons);
  setAcceptDrops(true);
  read();
  fit_buttons();
  setFocusProxy(table_);
}

/// A button with a menu: empty, each template, or from a file.
QPushButton* LibraryPage::make_new_button() {
  QPushButton* fresh = make_button(tr("New exercise"), ButtonKind::standard, u"plus"_qs, QKeySequence::New);
  auto* menu = new QMenu(fresh);
  menu->setObjectName(u"begin"_qs);
  connect(menu->addAction(tr("Empty")), &QAction::triggered, this, &LibraryPage::begin_new);
  menu->addSeparator();
  for (const ExerciseTemplate& one : exercise_templates()) {
    QAction* entry = menu->addAction(tr("From a template: %1…").arg(local(one.name)));
    entry->setObjectName(QString::fromStdString(one.key));
    connect(entry, &QAction::triggered, this, [this, key = one.key] { begin_from_template(key); });
  }
  menu->addSeparator();
  connect(menu->addAction(tr("Open a file…")), &QAction::triggered, this, &LibraryPage::choose_file);
  return put_menu(fresh, menu);
}

/// A button with a menu: what can be done with the chosen exercise.
QPushButton* LibraryPage::make_more_button() {
  QPushButton* more = make_button(tr("More"));
  more->setAccessibleName(tr("More for the chosen exercise"));
  auto* menu = new QMenu(more);
  copy_ = menu->addAction(icon(u"copy"_qs), tr("Copy"));
  save_ = menu->addAction(icon(u"save"_qs), tr("Save as file…"));
  connect(copy_, &QAction::triggered, this, &LibraryPage::copy_chosen);
  withdraw_ = menu->addAction(icon(u"ban"_qs), tr("Withdraw…"));
  discard_ = menu->addAction(icon(u"trash"_qs), tr("Discard the draft…"));
  connect(discard_, &QAction::triggered, this, &LibraryPage::discard_draft);
  connect(save_, &QAction::triggered, this, &LibraryPage::save_chosen);
  connect(withdraw_, &QAction::triggered, this, &LibraryPage::withdraw_chosen);
  return put_menu(more, menu);
}

void LibraryPage::read() {
  auto library = load_library(store_, actor_);
  if (!library) return show_failure(library.error());
  if (!library->unreadable.empty()) {
    band_->show_message(Band::Kind::look,
                        tr("%n exercise(s) cannot be read.", nullptr, static_cast<int>(library->unreadable.size())),
                        tr("The others are below."));
  }
  model_->set_rows(std::move(library->rows));
  table_->setColumnHidden(LibraryModel::kSaved, !model_->has_drafts());
  table_->choose_row(0);
  filter();
}

void LibraryPage::read_and_choose(ScenarioId id) {
  read();
  if (const int at = row_of(id); at >= 0 && !table_->isRowHidden(at)) table_->choose_row(at);
  fit_buttons();
}

/// A draft that was begun meanwhile stands first, and is chosen.
bool LibraryPage::read_again() {
  const int row = table_->chosen_row(), before = model_->rowCount();
  const ScenarioId kept = row < 0 ? ScenarioId{} : model_->row(row).shown().id;
  if (!working()) band_->clear();  // it speaks of what was before
  read();
  if (const int at = row_of(kept); at >= 0 && model_->rowCount() <= before && !table_->isRowHidden(at)) table_->choose_row(at);
  fit_buttons();
  table_->setFocus(Qt::OtherFocusReason);
  return true;
}

void LibraryPage::make_search() {
  search_ = make_search_field(tr("Find an exercise"), px(280));
  connect(search_, &QLineEdit::textChanged, this, &LibraryPage::filter);
  connect(search_, &QLineEdit::returnPressed, this, &LibraryPage::open_chosen);
  auto* find = new QShortcut(QKeySequence::Find, this);
  connect(find, &QShortcut::activated, search_, [this] { search_->setFocus(Qt::ShortcutFocusReason); });
}

QWidget* LibraryPage::make_filters() {
  auto* bar = new QWidget;
  auto* row = new HeadRow(bar);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(px(8));
  make_search();
  count_ = make_label({}, TextRole::body, Weight::regular, "text2");
  group_ = make_choice(tr("Group"));
  group_->addItem(tr("All groups"), -1);
  for (const ExerciseGroup group : kExerciseGroups) group_->addItem(group_name(group), static_cast<int>(group));
  state_ = make_choice(tr("State"));
  state_->addItem(tr("All states"), -1);
  for (const LibraryState state : {LibraryState::delivered, LibraryState::published, LibraryState::draft, LibraryState::withdrawn})
    state_->addItem(state_name(state), static_cast<int>(state));
  for (QComboBox* box : {group_, state_}) connect(box, &QComboBox::currentIndexChanged, this, &LibraryPage::filter);
  for (QWidget* part : std::initializer_list<QWidget*>{search_, count_, group_, state_}) row->addWidget(part);
  return bar;
}

bool LibraryPage::fits(int row) const {
  const auto chosen = [](const QComboBox& box, int value) { return box.currentIndex() == 0 || box.currentData().toInt() == value; };
  const LibraryRow& one = model_->row(row);
  if (!chosen(*group_, static_cast<int>(group_of(one.shown()))) || !chosen(*state_, static_cast<int>(state_of(one)))) return false;
  const QString text = search_->text().trimmed();
  return std::ranges::any_of(std::array{LibraryModel::kExercise, LibraryModel::kTooth}, [&](LibraryModel::Column column) {
    return model_->index(row, column).data().toString().contains(text, Qt::CaseInsensitive);
  });
}

void LibraryPage::filter() {
  int first = -1, shown = 0;
  for (int row = 0; row < model_->rowCount(); ++row) {
    const bool fitting = fits(row);
    table_->setRowHidden(row, !fitting);
    if (fitting && first < 0) first = row;
    shown += fitting;
  }
  count_->setText(tr("%n exercise(s)", nullptr, shown));
  below_->setCurrentIndex(first < 0 && model_->rowCount() > 0 ? 1 : 0);
  if (first < 0) return table_->clearSelection();
  if (const int chosen = table_->chosen_row(); chosen < 0 || table_->isRowHidden(chosen)) table_->choose_row(first);
}

void LibraryPage::fit_buttons() {
  const int index = table_->chosen_row();
  discard_->setEnabled(index >= 0 && model_->row(index).draft.has_value());
  copy_->setEnabled(index >= 0);
  save_->setEnabled(index >= 0);
  withdraw_->setEnabled(index >= 0 && model_->row(index).withdrawable);
  show_use();
}

void LibraryPage::show_use() {
  const int index = table_->chosen_row();
  chosen_->setVisible(index >= 0);
  if (index < 0) return;
  const Scenario& shown = model_->row(index).shown();
  chosen_->show_exercise(shown);
  show_picture();
  chosen_->show_use({});
  const auto use = use_of(store_, actor_, shown.id, ports_.now().toMSecsSinceEpoch() * 1000);
  if (!use) return show_failure(use.error());
  chosen_->show_use(use_text(*use));
}

/// Of the published version: a draft's volume may be half written.
void LibraryPage::show_picture() {
  const int index = table_->chosen_row();
  if (index < 0) return;
  const auto& exercise = model_->row(index).exercise;
  QImage picture;
  if (pictures_ != nullptr && exercise)
    if (const auto folder = exercise_folder(store_, *exercise, cache_)) picture = pictures_->picture(*exercise, *folder, ThumbnailCache::Use::card);
  chosen_->show_picture(picture);
}

void LibraryPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  chosen_->fold(height() < px(kFoldsBelow));
  table_->setColumnHidden(LibraryModel::kGroup, width() < px(kGroupFrom));  // a long name goes before it
}

void LibraryPage::discard_draft() {
  const int index = table_->chosen_row();
  if (index < 0 || !model_->row(index).draft) return;
  const LibraryRow row = model_->row(index);
  const ScenarioId id = row.draft->id;
  const QString follows = row.exercise    ? tr("What is published stays as it is.")
                          : row.withdrawn ? tr("Its versions are withdrawn: without the draft you cannot edit or publish it again. Results and reports stay.")
                                          : tr("It was never published: nothing of it is left.");
  ports_.ask(this, {tr("Discard the draft of %1?").arg(local(row.draft->title)), follows, tr("Discard the draft"), true},
             [this, id, published = row.exercise.has_value(), json = row.draft_json](bool yes) {
               if (!yes) return;
               const auto done = store_.scenarios.drop_draft(actor_, id, json);
               if (!done) return show_failure(done.error());
               if (*done == DraftSave::changed_elsewhere) {
                 band_->show_message(Band::Kind::look, tr("The draft was changed in another window meanwhile."),
                                     tr("It was not discarded. The list shows it as it is now."));
               } else if (!published) {
                 remove_unheld(drafts_folder(database_, id), [this, id] { return may_have_draft(store_, id); });
               }
               read();
               fit_buttons();
             });
}

void LibraryPage::withdraw_chosen() {
  const int index = table_->chosen_row();
  if (index < 0 || !model_->row(index).withdrawable) return;
  const LibraryRow row = model_->row(index);
  const auto plan = plan_withdrawal(store_, row, ports_.now().toMSecsSinceEpoch() * 1000);
  if (!plan) return show_failure(plan.error());
  if (!plan->newest) return show_changed(row);  // the list is older
  QStringList follows;
  follows << (plan->before ? tr("Students find version %1 again.").arg(*plan->before)
                           : tr("Students no longer find this exercise; you keep it as a draft."));
  if (plan->assignments > 0) follows << tr("%n open assignment(s) of this version can no longer be drilled.", nullptr, plan->assignments);
  follows << tr("Results and reports stay. A withdrawn version does not come back: publishing makes a new one.");
  ports_.ask(this, {tr("Withdraw version %1 of %2?").arg(plan->number).arg(local(row.exercise->scenario.title)), follows.join(u' '),
                    tr("Withdraw version %1").arg(plan->number), true},
             [self = QPointer(this), row, plan = *plan](bool yes) {
               if (self && yes) self->withdraw_row(row, plan);
             });
}

void LibraryPage::withdraw_row(const LibraryRow& row, const Withdrawal& plan) {
  const ScenarioId id = row.exercise->scenario.id;
  const QString title = local(row.exercise->scenario.title);
  const auto now = plan_withdrawal(store_, row, ports_.now().toMSecsSinceEpoch() * 1000);
  if (!now) return show_failure(now.error());
  if (*now != plan) return show_changed(row);
  const auto done = withdraw(store_, actor_, row, plan, database_, cache_);
  if (!done && done.error().code != StorageError::duplicate) return show_failure(done.error());  // else another desk was faster
  read_and_choose(id);
  band_->show_message(Band::Kind::good, tr("Version %1 of %2 is withdrawn.").arg(plan.number).arg(title),
                      plan.before ? tr("Students find version %1 again.").arg(*plan.before) : tr("It stays here as a draft of yours."));
}

void LibraryPage::show_changed(const LibraryRow& row) {
  read_and_choose(row.exercise->scenario.id);
  band_->show_message(Band::Kind::look, tr("The versions or assignments of %1 changed meanwhile.").arg(local(row.exercise->scenario.title)),
                      tr("Nothing was withdrawn. Withdraw it again to see what follows now."));
}

void LibraryPage::show_failure(const StorageFailure& failure) {
  const Message message = describe(failure);
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

void LibraryPage::open_chosen() {
  const int index = table_->chosen_row();
  if (index < 0) return;
  const LibraryRow& row = model_->row(index);
  if (!row.exercise) {
    Q_EMIT edit_wanted(open_draft(*row.draft, row.draft_json, database_));
    return;
  }
  const auto start = open_for_editing(store_, actor_, *row.exercise, database_, cache_);
  if (!start) return show_failure(start.error());
  Q_EMIT edit_wanted(*start);
}

void LibraryPage::copy_chosen() {
  const int index = table_->chosen_row();
  if (index < 0) return;
  const LibraryRow& row = model_->row(index);
  if (!row.exercise) {
    band_->show_message(Band::Kind::look, tr("A draft has nothing to copy yet."), tr("Publish it first."));
    return;
  }
  begin_as_copy(*row.exercise, title_of_copy(row.exercise->scenario.title));
}

void LibraryPage::begin_new() {
  const auto pattern = load_builtin(kBlankExercise);
  if (!pattern) return;
  // Content of the exercise, in each language of the pattern's briefing; tr() translates the screen only.
  begin_as_copy({*pattern, {}, 1, {}}, {{"en", "New exercise"}, {"de", "Neue Übung"}});
}

void LibraryPage::begin_from_template(const std::string& key) {
  auto* dialog = new TemplateDialog(key, this);
  connect(dialog, &TemplateDialog::made, this, [this](const Scenario& exercise) { Q_EMIT edit_wanted(open_new(exercise, database_)); });
  dialog->open();
}

void LibraryPage::begin_as_copy(const Exercise& pattern, const LocalText& title) {
  const auto start = copy_exercise(store_, pattern, title, database_, cache_);
  if (!start) return show_failure(start.error());
  Q_EMIT edit_wanted(*start);
}

}  // namespace cusp::ui
