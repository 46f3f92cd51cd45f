/// Which role has which right. Repositories check it before they write, or read the records of others.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/base/ids.h"
#include "storage/base/error.h"

namespace cusp::storage {

enum class Role : std::uint8_t { student, instructor, administrator };

/// Stable keys, as stored.
constexpr std::string_view key_of(Role role) noexcept {
  constexpr std::array<std::string_view, 3> keys = {"student", "instructor", "administrator"};
  return keys[static_cast<std::size_t>(role)];
}
std::optional<Role> role_from_key(std::string_view key) noexcept;

enum class Action : std::uint8_t {
  drill,            // start a session
  see_own_results,  // own history, reports and replays
  see_all_results,  // every user's history, reports and replays
  export_results,   // performance history as a file
  comment,          // write a comment on a session
  grade_again,      // grade a session manually or with another rubric
  edit_scenarios,   // drafts, try-outs, publishing versions
  assign,           // assignments: version, cohort, dates
  manage_cohorts,   // make cohorts, add and remove students
  manage_accounts,  // create, disable, change role, number, name, password
  see_audit_log,
  manage_station,  // backup, retention, keys
};
inline constexpr std::size_t kActions = 12;

/// The table of storage/README.md: columns in the order of Action, rows student, instructor, administrator.
constexpr bool may(Role role, Action action) noexcept {
  constexpr std::array<std::array<bool, kActions>, 3> table = {{
      {true, true, false, false, false, false, false, false, false, false, false, false},  // student
      {true, true, true, true, true, true, true, true, true, false, false, false},         // instructor
      {true, true, true, true, false, false, false, false, true, true, true, true},        // administrator
  }};
  return table[static_cast<std::size_t>(role)][static_cast<std::size_t>(action)];
}
/// Stable keys, in failures and in storage/README.md.
std::string_view key_of(Action action) noexcept;

/// The signed-in account that acts.
struct Actor {
  UserId id;
  Role role = Role::student;
};

/// not_allowed (where = the action's key) if the actor's role lacks the right.
Stored<void> require(const Actor& actor, Action action);
/// For records of `owner`: needs see_own_results if the actor is the owner, else see_all_results.
Stored<void> require_reading(const Actor& actor, UserId owner);

}  // namespace cusp::storage
