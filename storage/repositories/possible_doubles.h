/// Accounts that two stations may have made for one person. If the number of an account that comes in a file is taken here, the number
/// gets the end of the account's id (exchange/merge_people.cpp): an account of the number itself is the possible double. So is a student
/// of the same name, without regard to case, whose account this station knows by reference alone: the other one typed another number. Two
/// accounts that arrived whole or were made here are two people, for whoever made them saw both. Nothing is merged, for attempts are chained
/// to their account; who renames either account states that these are two people.
/// Thread: the context's.
#pragma once

#include <vector>

#include "storage/repositories/accounts.h"

namespace cusp::storage {

struct PossibleDouble {
  Account account;              // has the number, or the name
  Account other;                // has the number with the end of its id, or is known by reference alone
  std::vector<Uuid> stations{};  // where `other` has attempts; none of them may have come yet
};

/// By the name of `account`. Needs manage_accounts.
Stored<std::vector<PossibleDouble>> possible_doubles(StorageContext& context, const Actor& actor);

}  // namespace cusp::storage
