/// What somebody states about a session: final, signed rows of the table `statements`. Nothing is updated; a withdrawal
/// takes another statement back. Thread: the database's own.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "storage/records/context.h"
#include "storage/records/verify.h"

namespace cusp::storage {

enum class StatementKind : std::uint8_t {
  comment,            // on the session, a moment or a place
  override_points,    // the points of one criterion, with a reason
  override_critical,  // a critical event that does not count, with a reason
  confirmation,       // an examiner saw the result as it stands
  release,            // the student may read the result
  withdrawal,         // of another statement of this session
  self_assessment,    // the student's own rating of each criterion, before the result is shown (self_assessment.h)
};
std::string_view key_of(StatementKind kind) noexcept;

struct SignedStatement {
  Uuid id{};
  SessionId session{};
  Uuid station{};  // where it was made
  UserId author{};
  std::int64_t at_utc_us = 0;  // not before the statements about the session that were known there
  std::int64_t sequence = 0;   // the station's; greater than those of all statements that were known there
  StatementKind kind = StatementKind::comment;
  std::optional<int> grade{};      // number of the grade that it speaks of
  std::string criterion{};         // of an override: the criterion's id, or the critical event
  std::optional<double> points{};  // of override_points: what counts; of a confirmation: the score that it is of, none from older programs
  std::optional<Hash256> shown{};  // of a confirmation: shown_hash() of the result that it is of, none from older programs
  std::optional<std::uint64_t> tick{};
  std::optional<Vec3> place_mm{};
  Uuid withdraws{};    // of a withdrawal
  std::string text{};  // comment or reason; empty if erased
};

/// Oldest first: those of one station by their sequence, those of several by their time, then by sequence and id. A time counts as
/// the station's latest so far. A row of an unknown kind is left out: the verifier reports it.
Stored<std::vector<SignedStatement>> statements_of(Database& db, SessionId session);
/// Without withdrawals and what they take back; oldest first.
std::vector<SignedStatement> in_force(const std::vector<SignedStatement>& statements);

/// Writes and signs the row, with the head of the session's chain as it stands; sets id, time and sequence.
void insert_statement(StorageContext& context, Transaction& transaction, SignedStatement& statement);

/// Signature and key of every statement, and each text against its hash. Calls for rows that do not hold:
/// row_changed, key_changed, row_missing or row_added of `statements` or `statement_texts`; owner: the session.
Stored<std::vector<ChainFinding>> check_statements(Database& db);

}  // namespace cusp::storage
