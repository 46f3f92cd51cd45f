/// Hashes, the hash chain of a session's rows, and the station's signature over its head (libsodium: BLAKE2b-256 and
/// Ed25519). A chain covers pseudonymous ids and content, never names, so that erasing a person leaves it whole.
///
///   link 0 = H(label, session)      link n = H(link n-1, session, n, table, row, second, content n)
///
/// where content n is the hash of every column of one row. The head (count and last link) is signed after each
/// transaction, so that a cut-off tail shows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/ids.h"

namespace cusp::storage {

using Hash256 = std::array<std::uint8_t, 32>;

/// Lower-case hex, 64 characters.
std::string hex(const Hash256& hash);
/// nullopt unless exactly 64 characters of lower-case hex.
std::optional<Hash256> hash_from_hex(std::string_view text) noexcept;

/// BLAKE2b-256, fed in pieces. Each add_* writes a fixed-size or length-prefixed form, so that pieces never run
/// together.
class Blake2b {
 public:
  Blake2b();
  Blake2b& add_bytes(std::span<const std::byte> bytes);  // length first
  Blake2b& add_text(std::string_view text);              // length first
  Blake2b& add_u64(std::uint64_t value);                 // 8 bytes, little-endian
  Blake2b& add_hash(const Hash256& hash);                // 32 bytes
  Blake2b& add_uuid(const Uuid& id);                     // 16 bytes
  Hash256 finish();

 private:
  void raw(const void* data, std::size_t size);
  alignas(64) std::array<unsigned char, 384> state_;  // crypto_generichash_state
};

/// Plain BLAKE2b-256 of some bytes, nothing added: content hashes.
Hash256 blake2b_256(std::span<const std::byte> bytes);
Hash256 blake2b_256(std::string_view text);

/// One entry of a session's chain.
struct ChainLink {
  std::uint64_t position = 0;  // 0, 1, 2 ... without gaps
  std::uint64_t table = 0;     // number of the chained table (storage/session_tables.h)
  std::uint64_t row = 0;       // the row's number within that table and session
  std::int64_t second = -1;    // second of the session it belongs to; -1 for what has no time
  Hash256 content{};           // hash of the row
};
/// What comes before position 0.
Hash256 chain_start(const Uuid& session);
Hash256 chain_link(const Hash256& before, const Uuid& session, const ChainLink& link);

using Signature = std::array<std::uint8_t, 64>;

/// The station's Ed25519 key. The secret half lives in a file of its own beside the database, never in it.
struct StationKey {
  std::array<std::uint8_t, 32> public_key{};
  std::array<std::uint8_t, 64> secret_key{};
  static StationKey make();
  /// BLAKE2b-256 of the public key: how a head names the key that signed it.
  Hash256 id() const;
  /// The message's own label keeps what was signed for one purpose from serving another.
  Signature sign(const Hash256& message) const;
  /// The bytes that a head's signature covers are H(label, owner, count, link).
  Signature sign_head(const Uuid& owner, std::uint64_t count, const Hash256& link) const;
};
Hash256 key_id(std::span<const std::uint8_t, 32> public_key);
bool signature_holds(std::span<const std::uint8_t, 32> public_key, const Hash256& message,
                     const Signature& signature) noexcept;
bool head_signature_holds(std::span<const std::uint8_t, 32> public_key, const Uuid& owner, std::uint64_t count,
                          const Hash256& link, const Signature& signature) noexcept;

}  // namespace cusp::storage
