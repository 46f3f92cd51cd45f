/// What the form says of an account, written to the records.
#pragma once

#include <optional>
#include <string>

#include "storage/store.h"
#include "ui/modules.h"

namespace cusp::ui {

struct AccountChange {
  std::optional<Account> before;  // none: a new account
  std::string number, name;
  Role role = Role::student;
  std::string secret;  // PIN or password, by the role; empty: the account keeps the one there is
};

/// Writes what differs. argon2id takes longer than a frame, so not on the window's thread.
Stored<void> write_change(Accounts& accounts, const Actor& actor, const AccountChange& change);

}  // namespace cusp::ui
