/// Identity of a scenario's content: BLAKE2b-256 over lines "<hash of bytes>  <path>\n", sorted by path, scenario.json
/// as hashed_json() writes it. Equal hashes mean equal exercises, however the file was laid out or zipped, and whichever
/// format it was written in.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "scenarios/format/scenario.h"

namespace cusp::scenarios {

struct ContentHash {
  std::array<std::uint8_t, 32> bytes{};
  std::string hex() const;  // 64 digits, lower case
  friend auto operator<=>(const ContentHash&, const ContentHash&) = default;
};

/// BLAKE2b with 32 bytes out, no key (RFC 7693).
ContentHash hash_of_bytes(std::span<const std::byte> bytes) noexcept;

/// `beside`: the other files of the scenario by relative path with '/' (a volume); usually none.
ContentHash content_hash(const Scenario& scenario, const std::map<std::string, std::vector<std::byte>>& beside = {});

}  // namespace cusp::scenarios
