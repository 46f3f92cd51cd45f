/// A copy of the database in memory, for a disk on which SQLite cannot create the index of the write-ahead log. SQLite
/// needs the index to read a file that others may write; its `immutable=1` would ignore the log.
///
/// No other connection may use the file during the copy. If the file can be written, its exclusive lock proves that. Else
/// the copy holds the shared lock, and no index lies beside the file before and after: a writer needs an index, and
/// cannot remove it while another connection holds the shared lock.
#pragma once

#include "storage/base/error.h"

struct sqlite3;

namespace cusp::storage {

/// A read-only connection of its own; takes the file's size in memory. Fails with busy if another connection uses the
/// file, io if it cannot be read, corrupt if file and log do not match. Pre: `source` has run no statement.
Stored<sqlite3*> memory_copy(sqlite3* source);

}  // namespace cusp::storage
