/// What stations that have read each other's files hold in common, as one hash.
#pragma once

#include <map>
#include <string>

#include "tests/storage/sample.h"

namespace cusp::test {

/// By table: how many rows, and a hash over the columns that are the same on every station. What a station derives, decides or
/// knows for itself stays out: accounts "own-…" and "local-…" without an attempt, secrets, its own numbers of versions, its log, its keys, open sessions.
std::map<std::string, std::string> shared_records(Store& store);

}  // namespace cusp::test
