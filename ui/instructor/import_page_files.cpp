// How files come to the import page: by drop, and by choice.

#include <QDragEnterEvent>
#include <QMimeData>
#include <QUrl>

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

void ImportPage::pick_files() {
  ports_.pick_file(this,
                   {tr("Choose a file"), {},
                    tr("Meshes and volumes (*.stl *.obj *.ply *.3ds *.off *.nrrd *.mha *.mhd *.nii *.nii.gz *.hdr *.binvox *.dcm *.ima);;All files (*)"),
                    false},
                   [this](const QString& path) { open_files({path}); });
}

}  // namespace cusp::ui
