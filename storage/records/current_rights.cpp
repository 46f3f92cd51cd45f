#include "storage/records/current_rights.h"

#include <string>

namespace cusp::storage {
namespace {

struct RightsNow {
  std::optional<Role> role;
  bool disabled = false;
};

}  // namespace

void require_now(Transaction& transaction, UserId actor, Action action) {
  const auto now = transaction.first("SELECT role, disabled FROM people WHERE id = ?1", [](Row row) { return RightsNow{role_from_key(row.text(0)), row.flag(1)}; },
                                     actor);
  if (!now) return;
  if (now->disabled) return transaction.refuse({StorageError::disabled, "actor"});
  if (!now->role || !may(*now->role, action)) transaction.refuse({StorageError::not_allowed, std::string(key_of(action))});
}

}  // namespace cusp::storage
