/// A temporary folder, a fixed clock, and a small but complete session.
#pragma once

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "storage/store.h"
#include "storage/records/verify.h"
#include "tests/modules.h"

namespace cusp::test {

/// Deleted by the destructor.
class Folder {
 public:
  Folder();
  ~Folder();
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// The process's umask until the destructor.
class Umask {
 public:
  explicit Umask(mode_t mask) : before_{::umask(mask)} {}
  ~Umask() { ::umask(before_); }
  Umask(const Umask&) = delete;
  Umask& operator=(const Umask&) = delete;

 private:
  mode_t before_;
};
/// Of a file or folder: 0600.
inline unsigned mode_of(const std::filesystem::path& path) { return static_cast<unsigned>(std::filesystem::status(path).permissions()); }

/// 20 November 2026, 09:14:03 UTC.
inline constexpr std::int64_t kNow = 1'795'166'043'000'000;

/// Cheapest passwords, a clock at *now.
StoreOptions quick(const std::shared_ptr<std::int64_t>& now = std::make_shared<std::int64_t>(kNow));
std::unique_ptr<Store> open(const std::filesystem::path& file, const StoreOptions& options = quick());

Account make_administrator(Store& store);
Account make_student(Store& store, const std::string& number = "20267314", const std::string& name = "Lena Brandt");
/// A guest's account, which older programs may have made.
Account make_guest(Store& store);
Account make_instructor(Store& store, const std::string& number = "okafor");

Scenario small_scenario();
ScenarioVersion keep(Store& store, const Scenario& scenario = small_scenario(), const std::string& json = "{\"id\":1}");

NewSession new_session(const Account& student, const ScenarioVersion& version);
/// `count` inputs that move down; the same for the same first tick.
RecordedSecond second_from(std::uint64_t first_tick, std::size_t count = 12);
/// A row of key_states at the end of the trace, chained, as older programs wrote them.
void add_key_state_row(Store& store, SessionId session, const KeyState& state);
/// The final volume of a session that has not finished, chained, as older programs wrote it before the grade.
void keep_volume_row(Store& store, SessionId session, const FinalVolume& volume);
/// A grade as programs before schema 13 wrote it: each criterion a row of `criteria` with an entry of its own in the chain.
void add_old_grade(Store& store, SessionId session, const Grade& grade);
/// A row of the table `comments`, sealed, as older programs wrote it, at tick 12.
void add_comment_row(Store& store, const Actor& author, SessionId session, const std::string& text);
FinalVolume volume_after(std::uint64_t tick);
Grade small_grade(double score = 81.5, bool passed = true);

/// Started, three seconds of trace with a key state, finished and graded.
SessionId complete_session(Store& store, const Account& student, const ScenarioVersion& version, double score = 81.5,
                           bool passed = true);

/// The value, or a test failure with the code.
template <class T>
T must(Stored<T> result) {
  if (!result) {
    ADD_FAILURE() << "code " << static_cast<int>(result.error().code) << " where " << result.error().where << ": "
                  << result.error().detail;
    throw std::runtime_error("storage failed");
  }
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}
/// The code of a failure; fails the test on success.
template <class T>
StorageError code_of(const Stored<T>& result) {
  if (result) {
    ADD_FAILURE() << "succeeded";
    throw std::runtime_error("no failure");
  }
  return result.error().code;
}

}  // namespace cusp::test
