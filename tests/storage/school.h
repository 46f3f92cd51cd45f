/// Months of a school in a few rows, for tests that tamper with it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/storage/sample.h"

namespace cusp::test {

/// Database, key and counter; no log. Replaces what is at `to`.
void copy_school(const std::filesystem::path& from, const std::filesystem::path& to);

enum class SchoolTables : std::uint8_t { all, of_schema_1 };

class School {
 public:
  explicit School(SchoolTables tables = SchoolTables::all);
  std::filesystem::path old() const { return folder_ / "old.db"; }  // what the file was half way
  std::filesystem::path now() const { return folder_ / "now.db"; }
  std::filesystem::path trial() const { return folder_ / "trial.db"; }  // a copy to tamper with

  Account admin, instructor;
  UserId open_account;  // without password and PIN
  std::vector<SessionId> sessions, in_old;

 private:
  void second_half(Store& store, CohortId cohort, const ScenarioVersion& version, const Account& lena,
                   const Account& omar, SessionId first, SessionId second);
  SessionId sit_assessment(Store& store, CohortId cohort, const ScenarioVersion& version, const Account& student);
  void read_other_station(Store& store);
  SessionId thin_an_old_attempt(const ScenarioVersion& version, const Account& student);
  void keep_as(const std::string& name, Store& store);
  Folder folder_;
  SchoolTables tables_;
};

}  // namespace cusp::test
