#include "ui/settings/write_settings.h"

#include <QSettings>

namespace cusp::ui {

bool write_settings(const QString& file, const std::vector<SettingsEntry>& entries) {
  QSettings fresh(file, QSettings::IniFormat);  // its status is of this write alone
  for (const SettingsEntry& entry : entries) {
    if (entry.value.isValid()) {
      fresh.setValue(entry.key, entry.value);
    } else {
      fresh.remove(entry.key);
    }
  }
  fresh.sync();
  return fresh.status() != QSettings::AccessError;
}

}  // namespace cusp::ui
