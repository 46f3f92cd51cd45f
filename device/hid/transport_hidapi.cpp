#include "device/hid/transport_hidapi.h"

#include <hidapi/hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>

namespace cusp::device::hid {

namespace {

std::mutex& hidapi() {
  static std::mutex mutex;
  return mutex;
}

/// hidapi's wide text as UTF-8; an invalid character becomes '?'.
std::string narrow(const wchar_t* text) {
  std::string out;
  for (; text != nullptr && *text != 0; ++text) {
    const auto c = static_cast<std::uint32_t>(*text);
    if (c < 0x80) {
      out += static_cast<char>(c);
    } else if (c < 0x800) {
      out += static_cast<char>(0xC0 | c >> 6);
      out += static_cast<char>(0x80 | (c & 0x3F));
    } else if (c < 0x10000 && (c < 0xD800 || c > 0xDFFF)) {
      out += static_cast<char>(0xE0 | c >> 12);
      out += static_cast<char>(0x80 | (c >> 6 & 0x3F));
      out += static_cast<char>(0x80 | (c & 0x3F));
    } else {
      out += '?';
    }
  }
  return out;
}

/// hidapi 0.13 has no access to the report descriptor: sysfs has it.
std::vector<std::uint8_t> descriptor_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return {};
  std::ifstream file("/sys/class/hidraw" + path.substr(slash) + "/device/report_descriptor", std::ios::binary);
  constexpr std::size_t kMost = 4096;  // HID_MAX_DESCRIPTOR_SIZE of the kernel
  // read() keeps the error of a device that is unplugged meanwhile; an iterator would throw it.
  std::vector<std::uint8_t> bytes(kMost);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

class Reader final : public HidReader {
 public:
  explicit Reader(hid_device* device) : device_(device) {}
  ~Reader() override {
    const std::lock_guard lock(hidapi());
    hid_close(device_);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  HidRead read(std::span<std::uint8_t> into, std::chrono::milliseconds at_most) noexcept override {
    const int size = hid_read_timeout(device_, into.data(), into.size(), static_cast<int>(at_most.count()));
    if (size < 0) return {HidRead::Kind::lost, 0};
    if (size == 0) return {HidRead::Kind::nothing, 0};
    return {HidRead::Kind::report, static_cast<std::size_t>(size)};
  }

 private:
  hid_device* device_;
};

class Bus final : public HidBus {
 public:
  std::vector<HidDevice> list() override {
    std::vector<HidDevice> out;
    {
      const std::lock_guard lock(hidapi());
      hid_device_info* all = hid_enumerate(0, 0);
      for (const hid_device_info* at = all; at != nullptr; at = at->next) {
        if (at->path == nullptr) continue;
        const std::string path = at->path;
        // hidapi lists a device once per usage.
        if (std::any_of(out.begin(), out.end(), [&path](const HidDevice& d) { return d.path == path; })) continue;
        HidDevice device;
        device.path = path;
        device.vendor = at->vendor_id;
        device.product = at->product_id;
        device.interface_number = at->interface_number;
        device.name = narrow(at->product_string);
        device.serial = narrow(at->serial_number);
        out.push_back(std::move(device));
      }
      hid_free_enumeration(all);
    }
    std::map<std::string, HidDevice> known;
    for (HidDevice& device : out) {
      const auto before = known_.find(device.path);
      const bool again = before != known_.end() && before->second.vendor == device.vendor &&
                         before->second.product == device.product && !before->second.descriptor.empty();
      device.descriptor = again ? before->second.descriptor : descriptor_of(device.path);
      known[device.path] = device;
    }
    known_ = std::move(known);
    std::sort(out.begin(), out.end(), [](const HidDevice& a, const HidDevice& b) {
      return a.path.size() != b.path.size() ? a.path.size() < b.path.size() : a.path < b.path;  // hidraw9 before hidraw10
    });
    return out;
  }

  Result<std::unique_ptr<HidReader>, PortFailure> open(const std::string& path) override {
    if (access(path.c_str(), F_OK) != 0) return fail(PortError::not_found, path);
    if (access(path.c_str(), R_OK | W_OK) != 0 && (errno == EACCES || errno == EPERM))
      return fail(PortError::no_permission, path);
    const std::lock_guard lock(hidapi());
    hid_device* device = hid_open_path(path.c_str());
    if (device == nullptr) return fail(PortError::io, path, narrow(hid_error(nullptr)));
    return std::make_unique<Reader>(device);
  }

 private:
  std::map<std::string, HidDevice> known_;
};

}  // namespace

std::unique_ptr<HidBus> make_hidapi_bus() {
  const std::lock_guard lock(hidapi());
  if (hid_init() != 0) return nullptr;
  return std::make_unique<Bus>();
}

}  // namespace cusp::device::hid
