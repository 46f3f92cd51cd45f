#include "storage/repositories/student_lines.h"

#include <map>
#include <utility>
#include <vector>

#include "storage/base/small_letters.h"
#include "storage/base/text_length.h"
#include "storage/records/audit_writer.h"
#include "storage/records/current_rights.h"
#include "storage/records/sealing.h"
#include "storage/repositories/cohorts.h"
#include "storage/repositories/erasure.h"
#include "storage/repositories/new_account.h"

namespace cusp::storage {
namespace {

/// One per line; empty for an account that is known.
struct LineSecrets {
  std::vector<HashedSecrets> secrets{};
  StudentLinesEnd end{};
};

LineSecrets hash_lines(std::span<const StudentLine> lines, const PasswordCost& cost, const WorkWatch& watch) {
  LineSecrets out;
  WorkSteps steps(watch);
  steps.begin(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!steps.go_on()) return {{}, {StorageFailure{StorageError::stopped, "people"}, lines.size()}};
    const NewAccount& account = lines[i].account;
    HashedSecrets hashed;
    if (!lines[i].has_account) {
      if (const auto good = check_new_account(account); !good) return {{}, {good.error(), i}};
      auto made = hashed_secrets(account, cost);
      if (!made) return {{}, {made.error(), i}};
      hashed = std::move(*made);
    }
    out.secrets.push_back(std::move(hashed));
    steps.add_done();
  }
  if (!steps.go_on()) out.end = {StorageFailure{StorageError::stopped, "people"}, lines.size()};
  return out;
}

/// The cohorts by name, within a transaction.
class CohortsOfLines {
 public:
  CohortsOfLines(StorageContext& context, Transaction& transaction, UserId actor) : context_{context}, transaction_{transaction}, actor_{actor} {
    const auto all = transaction.database().all("SELECT name, id FROM cohorts", [](Row row) { return std::pair{row.text(0), row.id<CohortId>(1)}; });
    if (!all) {
      transaction.refuse(all.error());
      return;
    }
    for (const auto& [name, id] : *all) ids_.emplace(small_letters(name), id);
  }

  void join(const std::string& name, UserId student) {
    require_not_erased(transaction_, student);
    const CohortId cohort = named(name);
    transaction_.run("INSERT INTO cohort_students (cohort, student) VALUES (?1, ?2) ON CONFLICT DO NOTHING", cohort, student);
    // Who was in the cohort has not joined it now.
    if (!transaction_.ok() || context_.db.changes() == 0) return;
    log_event(context_, transaction_, {.actor = actor_, .action = "cohort_joined", .subject = student.uuid, .detail = cohort.text()});
  }

 private:
  CohortId named(const std::string& name) {
    const auto [at, missing] = ids_.try_emplace(small_letters(name));
    if (!missing) return at->second;
    if (!has_length(name, 1, kMostCohortName)) transaction_.refuse({StorageError::bad_value, "name"});
    at->second = CohortId::make();
    transaction_.run("INSERT INTO cohorts (id, name, created_at) VALUES (?1, ?2, ?3)", at->second, name, context_.clock());
    log_row(context_, transaction_, actor_, "cohort_created", SealedTable::cohorts, at->second.uuid);
    return at->second;
  }

  StorageContext& context_;
  Transaction& transaction_;
  UserId actor_;
  std::map<std::string, CohortId> ids_;  // [name in small letters]
};

/// nullopt refuses the transaction.
std::optional<UserId> account_known(Transaction& transaction, const std::string& number) {
  const auto id = transaction.first("SELECT id FROM people WHERE number = ?1 AND guest = 0", [](Row row) { return row.id<UserId>(0); }, number);
  if (!id) transaction.refuse({StorageError::not_found, "people", number});
  return id;
}

/// What has the number is named, and not the file.
StorageFailure of_line(StorageFailure failure, const std::string& number) {
  if (failure.code == StorageError::duplicate) failure.where = number;
  return failure;
}

}  // namespace

StudentLinesEnd add_students(StorageContext& context, const Actor& actor, std::span<const StudentLine> lines, const WorkWatch& watch) {
  for (const Action action : {Action::manage_accounts, Action::manage_cohorts})
    if (const auto allowed = require(actor, action); !allowed) return {allowed.error(), lines.size()};
  if (lines.empty()) return {};
  const LineSecrets hashed = hash_lines(lines, context.cost, watch);
  if (hashed.end.failure) return hashed.end;
  Transaction transaction(context.db);
  require_now(transaction, actor.id, Action::manage_accounts);
  CohortsOfLines cohorts(context, transaction, actor.id);
  std::size_t done = transaction.ok() ? 0 : lines.size();
  for (; done < lines.size(); ++done) {
    const StudentLine& line = lines[done];
    const auto id = line.has_account ? account_known(transaction, line.account.number)
                                     : std::optional(insert_account(context, transaction, actor.id, line.account, hashed.secrets[done]));
    if (id && !line.cohort.empty()) cohorts.join(line.cohort, *id);
    if (!transaction.ok()) break;
  }
  const auto committed = commit_sealed(context, transaction);
  if (committed) return {};
  return {done < lines.size() ? of_line(committed.error(), lines[done].account.number) : committed.error(), done};
}

}  // namespace cusp::storage
