/// The database as it stands now, in memory: for a disk where SQLite can make no index of the write-ahead log, which it
/// needs to read a file that others may be writing. SQLite's `immutable=1` would pass over the log's content.
///
/// No connection stands meanwhile. Where the file can be written, its exclusive lock proves that. Else the shared lock
/// is held, and no index lies beside the file before and after: whoever writes a log needs an index, and cannot take it
/// away again while somebody else holds the shared lock.
#pragma once

#include "storage/error.h"

struct sqlite3;

namespace cusp::storage {

/// A read-only connection of its own. Memory: as much as the file has, once. Fails with busy where another connection
/// stands, io where the file cannot be read, corrupt where file and log do not fit together.
/// Pre: `source` has run no statement yet.
Stored<sqlite3*> memory_copy(sqlite3* source);

}  // namespace cusp::storage
