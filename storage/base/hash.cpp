#include "storage/base/hash.h"

#include "storage/base/hex.h"
#include "storage/base/sodium.h"

namespace cusp::storage {

std::string hex(const Hash256& hash) { return hex_of(hash); }

std::optional<Hash256> hash_from_hex(std::string_view text) noexcept {
  Hash256 hash{};
  if (!bytes_from_hex(text, hash)) return std::nullopt;
  return hash;
}

namespace {
crypto_generichash_state* of(std::array<unsigned char, 384>& state) {
  static_assert(sizeof(crypto_generichash_state) <= 384 && alignof(crypto_generichash_state) <= 64);
  return reinterpret_cast<crypto_generichash_state*>(state.data());
}
}  // namespace

Blake2b::Blake2b() : state_{} {
  ready_sodium();
  crypto_generichash_init(of(state_), nullptr, 0, 32);
}
void Blake2b::add_raw(const void* data, std::size_t size) {
  crypto_generichash_update(of(state_), static_cast<const unsigned char*>(data), size);
}
Blake2b& Blake2b::add_bytes(std::span<const std::byte> bytes) {
  add_u64(bytes.size());
  add_raw(bytes.data(), bytes.size());
  return *this;
}
Blake2b& Blake2b::add_text(std::string_view text) { return add_bytes(std::as_bytes(std::span{text})); }
Blake2b& Blake2b::add_u64(std::uint64_t value) {
  std::array<std::uint8_t, 8> bytes{};
  for (std::size_t i = 0; i < 8; ++i) bytes[i] = static_cast<std::uint8_t>(value >> (8 * i));
  add_raw(bytes.data(), bytes.size());
  return *this;
}
Blake2b& Blake2b::add_hash(const Hash256& hash) {
  add_raw(hash.data(), hash.size());
  return *this;
}
Blake2b& Blake2b::add_uuid(const Uuid& id) {
  add_raw(id.bytes.data(), id.bytes.size());
  return *this;
}
Blake2b& Blake2b::add_part(std::span<const std::byte> bytes) {
  add_raw(bytes.data(), bytes.size());
  return *this;
}
Hash256 Blake2b::finish() {
  Hash256 hash{};
  crypto_generichash_final(of(state_), hash.data(), hash.size());
  return hash;
}

Hash256 blake2b_256(std::span<const std::byte> bytes) {
  ready_sodium();
  Hash256 hash{};
  crypto_generichash(hash.data(), hash.size(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                     nullptr, 0);
  return hash;
}
Hash256 blake2b_256(std::string_view text) { return blake2b_256(std::as_bytes(std::span{text})); }

}  // namespace cusp::storage
