/// Tissue codes. Stored in volumes, databases and files: never renumbered. From 16 on they are a scenario's own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace cusp::engine {

enum class Tissue : std::uint8_t {
  empty = 0,
  enamel = 1,
  dentine = 2,
  carious_dentine = 3,
  cementum = 4,
  pulp = 5,
  bone = 6,
  gingiva = 7,
  ligament = 8,
  amalgam = 9,
  composite = 10,
  plastic = 11,
  carious_enamel = 12,
};

/// One more than the greatest code of a volume. Of those below, is_tissue_code() names the ones that it may hold.
inline constexpr std::size_t kTissueCodes = 32;

constexpr std::size_t index_of(Tissue tissue) noexcept { return static_cast<std::size_t>(tissue); }

/// Stable keys of files and scenarios ("enamel", "carious_dentine"), never shown to a person.
inline constexpr std::array<std::string_view, 13> kTissueKeys = {
    "empty",   "enamel",   "dentine", "carious_dentine", "cementum", "pulp",          "bone",
    "gingiva", "ligament", "amalgam", "composite",       "plastic",  "carious_enamel"};

/// Whether a code is a key's, 0 of no tissue among them, or a scenario's own. 13 to 15 name nothing.
constexpr bool is_tissue_code(std::uint64_t code) noexcept {
  constexpr std::uint64_t kFirstOwn = 16;
  return code < kTissueKeys.size() || (code >= kFirstOwn && code < kTissueCodes);
}

constexpr std::optional<Tissue> tissue_from_key(std::string_view key) noexcept {
  for (std::size_t i = 0; i < kTissueKeys.size(); ++i) {
    if (kTissueKeys[i] == key) return static_cast<Tissue>(i);
  }
  return std::nullopt;
}

}  // namespace cusp::engine
