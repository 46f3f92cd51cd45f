#include "ui/device/hid_settings.h"

#include "ui/settings/settings.h"
#include "ui/settings/write_settings.h"

namespace cusp::ui {

HidSettings::HidSettings(const QString& file)
    : store_(file.isEmpty() ? Settings::usual_file() : file, QSettings::IniFormat) {}

hid::PedalSettings HidSettings::pedal() const {
  return hid::pedal_settings_from(store_.value("hid/pedal").toString().toStdString());
}
bool HidSettings::set_pedal(const hid::PedalSettings& settings) {
  return write_settings(file(), {{u"hid/pedal"_qs, QString::fromStdString(hid::to_text(settings))}});
}
hid::SpaceMouseSettings HidSettings::space_mouse() const {
  return hid::space_mouse_settings_from(store_.value("hid/space_mouse").toString().toStdString());
}
bool HidSettings::set_space_mouse(const hid::SpaceMouseSettings& settings) {
  return write_settings(file(), {{u"hid/space_mouse"_qs, QString::fromStdString(hid::to_text(settings))}});
}

}  // namespace cusp::ui
