/// A file system for SQLite that fails on demand, at the n-th write or sync, or as a read-only disk; or that counts.
/// One per process, used by one thread. All else goes to the system's own.
#pragma once

#include <string>

namespace cusp::testing {

enum class Failing {
  nothing,    // only counts
  disk_full,  // from the n-th on, every write that a full disk refuses
  io_error,   // from the n-th on, every write and sync
  once,       // the n-th alone: an I/O error
  read_only,  // every file opens for reading only, and none can be made
};

/// Registers the file system at first use; give the name to DatabaseOptions::vfs.
std::string failing_vfs();
/// `n` counts from 1 over all files of the process, from this call on.
void fail_from(Failing how, int n);
/// Writes, truncates and syncs seen since fail_from().
int operations_seen();

}  // namespace cusp::testing
