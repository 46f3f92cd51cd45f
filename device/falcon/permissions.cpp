#include "device/falcon/permissions.h"

namespace cusp::device::falcon {

std::string_view udev_rule() noexcept {
  return R"(SUBSYSTEM=="usb", ENV{DEVTYPE}=="usb_device", ATTR{idVendor}=="0403", ATTR{idProduct}=="cb48", TAG+="uaccess", ATTR{power/control}="on")";
}

std::string_view udev_rule_path() noexcept { return "/etc/udev/rules.d/51-cusp.rules"; }

std::string udev_install_command() {
  return "echo '" + std::string(udev_rule()) + "' | sudo tee " + std::string(udev_rule_path()) +
         " >/dev/null && sudo udevadm control --reload && sudo udevadm trigger --action=add --subsystem-match=usb"
         " --attr-match=idVendor=0403 --attr-match=idProduct=cb48";
}

}  // namespace cusp::device::falcon
