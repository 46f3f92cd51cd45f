/// BLAKE2b-256 (libsodium) and its hex form. Pure; any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/base/ids.h"

namespace cusp::storage {

using Hash256 = std::array<std::uint8_t, 32>;

/// Lower-case hex, 64 characters.
std::string hex(const Hash256& hash);
/// nullopt unless `text` is exactly 64 characters of lower-case hex.
std::optional<Hash256> hash_from_hex(std::string_view text) noexcept;

/// BLAKE2b-256 over several values. Each add_* writes a fixed-size or length-prefixed form, so that no two sequences of
/// values hash the same bytes.
class Blake2b {
 public:
  Blake2b();
  Blake2b& add_bytes(std::span<const std::byte> bytes);  // length first
  Blake2b& add_text(std::string_view text);              // length first
  Blake2b& add_u64(std::uint64_t value);                 // 8 bytes, little-endian
  Blake2b& add_hash(const Hash256& hash);                // 32 bytes
  Blake2b& add_uuid(const Uuid& id);                     // 16 bytes
  Blake2b& add_part(std::span<const std::byte> bytes);   // the bytes alone: of a content hash whose bytes come in parts
  Hash256 finish();

 private:
  void add_raw(const void* data, std::size_t size);
  alignas(64) std::array<unsigned char, 384> state_;  // crypto_generichash_state
};

/// BLAKE2b-256 of the bytes alone, without a length: content hashes.
Hash256 blake2b_256(std::span<const std::byte> bytes);
Hash256 blake2b_256(std::string_view text);

}  // namespace cusp::storage
