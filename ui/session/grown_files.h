/// Bytes that took long to compute, as files of a cache folder. A file bears the key of what made it and a hash over all of it:
/// a damaged file, or one of another key, counts as missing. Above the bound the least recently used files go first.
/// Any thread; several processes may use one folder. A folder that cannot be written keeps nothing, and that is no failure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "storage/base/hash.h"
#include "ui/modules.h"

namespace cusp::ui {

class GrownFiles {
 public:
  /// keep() writes nothing if less would stay free on the disk: the records need it.
  static constexpr std::uint64_t kLeaveFree = std::uint64_t{256} << 20;

  GrownFiles(std::filesystem::path folder, std::uint64_t most_bytes) : folder_(std::move(folder)), most_bytes_(most_bytes) {}

  /// nullopt: missing, damaged, or of another key. Removes a file that it cannot use.
  std::optional<std::vector<std::byte>> read(const Hash256& key) const;
  void keep(const Hash256& key, std::span<const std::byte> bytes) const;

 private:
  std::filesystem::path file_of(const Hash256& key) const;
  void trim(const std::filesystem::path& fresh) const;

  std::filesystem::path folder_;
  std::uint64_t most_bytes_;
};

}  // namespace cusp::ui
