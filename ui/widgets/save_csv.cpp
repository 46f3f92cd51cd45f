#include "ui/widgets/save_csv.h"

#include <QCoreApplication>
#include <QPointer>

#include "ui/widgets/save_bytes.h"

namespace cusp::ui {
namespace {

struct SaveText {
  Q_DECLARE_TR_FUNCTIONS(cusp::ui::SaveCsv)
};

}  // namespace

FileWish csv_file_wish(const QString& title, const QString& name) {
  FileWish where;
  where.title = title;
  where.name = name + QStringLiteral(".csv");
  where.filter = SaveText::tr("CSV (*.csv)");
  return where;
}

void show_unwritten(Band& band, const QString& path, const QString& reason) {
  band.show_message(Band::Kind::bad, SaveText::tr("The file was not written."),
                    SaveText::tr("%1: %2. What was there before is unchanged.").arg(path, reason));
}

void save_csv(Band& band, const Ports& ports, const CsvWish& wish) {
  ports.pick_file(&band, csv_file_wish(wish.title, wish.name), [band = QPointer(&band), make = wish.make](const QString& path) {
    if (!band) return;
    const auto made = make();
    if (!made) return;
    bool logged = true;
    const auto log = [&] { return logged = !made->log || made->log(); };
    if (const auto written = save_bytes(path, QByteArray::fromStdString(made->text), Readers::usual, log)) {
      band->show_message(Band::Kind::good, made->done, path);
    } else if (logged) {
      show_unwritten(*band, path, written.error());
    }
  });
}

}  // namespace cusp::ui
