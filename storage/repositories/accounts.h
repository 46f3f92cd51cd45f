/// Accounts of users, in the table `people`. Only that table holds names; every other table names a user by id.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/records/context.h"
#include "storage/base/rights.h"

namespace cusp::storage {

struct Account {
  UserId id{};
  std::string number{};  // student or staff number, typed at sign-in; unique without regard to case
  std::string name{};
  Role role = Role::student;
  bool disabled = false;
  bool guest = false;  // of an older program: not in lists, histories or figures
  bool has_password = false;
  bool has_pin = false;
  std::int64_t created_utc_us = 0;
  Actor actor() const noexcept { return {id, role}; }
};

/// The number that an erased account has in place of its own: nobody outside knows it.
std::string erased_number(UserId user);
/// SQL: the same of a row of `people`.
inline constexpr std::string_view kErasedNumber =
    "('erased ' || lower(substr(hex(id), 1, 8) || '-' || substr(hex(id), 9, 4) || '-' || substr(hex(id), 13, 4) || '-' || "
    "substr(hex(id), 17, 4) || '-' || substr(hex(id), 21)))";

inline constexpr std::size_t kMostNumber = 64, kMostName = 200;  // characters

struct NewAccount {
  std::string number{};  // 1 to kMostNumber characters
  std::string name{};    // 1 to kMostName characters
  Role role = Role::student;
  std::string password{};  // optional for students
  std::string pin{};       // students only: six digits, or empty
};

enum class SecretKind : std::uint8_t { password, pin };

class Accounts {
 public:
  explicit Accounts(StorageContext& context) : c_{context} {}

  /// False on the first start.
  Stored<bool> has_administrator();
  /// Needs no right. not_allowed if an administrator exists.
  Stored<Account> create_first_administrator(const NewAccount& account);
  /// The student "demo", without password, for `play` in a database without accounts. Made at first use.
  /// not_allowed if the database has other accounts and no "demo".
  Stored<Account> demo_student();

  /// These need manage_accounts. duplicate (where = number), weak_password, bad_value, last_administrator.
  Stored<Account> create(const Actor& actor, const NewAccount& account);
  Stored<void> rename(const Actor& actor, UserId user, const std::string& number, const std::string& name);
  Stored<void> set_role(const Actor& actor, UserId user, Role role);
  Stored<void> disable(const Actor& actor, UserId user);
  Stored<void> enable(const Actor& actor, UserId user);
  /// For good: name, number, password and PIN, cohorts, and the texts of comments and reasons about the user's sessions. The
  /// records stay under a pseudonym, and verify: with them what the chain and the seals cover, as extra time, large text and the file's name
  /// of a script that drilled an attempt. Without it nobody could explain a result. not_allowed (where = own_account); wrong_state (where = running) while a
  /// session runs. Backups from before still hold the name.
  Stored<void> erase(const Actor& actor, UserId user);
  /// The actor's own, with the old password; or another user's, with manage_accounts (`old` is then ignored). A wrong old one counts
  /// as a wrong try of sign_in().
  Stored<void> set_password(const Actor& actor, UserId user, std::string_view old, std::string_view fresh);
  /// Needs manage_accounts. Students only; empty removes the PIN.
  Stored<void> set_pin(const Actor& actor, UserId user, std::string_view pin);

  /// wrong_password, disabled, or locked: five wrong tries lock for 30 s, each further one doubles, up to 15 min. Where the records are
  /// read-only they are counted in memory (base/unwritten_tries.h).
  /// other_secret, not counted as a wrong try: a PIN that is not six digits, a kind of secret that the account does not
  /// have, or six digits as a password, which is never as short.
  /// A student without password and PIN signs in with an empty one. Guests cannot sign in.
  Stored<Account> sign_in(std::string_view number, std::string_view password);
  Stored<Account> sign_in_with_pin(std::string_view number, std::string_view pin);

  Stored<Account> find(UserId user);                     // not_found
  Stored<Account> find_number(std::string_view number);  // not_found
  /// By name, without guests and erased ones. Needs manage_accounts, manage_cohorts or see_all_results.
  Stored<std::vector<Account>> list(const Actor& actor);

 private:
  enum class Status : bool { enabled, disabled };
  Stored<void> set_status(const Actor& actor, UserId user, Status status);
  Stored<Account> sign_in_by(std::string_view number, std::string_view given, SecretKind kind);
  StorageContext& c_;
};

}  // namespace cusp::storage
