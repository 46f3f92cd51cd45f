/// Accounts that may be of one person. Nothing is merged, for attempts are chained to their account; who renames either account states that
/// these are two people. Named are
/// - an account whose number was taken when it came in a file, or that gave it to one of a file, so that it has the end of its id
///   (exchange/merge_people.cpp), and the account that has the number;
/// - a student of the same name as one whom this station knows by reference alone: the other station typed another number;
/// - two students of one name whose accounts were made here or arrived whole, if no third has the name, both are switched on, and no cohort
///   holds both: a list of a year names nobody twice.
/// Thread: the context's.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "storage/repositories/accounts.h"

namespace cusp::storage {

struct PossibleDouble {
  Account account;              // has the number, or the name
  Account other;                // has the number with the end of its id, or is known by reference alone, or has the name, too
  std::vector<Uuid> stations{};  // where `other` has attempts; none of them may have come yet
  bool by_name_alone = false;    // both accounts were made here or arrived whole
};

/// By the name of `account`. Needs manage_accounts.
Stored<std::vector<PossibleDouble>> possible_doubles(StorageContext& context, const Actor& actor);

/// What names that agree have in common: case, blanks, and "Brandt, Lena" for "Lena Brandt" make no difference.
std::string agreeing_name(std::string_view name);

}  // namespace cusp::storage
