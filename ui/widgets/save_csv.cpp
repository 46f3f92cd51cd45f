#include "ui/widgets/save_csv.h"

#include <QCoreApplication>
#include <QPointer>
#include <QSaveFile>

namespace cusp::ui {
namespace {

struct SaveText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::SaveCsv)
};

}  // namespace

void save_csv(Band& band, const Ports& ports, const CsvWish& wish) {
  FileWish where;
  where.title = wish.title;
  where.name = wish.name + QStringLiteral(".csv");
  where.filter = SaveText::tr("CSV (*.csv)");
  ports.pick_file(&band, where, [band = QPointer(&band), done = wish.done, bytes = QByteArray::fromStdString(wish.text)](const QString& path) {
    if (!band) return;
    // QSaveFile renames at the end: a full disk leaves the old file.
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.commit()) {
      band->show_message(Band::Kind::good, done, path);
    } else {
      band->show_message(Band::Kind::bad, SaveText::tr("The file was not written."),
                         SaveText::tr("%1: %2. What was there before is unchanged.").arg(path, file.errorString()));
    }
  });
}

}  // namespace cusp::ui
