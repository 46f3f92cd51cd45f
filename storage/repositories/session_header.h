/// The header of a session as JSON: every number reads back to the same bits. Within storage only.
#pragma once

#include <optional>
#include <string>

#include "storage/repositories/sessions.h"

namespace cusp::storage {

std::string header_to_json(const SessionHeader& header);
/// nullopt if a field is missing or of another type.
std::optional<SessionHeader> header_from_json(const std::string& text);

/// Keeps the JSON among the blobs, once for all sessions that have the same, and returns what the column `header` holds: its hash in
/// hex. Before schema 13 the column held the JSON itself.
std::string keep_header(Transaction& transaction, const SessionHeader& header);
/// corrupt (where = sessions) if it cannot be read.
Stored<SessionHeader> read_header(Database& db, const std::string& column);

}  // namespace cusp::storage
