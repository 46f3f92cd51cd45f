#include "device/hid/permissions.h"

#include <array>
#include <cstdio>

#include "device/hid/space_mouse.h"

namespace cusp::device::hid {

namespace {

// As 52-cusp-hid.rules has them; a test compares the two.
constexpr std::string_view kRules =
    R"(KERNEL=="hidraw*", ATTRS{idVendor}=="05f3", ATTRS{idProduct}=="00ff", TAG+="uaccess"
KERNEL=="hidraw*", ATTRS{idVendor}=="0c45", ATTRS{idProduct}=="7403", TAG+="uaccess"
KERNEL=="hidraw*", ATTRS{idVendor}=="1a86", ATTRS{idProduct}=="e026", TAG+="uaccess"
KERNEL=="hidraw*", ATTRS{idVendor}=="06a3", ATTRS{idProduct}=="0763", TAG+="uaccess"
KERNEL=="hidraw*", ATTRS{idVendor}=="256f", TAG+="uaccess"
KERNEL=="hidraw*", ATTRS{idVendor}=="046d", ATTRS{idProduct}=="c60[356]", TAG+="uaccess"
KERNEL=="hidraw*", ATTRS{idVendor}=="046d", ATTRS{idProduct}=="c62[135-9b]", TAG+="uaccess"
)";

struct Number {
  std::uint16_t vendor, product;
};
constexpr std::array kPedals = {Number{0x05f3, 0x00ff}, 
                                Number{0x0c45, 0x7403}, Number{0x1a86, 0xe026}, Number{0x06a3, 0x0763}};

std::string hex(std::uint16_t value) {
  std::array<char, 8> out{};
  std::snprintf(out.data(), out.size(), "%04x", static_cast<unsigned>(value));
  return out.data();
}

}  // namespace

std::string_view udev_rules() noexcept { return kRules; }

std::string_view udev_rules_path() noexcept { return "/etc/udev/rules.d/52-cusp-hid.rules"; }

bool is_ruled(std::uint16_t vendor, std::uint16_t product) noexcept {
  for (const Number& pedal : kPedals) {
    if (pedal.vendor == vendor && pedal.product == product) return true;
  }
  return vendor == 0x256f || is_space_mouse(vendor, product);
}

std::string udev_rule_for(std::uint16_t vendor, std::uint16_t product) {
  return "KERNEL==\"hidraw*\", ATTRS{idVendor}==\"" + hex(vendor) + "\", ATTRS{idProduct}==\"" + hex(product) +
         "\", TAG+=\"uaccess\"";
}

std::string udev_install_command(std::uint16_t vendor, std::uint16_t product) {
  // One line to copy: printf turns the two letters \n into ends of lines.
  std::string lines;
  for (const char c : kRules) lines += c == '\n' ? std::string("\\n") : std::string(1, c);
  if (!is_ruled(vendor, product)) lines += udev_rule_for(vendor, product) + "\\n";
  return "printf '" + lines + "' | sudo tee " + std::string(udev_rules_path()) +
         " >/dev/null && sudo udevadm control --reload && sudo udevadm trigger --action=add --subsystem-match=hidraw";
}

}  // namespace cusp::device::hid
