/// What this station knows of its pedal, its SpaceMouse and its Inverse3. In the same file as Settings. GUI thread.
#pragma once

#include <QSettings>

#include "device/hid/settings_text.h"
#include "ui/modules.h"

namespace cusp::ui {

class HidSettings {
 public:
  /// `file` as Settings::file(); empty: the user's own.
  explicit HidSettings(const QString& file = {});

  hid::PedalSettings pedal() const;
  void set_pedal(const hid::PedalSettings& settings);
  hid::SpaceMouseSettings space_mouse() const;
  void set_space_mouse(const hid::SpaceMouseSettings& settings);

 private:
  QSettings store_;
};

}  // namespace cusp::ui
