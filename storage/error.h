/// How storage fails: a code, and in Failure::where the file, table or key it met. ui turns codes into sentences.
#pragma once

#include <cstdint>

#include "engine/base/result.h"

namespace cusp::storage {

enum class StorageError : std::uint8_t {
  // Opening
  not_found,       // no such file (open only), folder (Failure::detail "folder") or row
  not_a_database,  // the file is not SQLite, or is SQLite of another program
  newer_schema,    // written by a newer version of the program; nothing was touched
  network_drive,   // lies on a drive where write-ahead logging is unsafe
  read_only,       // file, folder or disk cannot be written; Failure::detail "new file": none can be made there
  // Any time
  disk_full,  // nothing of the transaction was written
  io,         // the disk failed; nothing of the transaction was written
  busy,       // another process held the file for longer than the time-out
  corrupt,    // the file's structure is damaged
  // Accounts and rights
  wrong_password,      // also for an unknown number: the two cannot be told apart
  other_secret,        // this account signs in by Failure::detail, "pin" or "password"; where = number; no wrong try
  locked,              // too many wrong tries; Failure::detail is the UTC µs at which it opens again
  disabled,            // the account was switched off
  not_allowed,         // the role does not have this right
  weak_password,       // fewer than 8 characters, or a PIN that is not six digits
  last_administrator,  // would leave nobody to manage people
  // Rows
  duplicate,    // number, name or version exists already
  bad_value,    // outside what the table admits
  wrong_state,  // the session is not in a state that allows this (finished twice, a gap in ticks)
  bad_trace,    // bytes that are not a trace, key state or volume
};

using StorageFailure = Failure<StorageError>;
template <class T>
using Stored = Result<T, StorageFailure>;

}  // namespace cusp::storage
