#include "ui/settings/device_settings.h"

#include <QUrl>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "device/catalogue.h"
#include "ui/modules.h"
#include "ui/settings/settings.h"
#include "ui/settings/write_settings.h"

namespace cusp::ui {
namespace {

/// A Falcon's group; serial numbers may hold anything.
QString group(const std::string& name, const char* key) {
  const QString safe = QString::fromLatin1(QUrl::toPercentEncoding(QString::fromStdString(name)));
  return QStringLiteral("falcon-%1/%2").arg(safe, QString::fromLatin1(key));
}

}  // namespace

DeviceSettings::DeviceSettings(const QString& file)
    : store_(file.isEmpty() ? Settings::usual_file() : file, QSettings::IniFormat) {}

DeviceChoice DeviceSettings::choice() const {
  const std::string kind = store_.value("device/kind").toString().toStdString();
  const DeviceKind* known = device_kind(kind);
  if (known == nullptr || !known->offered) return choice_of(std::string(device_kinds().front().key), {});
  return choice_of(kind, store_.value("device/name").toString().toStdString());
}

DeviceChoice DeviceSettings::choice_of(const std::string& kind, const std::string& name) const {
  DeviceChoice out{.kind = kind, .name = name, .firmware = firmware(), .profile = {}};
  if (kind == "falcon") out.profile = profile(name);
  if (kind == "inverse3") out.inverse = inverse();
  return out;
}

bool DeviceSettings::choose(const std::string& kind, const std::string& name) {
  return write_settings(file(), {{u"device/kind"_qs, QString::fromStdString(kind)}, {u"device/name"_qs, QString::fromStdString(name)}});
}

InverseSettings DeviceSettings::inverse() const {
  InverseSettings out;
  const int port = store_.value("inverse/port", out.service.port).toInt();
  if (port > 0 && port <= 65535) out.service.port = static_cast<std::uint16_t>(port);
  const int turned = store_.value("inverse/turned_deg", 0).toInt();
  if (turned % 90 == 0 && turned >= 0 && turned < 360) out.yaw_rad = turned * std::numbers::pi / 180.0;
  bool ok = false;
  const int percent = store_.value("inverse/scale_percent").toInt(&ok);
  if (ok) out.scale = std::clamp(percent, 5, 100) / 100.0;
  return out;
}

bool DeviceSettings::set_inverse(const InverseSettings& settings) {
  return write_settings(file(), {{u"inverse/port"_qs, settings.service.port},
                                 {u"inverse/turned_deg"_qs, static_cast<int>(std::lround(settings.yaw_rad * 180.0 / std::numbers::pi))},
                                 {u"inverse/scale_percent"_qs, static_cast<int>(std::lround(100 * settings.scale))}});
}

FirmwareChoice DeviceSettings::firmware() const {
  return {store_.value("firmware/file").toString().toStdString(),
          store_.value("firmware/sha256").toString().toStdString()};
}

bool DeviceSettings::set_firmware(const FirmwareChoice& firmware) {
  return write_settings(file(), {{u"firmware/file"_qs, QString::fromStdString(firmware.file.string())},
                                 {u"firmware/sha256"_qs, QString::fromStdString(firmware.sha256)}});
}

FalconProfile DeviceSettings::profile(const std::string& name) const {
  FalconProfile out;
  const auto number = [&](const char* key) -> std::optional<double> {
    bool ok = false;
    const double value = store_.value(group(name, key)).toDouble(&ok);
    return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
  };
  const char* trims[] = {"trim_top_rad", "trim_right_rad", "trim_left_rad"};
  for (int i = 0; i < 3; ++i) out.calibration.trim_rad[i] = number(trims[i]).value_or(0.0);
  out.calibration.force_gain = number("force_gain").value_or(out.calibration.force_gain);
  out.gravity.grip_kg = number("grip_kg").value_or(0.0);
  out.gravity.arm_kg_m = number("arm_kg_m").value_or(0.0);
  out.scale = number("scale").value_or(out.scale);
  const Vec3 usual = out.centre_m;
  out.centre_m = {number("centre_x_m").value_or(usual.x), number("centre_y_m").value_or(usual.y), number("centre_z_m").value_or(usual.z)};
  out.clutch = static_cast<std::uint8_t>(store_.value(group(name, "clutch"), out.clutch).toUInt());
  out.damping_ns_per_m = number("damping_ns_per_m");
  out.delay_ms = number("delay_ms");
  out.friction_n = number("friction_n");
  out.moving_kg = number("moving_kg");
  out.encoder_mm = number("encoder_mm");
  return out;
}

bool DeviceSettings::set_profile(const std::string& name, const FalconProfile& profile) {
  std::vector<SettingsEntry> entries;
  const auto keep = [&](const char* key, std::optional<double> value) {
    entries.push_back({group(name, key), value ? QVariant(*value) : QVariant()});
  };
  keep("trim_top_rad", profile.calibration.trim_rad.x);
  keep("trim_right_rad", profile.calibration.trim_rad.y);
  keep("trim_left_rad", profile.calibration.trim_rad.z);
  keep("force_gain", profile.calibration.force_gain);
  keep("grip_kg", profile.gravity.grip_kg);
  keep("arm_kg_m", profile.gravity.arm_kg_m);
  keep("scale", profile.scale);
  keep("centre_x_m", profile.centre_m.x);
  keep("centre_y_m", profile.centre_m.y);
  keep("centre_z_m", profile.centre_m.z);
  keep("clutch", profile.clutch);
  keep("damping_ns_per_m", profile.damping_ns_per_m);
  keep("delay_ms", profile.delay_ms);
  keep("friction_n", profile.friction_n);
  keep("moving_kg", profile.moving_kg);
  keep("encoder_mm", profile.encoder_mm);
  return write_settings(file(), entries);
}

std::optional<QDateTime> DeviceSettings::tested_at(const std::string& name) const {
  const QDateTime when = QDateTime::fromString(store_.value(group(name, "tested_at")).toString(), Qt::ISODate);
  return when.isValid() ? std::optional(when) : std::nullopt;
}

bool DeviceSettings::set_tested_at(const std::string& name, const QDateTime& when) {
  return write_settings(file(), {{group(name, "tested_at"), when.toUTC().toString(Qt::ISODate)}});
}

}  // namespace cusp::ui
