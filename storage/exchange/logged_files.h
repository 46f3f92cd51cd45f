/// Files that leave the station as the audit log names them, and those that a killed program logged without naming them. Within storage
/// only. Thread: the context's own.
#pragma once

#include <filesystem>
#include <string>

#include "storage/base/hash.h"
#include "storage/exchange/exchange_file.h"
#include "storage/records/context.h"

namespace cusp::storage {

/// Of an entry "exchange_given_out": the key's id, the kind, and description_hash().
std::string given_out_detail(const Hash256& key, ExchangeKind kind, const Hash256& description);
/// Of an entry "packed": blake2b_256 of the whole file.
std::string packed_detail(const Hash256& file);

/// A program may be killed after the entry and before the name: each such file in the folder of `file` gets its name now. Whether one of
/// them is `file`.
bool name_earlier_files(StorageContext& context, const std::filesystem::path& file);

}  // namespace cusp::storage
