/// Writes seals (seals.h) into the audit log, and keeps the rollback counter up to the log.
///
/// | entry | subject | end of the detail |
/// |---|---|---|
/// | session_sealed | session | event, entries of its chain, last link |
/// | account_created, account_renamed, role_changed, ..., person_erased, person_sealed | user | the six fields of account_seal() |
/// | commented, comment_sealed | session | row_seals() of the comment |
/// | comment_erased | session | row_seals() of the comment before and after |
/// | statement_erased | statement | nothing: its text is gone |
/// | cohort_created, cohort_sealed | cohort | row_seals() |
/// | assigned, assignment_sealed | assignment | row_seals() |
/// | version_published, version_kept, version_sealed | version | row_seals() |
/// | stated, statement_sealed | statement | row_seals() |
/// | assessment_set, assessment_sealed | assignment | row_seals() |
/// | version_withdrawn, withdrawal_sealed | version | row_seals() |
/// | assignment_withdrawn, assignment_withdrawal_sealed | assignment | row_seals() |
/// | adjusted, adjustment_sealed | adjustment | row_seals() |
/// | key_trusted, key_kept, key_role_changed, key_revoked | row of other_keys | key, row_seals() |
/// | trace_thinned, thinning_sealed | session | row_seals() of its row in `thinned_traces` |
/// | trace_returned | session | nothing: the recording is here again, and the row is gone |
/// | referred, arrived | account or version | row_seals() of its row in `referred` |
/// | sealing_began | station | number of rows from before; the entries after it seal them |
/// | rolled_back, counter_missing, counter_broken, log_damaged | station | an incident; stays a finding for good |
#pragma once

#include <string_view>

#include "storage/records/context.h"
#include "storage/records/seals.h"

namespace cusp::storage {

/// Entries with a seal, within the transaction that wrote the row.
void log_account(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
                 UserId account);
void log_row(StorageContext& context, Transaction& transaction, UserId actor, std::string_view action,
             SealedTable table, const Uuid& id);
/// Call after ChainWriter::finish(). `event`: a key of EventKind.
void log_session(StorageContext& context, Transaction& transaction, UserId actor, SessionId session,
                 std::string_view event);

/// Commits, then brings the counter up to the log. A counter that cannot be written does not fail the transaction:
/// context.counter_failure holds the reason, and the next commit tries again.
Stored<void> commit_sealed(StorageContext& context, Transaction& transaction);

/// At each opening for writing: seals older rows once, and checks the counter. What the counter shows enters the log and
/// context.incident.
Stored<void> begin_sealing(StorageContext& context);
/// For a file opened read-only: checks the counter and sets context.incident; writes nothing.
void note_counter_incident(StorageContext& context);

}  // namespace cusp::storage
