// LibraryPage and files: the chosen exercise as NAME.cusp, and such a file as a draft.

#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QLineEdit>
#include <QMimeData>
#include <QPointer>
#include <QUrl>
#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "ui/editor/check_messages.h"
#include "ui/instructor/exchange.h"
#include "ui/instructor/library_page.h"
#include "ui/modules.h"
#include "ui/session/records_task.h"
#include "ui/text/failure_text.h"
#include "ui/text/names.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::ui {
namespace {

constexpr int kLongestName = 60;  // characters of a suggested file name

QString suffix() { return QString::fromUtf8(kExerciseFileSuffix.data(), static_cast<qsizetype>(kExerciseFileSuffix.size())); }

/// "Class II MO, tooth 46" as "Class-II-MO-tooth-46": letters and digits of any script, which every file system takes.
QString file_name_of(const QString& title) {
  QString out;
  for (const QChar c : title) {
    if (c.isLetterOrNumber()) out += c;
    else if (!out.isEmpty() && !out.endsWith(u'-')) out += u'-';
  }
  while (out.endsWith(u'-')) out.chop(1);
  return out.left(kLongestName);
}

/// The only file that is dragged; empty if there are none or several.
QString dragged_file(const QMimeData* data) {
  const QList<QUrl> urls = data->urls();
  return urls.size() == 1 && urls.front().isLocalFile() ? urls.front().toLocalFile() : QString();
}

/// The row of that id; nullptr without one.
const LibraryRow* row_with(const std::vector<LibraryRow>& rows, ScenarioId id) {
  const auto it = std::ranges::find_if(rows, [id](const LibraryRow& row) { return row.shown().id == id; });
  return it == rows.end() ? nullptr : &*it;
}

}  // namespace

template <class Work, class Then>
void LibraryPage::in_background(const QString& meanwhile, Work work, Then then) {
  working_ = true;
  band_->show_message(Band::Kind::info, meanwhile, {});
  work_ = with_own_store(store_, [self = QPointer(this), work, then](OwnStore own) {
    using Answer = std::invoke_result_t<Work, Store&>;
    const auto answer = std::make_shared<Answer>(own ? work(**own) : Answer(std::unexpected(FileFailure(own.error()))));
    QMetaObject::invokeMethod(
        qApp,
        [self, then, answer] {
          if (!self) return;
          self->working_ = false;
          self->read_.clear();
          self->band_->clear();
          if (!*answer) return self->show_failure(answer->error());
          then(*self, **answer);
        },
        Qt::QueuedConnection);
  });
}

void LibraryPage::show_failure(const FileFailure& failure) {
  if (const auto* of_records = std::get_if<StorageFailure>(&failure)) return show_failure(*of_records);
  const auto& of_file = std::get<ExerciseFileFailure>(failure);
  Message message = describe(of_file);
  if (const auto* finding = std::get_if<Finding>(&of_file)) message.more = check_message(*finding) + u' ' + tr("Nothing was changed.");
  band_->show_message(Band::Kind::bad, message.what, message.more);
}

void LibraryPage::save_chosen() {
  const int index = table_->chosen_row();
  if (index < 0) return;
  const LibraryRow row = model_->row(index);
  const Scenario& exercise = row.exercise ? row.exercise->scenario : *row.draft;
  const QString title = local(exercise.title), name = file_name_of(title);
  ports_.pick_file(this, {tr("Save the exercise as a file"), (name.isEmpty() ? tr("exercise") : name) + suffix(),
                          tr("Exercise (*%1)").arg(suffix()), true},
                   [self = QPointer(this), row, title](const QString& picked) {
                     if (self && !picked.isEmpty()) self->save_row(row, title, picked);
                   });
}

void LibraryPage::offer_again(const Question& question, std::function<void(LibraryPage&)> act) {
  ports_.ask(this, question, [self = QPointer(this), act = std::move(act)](bool yes) {
    if (self && yes) act(*self);
  });
}

void LibraryPage::save_row(const LibraryRow& row, const QString& title, const QString& picked) {
  const QString path = picked.endsWith(suffix(), Qt::CaseInsensitive) ? picked : picked + suffix();
  if (working()) {
    return offer_again({tr("%1 was not written.").arg(QFileInfo(path).fileName()), tr("Another file is still being written or read."), tr("Save again")},
                       [row, title, picked](LibraryPage& page) { page.save_row(row, title, picked); });
  }
  using Refusal = std::optional<ExerciseFileFailure>;  // of a published version, which is saved all the same
  const auto work = [row, path = path.toStdString(), database = database_](Store& store) -> Result<Refusal, FileFailure> {
    const auto file = file_of(store, row, database);
    if (!file) return std::unexpected(FileFailure(file.error()));
    const auto checked = check_exercise_file(*file);
    if (!checked && !row.exercise) return std::unexpected(FileFailure(checked.error()));
    if (const auto written = write_exercise_file(*file, path); !written) return std::unexpected(FileFailure(written.error()));
    return checked ? Refusal() : Refusal(checked.error());
  };
  const QString name = QFileInfo(path).fileName();
  const QString what = row.exercise ? tr("Version %1 of %2 is saved as a file.").arg(row.exercise->version_number).arg(title)
                                    : tr("The draft of %1 is saved as a file.").arg(title);
  const QString draft = row.exercise && row.draft ? u' ' + tr("Your draft of the next version is not in it.") : QString();
  in_background(tr("%1 is being written.").arg(name), work, [what, name, draft, row](LibraryPage& page, const Refusal& refusal) {
    if (!refusal) return page.band_->show_message(Band::Kind::good, what, tr("The file is %1. Another station opens it in its library.").arg(name) + draft);
    const auto* finding = std::get_if<Finding>(&*refusal);
    const QString why = finding ? check_message(*finding, &row.exercise->scenario.target) : describe(*refusal).more;
    page.band_->show_message(Band::Kind::look, what,
                             tr("The file is %1 and holds what was published. The checks refuse that now, and so does a station that opens the file: %2 "
                                "Mend it in the editor and publish it again.").arg(name, why) + draft);
  });
}

void LibraryPage::choose_file() {
  ports_.pick_file(this, {tr("Open an exercise"), {}, tr("Exercise (*%1)").arg(suffix() + u" *"_qs + suffix().toUpper()), false},
                   [self = QPointer(this)](const QString& path) {
                     if (self && !path.isEmpty()) self->open_file(path);
                   });
}

void LibraryPage::open_file(const QString& path) {
  if (working()) {
    if (path == read_) return;  // opened twice
    return offer_again({tr("%1 was not opened.").arg(QFileInfo(path).fileName()), tr("Another file is still being written or read."), tr("Open again")},
                       [path](LibraryPage& page) { page.open_file(path); });
  }
  read_ = path;
  std::vector<LibraryRow> rows;
  for (int i = 0; i < model_->rowCount(); ++i) rows.push_back(model_->row(i));
  const auto work = [rows = std::move(rows), path, database = database_](Store& store) -> Result<Looked, FileFailure> {
    auto file = read_exercise_file(path.toStdString());
    if (!file) return std::unexpected(FileFailure(file.error()));
    const auto standing = standing_of(store, *file, row_with(rows, file->scenario.id), database);
    if (!standing) return std::unexpected(FileFailure(standing.error()));
    return Looked{std::move(*file), *standing, path};
  };
  in_background(tr("%1 is being read.").arg(QFileInfo(path).fileName()), work,
                [](LibraryPage& page, const Looked& looked) { page.open_looked(looked); });
}

void LibraryPage::open_looked(const Looked& looked) {
  if (!isVisible()) return;  // whoever opened another exercise meanwhile is busy with that one
  const QString title = local(looked.file.scenario.title);
  switch (looked.standing) {
    case Standing::unknown: return open_taken(looked, KeepId::yes);
    case Standing::same:
      for (QComboBox* box : {group_, state_}) box->setCurrentIndex(0);
      search_->clear();
      table_->choose_row(row_of(looked.file.scenario.id));
      band_->show_message(Band::Kind::info, tr("%1 is in the library already.").arg(title), tr("The file holds the same. Nothing was changed."));
      return;
    case Standing::different: break;
  }
  ports_.ask(this, {tr("Open %1 as a new exercise?").arg(title),
                    tr("The library has this exercise with another content. It stays as it is; the file becomes an exercise beside it."),
                    tr("Open as a new exercise")},
             [self = QPointer(this), looked](bool yes) {
               if (self && yes) self->open_taken(looked, KeepId::no);
             });
}

void LibraryPage::open_taken(const Looked& looked, KeepId keep) {
  const ExerciseFile& file = looked.file;
  if (working()) {
    return offer_again({tr("%1 was not opened.").arg(local(file.scenario.title)), tr("Another file is still being written or read."), tr("Open again")},
                       [looked, keep](LibraryPage& page) { page.open_taken(looked, keep); });
  }
  read_ = looked.path;  // a second drop of it is the same wish
  const auto work = [actor = actor_, file, keep, database = database_](Store& store) -> Result<EditorStart, FileFailure> {
    auto start = take_in(store, actor, file, keep, database);
    if (!start) return std::unexpected(FileFailure(start.error()));
    return std::move(*start);
  };
  in_background(tr("%1 is being opened.").arg(local(file.scenario.title)), work, [](LibraryPage& page, const EditorStart& start) {
    const bool shown = page.isVisible();
    page.read();
    if (shown) Q_EMIT page.edit_wanted(start);
  });
}

int LibraryPage::row_of(ScenarioId id) const {
  for (int i = 0; i < model_->rowCount(); ++i)
    if (model_->row(i).shown().id == id) return i;
  return -1;
}

void LibraryPage::dragEnterEvent(QDragEnterEvent* event) {
  if (!dragged_file(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void LibraryPage::dropEvent(QDropEvent* event) {
  const QString path = dragged_file(event->mimeData());
  if (path.isEmpty()) return;
  event->acceptProposedAction();
  open_file(path);
}

}  // namespace cusp::ui
