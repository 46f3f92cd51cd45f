#include "ui/app/sparing_records.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <QWidget>
#include <utility>

#include "ui/session/database_files.h"

namespace cusp::ui {
namespace {

using Picked = std::function<void(const QString&)>;

struct SparingText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::SparingRecords)
};

void pick_spared(const Ports& ports, const std::filesystem::path& database, QWidget* parent, const FileWish& wish, const Picked& then) {
  ports.pick_file(parent, wish, [ports, database, parent = QPointer(parent), wish, then](const QString& path) {
    if (!database_of_file(path.toStdString(), database)) return then(path);
    if (!parent) return;
    const Question question{.what = SparingText::tr("%1 belongs to the records.").arg(QFileInfo(path).fileName()),
                            .more = SparingText::tr("A file of that name would take the place of one of theirs. Nothing was written."),
                            .act = SparingText::tr("Choose another name")};
    ports.ask(parent, question, [ports, database, parent, wish, then](bool again) {
      if (again && parent) pick_spared(ports, database, parent, wish, then);
    });
  });
}

}  // namespace

Ports sparing_records(Ports ports, const std::filesystem::path& database) {
  const Ports given = ports;
  ports.pick_file = [given, database](QWidget* parent, const FileWish& wish, const Picked& then) {
    if (!wish.saving || wish.what == FileWish::What::folder) return given.pick_file(parent, wish, then);
    pick_spared(given, database, parent, wish, then);
  };
  return ports;
}

}  // namespace cusp::ui
