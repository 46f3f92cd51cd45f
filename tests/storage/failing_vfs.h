/// A file system for SQLite that fails on demand: at the n-th call, or like a read-only or full disk. It counts calls and
/// passes them on to the system's own. One per process, used by one thread.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace cusp::test {

enum class Failing {
  nothing,      // only counts
  disk_full,    // from the n-th on, every write that a full disk refuses
  over_quota,   // from the n-th on, every write and sync, as above the user's quota (EDQUOT)
  too_large,    // from the n-th on, every write and sync, as at the largest size of a file (EFBIG)
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
/// Called before each file is opened, with its path; an empty function ends that.
void at_opening(std::function<void(std::string_view path)> call);

}  // namespace cusp::test
