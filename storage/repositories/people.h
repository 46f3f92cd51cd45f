/// Accounts. Only this table knows names; everything else names a person by id.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/context.h"
#include "storage/rights.h"

namespace cusp::storage {

struct Account {
  UserId id{};
  std::string number{};  // student or staff number: what is typed at sign-in; unique, upper and lower case alike
  std::string name{};
  Role role = Role::student;
  bool disabled = false;
  bool guest = false;  // "Try it": never in lists, histories or figures
  bool has_password = false;
  bool has_pin = false;
  std::int64_t created_utc_us = 0;
  Actor actor() const noexcept { return {id, role}; }
};

struct NewAccount {
  std::string number{};  // 1 to 64 bytes
  std::string name{};    // 1 to 200 bytes
  Role role = Role::student;
  std::string password{};  // students may do without; staff may not
  std::string pin{};       // students only: six digits, or empty
};

class People {
 public:
  explicit People(StorageContext& context) : c_{context} {}

  /// False on the first start: then the desktop asks for one.
  Stored<bool> has_administrator();
  /// Without anybody's leave, once: not_allowed when there is an administrator already.
  Stored<Account> create_first_administrator(const NewAccount& account);
  /// The student "demo", without password, for `play` in a database without accounts; the one there is, if there is
  /// one. not_allowed when the database has other accounts and no "demo".
  Stored<Account> demo_student();
  /// The account behind "Try it"; made at first use.
  Stored<Account> guest();

  /// Needs manage_people. duplicate (where = number), weak_password, bad_value.
  Stored<Account> create(const Actor& actor, const NewAccount& account);
  Stored<void> rename(const Actor& actor, UserId user, const std::string& number, const std::string& name);
  Stored<void> set_role(const Actor& actor, UserId user, Role role);
  Stored<void> set_disabled(const Actor& actor, UserId user, bool disabled);
  /// One's own with the old one given, or somebody's with manage_people (then `old` is not asked).
  Stored<void> set_password(const Actor& actor, UserId user, std::string_view old, std::string_view fresh);
  /// Needs manage_people; empty takes the PIN away. Students only.
  Stored<void> set_pin(const Actor& actor, UserId user, std::string_view pin);

  /// wrong_password, disabled, or locked: five wrong tries lock for 30 s, each further one doubles, up to 15 min.
  /// other_secret, which is no wrong try: a PIN that is not six digits, a secret of a kind that the account does not
  /// have, or six digits where the account's password is asked for, which is never as short.
  /// A student without password and PIN signs in with an empty one. Guests cannot sign in.
  Stored<Account> sign_in(std::string_view number, std::string_view password);
  Stored<Account> sign_in_with_pin(std::string_view number, std::string_view pin);

  Stored<Account> find(UserId user);                     // not_found
  Stored<Account> find_number(std::string_view number);  // not_found
  /// By name; guests left out. Needs manage_people, manage_cohorts or see_all_results.
  Stored<std::vector<Account>> list(const Actor& actor);

 private:
  Stored<Account> sign_in_by(std::string_view number, std::string_view given, bool by_pin);
  StorageContext& c_;
};

}  // namespace cusp::storage
