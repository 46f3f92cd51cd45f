#include "storage/exchange/merge.h"
#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/repositories/accounts.h"

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

/// An account that is known by name alone gives way to one that has the number.
void free_number(Merge& merge, const PersonInFile& person) {
  const auto holder = merge.transaction.first(
      "SELECT p.id FROM people p JOIN referred r ON r.id = p.id AND r.here = 0 WHERE p.number = ?1 AND p.id <> ?2",
      [](Row row) { return row.id<UserId>(0); }, person.number, person.id);
  if (!holder) {
    const auto taken = merge.transaction.first("SELECT 1 FROM people WHERE number = ?1 AND id <> ?2", [](Row) { return true; }, person.number, person.id);
    if (taken) merge.refuse(StorageError::duplicate, person.number, "number");
    return;
  }
  merge.transaction.run("UPDATE people SET number = number || ' ' || substr(hex(id), 25) WHERE id = ?1", *holder);
  log_account(merge.context, merge.transaction, merge.actor.id, "person_sealed", *holder);
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

/// The office's account takes the place of what is here. An account that the office has not changed since stays as it is here.
void update_person(Merge& merge, const PersonInFile& person) {
  constexpr const char* kRead = " account_created person_sealed ";
  constexpr const char* kAny = " account_created person_sealed account_renamed role_changed account_disabled account_enabled password_changed pin_changed ";
  const auto read = newest_entry(merge, person.id, kRead), newest = newest_entry(merge, person.id, kAny);
  const bool referred = is_referred(merge.transaction, person.id.uuid);
  if (!referred && read && read->seal == person.seal) return;
  if (!referred && read && newest && newest->seal != read->seal) merge.out.conflicts.push_back(person.number);
  free_number(merge, person);
  merge.transaction.run(
      "UPDATE people SET (number, name, role, password, pin, disabled, wrong_tries, locked_until) = "
      "(SELECT number, name, role, password, pin, disabled, 0, 0 FROM source.people s WHERE s.id = ?1) WHERE id = ?1",
      person.id);
  log_account(merge.context, merge.transaction, merge.actor.id, erased_number(person) ? "person_erased" : "person_sealed", person.id);
  if (erased_number(person)) erase_texts_about(merge.context, merge.transaction, merge.actor, person.id);
  ++merge.out.counts.accounts;
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
  for (const PersonInFile& person : merge.taken(people_in(merge.from.db))) {
    const auto here = merge.transaction.first("SELECT 1 FROM people WHERE id = ?1", [](Row) { return true; }, person.id);
    if (!merge.ok()) return;
    if (merge.referred.contains(person.id.uuid)) {
      if (!here) add_referred_person(merge, person);
      continue;
    }
    if (!here) {
      add_person(merge, person);
      continue;
    }
    const bool first_time = is_referred(merge.transaction, person.id.uuid);
    if (is_erased(merge.transaction, person.id) || (merge.late() && !first_time)) continue;
    update_person(merge, person);
    arrive(merge, person.id.uuid);
  }
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
