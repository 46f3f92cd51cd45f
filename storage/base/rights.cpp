#include "storage/base/rights.h"

#include <string>

namespace cusp::storage {

std::optional<Role> role_from_key(std::string_view key) noexcept {
  for (const Role role : {Role::student, Role::instructor, Role::administrator}) {
    if (key_of(role) == key) return role;
  }
  return std::nullopt;
}

std::string_view key_of(Action action) noexcept {
  constexpr std::array<std::string_view, kActions> keys = {
      "drill",          "see_own_results", "see_all_results", "export_results", "comment",       "grade_again",
      "edit_scenarios", "assign",          "manage_cohorts",  "manage_accounts",  "see_audit_log", "manage_station"};
  return keys[static_cast<std::size_t>(action)];
}

Stored<void> require(const Actor& actor, Action action) {
  if (may(actor.role, action)) return {};
  return fail(StorageError::not_allowed, std::string(key_of(action)));
}

Stored<void> require_reading(const Actor& actor, UserId owner) {
  return require(actor, actor.id == owner ? Action::see_own_results : Action::see_all_results);
}

}  // namespace cusp::storage
