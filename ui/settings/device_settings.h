/// What this station knows of its devices: which one is used, the firmware file that somebody named, and what was
/// measured of each Falcon. In the same file as Settings. GUI thread, or a verb's only one.
#pragma once

#include <QDateTime>
#include <QSettings>
#include <optional>

#include "ui/session/session_device.h"

namespace cusp::ui {

class DeviceSettings {
 public:
  /// `file` as Settings::file(); empty: the user's own.
  explicit DeviceSettings(const QString& file = {});
  QString file() const { return store_.fileName(); }

  /// The device that attempts are drilled with, with all that is known of it.
  DeviceChoice choice() const;
  /// Choosing keeps what is known of the others. False: the file cannot be written, and the choice ends with the program.
  bool choose(const std::string& kind, const std::string& name);
  /// With what is known of this one.
  DeviceChoice choice_of(const std::string& kind, const std::string& name) const;

  InverseSettings inverse() const;
  /// False: as of choose(); so for the others.
  bool set_inverse(const InverseSettings& settings);

  FirmwareChoice firmware() const;
  bool set_firmware(const FirmwareChoice& firmware);

  FalconProfile profile(const std::string& name) const;
  bool set_profile(const std::string& name, const FalconProfile& profile);
  /// When the self-test of that Falcon was last taken over.
  std::optional<QDateTime> tested_at(const std::string& name) const;
  bool set_tested_at(const std::string& name, const QDateTime& when);

 private:
  QSettings store_;
};

}  // namespace cusp::ui
