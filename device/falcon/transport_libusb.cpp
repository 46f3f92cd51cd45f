#include "device/falcon/transport_libusb.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include "device/falcon/transport_bus.h"
#include "device/falcon/wait_for_files.h"

namespace cusp::device::falcon {

namespace {

using Clock = std::chrono::steady_clock;

class UsbLink final : public FalconLink {
 public:
  UsbLink(Context context, std::string wanted) : context_(std::move(context)), wanted_(std::move(wanted)) {}
  ~UsbLink() override { close(); }

  LinkTime now() const noexcept override { return Clock::now().time_since_epoch(); }
  std::string name() const override { return opener_.joinable() || name_.empty() ? wanted_ : name_; }

  bool known_by_port() const noexcept override { return !opener_.joinable() && known_ && known_->by_port; }

  void start(const LinkAsk& ask) noexcept override {
    give_back();
    switch (ask.kind) {
      case LinkAsk::Kind::open:
        open();
        break;
      case LinkAsk::Kind::close:
        close();
        break;
      case LinkAsk::Kind::control:
        request(ask.request);
        break;
      case LinkAsk::Kind::send:
        send(ask.payload());
        break;
    }
  }

  LinkEvent wait(LinkTime until) noexcept override {
    give_back();
    for (;;) {
      take_opened();
      if (const auto event = next_event()) return *event;
      const LinkTime left = until - now();
      if (left > LinkTime(0)) sleep(left);
      if (!opener_.joinable()) {
        timeval at_once{0, 0};
        libusb_handle_events_timeout_completed(context_.get(), &at_once, nullptr);
      }
      if (left <= LinkTime(0)) {
        if (const auto event = next_event()) return *event;
        return {};
      }
    }
  }

 private:
  static constexpr std::size_t kReads = 3, kWrites = 8, kEvents = 32;
  static constexpr unsigned kRequestMs = 1000;

  struct Slot {
    UsbLink* link = nullptr;
    libusb_transfer* transfer = nullptr;
    bool under_way = false;
    std::array<unsigned char, kReadBytes> buffer{};
  };
  struct Queued {
    LinkEvent::Kind kind = LinkEvent::Kind::time;
    Slot* read = nullptr;  // of `received`
  };

  void queue(LinkEvent::Kind kind, Slot* read = nullptr) noexcept {
    if (queued_count_ == kEvents) return;  // one event per read and per ask: 3 + 8 + 1 at most
    queued_[(queued_at_ + queued_count_) % kEvents] = {kind, read};
    ++queued_count_;
  }

  std::optional<LinkEvent> next_event() noexcept {
    if (queued_count_ == 0) return std::nullopt;
    const Queued next = queued_[queued_at_];
    queued_at_ = (queued_at_ + 1) % kEvents;
    --queued_count_;
    LinkEvent event{.kind = next.kind};
    if (next.kind == LinkEvent::Kind::received) {
      given_ = next.read;
      event.bytes = std::span(next.read->buffer).first(static_cast<std::size_t>(next.read->transfer->actual_length));
    }
    return event;
  }

  /// Submits the read again whose bytes the driver has taken.
  void give_back() noexcept {
    Slot* slot = given_;
    given_ = nullptr;
    if (slot != nullptr && handle_ != nullptr) submit(*slot);
  }

  void submit(Slot& slot) noexcept {
    const int error = libusb_submit_transfer(slot.transfer);
    slot.under_way = error == 0;
    if (error == LIBUSB_ERROR_NO_DEVICE) {
      lose();
    } else if (error != 0) {
      queue(LinkEvent::Kind::failed);
    }
  }

  void lose() noexcept {
    if (!lost_) queue(LinkEvent::Kind::gone);
    lost_ = true;
  }

  static void LIBUSB_CALL done(libusb_transfer* transfer) noexcept {
    Slot& slot = *static_cast<Slot*>(transfer->user_data);
    slot.under_way = false;
    slot.link->finished(slot);
  }

  void finished(Slot& slot) noexcept {
    if (closing_) return;
    switch (slot.transfer->status) {
      case LIBUSB_TRANSFER_COMPLETED:
        if (is_read(slot)) {
          queue(LinkEvent::Kind::received, &slot);
        } else if (&slot == &control_) {
          queue(LinkEvent::Kind::control_done);
        }
        break;
      case LIBUSB_TRANSFER_CANCELLED:
        break;
      case LIBUSB_TRANSFER_NO_DEVICE:
        lose();
        break;
      case LIBUSB_TRANSFER_STALL:
        if (&slot != &control_) stalled_ = true;  // the next request clears a stall of its own
        queue(LinkEvent::Kind::failed);
        break;
      case LIBUSB_TRANSFER_ERROR:
      case LIBUSB_TRANSFER_TIMED_OUT:
      case LIBUSB_TRANSFER_OVERFLOW:
        queue(LinkEvent::Kind::failed);
        break;
    }
  }

  bool is_read(const Slot& slot) const noexcept { return &slot >= reads_.data() && &slot < reads_.data() + kReads; }

  /// What distinguishes the device that was opened first from every other one.
  struct Known {
    std::string port, serial;
    bool by_port = false;  // it has no serial number, or another device has the same one
  };

  bool is_wanted(const std::string& port, const std::string& serial) const noexcept {
    if (!known_) return wanted_.empty() || wanted_ == port || wanted_ == serial;
    if (!known_->by_port) return serial == known_->serial;
    // A device that does not answer in time shows no serial number.
    return port == known_->port && (known_->serial.empty() || serial.empty() || serial == known_->serial);
  }

  static bool others_have(const std::string& serial, libusb_device* own, const DeviceList& devices) {
    for (libusb_device* device : devices.all()) {
      libusb_device_descriptor descriptor{};
      libusb_device_handle* handle = nullptr;
      if (device == own || !is_falcon(device, descriptor) || libusb_open(device, &handle) != 0) continue;
      const bool same = serial_of(handle, descriptor) == serial;
      libusb_close(handle);
      if (same) return true;
    }
    return false;
  }

  /// The device that was asked for, opened: or why not. After the first one it opens no other.
  LinkEvent::Kind find() noexcept {
    const DeviceList devices(context_.get());
    LinkEvent::Kind outcome = LinkEvent::Kind::absent;
    for (libusb_device* device : devices.all()) {
      libusb_device_descriptor descriptor{};
      if (!is_falcon(device, descriptor)) continue;
      const std::string port = port_of(device);
      libusb_device_handle* handle = nullptr;
      const int error = libusb_open(device, &handle);
      if (error != 0) {
        // Its serial number is unknown without opening it: it may be the wanted one.
        if (error == LIBUSB_ERROR_ACCESS) outcome = LinkEvent::Kind::denied;
        continue;
      }
      const std::string serial = serial_of(handle, descriptor);
      if (!is_wanted(port, serial)) {
        libusb_close(handle);
        continue;
      }
      libusb_set_auto_detach_kernel_driver(handle, 1);
      const int claimed = libusb_claim_interface(handle, 0);
      if (claimed != 0) {
        libusb_close(handle);
        outcome = claimed == LIBUSB_ERROR_NO_DEVICE ? LinkEvent::Kind::absent : LinkEvent::Kind::busy;
        if (!wanted_.empty() || known_) return outcome;
        continue;  // another program holds the first: the next may be free
      }
      if (std::exchange(stalled_, false)) {
        for (const std::uint8_t endpoint : {kInEndpoint, kOutEndpoint}) libusb_clear_halt(handle, endpoint);
      }
      handle_ = handle;
      name_ = serial.empty() ? port : serial;
      if (!known_) known_ = Known{port, serial, serial.empty() || others_have(serial, device, devices)};
      return LinkEvent::Kind::opened;
    }
    return outcome;
  }

  /// On a thread of its own: a device that does not answer holds up whoever asks for its serial number by a second, and
  /// a lost one is looked for on the haptic thread.
  void open() noexcept {
    close();
    found_.store(LinkEvent::Kind::time, std::memory_order_relaxed);
    try {
      opener_ = std::thread([this] { found_.store(find(), std::memory_order_release); });
    } catch (const std::system_error&) {
      queue(LinkEvent::Kind::absent);  // no thread available: the driver asks again
    }
  }

  void take_opened() noexcept {
    if (!opener_.joinable()) return;
    const LinkEvent::Kind outcome = found_.load(std::memory_order_acquire);
    if (outcome == LinkEvent::Kind::time) return;
    opener_.join();
    if (outcome != LinkEvent::Kind::opened) return queue(outcome);
    lost_ = false;
    bool made = make(control_);
    for (Slot& slot : reads_) made = made && make(slot);
    for (Slot& slot : writes_) made = made && make(slot);
    if (!made) {
      close();
      return queue(LinkEvent::Kind::absent);
    }
    watch_files();
    for (Slot& slot : reads_) {
      libusb_fill_bulk_transfer(slot.transfer, handle_, kInEndpoint, slot.buffer.data(),
                                static_cast<int>(slot.buffer.size()), &UsbLink::done, &slot, 0);
    }
    queue(LinkEvent::Kind::opened);
    for (Slot& slot : reads_) submit(slot);
  }

  bool make(Slot& slot) noexcept {
    slot.link = this;
    slot.under_way = false;
    if (slot.transfer == nullptr) slot.transfer = libusb_alloc_transfer(0);
    return slot.transfer != nullptr;
  }

  void request(FtdiRequest request) noexcept {
    if (handle_ == nullptr) return;
    if (control_.under_way) return queue(LinkEvent::Kind::failed);
    constexpr std::uint8_t kVendorOut = 0x40;
    libusb_fill_control_setup(control_.buffer.data(), kVendorOut, request.request, request.value, 0, 0);
    libusb_fill_control_transfer(control_.transfer, handle_, control_.buffer.data(), &UsbLink::done, &control_,
                                 kRequestMs);
    submit(control_);
  }

  void send(std::span<const std::uint8_t> bytes) noexcept {
    if (handle_ == nullptr) return;
    for (Slot& slot : writes_) {
      if (slot.under_way) continue;
      std::copy(bytes.begin(), bytes.end(), slot.buffer.begin());
      libusb_fill_bulk_transfer(slot.transfer, handle_, kOutEndpoint, slot.buffer.data(),
                                static_cast<int>(bytes.size()), &UsbLink::done, &slot, kRequestMs);
      return submit(slot);
    }
    queue(LinkEvent::Kind::failed);  // eight writes wait: the bridge accepts nothing
  }

  void sleep(LinkTime left) noexcept {
    if (opener_.joinable()) return std::this_thread::sleep_for(std::min<LinkTime>(left, std::chrono::milliseconds(1)));
    if (handle_ != nullptr && file_count_ > 0) return wait_for_files(std::span(files_).first(file_count_), left);
    // Without files to watch (no device, or a system that has none) libusb waits, in whole milliseconds.
    const auto us =
        std::chrono::duration_cast<std::chrono::microseconds>(std::min<LinkTime>(left, std::chrono::seconds(1)));
    timeval time{};
    time.tv_sec = static_cast<decltype(time.tv_sec)>(us.count() / 1'000'000);
    time.tv_usec = static_cast<decltype(time.tv_usec)>(us.count() % 1'000'000);
    libusb_handle_events_timeout_completed(context_.get(), &time, nullptr);
  }

  void watch_files() noexcept {
    file_count_ = 0;
    const libusb_pollfd** files = libusb_get_pollfds(context_.get());
    if (files == nullptr) return;
    for (std::size_t i = 0; files[i] != nullptr && file_count_ < files_.size(); ++i) {
      files_[file_count_++] = {files[i]->fd, files[i]->events};
    }
    libusb_free_pollfds(files);
  }

  template <class F>
  void each_slot(F&& f) noexcept {
    f(control_);
    for (Slot& slot : reads_) f(slot);
    for (Slot& slot : writes_) f(slot);
  }

  void close() noexcept {
    if (opener_.joinable()) opener_.join();
    queued_count_ = 0;
    given_ = nullptr;
    if (handle_ != nullptr) {
      closing_ = true;
      each_slot([](Slot& slot) {
        if (slot.under_way) libusb_cancel_transfer(slot.transfer);
      });
      constexpr int kRounds = 50;  // of 10 ms: what does not come back by then is cut off by closing the handle
      for (int round = 0; round < kRounds; ++round) {
        bool waiting = false;
        each_slot([&waiting](Slot& slot) { waiting = waiting || slot.under_way; });
        if (!waiting) break;
        timeval ten_ms{0, 10'000};
        libusb_handle_events_timeout_completed(context_.get(), &ten_ms, nullptr);
      }
      libusb_release_interface(handle_, 0);  // gives a kernel driver that was detached its device back
      libusb_close(handle_);
      handle_ = nullptr;
      closing_ = false;
    }
    each_slot([](Slot& slot) {
      if (slot.transfer != nullptr) libusb_free_transfer(slot.transfer);
      slot.transfer = nullptr;
      slot.under_way = false;
    });
    file_count_ = 0;
  }

  Context context_;
  std::string wanted_, name_;
  std::optional<Known> known_;
  libusb_device_handle* handle_ = nullptr;
  bool lost_ = false, closing_ = false;
  bool stalled_ = false;  // an endpoint has refused a transfer, and refuses all until it is cleared: closing does not clear it
  std::thread opener_;  // while it can be joined, handle_, name_, known_ and stalled_ are its own
  std::atomic<LinkEvent::Kind> found_{LinkEvent::Kind::time};
  Slot control_;
  std::array<Slot, kReads> reads_{};
  std::array<Slot, kWrites> writes_{};
  Slot* given_ = nullptr;
  std::array<Queued, kEvents> queued_{};
  std::size_t queued_at_ = 0, queued_count_ = 0;
  std::array<WatchedFile, 16> files_{};
  std::size_t file_count_ = 0;
};

}  // namespace

Result<std::unique_ptr<FalconLink>, PortFailure> make_usb_link(std::string name) {
  auto context = start_libusb();
  if (!context) return std::unexpected(std::move(context.error()));
  return std::make_unique<UsbLink>(std::move(*context), std::move(name));
}

}  // namespace cusp::device::falcon
