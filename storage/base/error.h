/// How storage fails: a code, and in Failure::where the file, table or key. ui turns codes into sentences.
#pragma once

#include <cstdint>

#include "engine/base/result.h"

namespace cusp::storage {

enum class StorageError : std::uint8_t {
  // Opening
  not_found,       // no such file (open only), folder (Failure::detail "folder") or row
  not_a_database,  // not SQLite, or SQLite of another program; Failure::detail "empty": no table yet
  newer_schema,    // a newer version of the program wrote the file; it is unchanged
  network_drive,   // on a drive where write-ahead logging is unsafe
  read_only,       // file, folder or disk cannot be written; Failure::detail "new file": none can be made there
  // Any time
  // After each of these nothing of the transaction is written.
  disk_full,       // no space left; detail "reserve": what is left is kept for the records (KeyStateCache)
  quota_exceeded,  // the disk has space, this user's quota has none
  file_too_large,  // the file would exceed the limit of the file system or of the process
  out_of_memory,   // also for a password's hash (where = "memory")
  io,              // the disk failed, or the system gives another reason (detail)
  busy,            // another process held the file for longer than the time-out
  stopped,         // the watch of the work ended it (storage/base/watch.h)
  corrupt,         // the file's structure is damaged; detail "sessions": a backup holds another number than its description
  bad_statement,   // SQLite rejects the SQL: a table or column is missing
  // Accounts and rights
  wrong_password,      // also for an unknown number: the caller cannot tell which
  other_secret,        // this account signs in by Failure::detail, "pin" or "password"; where = number; no wrong try
  locked,              // too many wrong tries; Failure::detail: UTC µs of the end of the lock
  disabled,            // the account is disabled; where = "actor": that of who acts
  not_allowed,         // the role lacks this right
  weak_password,       // fewer than 8 characters, or a PIN that is not six digits
  last_administrator,  // would leave no enabled administrator
  // Rows
  duplicate,    // number, name or version exists already, or a file; detail "number": where = an account's number that a file brings;
                // detail "log": where = name of a log whose records were moved away, where none are to be made;
                // detail "finished": an earlier restore to where, or an earlier file that leaves the station
  bad_value,    // outside the range that the table admits
  wrong_state,  // the session is not in a state that allows this (finished twice, a gap in ticks)
  bad_trace,    // bytes that are not a trace, key state or volume
  other_device,  // the assignment does not admit this class; where = the device's class, detail = the classes admitted, spaced
  self_test_due,  // no self-test of this class passed in the days that the assignment asks; where = the device's class, detail = days
  // Files of other stations (storage/exchange). Nothing of the file is read.
  not_exchange,  // no such file, or not as it was signed
  cut_short,     // it ends before its last page; detail: its bytes, a blank, those of the whole
  older_schema,  // an older version of the program made it; detail: its schema
  unknown_key,   // nobody has made the key known here; where = station, detail = the key's id
  revoked_key,   // where = station, detail = the key's id
  put_back,      // the station stands on an old copy: it has given out another file under this number; where = station, detail = number
  differs,       // the same id stands here with other content; where = table, detail = id
  // Retention
  clock_ahead,  // the clock is further ahead of every attempt and account than a station pauses; detail: storage/retention/clock_doubt.h
};

/// True if freeing space, or quota, lets the same write succeed.
constexpr bool out_of_space(StorageError code) noexcept {
  return code == StorageError::disk_full || code == StorageError::quota_exceeded;
}

using StorageFailure = Failure<StorageError>;
template <class T>
using Stored = Result<T, StorageFailure>;

}  // namespace cusp::storage
