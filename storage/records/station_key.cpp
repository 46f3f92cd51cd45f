#include "storage/records/station_key.h"

#include <algorithm>

#include "storage/base/sodium.h"

namespace cusp::storage {
namespace {

Hash256 head_message(const Uuid& owner, const ChainHead& head) {
  return Blake2b{}.add_text("cusp head 1").add_uuid(owner).add_u64(head.links).add_hash(head.link).finish();
}

}  // namespace

Signature signature_of(std::span<const std::byte> bytes) {
  Signature out{};
  if (bytes.size() == out.size()) {
    std::ranges::transform(bytes, out.begin(), [](std::byte b) { return std::to_integer<std::uint8_t>(b); });
  }
  return out;
}

StationKey StationKey::make() {
  ready_sodium();
  StationKey key;
  crypto_sign_keypair(key.public_key.data(), key.secret_key.data());
  return key;
}

std::optional<StationKey> station_key_from(std::string_view content) {
  StationKey key;
  if (content.size() != key.secret_key.size()) return std::nullopt;
  std::ranges::transform(content, key.secret_key.begin(), [](char c) { return static_cast<std::uint8_t>(c); });
  std::copy_n(key.secret_key.begin() + 32, 32, key.public_key.begin());
  // If the halves do not match, nobody could check what the key signs.
  const Hash256 probe = blake2b_256(std::string_view{"probe"});
  if (!signature_holds(key.public_key, probe, key.sign(probe))) return std::nullopt;
  return key;
}

Hash256 key_id(std::span<const std::uint8_t, 32> public_key) { return blake2b_256(std::as_bytes(public_key)); }
Hash256 StationKey::id() const { return key_id(public_key); }

Signature StationKey::sign(const Hash256& message) const {
  Signature signature{};
  crypto_sign_detached(signature.data(), nullptr, message.data(), message.size(), secret_key.data());
  return signature;
}
Signature StationKey::sign_head(const Uuid& owner, const ChainHead& head) const {
  return sign(head_message(owner, head));
}

bool signature_holds(std::span<const std::uint8_t, 32> public_key, const Hash256& message,
                     const Signature& signature) noexcept {
  ready_sodium();
  return crypto_sign_verify_detached(signature.data(), message.data(), message.size(), public_key.data()) == 0;
}
bool head_signature_holds(std::span<const std::uint8_t, 32> public_key, const Uuid& owner, const ChainHead& head,
                          const Signature& signature) noexcept {
  return signature_holds(public_key, head_message(owner, head), signature);
}

}  // namespace cusp::storage
