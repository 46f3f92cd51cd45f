/// Cohorts: named groups of students.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "storage/records/context.h"
#include "storage/base/rights.h"

namespace cusp::storage {

inline constexpr std::size_t kMostCohortName = 200;  // characters

struct Cohort {
  CohortId id;
  std::string name;  // 1 to kMostCohortName characters
  int students = 0;
};

class Cohorts {
 public:
  explicit Cohorts(StorageContext& context) : c_{context} {}
  /// These need manage_cohorts.
  Stored<Cohort> create(const Actor& actor, const std::string& name);  // duplicate, bad_value
  Stored<void> add(const Actor& actor, CohortId cohort, UserId student);
  /// All or none. not_found (where = people) for one who was erased.
  Stored<void> add_all(const Actor& actor, CohortId cohort, std::span<const UserId> students);
  Stored<void> remove(const Actor& actor, CohortId cohort, UserId student);

  Stored<std::vector<Cohort>> list();  // by name
  /// Upper and lower case of ASCII are the same, as in `duplicate`. not_found (where = name).
  Stored<Cohort> find_name(const std::string& name);
  Stored<std::vector<UserId>> students(CohortId cohort);

 private:
  StorageContext& c_;
};

}  // namespace cusp::storage
