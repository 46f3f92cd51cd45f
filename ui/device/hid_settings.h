/// What this station knows of its pedal and its SpaceMouse. In the same file as Settings. GUI thread.
#pragma once

#include <QSettings>

#include "device/hid/settings_text.h"
#include "ui/modules.h"

namespace cusp::ui {

class HidSettings {
 public:
  /// `file` as Settings::file(); empty: the user's own.
  explicit HidSettings(const QString& file = {});
  QString file() const { return store_.fileName(); }

  hid::PedalSettings pedal() const;
  /// False: the file cannot be written, and the settings end with the program.
  bool set_pedal(const hid::PedalSettings& settings);
  hid::SpaceMouseSettings space_mouse() const;
  bool set_space_mouse(const hid::SpaceMouseSettings& settings);

 private:
  QSettings store_;
};

}  // namespace cusp::ui
