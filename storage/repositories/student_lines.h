/// Students of a school's list: the accounts and cohorts of all its lines, or of none. A program that is killed meanwhile leaves no account
/// whose PIN nobody has. Thread: the context's.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "storage/base/watch.h"
#include "storage/repositories/accounts.h"

namespace cusp::storage {

struct StudentLine {
  NewAccount account{};
  std::string cohort{};      // that the student joins, found whatever the case of its name, or made; empty: none
  bool has_account = false;  // found by its number: it joins the cohort alone
};

struct StudentLinesEnd {
  std::optional<StorageFailure> failure{};  // nothing was changed
  std::size_t line = 0;                     // that `failure` concerns, from 0; as many as there are: no single one
};

/// Needs manage_accounts and manage_cohorts. duplicate (where = number), bad_value, weak_password; not_found (where = people) for an account
/// that is gone; stopped. `watch`: lines whose secrets are hashed, before anything is written.
StudentLinesEnd add_students(StorageContext& context, const Actor& actor, std::span<const StudentLine> lines, const WorkWatch& watch = {});

}  // namespace cusp::storage
