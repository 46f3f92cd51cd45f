#include "ui/session/session_device.h"

#include <algorithm>

#include "device/catalogue.h"
#include "device/falcon/transport_libusb.h"
#include "device/pointer/pointer_port.h"
#include "ui/modules.h"

namespace cusp::ui {

namespace {

/// Mouse and keys as the emulated Falcon's hand: the same motion as the mouse's own device.
EmulatedHand mouse_hand(std::shared_ptr<PointerHand> hand, Vec3 start_mm) {
  auto motion = std::make_shared<PointerMotion>(start_mm);
  return [hand = std::move(hand), motion = std::move(motion)](const Feedback& felt, double dt_s) noexcept {
    const PointerWish& wish = hand->latest();
    return EmulatedHandPose{motion->advance(wish, felt, dt_s), wish.cut, wish.bur};
  };
}

}  // namespace

const FalconView* SessionDevice::view() const noexcept {
  if (falcon != nullptr) return &falcon->view();
  if (emulated != nullptr) return &emulated->view();
  return nullptr;
}

Result<falcon::FirmwareImage, PortFailure> read_firmware(const FirmwareChoice& choice) {
  auto image = falcon::FirmwareImage::from_file(choice.file);
  if (!image) return fail(PortError::bad_file, choice.file.string(), std::string(falcon::key_of(image.error().code)));
  if (image->sha256() != choice.sha256) return fail(PortError::bad_file, choice.file.string(), "changed");
  return std::move(*image);
}

Result<SessionDevice, PortFailure> make_session_device(const DeviceChoice& choice, Vec3 start_mm, std::size_t burs,
                                               EmulatedHand hand) {
  const DeviceKind* kind = device_kind(choice.kind);
  if (kind == nullptr) return fail(PortError::not_found, choice.kind);
  if (kind->needs_file) return fail(PortError::bad_file, choice.kind, "needs_file");
  SessionDevice out;
  if (choice.kind == "falcon") {
    auto link = falcon::make_usb_link(choice.name);
    if (!link) return std::unexpected(link.error());
    FalconSettings settings =
        settings_for(choice.profile, start_mm, static_cast<std::uint16_t>(std::clamp<std::size_t>(burs, 1, 0xFFFF)));
    settings.home_in_open = true;
    auto port = std::make_unique<FalconPort>(std::move(*link), settings);
    if (!choice.firmware.file.empty()) {
      // A Falcon whose firmware runs needs no file.
      auto image = read_firmware(choice.firmware);
      if (image) {
        port->give_image(std::move(*image));
      } else {
        port->lack_image(image.error());
      }
    }
    out.falcon = port.get();
    out.port = std::move(port);
  } else if (choice.kind == "inverse3") {
    InverseSettings settings = choice.inverse;
    settings.origin_mm = start_mm;
    settings.burs = static_cast<std::uint16_t>(std::clamp<std::size_t>(burs, 1, 0xFFFF));
    auto port = make_inverse_port(settings);
    out.inverse = port.get();
    out.port = std::move(port);
  } else if (choice.kind == "emulated-falcon") {
    if (!hand) {
      out.hand = std::make_shared<PointerHand>(start_mm);
      hand = mouse_hand(out.hand, start_mm);
    }
    auto port = std::make_unique<EmulatedFalconPort>(std::move(hand), EmulatedFalconSettings{.start_mm = start_mm});
    out.emulated = port.get();
    out.port = std::move(port);
  } else {
    auto port = std::make_unique<PointerPort>(start_mm);
    out.hand = std::shared_ptr<PointerHand>(std::shared_ptr<void>(), &port->hand());
    out.port = std::move(port);
  }
  return out;
}

}  // namespace cusp::ui
