#include "scenarios/format/content_hash.h"

#include <cassert>

#include <sodium.h>

#include "scenarios/format/write.h"

namespace cusp::scenarios {

std::string ContentHash::hex() const {
  static constexpr char digits[] = "0123456789abcdef";
  std::string out;
  out.reserve(64);
  for (const std::uint8_t byte : bytes) {
    out += digits[byte >> 4];
    out += digits[byte & 15];
  }
  return out;
}

ContentHash hash_of_bytes(std::span<const std::byte> bytes) noexcept {
  ContentHash hash;
  // Needs no sodium_init: it draws no random number. It fails only for lengths out of range.
  [[maybe_unused]] const int failed =
      crypto_generichash_blake2b(hash.bytes.data(), hash.bytes.size(),
                                 reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), nullptr, 0);
  assert(failed == 0);
  return hash;
}

ContentHash content_hash(const Scenario& scenario, const std::map<std::string, std::vector<std::byte>>& beside) {
  std::map<std::string, ContentHash> files;  // std::string compares bytes, as unsigned
  for (const auto& [path, bytes] : beside) files[path] = hash_of_bytes(bytes);
  const std::string text = hashed_json(scenario);
  files["scenario.json"] = hash_of_bytes(std::as_bytes(std::span(text)));
  std::string lines;
  for (const auto& [path, hash] : files) lines += hash.hex() + "  " + path + "\n";
  return hash_of_bytes(std::as_bytes(std::span(lines)));
}

}  // namespace cusp::scenarios
