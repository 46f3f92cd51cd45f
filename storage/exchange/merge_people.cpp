#include "storage/exchange/merge.h"
#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/repositories/erasure.h"
#include "storage/repositories/possible_doubles.h"

namespace cusp::storage {
namespace {

struct PersonInFile {
  UserId id;
  std::string number, seal;
};

Stored<std::vector<PersonInFile>> people_in(Database& db) {
  return db.all(kSelectSealedAccounts, [](Row row) { return PersonInFile{row.id<UserId>(0), row.text(7), text_of(account_seal(row))}; });
}

bool erased_number(const PersonInFile& person) { return person.number == "erased " + person.id.text(); }

struct NumberHolder {
  UserId id{};
  bool referred = false, same_student = false;
};

/// Of the account's number here, other than the account itself. Two students of one name and number are one person, whom both stations made.
std::optional<NumberHolder> holder_of_number(Merge& merge, const PersonInFile& person) {
  return merge.transaction.first(
      "SELECT p.id, p.id IN (SELECT id FROM main.referred WHERE here = 0), p.role = 'student' AND s.role = 'student', p.name, s.name "
      "FROM main.people p JOIN source.people s ON s.id = ?2 WHERE p.number = ?1 AND p.id <> ?2",
      [](Row row) { return NumberHolder{row.id<UserId>(0), row.flag(1), row.flag(2) && agreeing_name(row.text(3)) == agreeing_name(row.text(4))}; },
      person.number, person.id);
}

/// An account that is known by name alone, or that this station made for the same student, gives way to the office's.
void free_number(Merge& merge, const PersonInFile& person) {
  const auto holder = holder_of_number(merge, person);
  if (!holder) return;
  if (!holder->referred && !holder->same_student) return merge.refuse(StorageError::duplicate, person.number, "number");
  merge.transaction.run("UPDATE people SET number = number || ' ' || substr(hex(id), 25) WHERE id = ?1", holder->id);
  log_account(merge.context, merge.transaction, merge.actor.id, holder->referred ? "person_sealed" : "account_renamed", holder->id);
  if (!holder->referred) merge.out.gave_way.push_back(person.number);
}

void add_referred_person(Merge& merge, const PersonInFile& person) {
  merge.transaction.run(
      "INSERT INTO people SELECT id, iif(number IN (SELECT number FROM main.people), number || ' ' || substr(hex(id), 25), number), name, role, "
      "'', '', 1, guest, 0, 0, created_at FROM source.people WHERE id = ?1",
      person.id);
  log_account(merge.context, merge.transaction, merge.actor.id, "account_created", person.id);
  refer(merge, person.id.uuid);
}

void add_person(Merge& merge, const PersonInFile& person) {
  free_number(merge, person);
  merge.transaction.run("INSERT INTO people SELECT id, number, name, role, password, pin, disabled, guest, 0, 0, created_at FROM source.people WHERE id = ?1",
                        person.id);
  log_account(merge.context, merge.transaction, merge.actor.id, "account_created", person.id);
  ++merge.out.counts.accounts;
}

struct AccountEntry {
  std::string action, seal;
};

/// The newest entry about the account, and the newest that reading a file or making the account wrote.
std::optional<AccountEntry> newest_entry(Merge& merge, UserId person, const char* actions) {
  return merge.transaction.first(
      "SELECT action, detail FROM main.audit_log INDEXED BY audit_by_subject WHERE subject = ?1 AND instr(?2, ' ' || action || ' ') > 0 "
      "AND action <> 'session_sealed' ORDER BY number DESC LIMIT 1",
      [](Row row) { return AccountEntry{row.text(0), row.text(1)}; }, person, actions);
}

constexpr const char* kWhenRead = " account_created person_sealed ";
constexpr const char* kAnyTime =
    " account_created person_sealed account_renamed role_changed account_disabled account_enabled password_changed pin_changed ";

/// A seal leaves number and name out where the account has no secret: who renamed it shows in the log alone.
bool renamed_here(Merge& merge, UserId person) {
  const auto newest = newest_entry(merge, person, " account_created person_sealed account_renamed ");
  return newest && newest->action == "account_renamed";
}

bool other_name_in_file(Merge& merge, UserId person) {
  return merge.transaction
      .first("SELECT (m.number, m.name) <> (s.number, s.name) FROM main.people m JOIN source.people s ON s.id = m.id WHERE m.id = ?1",
             [](Row row) { return row.flag(0); }, person)
      .value_or(false);
}

/// Whether the office has changed the account since the last file.
bool changed_in_office(Merge& merge, const PersonInFile& person) {
  if (erased_number(person)) return true;
  const auto read = newest_entry(merge, person.id, kWhenRead);
  if (!read || read->seal != person.seal) return true;
  return other_name_in_file(merge, person.id) && !renamed_here(merge, person.id);
}

/// Whether another station than the file's has records of the account here.
bool known_from_elsewhere(Merge& merge, UserId person) {
  return merge.transaction
      .first("SELECT EXISTS (SELECT 1 FROM main.sessions WHERE student = ?1 AND station <> ?2) "
             "OR EXISTS (SELECT 1 FROM main.statements WHERE author = ?1 AND station <> ?2)",
             [](Row row) { return row.flag(0); }, person, merge.out.description.station)
      .value_or(true);
}

/// Whether the account, known here by reference alone, was erased where it was made. A results file speaks of its own station's alone.
bool erased_at_home(Merge& merge, const PersonInFile& person) {
  if (!erased_number(person) || !is_referred(merge.transaction, person.id.uuid) || is_erased(merge.transaction, person.id)) return false;
  return merge.out.description.kind == ExchangeKind::office || !known_from_elsewhere(merge, person.id);
}

/// Whether the file's account takes the place of the one here. Who is erased here stays so.
bool replaces(Merge& merge, const PersonInFile& person) {
  if (is_erased(merge.transaction, person.id)) return false;
  if (is_referred(merge.transaction, person.id.uuid)) return true;
  return !merge.late() && changed_in_office(merge, person);
}

/// Neither name nor secret, and nobody signs in with it, whatever else the file says of an erased account.
void write_erased(Merge& merge, const PersonInFile& person) {
  merge.transaction.run(
      "UPDATE people SET number = ?2, name = '–', password = '', pin = '', disabled = 1, wrong_tries = 0, locked_until = 0 WHERE id = ?1",
      person.id, person.number);
}

void write_account(Merge& merge, UserId person) {
  merge.transaction.run(
      "UPDATE people SET (number, name, role, password, pin, disabled, wrong_tries, locked_until) = "
      "(SELECT number, name, role, password, pin, disabled, 0, 0 FROM source.people s WHERE s.id = ?1) WHERE id = ?1",
      person);
}

void replace_person(Merge& merge, const PersonInFile& person) {
  const auto read = newest_entry(merge, person.id, kWhenRead), newest = newest_entry(merge, person.id, kAnyTime);
  const bool changed_here = read && newest && (newest->seal != read->seal || renamed_here(merge, person.id));
  if (changed_here && !is_referred(merge.transaction, person.id.uuid)) merge.out.conflicts.push_back(person.number);
  free_number(merge, person);
  erased_number(person) ? write_erased(merge, person) : write_account(merge, person.id);
  log_account(merge.context, merge.transaction, merge.actor.id, erased_number(person) ? "person_erased" : "person_sealed", person.id);
  if (erased_number(person)) {
    // Cohorts that this station made itself are in no file.
    leave_cohorts(merge.context, merge.transaction, merge.actor, person.id);
    erase_texts_about(merge.context, merge.transaction, merge.actor, person.id);
  }
  ++merge.out.counts.accounts;
  if (!merge.referred.contains(person.id.uuid)) arrive(merge, person.id.uuid);
}

/// What becomes of the accounts of a file.
struct PeoplePlan {
  std::vector<PersonInFile> referred{}, added{}, replaced{};
};

PeoplePlan plan_people(Merge& merge) {
  PeoplePlan plan;
  for (PersonInFile& person : merge.taken(people_in(merge.from.db))) {
    const auto here = merge.transaction.first("SELECT 1 FROM people WHERE id = ?1", [](Row) { return true; }, person.id);
    if (!merge.ok()) return {};
    if (merge.referred.contains(person.id.uuid)) {
      if (!here) {
        plan.referred.push_back(std::move(person));
      } else if (erased_at_home(merge, person)) {
        plan.replaced.push_back(std::move(person));
      }
    } else if (!here) {
      plan.added.push_back(std::move(person));
    } else if (replaces(merge, person)) {
      plan.replaced.push_back(std::move(person));
    }
  }
  return plan;
}

void merge_each(Merge& merge, const std::vector<PersonInFile>& people, void (*merge_one)(Merge&, const PersonInFile&)) {
  for (const PersonInFile& person : people) {
    if (!merge.goes_on()) return;
    merge_one(merge, person);
    merge.steps.add_done();
  }
}

/// Accounts of one file may exchange their numbers: each frees its own first.
void free_own_numbers(Merge& merge, const std::vector<PersonInFile>& people) {
  for (const PersonInFile& person : people) {
    merge.transaction.run("UPDATE people SET number = 'moving ' || hex(id) WHERE id = ?1 AND number <> ?2", person.id, person.number);
  }
}

}  // namespace

bool is_referred(Transaction& transaction, const Uuid& id) {
  return transaction.first("SELECT 1 FROM referred WHERE id = ?1 AND here = 0", [](Row) { return true; }, id).value_or(false);
}

void refer(Merge& merge, const Uuid& id) {
  merge.transaction.run("INSERT INTO referred (id, here) VALUES (?1, 0)", id);
  log_row(merge.context, merge.transaction, merge.actor.id, "referred", SealedTable::referred, id);
}

void arrive(Merge& merge, const Uuid& id) {
  if (!is_referred(merge.transaction, id)) return;
  merge.transaction.run("UPDATE referred SET here = 1 WHERE id = ?1", id);
  log_row(merge.context, merge.transaction, merge.actor.id, "arrived", SealedTable::referred, id);
}

bool is_erased(Transaction& transaction, UserId user) {
  return transaction.first("SELECT number = ?2 FROM people WHERE id = ?1", [](Row row) { return row.flag(0); }, user, "erased " + user.text()).value_or(false);
}

void merge_people(Merge& merge) {
  const PeoplePlan plan = plan_people(merge);
  // Those of a results file are few; its sessions count.
  if (merge.out.description.kind == ExchangeKind::office) merge.steps.begin(plan.replaced.size() + plan.added.size() + plan.referred.size());
  free_own_numbers(merge, plan.replaced);
  merge_each(merge, plan.replaced, replace_person);
  merge_each(merge, plan.added, add_person);
  merge_each(merge, plan.referred, add_referred_person);
  const auto left = merge.transaction.first("SELECT count(*) FROM people WHERE role = 'administrator' AND disabled = 0", [](Row row) { return row.integer(0); });
  if (left && *left == 0) merge.refuse(StorageError::last_administrator, "people");
}

void merge_members(Merge& merge) {
  if (merge.late()) return;
  struct Member {
    Uuid cohort;
    UserId student;
  };
  const auto member_of = [](Row row) { return Member{row.uuid(0), row.id<UserId>(1)}; };
  const auto log = [&](const Member& member, const char* action) {
    const std::string cohort = member.cohort.text();
    log_event(merge.context, merge.transaction, {.actor = merge.actor.id, .action = action, .subject = member.student.uuid, .detail = cohort});
  };
  if (!merge.ok()) return;
  const auto gone = merge.taken(merge.db().all(
      "SELECT m.cohort, m.student FROM main.cohort_students m WHERE m.cohort IN (SELECT id FROM source.cohorts) AND NOT EXISTS "
      "(SELECT 1 FROM source.cohort_students s WHERE s.cohort = m.cohort AND s.student = m.student)", member_of));
  const auto fresh = merge.taken(merge.db().all(
      "SELECT s.cohort, s.student FROM source.cohort_students s WHERE NOT EXISTS "
      "(SELECT 1 FROM main.cohort_students m WHERE m.cohort = s.cohort AND m.student = s.student)", member_of));
  for (const Member& member : gone) {
    merge.transaction.run("DELETE FROM main.cohort_students WHERE cohort = ?1 AND student = ?2", member.cohort, member.student);
    log(member, "cohort_left");
  }
  for (const Member& member : fresh) {
    if (is_erased(merge.transaction, member.student)) continue;
    merge.transaction.run("INSERT INTO main.cohort_students (cohort, student) VALUES (?1, ?2)", member.cohort, member.student);
    log(member, "cohort_joined");
  }
}

}  // namespace cusp::storage
