#include "tests/device/hid/mock_hid.h"

#include <linux/hidraw.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace cusp::test {

namespace {

std::string upper_hex(const Bytes& bytes) {
  std::string out;
  for (const std::uint8_t byte : bytes) {
    constexpr char kDigits[] = "0123456789ABCDEF";  // umockdev reads upper case alone
    out += kDigits[byte >> 4];
    out += kDigits[byte & 15];
  }
  return out;
}

std::string number_of(std::uint16_t value, const char* form) {
  char text[16];
  std::snprintf(text, sizeof text, form, static_cast<unsigned>(value));
  return text;
}

}  // namespace

MockHid::MockHid(MockHidBus& bus, int number, std::uint16_t vendor, std::uint16_t product, std::string name,
                 Bytes descriptor)
    : bus_(bus),
      number_(number),
      vendor_(vendor),
      product_(product),
      name_(std::move(name)),
      node_("hidraw" + std::to_string(number)),
      usb_path_("/devices/pci0000:00/usb1/1-" + std::to_string(number)),
      descriptor_(std::move(descriptor)),
      base_(umockdev_ioctl_base_new()) {
  g_signal_connect(base_, "handle-ioctl", G_CALLBACK(&MockHid::on_ioctl), this);
  g_signal_connect(base_, "handle-read", G_CALLBACK(&MockHid::on_read), this);
}

MockHid::~MockHid() {
  unplug();
  if (attached_) umockdev_testbed_detach_ioctl(bus_.testbed(), path().c_str(), nullptr);
  g_object_unref(base_);
}

void MockHid::plug() {
  if (plugged_) return;
  const std::string vendor = number_of(vendor_, "%04X"), product = number_of(product_, "%04X");
  const std::string small = number_of(vendor_, "%04x"), small_product = number_of(product_, "%04x");
  const std::string socket = "1-" + std::to_string(number_);
  const std::string interface_path = usb_path_ + "/" + socket + ":1.0";
  const std::string hid = "0003:" + vendor + ":" + product + ".000" + std::to_string(number_);
  static int minor = 0;  // the testbed keeps the links of numbers that were there once
  ++minor;
  std::string text = "P: " + usb_path_ + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n";
  text += "A: busnum=1\\n\nA: devnum=" + std::to_string(number_ + 1) + "\\n\nA: idVendor=" + small +
          "\\n\nA: idProduct=" + small_product + "\\n\nA: bcdDevice=0100\\n\nA: manufacturer=Maker\\n\nA: product=" + name_ +
          "\\n\nA: serial=S" + std::to_string(number_) + "\\n\n\n";
  text += "P: " + interface_path + "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nA: bInterfaceNumber=00\\n\n\n";
  text += "P: " + interface_path + "/" + hid + "\nE: SUBSYSTEM=hid\nE: HID_ID=0003:0000" + vendor + ":0000" + product +
          "\nE: HID_NAME=" + name_ + "\nE: HID_PHYS=usb-" + socket + "\nE: HID_UNIQ=S" + std::to_string(number_) +
          "\nH: report_descriptor=" + upper_hex(descriptor_) + "\n\n";
  text += "P: " + interface_path + "/" + hid + "/hidraw/" + node_ + "\nN: " + node_ + "=00\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/" +
          node_ + "\nA: dev=240:" + std::to_string(minor) + "\\n\nL: device=../../../" + hid + "\n\n";
  GError* error = nullptr;
  // Of the time before it was unplugged; whoever held it then has closed it by now.
  if (attached_) umockdev_testbed_detach_ioctl(bus_.testbed(), path().c_str(), nullptr);
  attached_ = true;
  if (!umockdev_testbed_add_from_string(bus_.testbed(), text.c_str(), &error)) throw std::runtime_error(error->message);
  if (!umockdev_testbed_attach_ioctl(bus_.testbed(), path().c_str(), base_, &error))
    throw std::runtime_error(error->message);
  const std::lock_guard lock(mutex_);
  plugged_ = true;
}

void MockHid::unplug() {
  if (!plugged_) return;
  {
    const std::lock_guard lock(mutex_);
    plugged_ = false;
    reports_.clear();
  }
  const std::string hid = number_of(vendor_, "%04X") + ":" + number_of(product_, "%04X");
  const std::string leaf = "/sys" + usb_path_ + "/1-" + std::to_string(number_) + ":1.0";
  const std::string hid_path = leaf + "/0003:" + hid + ".000" + std::to_string(number_);
  for (const std::string& at : {hid_path + "/hidraw/" + node_, hid_path, leaf, "/sys" + usb_path_})
    umockdev_testbed_remove_device(bus_.testbed(), at.c_str());
}

void MockHid::send(Bytes report) {
  const std::lock_guard lock(mutex_);
  reports_.push_back(std::move(report));
}

std::size_t MockHid::waiting() {
  const std::lock_guard lock(mutex_);
  return reports_.size();
}

gboolean MockHid::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, MockHid* self) {
  const std::lock_guard lock(self->mutex_);
  const auto request = umockdev_ioctl_client_get_request(client);
  UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
  if (!self->plugged_) {
    umockdev_ioctl_client_complete(client, -1, ENODEV);
  } else if (request == HIDIOCGRDESCSIZE) {
    UMockdevIoctlData* out = umockdev_ioctl_data_resolve(argument, 0, sizeof(int), nullptr);
    const int size = static_cast<int>(self->descriptor_.size());
    std::memcpy(out->data, &size, sizeof size);
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(out);
  } else if (request == HIDIOCGRDESC) {
    UMockdevIoctlData* out = umockdev_ioctl_data_resolve(argument, 0, sizeof(hidraw_report_descriptor), nullptr);
    auto* answer = reinterpret_cast<hidraw_report_descriptor*>(out->data);
    answer->size = static_cast<std::uint32_t>(self->descriptor_.size());
    std::memcpy(answer->value, self->descriptor_.data(), self->descriptor_.size());
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(out);
  } else {
    umockdev_ioctl_client_complete(client, -1, ENOTTY);
  }
  return TRUE;
}

gboolean MockHid::on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, MockHid* self) {
  const std::lock_guard lock(self->mutex_);
  if (!self->plugged_) {
    umockdev_ioctl_client_complete(client, -1, ENODEV);
    return TRUE;
  }
  if (self->reports_.empty()) {
    umockdev_ioctl_client_complete(client, -1, EAGAIN);
    return TRUE;
  }
  UMockdevIoctlData* into = umockdev_ioctl_client_get_arg(client);
  const Bytes report = std::move(self->reports_.front());
  self->reports_.pop_front();
  const std::size_t size = std::min<std::size_t>(report.size(), into->data_len);
  std::memcpy(into->data, report.data(), size);
  umockdev_ioctl_client_complete(client, static_cast<glong>(size), 0);
  return TRUE;
}

}  // namespace cusp::test
