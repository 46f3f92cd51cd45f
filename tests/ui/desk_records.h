/// Records for tests of the desktop: a database in a folder of its own, with people and graded attempts.
#pragma once

#include <QTemporaryDir>
#include <memory>
#include <string>

#include "scenarios/grading/grade.h"
#include "storage/store.h"
#include "tests/modules.h"

namespace cusp::test {

/// 2026-11-20 09:00 UTC, where the records' clock starts; each attempt lasts as long as given.
inline constexpr std::int64_t kMorning = 1'795'165'200'000'000;

class DeskRecords {
 public:
  explicit DeskRecords(std::int64_t opened_utc_us = kMorning);
  Store& store() { return *store_; }
  std::filesystem::path file() const;

  Account administrator();                     // "anna", password "correct horse"
  Account student(const std::string& number, const std::string& name, const std::string& pin = {});

  /// A graded attempt at a built-in exercise. Points are of 100 with pass mark 70.
  SessionId attempt(const Account& student, const std::string& key, double score, double seconds,
               const std::string& device_class = "pointer");
  SessionId graded_attempt(const Account& student, const std::string& key, const Grade& grade, double seconds,
                           const std::string& device_class = "pointer");
  /// One that the scripted expert drilled in the student's name.
  SessionId scripted_attempt(const Account& student, const std::string& key, double score, double seconds);
  /// An attempt that broke off, not graded.
  SessionId broken_attempt(const Account& student, const std::string& key);

  /// Goes on to that day: the log has no gap of half a year, so that the clock is believed.
  void use_until(std::int64_t utc_us);

  std::int64_t now_us;

 private:
  Session begin(const Account& student, const std::string& key, double seconds, const std::string& device_class,
                const std::string& operator_name = std::string(kUserOperator));
  SessionId grade_it(const Session& session, const Grade& grade);
  QTemporaryDir folder_;
  std::unique_ptr<Store> store_;
  std::optional<Account> administrator_;
};

/// Two criteria: one full, one that lost points for depth.
Grade sample_grade(double score, double pass = 70);

}  // namespace cusp::test
