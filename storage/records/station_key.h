/// The station's Ed25519 key (libsodium), and signatures over the heads of chains. Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "engine/base/ids.h"
#include "storage/records/chain.h"

namespace cusp::storage {

/// SQL for one of this station's own keys by its id: station_keys holds those of other stations too.
inline constexpr const char* kSelectOwnKey =
    "SELECT public_key FROM station_keys WHERE id = ?1 AND id NOT IN (SELECT key FROM other_keys)";

using Signature = std::array<std::uint8_t, 64>;
/// Zeros unless `bytes` holds exactly 64 bytes.
Signature signature_of(std::span<const std::byte> bytes);

/// The secret half lies in a file of its own beside the database, never in it.
struct StationKey {
  std::array<std::uint8_t, 32> public_key{};
  std::array<std::uint8_t, 64> secret_key{};
  static StationKey make();
  /// BLAKE2b-256 of the public key. A signed head names its key by this id.
  Hash256 id() const;
  /// The caller hashes a label of its own into `message`: a signature then serves one purpose only.
  Signature sign(const Hash256& message) const;
  /// Signs H(label, owner, head.links, head.link).
  Signature sign_head(const Uuid& owner, const ChainHead& head) const;
};

/// The key of a key file's content: the secret half as 64 raw bytes, whose last 32 are the public half. nullopt if the size
/// is another, or the halves do not belong together.
std::optional<StationKey> station_key_from(std::string_view content);

/// A head as a table stores it.
struct SignedHead {
  ChainHead head;
  Hash256 key{};  // id of the key that signed
  Signature signature{};
};

Hash256 key_id(std::span<const std::uint8_t, 32> public_key);
bool signature_holds(std::span<const std::uint8_t, 32> public_key, const Hash256& message,
                     const Signature& signature) noexcept;
bool head_signature_holds(std::span<const std::uint8_t, 32> public_key, const Uuid& owner, const ChainHead& head,
                          const Signature& signature) noexcept;

}  // namespace cusp::storage
