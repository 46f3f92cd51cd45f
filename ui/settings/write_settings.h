/// Writes into the file of the settings at once. GUI thread, or a verb's only one.
#pragma once

#include <QString>
#include <QVariant>
#include <vector>

namespace cusp::ui {

struct SettingsEntry {
  QString key;
  QVariant value;  // invalid: the key goes
};

/// Every object of the program with this file reads them at once. False: the file itself cannot be written, and they end with the program.
bool write_settings(const QString& file, const std::vector<SettingsEntry>& entries);

}  // namespace cusp::ui
