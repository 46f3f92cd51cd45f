// LibraryPage and files: the chosen exercise as NAME.cusp, and such a file as a draft.

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMimeData>
#include <QPointer>
#include <QUrl>
#include <variant>

#include "ui/editor/check_messages.h"
#include "ui/instructor/exchange.h"
#include "ui/instructor/library_page.h"
#include "ui/modules.h"
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

/// Reading a volume takes up to some seconds.
class WaitCursor {
 public:
  WaitCursor() { QGuiApplication::setOverrideCursor(Qt::WaitCursor); }
  ~WaitCursor() { QGuiApplication::restoreOverrideCursor(); }
  WaitCursor(const WaitCursor&) = delete;
  WaitCursor& operator=(const WaitCursor&) = delete;
};

}  // namespace

void LibraryPage::show_refusal(const ExerciseFileFailure& failure) {
  Message message = describe(failure);
  if (const auto* finding = std::get_if<Finding>(&failure)) message.more = check_message(*finding) + u' ' + tr("Nothing was changed.");
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

void LibraryPage::save_row(const LibraryRow& row, const QString& title, const QString& picked) {
  const QString path = picked.endsWith(suffix(), Qt::CaseInsensitive) ? picked : picked + suffix();
  const WaitCursor waits;
  const auto file = file_of(store_, row, database_);
  if (!file) return show_failure(file.error());
  if (const auto written = write_exercise_file(*file, path.toStdString()); !written) return show_refusal(written.error());
  const QString where = tr("The file is %1. Another station opens it in its library.").arg(QFileInfo(path).fileName());
  const QString what = row.exercise ? tr("Version %1 of %2 is saved as a file.").arg(row.exercise->version_number).arg(title)
                                    : tr("The draft of %1 is saved as a file.").arg(title);
  band_->show_message(Band::Kind::good, what, row.exercise && row.draft ? where + u' ' + tr("Your draft of the next version is not in it.") : where);
}

void LibraryPage::choose_file() {
  ports_.pick_file(this, {tr("Open an exercise"), {}, tr("Exercise (*%1)").arg(suffix()), false}, [self = QPointer(this)](const QString& path) {
    if (self && !path.isEmpty()) self->open_file(path);
  });
}

void LibraryPage::open_file(const QString& path) {
  const auto file = [&] {
    const WaitCursor waits;
    return read_exercise_file(path.toStdString());
  }();
  if (!file) return show_refusal(file.error());
  int index = -1;
  for (int i = 0; i < model_->rowCount(); ++i)
    if (model_->row(i).shown().id == file->scenario.id) index = i;
  const auto standing = standing_of(store_, *file, index >= 0 ? &model_->row(index) : nullptr, database_);
  if (!standing) return show_failure(standing.error());
  switch (*standing) {
    case Standing::unknown: return open_taken(*file, KeepId::yes);
    case Standing::same:
      search_->clear();
      table_->choose_row(index);
      band_->show_message(Band::Kind::info, tr("%1 is in the library already.").arg(local(file->scenario.title)),
                          tr("The file holds the same. Nothing was changed."));
      return;
    case Standing::different: break;
  }
  ports_.ask(this, {tr("Open %1 as a new exercise?").arg(local(file->scenario.title)),
                    tr("The library has this exercise with another content. It stays as it is; the file becomes an exercise beside it."),
                    tr("Open as a new exercise")},
             [self = QPointer(this), file = *file](bool yes) {
               if (self && yes) self->open_taken(file, KeepId::no);
             });
}

void LibraryPage::open_taken(const ExerciseFile& file, KeepId keep) {
  const auto start = take_in(store_, actor_, file, keep, database_);
  if (!start) return show_failure(start.error());
  read();
  Q_EMIT edit_wanted(*start);
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
