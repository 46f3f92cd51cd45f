#include "storage/repositories/statements.h"

#include <algorithm>
#include <cmath>

#include "storage/base/text_length.h"
#include "storage/records/sealing.h"
#include "storage/records/session_summary.h"
#include "storage/records/current_rights.h"
#include "storage/repositories/erasure.h"
#include "storage/repositories/session_state.h"

namespace cusp::storage {
namespace {

bool good_text(const std::string& text) noexcept { return has_length(text, 1, kMostStatementText); }

/// Grade and statements as the transaction sees them; refuses without a grade.
std::optional<EffectiveGrade> counted(Transaction& transaction, SessionId session) {
  if (!transaction.ok()) return std::nullopt;
  const auto grades = grades_of(transaction.database(), session);
  const auto statements = statements_of(transaction.database(), session);
  if (!grades || !statements) {
    transaction.refuse(grades ? statements.error() : grades.error());
    return std::nullopt;
  }
  auto out = effective_grade(*grades, *statements);
  if (!out) transaction.refuse({StorageError::wrong_state, "grade", session.text()});
  return out;
}

/// Refuses if another result counts by now than the examiner has read. Without `seen` any does.
void require_seen(Transaction& transaction, SessionId session, const Grade& counts, const std::optional<Hash256>& seen) {
  if (seen && *seen != shown_hash(counts)) transaction.refuse({StorageError::wrong_state, "changed", session.text()});
}

/// Erasing took what was written about the student: nothing is written after it.
void require_student(Transaction& transaction, SessionId session) {
  const auto student = transaction.first("SELECT student FROM sessions WHERE id = ?1", [](Row row) { return row.id<UserId>(0); }, session);
  if (student) require_not_erased(transaction, *student);
}

/// Of a withdrawal the right is that for what it withdraws: every role has drill.
Action right_for(StatementKind kind) noexcept {
  if (kind == StatementKind::comment) return Action::comment;
  if (kind == StatementKind::self_assessment || kind == StatementKind::withdrawal) return Action::drill;
  return kind == StatementKind::release ? Action::assign : Action::grade_again;
}

/// What an examiner decides about a result. Nobody decides about an own attempt, as who has become an instructor could.
bool decides(StatementKind kind) noexcept { return right_for(kind) == Action::grade_again || kind == StatementKind::release; }

void require_other(Transaction& transaction, SessionId session, UserId actor) {
  const auto student = transaction.first("SELECT student FROM sessions WHERE id = ?1", [](Row row) { return row.id<UserId>(0); }, session);
  if (student && *student == actor) transaction.refuse({StorageError::not_allowed, "own_attempt", session.text()});
}

}  // namespace

Stored<SignedStatement> Statements::state(const Actor& actor, SignedStatement statement, const Check& check) {
  statement.author = actor.id;
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, right_for(statement.kind));
  require_state(transaction, statement.session, Need::not_running);
  if (!statement.text.empty()) require_student(transaction, statement.session);
  if (decides(statement.kind)) require_other(transaction, statement.session, actor.id);
  if (transaction.ok()) check(transaction, statement);
  insert_statement(c_, transaction, statement);
  if (transaction.ok()) follow_event(transaction, statement.session);
  log_row(c_, transaction, actor.id, "stated", SealedTable::statements, statement.id);
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  return statement;
}

Stored<SignedStatement> Statements::comment(const Actor& actor, SessionId session, const std::string& text,
                                            const CommentPlace& at) {
  if (auto allowed = require(actor, Action::comment); !allowed) return std::unexpected(allowed.error());
  if (!good_text(text)) return fail(StorageError::bad_value, "text");
  SignedStatement s{.session = session, .kind = StatementKind::comment};
  s.tick = at.tick;
  s.place_mm = at.place_mm;
  s.text = text;
  return state(actor, std::move(s), [](Transaction&, SignedStatement&) {});
}

Stored<SignedStatement> Statements::override_points(const Actor& actor, SessionId session, const std::string& criterion,
                                                    double points, const std::string& reason, const std::optional<Hash256>& seen) {
  if (auto allowed = require(actor, Action::grade_again); !allowed) return std::unexpected(allowed.error());
  if (!good_text(reason)) return fail(StorageError::bad_value, "text");
  SignedStatement s{.session = session, .kind = StatementKind::override_points};
  s.criterion = criterion;
  s.points = points;
  s.text = reason;
  return state(actor, std::move(s), [&seen](Transaction& transaction, SignedStatement& made) {
    const auto grade = counted(transaction, made.session);
    if (!grade) return;
    require_seen(transaction, made.session, grade->grade, seen);
    made.grade = grade->stored.number;
    const auto& criteria = grade->stored.grade.criteria;
    const auto found = std::ranges::find(criteria, made.criterion, &CriterionGrade::id);
    if (found == criteria.end()) return transaction.refuse({StorageError::bad_value, "criterion", made.criterion});
    const bool inside = std::isfinite(*made.points) && *made.points >= 0 && *made.points <= found->points_max;
    if (!inside) transaction.refuse({StorageError::bad_value, "points", made.criterion});
  });
}

Stored<SignedStatement> Statements::override_critical(const Actor& actor, SessionId session, const std::string& event,
                                                      const std::string& reason, const std::optional<Hash256>& seen) {
  if (auto allowed = require(actor, Action::grade_again); !allowed) return std::unexpected(allowed.error());
  if (!good_text(reason)) return fail(StorageError::bad_value, "text");
  SignedStatement s{.session = session, .kind = StatementKind::override_critical};
  s.criterion = event;
  s.text = reason;
  return state(actor, std::move(s), [&seen](Transaction& transaction, SignedStatement& made) {
    const auto grade = counted(transaction, made.session);
    if (!grade) return;
    require_seen(transaction, made.session, grade->grade, seen);
    made.grade = grade->stored.number;
    const auto& events = grade->grade.critical;
    if (std::ranges::find(events, made.criterion) == events.end()) {
      transaction.refuse({StorageError::bad_value, "criterion", made.criterion});
    }
  });
}

Stored<SignedStatement> Statements::confirm(const Actor& actor, SessionId session, const std::optional<Hash256>& seen) {
  if (auto allowed = require(actor, Action::grade_again); !allowed) return std::unexpected(allowed.error());
  return state(actor, {.session = session, .kind = StatementKind::confirmation},
               [&seen](Transaction& transaction, SignedStatement& made) {
                 const auto grade = counted(transaction, made.session);
                 if (!grade) return;
                 made.grade = grade->stored.number;
                 made.points = grade->grade.score;
                 made.shown = shown_hash(grade->grade);
                 require_seen(transaction, made.session, grade->grade, seen);
               });
}

Stored<SignedStatement> Statements::release(const Actor& actor, SessionId session) {
  if (auto allowed = require(actor, Action::assign); !allowed) return std::unexpected(allowed.error());
  return state(actor, {.session = session, .kind = StatementKind::release},
               [](Transaction& transaction, SignedStatement& made) {
                 const auto grade = counted(transaction, made.session);
                 if (!grade) return;
                 made.grade = grade->stored.number;
                 if (grade->needs_confirmation()) {
                   transaction.refuse({StorageError::wrong_state, "confirmation", made.session.text()});
                 }
                 const auto released = transaction.first(
                     "SELECT released FROM session_summaries WHERE session = ?1", [](Row row) { return row.flag(0); },
                     made.session);
                 if (released.value_or(false)) {
                   transaction.refuse({StorageError::wrong_state, "released", made.session.text()});
                 }
               });
}

Stored<SignedStatement> Statements::withdraw(const Actor& actor, SessionId session, const Uuid& statement,
                                             const std::string& reason) {
  if (!good_text(reason)) return fail(StorageError::bad_value, "text");
  SignedStatement s{.session = session, .kind = StatementKind::withdrawal};
  s.withdraws = statement;
  s.text = reason;
  return state(actor, std::move(s), [&actor](Transaction& transaction, SignedStatement& made) {
    const auto all = statements_of(transaction.database(), made.session);
    if (!all) return transaction.refuse(all.error());
    const auto standing = in_force(*all);
    const auto target = std::ranges::find(standing, made.withdraws, &SignedStatement::id);
    if (target == standing.end()) {
      return transaction.refuse({StorageError::not_found, "statements", made.withdraws.text()});
    }
    if (target->kind == StatementKind::self_assessment) {
      return transaction.refuse({StorageError::not_allowed, std::string(key_of(target->kind)), made.session.text()});
    }
    if (auto allowed = require(actor, right_for(target->kind)); !allowed) transaction.refuse(allowed.error());
    require_now(transaction, actor.id, right_for(target->kind));
    if (decides(target->kind)) require_other(transaction, made.session, actor.id);
  });
}

Stored<SignedStatement> Statements::assess_own(const Actor& actor, SessionId session, const SelfAssessment& own) {
  if (auto allowed = require(actor, Action::drill); !allowed) return std::unexpected(allowed.error());
  SignedStatement s{.session = session, .kind = StatementKind::self_assessment};
  s.text = text_of(own);
  if (!good_text(s.text)) return fail(StorageError::bad_value, "text");
  return state(actor, std::move(s), [&](Transaction& transaction, SignedStatement& made) {
    const auto student = transaction.first("SELECT student FROM sessions WHERE id = ?1",
                                           [](Row row) { return row.id<UserId>(0); }, made.session);
    if (student && *student != actor.id) return transaction.refuse({StorageError::not_allowed, "own_session"});
    const auto all = statements_of(transaction.database(), made.session);
    const auto grades = grades_of(transaction.database(), made.session);
    if (!all || !grades) return transaction.refuse(all ? grades.error() : all.error());
    const auto refuse_for = [&](std::string_view what) {
      transaction.refuse({StorageError::wrong_state, std::string(what), made.session.text()});
    };
    if (std::ranges::any_of(*all, [&](const SignedStatement& o) { return o.kind == made.kind; })) return refuse_for(key_of(made.kind));
    if (release_of(*all)) return refuse_for("released");
    if (grades->empty()) return;
    made.grade = grades->back().number;
    for (const auto& [criterion, rating] : own.ratings) {
      const auto& graded = grades->back().grade.criteria;
      const auto found = std::ranges::find(graded, criterion, &CriterionGrade::id);
      if (found == graded.end()) return transaction.refuse({StorageError::bad_value, "criterion", criterion});
    }
  });
}

Stored<std::vector<SignedStatement>> Statements::of(const Actor& actor, SessionId session) {
  const auto row = c_.db.first(
      "SELECT student, released FROM session_summaries WHERE session = ?1",
      [](Row r) { return std::pair{r.id<UserId>(0), r.flag(1)}; }, session);
  if (!row) return std::unexpected(row.error());
  if (!*row) return fail(StorageError::not_found, "sessions", session.text());
  if (auto allowed = require_reading(actor, (*row)->first); !allowed) return std::unexpected(allowed.error());
  if (!(*row)->second && !may(actor.role, Action::see_all_results)) return std::vector<SignedStatement>{};
  return statements_of(c_.db, session);
}

Stored<std::optional<SelfAssessment>> Statements::self_assessment(const Actor& actor, SessionId session) {
  const auto student = c_.db.first("SELECT student FROM sessions WHERE id = ?1", [](Row row) { return row.id<UserId>(0); }, session);
  if (!student) return std::unexpected(student.error());
  if (!*student) return fail(StorageError::not_found, "sessions", session.text());
  if (auto allowed = require_reading(actor, **student); !allowed) return std::unexpected(allowed.error());
  const auto statements = statements_of(c_.db, session);
  if (!statements) return std::unexpected(statements.error());
  return self_assessment_of(*statements);
}

}  // namespace cusp::storage
