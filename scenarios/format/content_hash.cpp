#include "scenarios/format/content_hash.h"

#include <cassert>
#include <fstream>
#include <iterator>

#include <sodium.h>

#include "scenarios/format/read.h"
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
  const std::string text = canonical_json(scenario);
  files["scenario.json"] = hash_of_bytes(std::as_bytes(std::span(text)));
  std::string lines;
  for (const auto& [path, hash] : files) lines += hash.hex() + "  " + path + "\n";
  return hash_of_bytes(std::as_bytes(std::span(lines)));
}

Result<ContentHash, FormatFailure> content_hash_of_folder(const std::filesystem::path& folder) {
  const auto scenario = read_scenario_file(folder);
  if (!scenario) return std::unexpected(scenario.error());
  std::map<std::string, std::vector<std::byte>> beside;
  if (const std::string& name = scenario->specimen.volume; !name.empty()) {
    const std::filesystem::path path = folder / name;
    std::ifstream file(path, std::ios::binary);
    if (!file) return fail(FormatError::unreadable, path.string());
    const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (file.bad()) return fail(FormatError::unreadable, path.string());
    const auto view = std::as_bytes(std::span(bytes));
    beside[name].assign(view.begin(), view.end());
  }
  return content_hash(*scenario, beside);
}

}  // namespace cusp::scenarios
