/// The header of a session as JSON: every number reads back to the same bits. Within storage only.
#pragma once

#include <optional>
#include <string>

#include "storage/repositories/sessions.h"

namespace cusp::storage {

std::string header_to_json(const SessionHeader& header);
/// nullopt if a field is missing or of another type.
std::optional<SessionHeader> header_from_json(const std::string& text);

}  // namespace cusp::storage
