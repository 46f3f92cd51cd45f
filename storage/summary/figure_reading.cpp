// Reads the graded attempts that a filter admits: of a few students by index, else from the packed attempts.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "storage/records/packed_attempts.h"
#include "storage/summary/pages.h"

namespace cusp::storage {
namespace {

constexpr std::int64_t kEnd = std::numeric_limits<std::int64_t>::max();
/// Up to so many students are asked for one by one: 0.4 ms each with 400 attempts, where a million packed attempts take 30 ms or more.
constexpr std::size_t kFewStudents = 20;

Stored<Figures> of_few(Database& db, const HistoryFilter& f, const std::vector<UserId>& students) {
  std::string sql =
      "SELECT student, attempt, score, pass_mark, passed, elapsed_us FROM session_summaries INDEXED BY graded_of_student "
      "WHERE listed = 1 AND student = ?1 AND score IS NOT NULL AND started_at >= ?8 AND started_at < ?9";
  if (f.scenario) sql += " AND scenario = ?2";
  if (f.device_class) sql += " AND device_class = ?3";
  if (f.passed) sql += " AND passed = ?4";
  if (f.scripted) sql += " AND (operator <> 'person') = ?5";
  if (f.released_alone) sql += " AND released = 1";
  if (f.version_number) sql += " AND version_number = ?6";
  if (f.kind) sql += " AND kind = ?7";
  if (f.drilled_by == DrilledBy::students) sql += " AND student NOT IN (SELECT id FROM people WHERE role <> 'student')";
  FigureCount count;
  Statement query = db.prepare(sql);
  for (const UserId student : students) {
    query.bind(student, f.scenario, f.device_class, f.passed, f.scripted, f.version_number,
               f.kind.transform([](SessionKind kind) { return key_of(kind); }), f.from_utc_us.value_or(-kEnd), f.to_utc_us.value_or(kEnd));
    while (true) {
      const auto there = query.step();
      if (!there) return std::unexpected(there.error());
      if (!*there) break;
      const Row row = query.row();
      count.add({row.id<UserId>(0), static_cast<int>(row.integer(1)), row.real(2), row.maybe_real(3), row.flag(4), row.u64(5)});
    }
  }
  return count.figures();
}

struct Group {
  ScenarioId scenario;
  std::string device_class;
};

/// Every scenario and device class that has packed attempts and that the filter admits: each is found by the one before it.
Stored<std::vector<Group>> groups_of(Database& db, const HistoryFilter& f) {
  std::vector<Group> groups;
  Statement next = db.prepare(
      "SELECT scenario, device_class FROM packed_attempts WHERE (scenario, device_class) > (?1, ?2) "
      "ORDER BY scenario, device_class LIMIT 1");
  next.bind(std::span<const std::byte>{}, "");
  while (true) {
    const auto there = next.step();
    if (!there) return std::unexpected(there.error());
    if (!*there) return groups;
    const Group group{next.row().id<ScenarioId>(0), next.row().text(1)};
    next.bind(group.scenario, group.device_class);
    const bool fits = (!f.scenario || *f.scenario == group.scenario) && (!f.device_class || *f.device_class == group.device_class);
    if (fits) groups.push_back(group);
  }
}

/// The conditions that a packed attempt is compared with; scenario and device class are those of its row.
class Conditions {
 public:
  /// `left_out`: whose attempts do not count.
  Conditions(const HistoryFilter& f, const std::optional<std::vector<UserId>>& students, const std::vector<UserId>& left_out)
      : version_{f.version_number.transform([](int n) { return std::min(n, static_cast<int>(PackedAttempt::kMostVersion)); })}, from_{f.from_utc_us.value_or(-kEnd)}, to_{f.to_utc_us.value_or(kEnd)}, any_student_{!students} {
    if (students) {
      for (const UserId student : *students) static_cast<void>(students_.number(student));
    }
    for (const UserId account : left_out) static_cast<void>(left_out_.number(account));
    require(PackedAttempt::kPassed, f.passed);
    require(PackedAttempt::kScripted, f.scripted);
    require(PackedAttempt::kAssessment, f.kind.transform([](SessionKind kind) { return kind == SessionKind::assessment; }));
    require(PackedAttempt::kReleased, f.released_alone ? std::optional(true) : std::nullopt);
  }
  bool admits(const PackedAttempt& a) const noexcept {
    return a.started_utc_us >= from_ && a.started_utc_us < to_ && (a.rest & compared_) == wanted_ &&
           (!version_ || *version_ == a.version_number()) && (any_student_ || students_.knows(UserId{a.student})) &&
           (left_out_.size() == 0 || !left_out_.knows(UserId{a.student}));
  }
  std::int64_t first_period() const noexcept { return period_of(from_); }
  std::int64_t last_period() const noexcept { return period_of(to_); }

 private:
  void require(std::uint64_t flag, const std::optional<bool>& value) noexcept {
    if (value) compared_ |= flag;
    if (value.value_or(false)) wanted_ |= flag;
  }
  std::optional<int> version_;
  std::int64_t from_, to_;
  bool any_student_;
  StudentNumbers students_, left_out_;
  std::uint64_t compared_ = 0, wanted_ = 0;  // flags
};

}  // namespace

Stored<Figures> read_figures(Database& db, const HistoryFilter& filter) {
  const Snapshot snapshot(db);
  const auto students = students_of(db, filter);
  if (!students) return std::unexpected(students.error());
  if (*students && (*students)->size() <= kFewStudents) return of_few(db, filter, **students);
  const auto groups = groups_of(db, filter);
  if (!groups) return std::unexpected(groups.error());
  const auto left_out = filter.drilled_by == DrilledBy::students ? staff_of(db) : Stored<std::vector<UserId>>{};
  if (!left_out) return std::unexpected(left_out.error());
  const Conditions conditions(filter, *students, *left_out);
  FigureCount count;
  Statement packed = db.prepare(
      "SELECT attempts FROM packed_attempts WHERE scenario = ?1 AND device_class = ?2 AND period BETWEEN ?3 AND ?4");
  for (const Group& group : *groups) {
    packed.bind(group.scenario, group.device_class, conditions.first_period(), conditions.last_period());
    while (true) {
      const auto there = packed.step();
      if (!there) return std::unexpected(there.error());
      if (!*there) break;
      unpack_attempts(packed.row().bytes(0), [&](const PackedAttempt& a) {
        if (!conditions.admits(a)) return;
        const auto mark = std::isnan(a.pass_mark) ? std::nullopt : std::optional(a.pass_mark);
        count.add({UserId{a.student}, a.attempt(), a.score, mark, a.has(PackedAttempt::kPassed), a.elapsed_us()});
      });
    }
  }
  return count.figures();
}

}  // namespace cusp::storage
