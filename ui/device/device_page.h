/// What this station drills with: what is plugged in, which of it is used, permissions, the Falcon's firmware file, and a
/// panel for each kind. Students look and feel; what changes the station is for staff. Thread: GUI.
#pragma once

#include <QWidget>
#include <functional>
#include <memory>

#include "device/catalogue.h"
#include "storage/repositories/device_tests.h"
#include "ui/modules.h"
#include "ui/session/background_watch.h"
#include "ui/settings/settings.h"
#include "ui/widgets/ports.h"

class QVBoxLayout;

namespace cusp::device::hid {
class HidStation;
}

namespace cusp::ui {

class DevicePage : public QWidget {
  Q_OBJECT

 public:
  using MakeWatch = std::function<std::unique_ptr<DeviceWatch>()>;
  /// `settings` and `hid` outlive this; `hid` null: no pedal, no SpaceMouse. The watch lasts while the page is seen; empty: the
  /// station's own, with the Inverse3's service at the port of the settings.
  DevicePage(Settings& settings, Ports ports, Role role, hid::HidStation* hid = nullptr,
             MakeWatch watch = {}, QWidget* parent = nullptr);
  ~DevicePage() override;

  class FalconPanel* falcon() const;
  /// What is listed now, as people read it.
  QStringList listed() const;

 public Q_SLOTS:
  /// Takes over what was found; by itself while the page is seen.
  void look();

 Q_SIGNALS:
  /// Another device was chosen, and is kept at least until the program ends: see DeviceSettings.
  void chosen();
  /// As FalconPanel::tested().
  void tested(const DeviceTest& test);

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void fill();
  void use(const FoundDevice& device);
  void show_chosen();
  void name_firmware();
  void make_firmware_card();
  void add_hid_cards(hid::HidStation& hid, Settings& settings, QVBoxLayout* body);
  void show_firmware();

  struct Inner;
  std::unique_ptr<Inner> inner_;
};

}  // namespace cusp::ui
