/// A file system for SQLite that fails on demand, at the n-th call, or as a read-only or full disk; or that counts.
/// One per process, used by one thread. All else goes to the system's own.
#pragma once

#include <string>

namespace cusp::test {

enum class Failing {
  nothing,      // only counts
  disk_full,    // from the n-th on, every write that a full disk refuses
  io_error,     // from the n-th on, every write and sync
  once,         // the n-th alone: an I/O error
  short_write,  // the n-th write keeps half of its bytes and fails, and so does every write and sync after it
  any_call,     // the n-th call of any kind: opening, reading, size, deleting, mapping the index, writing, syncing
  read_only,    // every file opens for reading only, and none can be made
  no_index,     // a full disk, on which the log's index cannot grow
};

/// Registers the file system at first use; give the name to DatabaseOptions::vfs.
std::string failing_vfs();
/// `n` counts from 1 over all files of the process, from this call on.
void fail_from(Failing how, int n);
/// Calls seen since fail_from(): writes, truncates and syncs; with any_call those of every kind.
int operations_seen();

}  // namespace cusp::test
