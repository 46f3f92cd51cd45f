/// Backups as a table, newest first: when made, daily or by an administrator, sessions, size, folder. Thread: GUI.
#pragma once

#include <optional>
#include <vector>

#include "storage/backup/backup.h"
#include "ui/modules.h"
#include "ui/widgets/table.h"

class QStandardItemModel;

namespace cusp::ui {

/// Of backups, newest first: how they stand where a wrong clock dated some; else empty.
QString dates_note(const std::vector<Backup>& newest_first);

class BackupsTable : public Table {
  Q_OBJECT

 public:
  explicit BackupsTable(QWidget* parent = nullptr);
  void show_backups(std::vector<Backup> backups);
  std::optional<Backup> chosen() const;

 private:
  QStandardItemModel* list_;
  std::vector<Backup> backups_;
};

}  // namespace cusp::ui
