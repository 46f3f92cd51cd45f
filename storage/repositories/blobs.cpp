#include "storage/repositories/blobs.h"

#include "storage/records/trace_codec.h"

namespace cusp::storage {

Stored<Hash256> Blobs::put(std::span<const std::byte> bytes) {
  if (bytes.size() > kMostUnpackedBytes) return fail(StorageError::bad_value, "blobs");
  const Hash256 hash = blake2b_256(bytes);
  const auto there = get(hash);
  if (there) return hash;
  if (there.error().code != StorageError::not_found && there.error().code != StorageError::corrupt) return std::unexpected(there.error());
  Transaction transaction(c_.db);
  // The hash names the content: a damaged row is put right, for every attempt at the exercise shares it.
  transaction.run("INSERT INTO blobs (hash, packed) VALUES (?1, ?2) ON CONFLICT (hash) DO UPDATE SET packed = excluded.packed", hash, pack(bytes));
  if (auto done = transaction.commit(); !done) return std::unexpected(done.error());
  return hash;
}

Stored<std::vector<std::byte>> Blobs::get(const Hash256& hash) {
  const auto packed =
      c_.db.first("SELECT packed FROM blobs WHERE hash = ?1", [](Row row) { return row.blob(0); }, hash);
  if (!packed) return std::unexpected(packed.error());
  if (!*packed) return fail(StorageError::not_found, "blobs", hex(hash));
  auto bytes = unpack(**packed);
  if (!bytes || blake2b_256(*bytes) != hash) return fail(StorageError::corrupt, "blobs", hex(hash));
  return bytes;
}

}  // namespace cusp::storage
