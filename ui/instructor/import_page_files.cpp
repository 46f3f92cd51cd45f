// How files come to the import page, by drop and by choice, and what is asked before they are left.

#include <QDragEnterEvent>
#include <QMimeData>
#include <QPointer>
#include <QUrl>
#include <algorithm>
#include <utility>

#include "ui/instructor/import_drop.h"
#include "ui/instructor/import_page.h"
#include "ui/widgets/theme.h"

namespace cusp::ui {
namespace {

QStringList local_files(const QMimeData* data) {
  QStringList out;
  for (const QUrl& url : data->urls())
    if (url.isLocalFile()) out << url.toLocalFile();
  return out;
}

}  // namespace

void ImportPage::dragEnterEvent(QDragEnterEvent* event) {
  if (work_ || local_files(event->mimeData()).isEmpty()) return;
  for (Card* card : {static_cast<Card*>(drop_card_), files_card_}) set_kind(card, "drop");
  event->acceptProposedAction();
}

void ImportPage::dragLeaveEvent(QDragLeaveEvent*) {
  for (Card* card : {static_cast<Card*>(drop_card_), files_card_}) set_kind(card, "card");
}

void ImportPage::dropEvent(QDropEvent* event) {
  dragLeaveEvent(nullptr);
  const QStringList paths = local_files(event->mimeData());
  if (work_ || paths.isEmpty()) return;
  event->acceptProposedAction();
  open_files(paths);
}

void ImportPage::open_files(const QStringList& paths) {
  std::vector<std::filesystem::path> chosen;
  for (const QString& path : paths) chosen.emplace_back(path.toStdString());
  joins_ = mesh_form_ && std::ranges::all_of(chosen, [](const auto& f) { return file_kind(f) == FileKind::mesh; });
  if (!files_before_) files_before_ = files_;
  if (joins_) {
    files_ = *files_before_;
    for (auto& file : chosen)
      if (std::ranges::find(files_, file) == files_.end()) files_.push_back(std::move(file));
  } else {
    files_ = std::move(chosen);
  }
  look();
}

void ImportPage::leave() {
  if (!begun()) return Q_EMIT back_wanted();
  const Question question{tr("Leave the import?"), tr("The files stay as they are. What was read of them and what you chose here is not kept."), tr("Leave"), true};
  ports_.ask(this, question, [self = QPointer(this)](bool yes) {
    if (self && yes) Q_EMIT self->back_wanted();
  });
}

void ImportPage::take_back_files() {
  joins_ = false;
  if (files_before_) files_ = *std::exchange(files_before_, std::nullopt);
}

void ImportPage::pick_files() {
  ports_.pick_file(this,
                   {tr("Choose a file"), {},
                    tr("Meshes and volumes (*.stl *.obj *.ply *.3ds *.off *.nrrd *.mha *.mhd *.nii *.nii.gz *.hdr *.binvox *.dcm *.ima);;All files (*)"),
                    false},
                   [this](const QString& path) { open_files({path}); });
}

}  // namespace cusp::ui
