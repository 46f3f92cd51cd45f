#include "ui/admin/account_change.h"

#include <array>
#include <functional>

#include "storage/base/password.h"
#include "storage/base/text_length.h"

namespace cusp::ui {

Stored<void> write_change(Accounts& accounts, const Actor& actor, const AccountChange& change) {
  const bool student = change.role == Role::student;
  if (!change.before) {
    const auto made = accounts.create(actor, {change.number, change.name, change.role, student ? "" : change.secret, student ? change.secret : ""});
    return made ? Stored<void>() : std::unexpected(made.error());
  }
  const Account& before = *change.before;
  if (!change.secret.empty() && !(student ? storage::acceptable_pin(change.secret) : storage::acceptable_password(change.secret)))
    return fail(StorageError::weak_password, student ? "pin" : "password");
  if (!has_length(change.number, 0, kMostNumber)) return fail(StorageError::bad_value, "number");
  if (!has_length(change.name, 0, kMostName)) return fail(StorageError::bad_value, "name");
  if (change.number != before.number)
    if (const auto taken = accounts.find_number(change.number); taken && taken->id != before.id) return fail(StorageError::duplicate, change.number);
  using Step = std::function<Stored<void>()>;
  const Step secret = [&]() -> Stored<void> {
    if (change.secret.empty()) return {};
    if (!student) return accounts.set_password(actor, before.id, {}, change.secret);
    // Another desk may have made the student staff.
    const auto now = accounts.find(before.id);
    if (!now) return std::unexpected(now.error());
    if (now->role != Role::student) return fail(StorageError::bad_value, "pin");
    return accounts.set_pin(actor, before.id, change.secret);
  };
  const Step role = [&]() -> Stored<void> {
    if (change.role == before.role) return {};
    return accounts.set_role(actor, before.id, change.role);
  };
  const Step name = [&]() -> Stored<void> {
    if (change.name == before.name && change.number == before.number) return {};
    // Another desk may have changed the one that this form leaves.
    const auto now = accounts.find(before.id);
    if (!now) return std::unexpected(now.error());
    return accounts.rename(actor, before.id, change.number == before.number ? now->number : change.number,
                           change.name == before.name ? now->name : change.name);
  };
  // Staff need a password before the role. Only a student has a PIN.
  const bool joins_staff = !student && change.role != before.role;
  for (const Step& step : joins_staff ? std::array{secret, role, name} : std::array{role, name, secret})
    if (auto done = step(); !done) return done;
  return {};
}

}  // namespace cusp::ui
