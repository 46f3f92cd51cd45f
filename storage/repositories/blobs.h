/// Large immutable bytes by content hash (specimens as voxels, files of a scenario), compressed and stored once.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "storage/records/context.h"

namespace cusp::storage {

class Blobs {
 public:
  explicit Blobs(StorageContext& context) : c_{context} {}
  /// Stores the bytes unless they exist whole, and returns their BLAKE2b-256. bad_value above kMostUnpackedBytes. Reads what exists.
  Stored<Hash256> put(std::span<const std::byte> bytes);
  /// not_found, or corrupt if the bytes no longer have this hash.
  Stored<std::vector<std::byte>> get(const Hash256& hash);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
