/// Rows of new accounts, one or many in a transaction. Within storage only.
#pragma once

#include <string>
#include <string_view>

#include "storage/repositories/accounts.h"

namespace cusp::storage {

/// bad_value or weak_password, where = the field.
Stored<void> check_new_account(const NewAccount& account);

/// Empty stays empty. Takes a tenth of a second: a transaction comes later, for others wait for its end. out_of_memory (where = memory) if
/// argon2id cannot get the memory that the cost asks for.
Stored<std::string> hashed_secret(std::string_view plain, const PasswordCost& cost);

struct HashedSecrets {
  std::string password{}, pin{};
};
Stored<HashedSecrets> hashed_secrets(const NewAccount& account, const PasswordCost& cost);

/// Within a transaction: the row, and the entry "account_created".
UserId insert_account(StorageContext& context, Transaction& transaction, UserId actor, const NewAccount& account, const HashedSecrets& secrets);

}  // namespace cusp::storage
