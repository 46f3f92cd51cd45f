#include "storage/repositories/accounts.h"

#include <algorithm>
#include <utility>

#include "storage/base/text_length.h"
#include "storage/records/audit_writer.h"
#include "storage/records/sealing.h"
#include "storage/records/current_rights.h"
#include "storage/repositories/erasure.h"
#include "storage/repositories/new_account.h"
#include "storage/repositories/sign_in_lock.h"

namespace cusp::storage {
namespace {

constexpr const char* kAccountColumns =
    "SELECT id, number, name, role, disabled, guest, password <> '', pin <> '', created_at FROM people ";

/// Of a row that is an account: a guest's and an erased person's stand for their attempts alone. Nobody else's number is of this form:
/// an account that no list shows and nobody can switch off would still sign in.
const std::string kIsAccount = "guest = 0 AND number <> " + std::string(kErasedNumber);

Account account_of(Row row) {
  Account a;
  a.id = row.id<UserId>(0);
  a.number = row.text(1);
  a.name = row.text(2);
  a.role = role_from_key(row.text(3)).value_or(Role::student);
  a.disabled = row.flag(4);
  a.guest = row.flag(5);
  a.has_password = row.flag(6);
  a.has_pin = row.flag(7);
  a.created_utc_us = row.integer(8);
  return a;
}

/// What of the account may have changed while a secret was compared.
struct Standing {
  std::int64_t locked_until = 0;
  bool disabled = false, same_secrets = false;
};

std::optional<Account> insert(StorageContext& c, Transaction& transaction, UserId actor, const NewAccount& a, const HashedSecrets& secrets) {
  const UserId id = insert_account(c, transaction, actor, a, secrets);
  return transaction.first(std::string(kAccountColumns) + "WHERE id = ?1", account_of, id);
}

Stored<Account> committed(StorageContext& c, Transaction& transaction, std::optional<Account> account) {
  if (auto done = commit_sealed(c, transaction); !done) return std::unexpected(done.error());
  return *account;
}

/// Refuses to disable or demote the last enabled administrator.
void keep_an_administrator(Transaction& transaction) {
  const auto left = transaction.first("SELECT count(*) FROM people WHERE role = 'administrator' AND disabled = 0",
                                      [](Row row) { return row.integer(0); });
  if (left && *left == 0) transaction.refuse({StorageError::last_administrator, "people"});
}

/// A duplicate number names itself as the place of the failure, not the file.
template <class T>
Stored<T> naming_number(Stored<T> done, const std::string& number) {
  if (!done && done.error().code == StorageError::duplicate) done.error().where = number;
  return done;
}

/// The kind of secret that this account signs in with, if `given` is of the other kind; else nullptr.
const char* other_secret(const Account& a, std::string_view given, SecretKind kind) noexcept {
  if (!a.has_pin && !a.has_password) return nullptr;
  if (kind == SecretKind::pin) return !a.has_pin ? "password" : nullptr;
  if (!a.has_password) return "pin";
  return acceptable_pin(given) ? "password" : nullptr;
}

/// What stands against a try of which `compared` was the record: another process has locked the account, or changed the password.
/// Within a transaction.
std::optional<StorageFailure> barred_since(Transaction& transaction, UserId user, const std::string& compared, std::int64_t now) {
  const auto own = transaction.first("SELECT locked_until, password = ?2 FROM people WHERE id = ?1",
                                     [](Row row) { return std::pair{row.integer(0), row.flag(1)}; }, user, compared);
  if (!own) return std::nullopt;
  if (lock_holds(own->first, now)) return locked_failure(own->first);
  if (!own->second) return StorageFailure{StorageError::wrong_password, "password"};
  return std::nullopt;
}

/// The record that `old` matches. A wrong one counts as at sign-in: whoever finds a signed-in desk guesses no longer there. An empty one
/// is no try.
Stored<std::string> check_old_password(StorageContext& c, UserId user, std::string_view old) {
  struct Own {
    std::string password;
    std::int64_t locked_until = 0;
  };
  const auto own = c.db.first("SELECT password, locked_until FROM people WHERE id = ?1",
                              [](Row row) { return Own{row.text(0), row.integer(1)}; }, user);
  if (!own) return std::unexpected(own.error());
  if (!*own) return fail(StorageError::not_found, "people");
  const std::string& password = (*own)->password;
  if (password.empty() && old.empty()) return password;
  const std::int64_t asked_at = c.clock(), until = locked_until(c, user, (*own)->locked_until, asked_at);
  if (lock_holds(until, asked_at)) return std::unexpected(locked_failure(until));
  if (password_matches(password, old)) return password;
  if (!old.empty() && c.db.read_only()) count_unwritten_try(c, user, c.clock());
  if (!old.empty() && !c.db.read_only()) {
    Transaction transaction(c.db);
    const std::int64_t now = c.clock();
    if (auto barred = barred_since(transaction, user, password, now)) return std::unexpected(std::move(*barred));
    count_wrong_try(c, transaction, user, now);
    if (auto done = commit_sealed(c, transaction); !done) return std::unexpected(done.error());
  }
  return fail(StorageError::wrong_password, "password");
}

/// Refuses if the UPDATE before it changed no row.
void require_one_change(StorageContext& c, Transaction& transaction) {
  if (transaction.ok() && c.db.changes() != 1) transaction.refuse({StorageError::not_found, "people"});
}

}  // namespace

Stored<bool> Accounts::has_administrator() {
  const auto count = c_.db.first("SELECT count(*) FROM people WHERE role = 'administrator' AND disabled = 0",
                                 [](Row row) { return row.integer(0); });
  if (!count) return std::unexpected(count.error());
  return count->value_or(0) > 0;
}

Stored<Account> Accounts::create_first_administrator(const NewAccount& account) {
  NewAccount wanted = account;
  wanted.role = Role::administrator;
  if (auto good = check_new_account(wanted); !good) return std::unexpected(good.error());
  const auto secrets = hashed_secrets(wanted, c_.cost);
  if (!secrets) return std::unexpected(secrets.error());
  Transaction transaction(c_.db);
  const auto there = has_administrator();
  if (!there) transaction.refuse(there.error());
  if (there && *there) transaction.refuse({StorageError::not_allowed, std::string(key_of(Action::manage_accounts))});
  auto made = transaction.ok() ? insert(c_, transaction, UserId{}, wanted, *secrets) : std::nullopt;
  return naming_number(committed(c_, transaction, std::move(made)), account.number);
}

Stored<Account> Accounts::demo_student() {
  if (auto there = find_number("demo"); there || there.error().code != StorageError::not_found) return there;
  Transaction transaction(c_.db);
  // Another process may have made it since.
  auto demo = transaction.first(std::string(kAccountColumns) + "WHERE number = 'demo'", account_of);
  if (!demo) {
    const auto others =
        transaction.first("SELECT count(*) FROM people WHERE guest = 0", [](Row row) { return row.integer(0); });
    if (others.value_or(0) > 0) transaction.refuse({StorageError::not_allowed, "demo"});
    if (transaction.ok()) demo = insert(c_, transaction, UserId{}, {.number = "demo", .name = "demo"}, {});
  }
  return committed(c_, transaction, std::move(demo));
}

Stored<Account> Accounts::create(const Actor& actor, const NewAccount& account) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return std::unexpected(allowed.error());
  if (auto good = check_new_account(account); !good) return std::unexpected(good.error());
  const auto secrets = hashed_secrets(account, c_.cost);
  if (!secrets) return std::unexpected(secrets.error());
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_accounts);
  auto made = insert(c_, transaction, actor.id, account, *secrets);
  return naming_number(committed(c_, transaction, std::move(made)), account.number);
}

Stored<void> Accounts::rename(const Actor& actor, UserId user, const std::string& number, const std::string& name) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return allowed;
  if (!has_length(number, 1, kMostNumber)) return fail(StorageError::bad_value, "number");
  if (!has_length(name, 1, kMostName)) return fail(StorageError::bad_value, "name");
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_accounts);
  transaction.run("UPDATE people SET number = ?2, name = ?3 WHERE id = ?1 AND " + kIsAccount, user, number, name);
  require_one_change(c_, transaction);
  const auto account = transaction.first("SELECT 1 FROM people WHERE id = ?1 AND " + kIsAccount, [](Row) { return true; }, user);
  if (!account) transaction.refuse({StorageError::duplicate, number});
  log_account(c_, transaction, actor.id, "account_renamed", user);
  return naming_number(commit_sealed(c_, transaction), number);
}

Stored<void> Accounts::set_role(const Actor& actor, UserId user, Role role) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return allowed;
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_accounts);
  const auto has_password = transaction.first(
      "SELECT password <> '' FROM people WHERE id = ?1 AND " + kIsAccount, [](Row row) { return row.flag(0); }, user);
  if (!has_password) transaction.refuse({StorageError::not_found, "people"});
  if (role != Role::student && has_password && !*has_password) {
    transaction.refuse({StorageError::weak_password, "password"});  // staff need one
  }
  transaction.run("UPDATE people SET role = ?2, pin = iif(?2 = 'student', pin, '') WHERE id = ?1", user, key_of(role));
  keep_an_administrator(transaction);
  log_account(c_, transaction, actor.id, "role_changed", user);
  return commit_sealed(c_, transaction);
}

Stored<void> Accounts::disable(const Actor& actor, UserId user) { return set_status(actor, user, Status::disabled); }
Stored<void> Accounts::enable(const Actor& actor, UserId user) { return set_status(actor, user, Status::enabled); }

Stored<void> Accounts::set_status(const Actor& actor, UserId user, Status status) {
  const bool disabled = status == Status::disabled;
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return allowed;
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_accounts);
  transaction.run("UPDATE people SET disabled = ?2 WHERE id = ?1 AND " + kIsAccount, user, disabled);
  require_one_change(c_, transaction);
  keep_an_administrator(transaction);
  log_account(c_, transaction, actor.id, disabled ? "account_disabled" : "account_enabled", user);
  return commit_sealed(c_, transaction);
}

std::string erased_number(UserId user) { return "erased " + user.text(); }

Stored<void> Accounts::erase(const Actor& actor, UserId user) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return allowed;
  if (actor.id == user) return fail(StorageError::not_allowed, "own_account");
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_accounts);
  const auto running = transaction.first(
      "SELECT count(*) FROM session_summaries INDEXED BY running_summaries WHERE state = 'running' AND student = ?1",
      [](Row row) { return row.integer(0); }, user);
  if (running.value_or(0) > 0) transaction.refuse({StorageError::wrong_state, "running", user.text()});
  transaction.run(
      "UPDATE people SET number = ?2, name = '–', password = '', pin = '', disabled = 1, wrong_tries = 0, locked_until = 0 "
      "WHERE id = ?1 AND guest = 0",
      user, erased_number(user));
  require_one_change(c_, transaction);
  keep_an_administrator(transaction);
  log_account(c_, transaction, actor.id, "person_erased", user);
  leave_cohorts(c_, transaction, actor, user);
  erase_texts_about(c_, transaction, actor, user);
  if (auto done = commit_sealed(c_, transaction); !done) return done;
  // The log holds the old pages until then. Another connection may hold it open: the next checkpoint takes it.
  static_cast<void>(c_.db.run("PRAGMA wal_checkpoint(TRUNCATE)"));
  return {};
}

Stored<void> Accounts::set_password(const Actor& actor, UserId user, std::string_view old, std::string_view fresh) {
  if (!acceptable_password(fresh)) return fail(StorageError::weak_password, "password");
  if (actor.id != user) {
    if (auto allowed = require(actor, Action::manage_accounts); !allowed) return allowed;
  }
  const auto there = c_.db.first("SELECT 1 FROM people WHERE id = ?1 AND " + kIsAccount, [](Row) { return true; }, user);
  if (!there) return std::unexpected(there.error());
  if (!*there) return fail(StorageError::not_found, "people");
  std::optional<std::string> compared;
  if (actor.id == user) {
    auto good = check_old_password(c_, user, old);
    if (!good) return std::unexpected(good.error());
    compared = std::move(*good);
  }
  const auto hashed = hashed_secret(fresh, c_.cost);
  if (!hashed) return std::unexpected(hashed.error());
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, actor.id == user ? Action::drill : Action::manage_accounts);
  if (compared) {
    if (auto barred = barred_since(transaction, user, *compared, c_.clock())) return std::unexpected(std::move(*barred));
  }
  transaction.run("UPDATE people SET password = ?2, wrong_tries = 0, locked_until = 0 WHERE id = ?1 AND " + kIsAccount, user,
                  *hashed);
  require_one_change(c_, transaction);
  log_account(c_, transaction, actor.id, "password_changed", user);
  return commit_sealed(c_, transaction);
}

Stored<void> Accounts::set_pin(const Actor& actor, UserId user, std::string_view pin) {
  if (auto allowed = require(actor, Action::manage_accounts); !allowed) return allowed;
  if (!pin.empty() && !acceptable_pin(pin)) return fail(StorageError::weak_password, "pin");
  const auto hashed = hashed_secret(pin, c_.cost);
  if (!hashed) return std::unexpected(hashed.error());
  Transaction transaction(c_.db);
  require_now(transaction, actor.id, Action::manage_accounts);
  transaction.run(
      "UPDATE people SET pin = ?2, wrong_tries = 0, locked_until = 0 WHERE id = ?1 AND role = 'student' AND " + kIsAccount,
      user, *hashed);
  require_one_change(c_, transaction);
  log_account(c_, transaction, actor.id, "pin_changed", user);
  return commit_sealed(c_, transaction);
}

Stored<Account> Accounts::sign_in(std::string_view number, std::string_view password) {
  return sign_in_by(number, password, SecretKind::password);
}
Stored<Account> Accounts::sign_in_with_pin(std::string_view number, std::string_view pin) {
  return sign_in_by(number, pin, SecretKind::pin);
}

Stored<Account> Accounts::sign_in_by(std::string_view number, std::string_view given, SecretKind kind) {
  // Checked before the number is looked up: the answer does not depend on which accounts exist.
  if (kind == SecretKind::pin && !acceptable_pin(given)) return fail(StorageError::other_secret, std::string(number), "pin");
  struct Secrets {
    Account account;
    std::string password, pin;
    std::int64_t locked_until = 0;
  };
  const auto found = c_.db.first(
      "SELECT id, number, name, role, disabled, guest, password <> '', pin <> '', created_at, password, pin, "
      "locked_until FROM people WHERE number = ?1 AND guest = 0",
      [](Row row) {
        return Secrets{account_of(row), row.text(9), row.text(10), row.integer(11)};
      },
      number);
  if (!found) return std::unexpected(found.error());
  const std::int64_t now = c_.clock();
  if (!*found) {
    // As slow as a wrong password: the time does not reveal whether the number exists.
    static_cast<void>(hash_password(given, c_.cost));
    return fail(StorageError::wrong_password, "sign_in");
  }
  const Secrets& s = **found;
  if (const char* other = other_secret(s.account, given, kind)) {
    return fail(StorageError::other_secret, s.account.number, other);
  }
  const std::int64_t until = locked_until(c_, s.account.id, s.locked_until, now);
  if (lock_holds(until, now)) return std::unexpected(locked_failure(until));
  const bool open = s.password.empty() && s.pin.empty() && s.account.role == Role::student;
  const bool right = open ? given.empty() : password_matches(kind == SecretKind::pin ? s.pin : s.password, given);
  if (right && s.account.disabled) return fail(StorageError::disabled, "sign_in");
  if (c_.db.read_only()) {
    if (right) {
      c_.tries->forget(s.account.id);
      return s.account;
    }
    count_unwritten_try(c_, s.account.id, now);
    return fail(StorageError::wrong_password, "sign_in");
  }
  Transaction transaction(c_.db);
  // Comparing takes a tenth of a second, in which other processes try too: their lock holds for this try, be it right or wrong. By the
  // clock from before, a lock of the longest time would seem to be of a clock that was set back.
  const std::int64_t compared_at = c_.clock();
  const auto standing = transaction.first(
      "SELECT locked_until, disabled, password = ?2 AND pin = ?3 FROM people WHERE id = ?1",
      [](Row row) { return Standing{row.integer(0), row.flag(1), row.flag(2)}; }, s.account.id, s.password, s.pin);
  if (standing && lock_holds(standing->locked_until, compared_at)) return std::unexpected(locked_failure(standing->locked_until));
  if (right && standing && standing->disabled) return fail(StorageError::disabled, "sign_in");
  if (right && (!standing || standing->same_secrets)) {
    transaction.run("UPDATE people SET wrong_tries = 0, locked_until = 0 WHERE id = ?1", s.account.id);
    log_event(c_, transaction, {.actor = s.account.id, .action = "signed_in", .subject = s.account.id.uuid});
    // Another process may have changed the role, too.
    const auto as_it_stands = transaction.first(std::string(kAccountColumns) + "WHERE id = ?1", account_of, s.account.id);
    return committed(c_, transaction, as_it_stands.value_or(s.account));
  }
  count_wrong_try(c_, transaction, s.account.id, compared_at);
  if (auto done = commit_sealed(c_, transaction); !done) return std::unexpected(done.error());
  return fail(StorageError::wrong_password, "sign_in");
}

Stored<Account> Accounts::find(UserId user) {
  const auto found = c_.db.first(std::string(kAccountColumns) + "WHERE id = ?1", account_of, user);
  if (!found) return std::unexpected(found.error());
  if (!*found) return fail(StorageError::not_found, "people", user.text());
  return **found;
}

Stored<Account> Accounts::find_number(std::string_view number) {
  const auto found = c_.db.first(std::string(kAccountColumns) + "WHERE number = ?1 AND guest = 0", account_of, number);
  if (!found) return std::unexpected(found.error());
  if (!*found) return fail(StorageError::not_found, "people", std::string(number));
  return **found;
}

Stored<std::vector<Account>> Accounts::list(const Actor& actor) {
  if (!may(actor.role, Action::manage_accounts) && !may(actor.role, Action::manage_cohorts)) {
    if (auto allowed = require(actor, Action::see_all_results); !allowed) return std::unexpected(allowed.error());
  }
  return c_.db.all(kAccountColumns + ("WHERE " + kIsAccount) + " ORDER BY name, number", account_of);
}

}  // namespace cusp::storage
