/// What examiners and instructors state about a session: comments, overrides, confirmation, release, withdrawal; and what its
/// student states: the own assessment. Each is a signed row that stays (storage/records/statement_rows.h). Every write refuses
/// while the session runs (wrong_state), and one with a text once its student was erased (not_found, where = people). Nobody decides about
/// an own attempt, by override, confirmation, release, or withdrawal of one (not_allowed, where = own_attempt).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "storage/base/rights.h"
#include "storage/records/context.h"
#include "storage/records/effective_grade.h"
#include "storage/records/self_assessment.h"

namespace cusp::storage {

inline constexpr std::size_t kMostStatementText = 10'000;  // characters

struct CommentPlace {
  std::optional<std::uint64_t> tick{};  // moment in the session
  std::optional<Vec3> place_mm{};       // on the specimen
};

class Statements {
 public:
  explicit Statements(StorageContext& context) : c_{context} {}

  /// Needs comment. bad_value (where = text) for an empty or too long text.
  Stored<SignedStatement> comment(const Actor& actor, SessionId session, const std::string& text,
                                  const CommentPlace& at = {});
  /// These need grade_again and a reason. They speak of the newest grade; wrong_state (where = grade) without one.
  /// bad_value (where = criterion) for one that the grade does not have, (where = points) outside 0 to the criterion's most.
  /// `seen`: shown_hash() of the result that the examiner has read; wrong_state (where = changed) if another one counts by now.
  Stored<SignedStatement> override_points(const Actor& actor, SessionId session, const std::string& criterion,
                                          double points, const std::string& reason, const std::optional<Hash256>& seen = {});
  /// The critical event no longer fails the attempt.
  Stored<SignedStatement> override_critical(const Actor& actor, SessionId session, const std::string& event,
                                            const std::string& reason, const std::optional<Hash256>& seen = {});
  /// Needs grade_again. The result as it stands now; a later override asks for another one. A release that waits for it holds
  /// again. `seen`: as of an override.
  Stored<SignedStatement> confirm(const Actor& actor, SessionId session, const std::optional<Hash256>& seen = {});
  /// Needs assign. wrong_state (where = released) if it is, (where = confirmation) while the result is failed and unconfirmed,
  /// (where = grade) without a grade.
  Stored<SignedStatement> release(const Actor& actor, SessionId session);
  /// By the session's student, once. not_allowed (where = own_session) for another actor; wrong_state (where = self_assessment) if
  /// there is one, (where = released) once an assessment has a release, also one that waits; bad_value (where = criterion) for one
  /// that the grade does not have. An empty one says that the student skipped it.
  Stored<SignedStatement> assess_own(const Actor& actor, SessionId session, const SelfAssessment& own);
  /// Needs the right of what it takes back. not_found unless that statement is in force in this session. Needs a reason. An own
  /// assessment stays: not_allowed (where = self_assessment).
  Stored<SignedStatement> withdraw(const Actor& actor, SessionId session, const Uuid& statement, const std::string& reason);

  /// Oldest first. A student reads those of own, released sessions; others need see_all_results.
  Stored<std::vector<SignedStatement>> of(const Actor& actor, SessionId session);
  /// nullopt: none, or erased. A student reads the own ones, also while the result is withheld; others need see_all_results.
  Stored<std::optional<SelfAssessment>> self_assessment(const Actor& actor, SessionId session);

 private:
  /// Checks and completes the statement within the transaction that writes it.
  using Check = std::function<void(Transaction&, SignedStatement&)>;
  Stored<SignedStatement> state(const Actor& actor, SignedStatement statement, const Check& check);
  StorageContext& c_;
};

}  // namespace cusp::storage
