#include "tests/ui/desk_records.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

template <class T>
T must(Stored<T> result) {
  if (!result) throw std::runtime_error("storage failed at " + result.error().where + ": " + result.error().detail);
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

}  // namespace

Grade sample_grade(double score, double pass) {
  Grade grade;
  grade.score = score;
  grade.pass_mark = pass;
  grade.passed = score >= pass;
  CriterionGrade removed;
  removed.id = "target_removed";
  removed.measure = {"target_removed", true, 99.4, 0.4, "%", std::nullopt};
  removed.band = "ideal";
  removed.points = removed.points_max = 20;
  removed.reason_code = "full";
  CriterionGrade depth;
  depth.id = "depth_most";
  depth.measure = {"depth_most", true, 2.41, 0.03, "mm", Vec3(1.5, -0.25, -2.4)};
  depth.band = "fail";
  depth.points = 4;
  depth.points_max = 10;
  depth.reason_code = "too_deep";
  depth.reason_args = {{"value", 2.41}, {"limit", 2.0}, {"lost", 6.0}};
  grade.criteria = {removed, depth};
  return grade;
}

DeskRecords::DeskRecords(std::int64_t opened_utc_us) : now_us{opened_utc_us} {
  StoreOptions options;
  options.clock = [this] { return now_us; };
  options.cost = PasswordCost::least();
  store_ = must(Store::open(file(), options));
}

std::filesystem::path DeskRecords::file() const { return folder_.filePath(QStringLiteral("cusp.db")).toStdString(); }

void DeskRecords::use_until(std::int64_t utc_us) {
  constexpr std::int64_t kStep_us = 180 * std::int64_t{86'400'000'000};
  while (utc_us - now_us > kStep_us) {
    now_us += kStep_us;
    must(store_->audit.add({.actor = UserId{}, .action = "signed_in", .subject = {}, .detail = {}}));
  }
  now_us = utc_us;
}

Account DeskRecords::administrator() {
  if (!administrator_) {
    administrator_ = must(store_->accounts.create_first_administrator(
        {.number = "anna", .name = "Anna Weber", .role = Role::administrator, .password = "correct horse", .pin = {}}));
  }
  return *administrator_;
}

Account DeskRecords::student(const std::string& number, const std::string& name, const std::string& pin) {
  return must(store_->accounts.create(administrator().actor(),
                                    {.number = number, .name = name, .role = Role::student, .password = {}, .pin = pin}));
}

Session DeskRecords::begin(const Account& student, const std::string& key, double seconds,
                           const std::string& device_class, const std::string& operator_name) {
  const auto scenario = load_builtin(key);
  if (!scenario) throw std::runtime_error("no built-in exercise " + key);
  const ScenarioVersion version =
      must(store_->scenarios.ensure(*scenario, canonical_json(*scenario), content_hash(*scenario).bytes));
  NewSession fresh;
  fresh.student = student.id;
  fresh.version = version.id;
  fresh.operator_name = operator_name;
  fresh.header.device.name = fresh.header.device.device_class = device_class;
  fresh.header.scene = "{}";
  const Session session = must(store_->sessions.start(student.actor(), fresh));
  RecordedSecond recorded;
  recorded.first_tick = 1;
  for (int i = 0; i < 10; ++i) {
    StepInput input;
    input.elapsed_us = static_cast<std::uint32_t>(seconds * 1e5);
    recorded.inputs.push_back(input);
  }
  recorded.metrics.force_peak_n = 2.1;
  must(store_->traces.append(session.id, recorded));
  now_us += static_cast<std::int64_t>(seconds * 1e6) + 60'000'000;
  return session;
}

SessionId DeskRecords::attempt(const Account& student, const std::string& key, double score, double seconds,
                          const std::string& device_class) {
  return graded_attempt(student, key, sample_grade(score), seconds, device_class);
}

SessionId DeskRecords::graded_attempt(const Account& student, const std::string& key, const Grade& grade, double seconds,
                                      const std::string& device_class) {
  return grade_it(begin(student, key, seconds, device_class), grade);
}

SessionId DeskRecords::scripted_attempt(const Account& student, const std::string& key, double score, double seconds) {
  return grade_it(begin(student, key, seconds, "scripted", "expert"), sample_grade(score));
}

SessionId DeskRecords::grade_it(const Session& session, const Grade& grade) {
  FinalVolume volume;
  volume.tick = 10;
  must(store_->sessions.finish(session.id, volume, "student"));
  must(store_->grades.save(session.id, grade, Hash256{}));
  return session.id;
}

SessionId DeskRecords::broken_attempt(const Account& student, const std::string& key) {
  const Session session = begin(student, key, 12, "pointer");
  must(store_->sessions.interrupt(session.id, "process_gone"));
  return session.id;
}

}  // namespace cusp::test
