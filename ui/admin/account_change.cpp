#include "ui/admin/account_change.h"

namespace cusp::ui {

Stored<void> write_change(Accounts& accounts, const Actor& actor, const AccountChange& change) {
  const bool student = change.role == Role::student;
  if (!change.before) {
    const auto made = accounts.create(actor, {change.number, change.name, change.role, student ? "" : change.secret, student ? change.secret : ""});
    return made ? Stored<void>() : std::unexpected(made.error());
  }
  const Account& before = *change.before;
  // The secret comes before the role: staff without a password cannot sign in.
  if (!change.secret.empty()) {
    const auto done = student ? accounts.set_pin(actor, before.id, change.secret) : accounts.set_password(actor, before.id, {}, change.secret);
    if (!done) return done;
  }
  if (change.role != before.role)
    if (const auto done = accounts.set_role(actor, before.id, change.role); !done) return done;
  if (change.name == before.name && change.number == before.number) return {};
  return accounts.rename(actor, before.id, change.number, change.name);
}

}  // namespace cusp::ui
