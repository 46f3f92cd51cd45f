/// Records that cannot be read whole, or those of a new computer: a backup takes their place, and what stood there is kept in a folder
/// beside it. Thread: GUI; the backup is checked and copied in the background.
#pragma once

#include <QWidget>
#include <filesystem>
#include <optional>

#include "storage/backup/backup.h"
#include "ui/admin/backup_work.h"
#include "ui/modules.h"
#include "ui/text/failure_text.h"
#include "ui/widgets/ports.h"

class QLabel;
class QPushButton;

namespace cusp::ui {

class BackupsTable;
class Band;
class Busy;

class WayBack : public QWidget {
  Q_OBJECT

 public:
  /// Nothing has `database` open. `backups`: the folder that is looked into first. Ports outlive the page.
  WayBack(std::filesystem::path database, std::filesystem::path backups, const Message& why, const Ports& ports, QWidget* parent = nullptr);
  QString message() const;
  QPushButton* act() const { return go_back_; }

 public Q_SLOTS:
  void go_back();
  void choose_folder();

 Q_SIGNALS:
  void try_again();
  /// The backup stands in the place of the damaged records.
  void went_back(const Message& done);

 private:
  /// Shows its backups, once they are read in the background: those of this station first, each part newest first.
  void look_into(const std::filesystem::path& folder);
  void show_found(const FoundBackups& found);
  void begin(const Backup& backup);
  void show_went_back(const Stored<WentBack>& done);
  void enable(bool on);

  std::filesystem::path database_;
  std::optional<Uuid> station_;  // of the damaged records; nullopt: nothing names it
  const Ports& ports_;
  std::filesystem::path folder_;  // the one that is looked into
  BackgroundTask task_, finding_;
  int asked_ = 0;  // calls of look_into()
  Band* band_;
  Busy* busy_;
  QLabel* found_;
  BackupsTable* table_;
  QPushButton *go_back_, *choose_, *again_;
};

}  // namespace cusp::ui
