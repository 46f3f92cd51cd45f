#include "storage/repositories/new_account.h"

#include <utility>

#include "storage/base/text_length.h"
#include "storage/records/sealing.h"

namespace cusp::storage {

Stored<void> check_new_account(const NewAccount& a) {
  if (!has_length(a.number, 1, kMostNumber)) return fail(StorageError::bad_value, "number");
  if (!has_length(a.name, 1, kMostName)) return fail(StorageError::bad_value, "name");
  if (!a.pin.empty() && a.role != Role::student) return fail(StorageError::bad_value, "pin");
  const bool password_optional = a.role == Role::student;
  if (!(a.password.empty() && password_optional) && !acceptable_password(a.password)) {
    return fail(StorageError::weak_password, "password");
  }
  if (!a.pin.empty() && !acceptable_pin(a.pin)) return fail(StorageError::weak_password, "pin");
  return {};
}

Stored<std::string> hashed_secret(std::string_view plain, const PasswordCost& cost) {
  if (plain.empty()) return std::string();
  std::string hashed = hash_password(plain, cost);
  if (hashed.empty()) return fail(StorageError::out_of_memory, "memory");
  return hashed;
}

Stored<HashedSecrets> hashed_secrets(const NewAccount& account, const PasswordCost& cost) {
  auto password = hashed_secret(account.password, cost);
  if (!password) return std::unexpected(password.error());
  auto pin = hashed_secret(account.pin, cost);
  if (!pin) return std::unexpected(pin.error());
  return HashedSecrets{std::move(*password), std::move(*pin)};
}

UserId insert_account(StorageContext& context, Transaction& transaction, UserId actor, const NewAccount& a, const HashedSecrets& secrets) {
  const UserId id = UserId::make();
  transaction.run(
      "INSERT INTO people (id, number, name, role, password, pin, guest, created_at) "
      "VALUES (?1, ?2, ?3, ?4, ?5, ?6, 0, ?7)",
      id, a.number, a.name, key_of(a.role), secrets.password, secrets.pin, context.clock());
  log_account(context, transaction, actor, "account_created", id);
  return id;
}

}  // namespace cusp::storage
