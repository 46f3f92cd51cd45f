/// Large immutable bytes by their content hash (specimens as voxels, files of a scenario), compressed, each kept once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "storage/context.h"

namespace cusp::storage {

class Blobs {
 public:
  explicit Blobs(StorageContext& context) : c_{context} {}
  /// Keeps the bytes and returns their BLAKE2b-256. Already there: nothing is written.
  Stored<Hash256> put(std::span<const std::byte> bytes);
  /// not_found, or corrupt when the bytes no longer have this hash.
  Stored<std::vector<std::byte>> get(const Hash256& hash);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
