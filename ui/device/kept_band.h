/// Reports that the changes made on a panel of the device page end with the program, because the file of the settings cannot be
/// written. Hidden otherwise. Thread: GUI.
#pragma once

#include "ui/widgets/parts.h"

namespace cusp::ui {

class KeptBand : public Band {
 public:
  explicit KeptBand(QString file, QWidget* parent = nullptr);
  /// Of the newest change, which brings along what could not be written before. Announced once while the band is shown.
  void show_kept(bool kept);

 private:
  QString file_;
};

}  // namespace cusp::ui
