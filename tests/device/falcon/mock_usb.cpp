#include "tests/device/falcon/mock_usb.h"

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <stdexcept>

namespace cusp::test {

namespace {

using falcon::LinkTime;

LinkTime now() { return std::chrono::steady_clock::now().time_since_epoch(); }

std::string hex(const std::vector<std::uint8_t>& bytes) {
  std::string out;
  for (const std::uint8_t byte : bytes) {
    constexpr char kDigits[] = "0123456789ABCDEF";  // umockdev reads upper case alone
    out += kDigits[byte >> 4];
    out += kDigits[byte & 15];
  }
  return out;
}

constexpr std::uint8_t kSerialString = 3;

/// Device, configuration, one vendor interface, bulk 0x81 and 0x02 of 64 bytes. `serial_string`: index of the serial
/// number's string, 0 for none.
std::vector<std::uint8_t> descriptors(std::uint8_t serial_string) {
  return {18,
          1,
          0x00,
          0x02,
          0,
          0,
          0,
          8,
          0x03,
          0x04,
          0x48,
          0xCB,
          0x00,
          0x06,
          1,
          2,
          serial_string,
          1,
          9,
          2,
          32,
          0,
          1,
          1,
          0,
          0x80,
          45,
          9,
          4,
          0,
          0,
          2,
          0xFF,
          0xFF,
          0xFF,
          2,
          7,
          5,
          0x81,
          2,
          64,
          0,
          0,
          7,
          5,
          0x02,
          2,
          64,
          0,
          0};
}

}  // namespace

struct MockFalcon::Urb {
  UMockdevIoctlData* data = nullptr;
  UMockdevIoctlData* buffer = nullptr;
  usbdevfs_urb* urb() const { return reinterpret_cast<usbdevfs_urb*>(data->data); }
  ~Urb() {
    if (buffer != nullptr) umockdev_ioctl_data_unref(buffer);
    if (data != nullptr) umockdev_ioctl_data_unref(data);
  }
};

MockFalcon::MockFalcon(MockBus& bus, int address, std::string port, std::string serial,
                       const falcon::EmulatorSettings& settings)
    : bus_(bus), address_(address), port_(std::move(port)), serial_(std::move(serial)), falcon_(settings) {
  char name[32];
  std::snprintf(name, sizeof name, "/dev/bus/usb/001/%03d", address_);
  node_ = name;
  syspath_ = "/sys/devices/pci0000:00/usb1/" + port_;
  base_ = umockdev_ioctl_base_new();
  g_signal_connect(base_, "handle-ioctl", G_CALLBACK(&MockFalcon::on_ioctl), this);
}

MockFalcon::~MockFalcon() {
  unplug();
  if (attached_) umockdev_testbed_detach_ioctl(bus_.testbed(), node_.c_str(), nullptr);
  g_object_unref(base_);
}

void MockFalcon::plug() {
  if (plugged_) return;
  const auto bytes = descriptors(serial_.empty() ? 0 : kSerialString);
  const std::string number = std::to_string(address_);
  std::string text = "P: /devices/pci0000:00/usb1/" + port_ + "\n";
  text += "N: " + node_.substr(5) + "=" + hex(bytes) + "\n";
  text += "E: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DEVNAME=" + node_ + "\nE: BUSNUM=001\n";
  text +=
      "E: DEVNUM=" + node_.substr(node_.size() - 3) + "\nE: MAJOR=189\nE: MINOR=" + std::to_string(address_ - 1) + "\n";
  text += "E: PRODUCT=403/cb48/600\n";
  text += "A: busnum=1\\n\nA: devnum=" + number + "\\n\nA: speed=12\\n\nA: bConfigurationValue=1\\n\n";
  text += "A: bNumConfigurations=1\\n\nA: idVendor=0403\\n\nA: idProduct=cb48\\n\nA: bcdDevice=0600\\n\n";
  text += "H: descriptors=" + hex(bytes) + "\n\n";
  GError* error = nullptr;
  // Of the time before it was unplugged; whoever held it then has closed it by now.
  if (attached_) umockdev_testbed_detach_ioctl(bus_.testbed(), node_.c_str(), nullptr);
  attached_ = true;
  if (!umockdev_testbed_add_from_string(bus_.testbed(), text.c_str(), &error)) throw std::runtime_error(error->message);
  if (!umockdev_testbed_attach_ioctl(bus_.testbed(), node_.c_str(), base_, &error)) {
    throw std::runtime_error(error->message);
  }
  with([this](auto&) { plugged_ = true; });
  umockdev_testbed_uevent(bus_.testbed(), syspath_.c_str(), "add");
}

void MockFalcon::unplug() {
  if (!plugged_) return;
  with([this](auto&) {
    plugged_ = false;
    drop_all();
  });
  umockdev_testbed_uevent(bus_.testbed(), syspath_.c_str(), "remove");
  umockdev_testbed_remove_device(bus_.testbed(), syspath_.c_str());
}

void MockFalcon::drop_all() {
  for (auto& urb : waiting_) {
    urb->urb()->status = -ESHUTDOWN;
    urb->urb()->actual_length = 0;
    done_.push_back(std::move(urb));
  }
  waiting_.clear();
}

gboolean MockFalcon::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, MockFalcon* self) {
  const std::lock_guard lock(self->mutex_);
  return self->ioctl(client);
}

gboolean MockFalcon::ioctl(UMockdevIoctlClient* client) {
  const auto request = umockdev_ioctl_client_get_request(client);
  UMockdevIoctlData* argument = umockdev_ioctl_client_get_arg(client);
  gboolean handled = TRUE;
  if (!plugged_ && request != USBDEVFS_REAPURBNDELAY && request != USBDEVFS_DISCARDURB) {
    umockdev_ioctl_client_complete(client, -1, ENODEV);
  } else if (request == USBDEVFS_GET_CAPABILITIES) {
    UMockdevIoctlData* out = umockdev_ioctl_data_resolve(argument, 0, sizeof(guint32), nullptr);
    const guint32 capabilities = USBDEVFS_CAP_BULK_CONTINUATION | USBDEVFS_CAP_NO_PACKET_SIZE_LIM;
    std::memcpy(out->data, &capabilities, sizeof capabilities);
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(out);
  } else if (request == USBDEVFS_GETDRIVER) {
    if (kernel_driver_) {
      UMockdevIoctlData* out = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_getdriver), nullptr);
      std::strcpy(reinterpret_cast<usbdevfs_getdriver*>(out->data)->driver, "ftdi_sio");
      umockdev_ioctl_client_complete(client, 0, 0);
      umockdev_ioctl_data_unref(out);
    } else {
      umockdev_ioctl_client_complete(client, -1, ENODATA);
    }
  } else if (request == USBDEVFS_IOCTL) {
    UMockdevIoctlData* out = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_ioctl), nullptr);
    const int code = reinterpret_cast<usbdevfs_ioctl*>(out->data)->ioctl_code;
    if (code == static_cast<int>(USBDEVFS_DISCONNECT)) kernel_driver_ = false;
    if (code == static_cast<int>(USBDEVFS_CONNECT)) kernel_driver_ = true;
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(out);
  } else if (request == USBDEVFS_DISCONNECT_CLAIM || request == USBDEVFS_CLAIMINTERFACE) {
    if (claimed_elsewhere_ || (request == USBDEVFS_CLAIMINTERFACE && kernel_driver_)) {
      umockdev_ioctl_client_complete(client, -1, EBUSY);
    } else {
      kernel_driver_ = false;
      umockdev_ioctl_client_complete(client, 0, 0);
    }
  } else if (request == USBDEVFS_CLEAR_HALT) {
    UMockdevIoctlData* endpoint = umockdev_ioctl_data_resolve(argument, 0, sizeof(unsigned), nullptr);
    unsigned cleared = 0;
    std::memcpy(&cleared, endpoint->data, sizeof cleared);
    if (cleared == stalled_) stalled_ = 0;
    umockdev_ioctl_client_complete(client, 0, 0);
    umockdev_ioctl_data_unref(endpoint);
  } else if (request == USBDEVFS_RELEASEINTERFACE || request == USBDEVFS_RESET ||
             request == USBDEVFS_SETCONFIGURATION || request == USBDEVFS_SETINTERFACE) {
    umockdev_ioctl_client_complete(client, 0, 0);
  } else if (request == USBDEVFS_SUBMITURB) {
    handled = submit(client, argument);
  } else if (request == USBDEVFS_REAPURBNDELAY || request == USBDEVFS_REAPURB) {
    reap(client, argument);
  } else if (request == USBDEVFS_DISCARDURB) {
    discard(client, argument);
  } else {
    handled = FALSE;
  }
  return handled;
}

bool MockFalcon::submit(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
  auto urb = std::make_unique<Urb>();
  urb->data = umockdev_ioctl_data_resolve(argument, 0, sizeof(usbdevfs_urb), nullptr);
  const int length = urb->urb()->buffer_length;
  urb->buffer =
      umockdev_ioctl_data_resolve(urb->data, offsetof(usbdevfs_urb, buffer), static_cast<gsize>(length), nullptr);
  urb->urb()->status = 0;
  if (urb->urb()->type == USBDEVFS_URB_TYPE_CONTROL) {
    answer_control(*urb);
    done_.push_back(std::move(urb));
  } else if (urb->urb()->endpoint == stalled_) {
    urb->urb()->actual_length = 0;
    urb->urb()->status = -EPIPE;
    done_.push_back(std::move(urb));
  } else if ((urb->urb()->endpoint & 0x80) != 0) {
    urb->urb()->actual_length = 0;
    waiting_.push_back(std::move(urb));
  } else {
    falcon_.write({urb->buffer->data, static_cast<std::size_t>(length)}, now());
    urb->urb()->actual_length = length;
    done_.push_back(std::move(urb));
  }
  umockdev_ioctl_client_complete(client, 0, 0);
  return true;
}

void MockFalcon::answer_control(Urb& urb) {
  const std::uint8_t* setup = urb.buffer->data;
  const unsigned value = setup[2] | setup[3] << 8, length = setup[6] | setup[7] << 8;
  urb.urb()->actual_length = 0;
  if (setup[0] == 0x40) {  // the bridge's own
    ++requests_;
    if (!falcon_.control({setup[1], static_cast<std::uint16_t>(value)}, now())) urb.urb()->status = -EPIPE;
    return;
  }
  if (!serial_hidden_ && setup[0] == 0x80 && setup[1] == 6 && (value >> 8) == 3) {  // a string
    std::vector<std::uint8_t> text = {4, 3, 0x09, 0x04};         // number 0: the languages, US English
    if ((value & 0xFF) != 0) {
      text = {static_cast<std::uint8_t>(2 + 2 * serial_.size()), 3};
      for (const char letter : serial_) {
        text.push_back(static_cast<std::uint8_t>(letter));
        text.push_back(0);
      }
    }
    const std::size_t size = std::min<std::size_t>(text.size(), length);
    std::memcpy(urb.buffer->data + 8, text.data(), size);
    urb.urb()->actual_length = static_cast<int>(size);
    return;
  }
  urb.urb()->status = -EPIPE;
}

void MockFalcon::fill_reads() {
  std::array<std::uint8_t, falcon::kPacketBytes> packet{};
  while (plugged_ && !waiting_.empty()) {
    const std::size_t size = falcon_.read(packet, now());
    if (size == 0) return;
    auto urb = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    std::memcpy(urb->buffer->data, packet.data(), size);
    urb->urb()->actual_length = static_cast<int>(size);
    done_.push_back(std::move(urb));
  }
}

void MockFalcon::reap(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
  fill_reads();
  if (done_.empty()) {
    umockdev_ioctl_client_complete(client, -1, plugged_ ? EAGAIN : ENODEV);
    return;
  }
  auto urb = std::move(done_.front());
  done_.erase(done_.begin());
  UMockdevIoctlData* pointer = umockdev_ioctl_data_resolve(argument, 0, sizeof(gpointer), nullptr);
  umockdev_ioctl_data_set_ptr(pointer, 0, urb->data);
  umockdev_ioctl_client_complete(client, 0, 0);
  umockdev_ioctl_data_unref(pointer);
}

void MockFalcon::discard(UMockdevIoctlClient* client, UMockdevIoctlData* argument) {
  gulong address = 0;
  std::memcpy(&address, argument->data, sizeof address);
  const auto at = std::find_if(waiting_.begin(), waiting_.end(),
                               [address](const auto& urb) { return urb->data->client_addr == address; });
  if (at == waiting_.end()) {
    umockdev_ioctl_client_complete(client, -1, EINVAL);
    return;
  }
  (*at)->urb()->status = -ENOENT;
  done_.push_back(std::move(*at));
  waiting_.erase(at);
  umockdev_ioctl_client_complete(client, 0, 0);
}

}  // namespace cusp::test
