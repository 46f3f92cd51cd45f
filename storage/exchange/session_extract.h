/// The records of one attempt as a database of their own, which opens read-only like a station's. Passwords and PINs stay
/// behind; so does the audit log, of which log_about() gives the entries that concern the attempt.
/// Thread: the context's own.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "storage/base/rights.h"
#include "storage/records/audit_writer.h"
#include "storage/records/context.h"

namespace cusp::storage {

/// How the student is named. Staff keep their names: they answer for what they stated.
enum class StudentNamed : std::uint8_t { by_candidate_number, by_name };

/// Writes a new file with every row of the session, all statements, and what they refer to, as of one moment. Needs
/// export_results. wrong_state while the session runs, or (where = thinned) without its recording; duplicate if the file exists.
/// read_only without the station's key, which signs it afterwards. A failure leaves no file.
Stored<void> extract_session(StorageContext& context, const Actor& actor, SessionId session, StudentNamed named,
                             const std::filesystem::path& file);

/// Entries of the audit log about the session, its statements, its version and its assignment; oldest first. Needs
/// export_results.
Stored<std::vector<AuditEntry>> log_about(StorageContext& context, const Actor& actor, SessionId session);

}  // namespace cusp::storage
