/// A fault at each call that every writing operation makes of the file system: nothing committed is lost, nothing is
/// half there, and the code names what failed. Of writes a thirteenth of the calls, of reads and others a third; CUSP_FULL=1: each
/// of the first 500.
#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "storage/repositories/student_lines.h"
#include "tests/full_run.h"
#include "tests/storage/failing_vfs.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// Who and what the file holds before each operation.
struct Rows {
  Actor administrator, instructor, student;
  CohortId cohort;
  AssignmentId assignment;
  ScenarioVersion version;
  SessionId running, finished, graded;
  UserId other;  // a student without a running session
};

using Outcome = std::optional<StorageFailure>;
template <class T>
Outcome outcome(Stored<T> result) {
  if (result) return std::nullopt;
  return result.error();
}

struct Operation {
  const char* name;
  std::function<Outcome(Store&, const Rows&)> run;
};

/// Several pages of a trace that does not pack: 8,000 places without order.
RecordedSecond large_second(std::uint64_t first_tick) {
  RecordedSecond second = second_from(first_tick, 8'000);
  std::uint32_t state = 1;
  for (StepInput& input : second.inputs) {
    input.x = input.y = static_cast<std::int32_t>((state = state * 1664525u + 1013904223u) >> 8);
  }
  return second;
}

std::vector<StudentLine> two_students() {
  return {{.account = {.number = "77", .name = "New"}, .cohort = "Year 3"}, {.account = {.number = "78", .name = "New"}}};
}

std::vector<Operation> operations_on_people() {
  return {
      {"create a student",
       [](Store& s, const Rows& r) {
         return outcome(
             s.accounts.create(r.administrator, {.number = "77", .name = "New", .password = "battery staple"}));
       }},
      {"add the students of a list",
       [](Store& s, const Rows& r) { return add_students(s.context(), r.administrator, two_students()).failure; }},
      {"rename",
       [](Store& s, const Rows& r) { return outcome(s.accounts.rename(r.administrator, r.student.id, "78", "N")); }},
      {"set a role",
       [](Store& s, const Rows& r) {
         return outcome(s.accounts.set_role(r.administrator, r.student.id, Role::instructor));
       }},
      {"switch off",
       [](Store& s, const Rows& r) { return outcome(s.accounts.disable(r.administrator, r.student.id)); }},
      {"erase a student",
       [](Store& s, const Rows& r) {
         return outcome(s.accounts.erase(r.administrator, r.other));
       }},
      {"set a password",
       [](Store& s, const Rows& r) {
         return outcome(s.accounts.set_password(r.administrator, r.student.id, "", "another staple"));
       }},
      {"set a PIN",
       [](Store& s, const Rows& r) { return outcome(s.accounts.set_pin(r.administrator, r.student.id, "271828")); }},
      {"make a cohort", [](Store& s, const Rows& r) { return outcome(s.cohorts.create(r.administrator, "Year 3")); }},
      {"add to a cohort",
       [](Store& s, const Rows& r) { return outcome(s.cohorts.add(r.administrator, r.cohort, r.instructor.id)); }},
      {"take from a cohort",
       [](Store& s, const Rows& r) { return outcome(s.cohorts.remove(r.administrator, r.cohort, r.student.id)); }},
      {"assign",
       [](Store& s, const Rows& r) {
         return outcome(s.assignments.create(r.instructor, {.version = r.version.id, .cohort = r.cohort}));
       }},
      {"assign an assessment",
       [](Store& s, const Rows& r) {
         return outcome(s.assignments.create(
             r.instructor, {.version = r.version.id, .cohort = r.cohort, .kind = SessionKind::assessment}, "4711"));
       }},
      {"adjust",
       [](Store& s, const Rows& r) {
         return outcome(s.assignments.adjust(r.instructor, r.assignment, r.student.id, {.extra_time_percent = 25}));
       }},
      {"write in the audit log",
       [](Store& s, const Rows& r) { return outcome(s.audit.add({.actor = r.administrator.id, .action = "exported", .subject = Uuid::v7(), .detail = "csv"})); }},
  };
}

std::vector<Operation> operations_on_sessions() {
  return {
      {"publish",
       [](Store& s, const Rows& r) {
         return outcome(
             s.scenarios.publish(r.instructor, small_scenario(), "{\"id\":2}", blake2b_256(std::string_view{"2"})));
       }},
      {"save a draft",
       [](Store& s, const Rows& r) { return outcome(s.scenarios.save_draft(r.instructor, r.version.scenario, "{}", {})); }},
      {"keep a blob", [](Store& s, const Rows&) { return outcome(s.blobs.put(std::as_bytes(std::span{"specimen"}))); }},
      {"start",
       [](Store& s, const Rows& r) {
         NewSession session{.student = r.student.id, .version = r.version.id};
         session.header.scene = "{}";
         return outcome(s.sessions.start(r.student, session));
       }},
      {"append a second",
       [](Store& s, const Rows& r) { return outcome(s.traces.append(r.running, large_second(13))); }},
      {"interrupt", [](Store& s, const Rows& r) { return outcome(s.sessions.interrupt(r.running, "stopped")); }},
      {"finish",
       [](Store& s, const Rows& r) { return outcome(s.sessions.finish(r.running, volume_after(12), "student")); }},
      {"grade", [](Store& s, const Rows& r) { return outcome(s.grades.save(r.finished, small_grade(), {})); }},
      {"grade again",
       [](Store& s, const Rows& r) {
         return outcome(s.grades.save(r.graded, small_grade(50, false), {}, r.instructor));
       }},
      {"override",
       [](Store& s, const Rows& r) {
         return outcome(s.statements.override_points(r.instructor, r.graded, "target_removed", 20, "Worn."));
       }},
      {"rate an own attempt",
       [](Store& s, const Rows& r) {
         return outcome(s.statements.assess_own(r.student, r.graded, {{{"target_removed", OwnRating::partly}}}));
       }},
      {"confirm", [](Store& s, const Rows& r) { return outcome(s.statements.confirm(r.instructor, r.graded)); }},
      {"withdraw an assignment",
       [](Store& s, const Rows& r) { return outcome(s.assignments.withdraw(r.instructor, r.assignment)); }},
      {"withdraw a version",
       [](Store& s, const Rows& r) { return outcome(s.scenarios.withdraw(r.instructor, r.version.id)); }},
      {"comment",
       [](Store& s, const Rows& r) {
         return outcome(s.statements.comment(r.instructor, r.graded, "Look at the wall.", {.tick = 12}));
       }},
      {"close", [](Store& s, const Rows& r) { return outcome(s.sessions.close(r.graded, "")); }},
  };
}

class EveryCall : public ::testing::Test {
 protected:
  void SetUp() override {
    failing_vfs();
    const auto store = open(folder / "start.db");
    rows.administrator = make_administrator(*store).actor();
    rows.instructor = make_instructor(*store).actor();
    const Account student = make_student(*store);
    rows.student = student.actor();
    rows.cohort = must(store->cohorts.create(rows.administrator, "Year 2")).id;
    must(store->cohorts.add(rows.administrator, rows.cohort, student.id));
    rows.version = keep(*store);
    rows.assignment = must(store->assignments.create(rows.instructor, {.version = rows.version.id, .cohort = rows.cohort})).id;
    rows.graded = complete_session(*store, student, rows.version);
    const Account other = make_student(*store, "20260002", "Omar Haddad");
    rows.other = other.id;
    must(store->statements.comment(rows.instructor, complete_session(*store, other, rows.version), "Well done."));
    rows.finished = must(store->sessions.start(student.actor(), new_session(student, rows.version))).id;
    must(store->traces.append(rows.finished, second_from(1)));
    must(store->sessions.finish(rows.finished, volume_after(12), "student"));
    rows.running = must(store->sessions.start(student.actor(), new_session(student, rows.version))).id;
    must(store->traces.append(rows.running, second_from(1)));
  }
  void TearDown() override { fail_from(Failing::nothing, 0); }

  /// What the tables hold, and how many rows each has.
  struct Content {
    std::string rows, counts;
  };
  static Content content_of(Database& db) {
    Content out;
    for (const std::string& table : must(db.all("SELECT name FROM sqlite_schema WHERE type = 'table' ORDER BY name",
                                                [](Row r) { return r.text(0); }))) {
      const auto all = must(db.all("SELECT * FROM " + table, [](Row r) { return r.content_hash(); }));
      for (const Hash256& row : all) out.rows += hex(row);
      out.rows += table;
      out.counts += table + " " + std::to_string(all.size()) + "\n";
    }
    return out;
  }

  void expect_sound(Store& store) {
    EXPECT_EQ(must(store.database().integrity_check()), "");
    EXPECT_TRUE(must(verify_audit_log(store.context())).intact());
    for (const SessionId session : must(sessions_to_verify(store.context()))) {
      EXPECT_TRUE(must(verify_session(store.context(), session)).intact());
    }
  }

  /// Calls that the operation made.
  int attempt(const Operation& operation, Failing how, int n) {
    const fs::path file = folder / "try.db";
    for (const char* part : {"", "-wal", "-shm", ".key", ".key-counter"}) {
      fs::remove(file.string() + part);
      const std::string from = (folder / "start.db").string() + part;
      if (fs::exists(from)) fs::copy_file(from, file.string() + part);
    }
    int calls = 0;
    Outcome failure;
    {
      StoreOptions options = quick();
      options.database.vfs = failing_vfs();
      fail_from(Failing::nothing, 0);
      const auto store = open(file, options);
      fail_from(how, n);
      failure = operation.run(*store, rows);
      calls = operations_seen();
      if (n % 2 == 0) fail_from(Failing::nothing, 0);  // else the disk still fails while it is closed
    }
    fail_from(Failing::nothing, 0);
    const auto store = open(file);
    expect_sound(*store);
    const Content now = content_of(store->database());
    const bool done = now.counts == after.counts && now.rows != before.rows, undone = now.rows == before.rows;
    EXPECT_TRUE(done || undone) << "half of it is there";
    if (!failure) {
      EXPECT_TRUE(done) << "reported as done, and lost";
    } else {
      codes.insert(failure->code);
      const bool full = how == Failing::disk_full;
      EXPECT_EQ(failure->code, full ? StorageError::disk_full : StorageError::io) << failure->detail;
      // A full disk takes no part of it; a failed sync may leave all of it in the log.
      EXPECT_TRUE(undone || !full);
    }
    ++tries;
    return calls;
  }

  void all_faults(const std::vector<Operation>& operations) {
    const bool full = full_run();
    before = content_of(open(folder / "start.db")->database());
    for (const Operation& operation : operations) {
      SCOPED_TRACE(operation.name);
      after = done_by(operation);
      for (const Failing how :
           {Failing::disk_full, Failing::io_error, Failing::once, Failing::short_write, Failing::any_call}) {
        const int stride = full ? 1 : how == Failing::any_call ? 3 : 13;
        // Until the fault comes after the operation's last call.
        for (int n = 1, calls = 1; n <= std::min(calls, 500); n += stride) {
          SCOPED_TRACE("kind " + std::to_string(static_cast<int>(how)) + ", call " + std::to_string(n));
          calls = attempt(operation, how, n) + stride;
          if (HasFailure()) return;
          most = std::max(most, n);
        }
      }
    }
    std::printf("%d tries, faults up to call %d of an operation\n", tries, most);
    EXPECT_TRUE(codes.contains(StorageError::disk_full) && codes.contains(StorageError::io));
  }

  /// What the file holds when nothing fails.
  Content done_by(const Operation& operation) {
    const fs::path file = folder / "whole.db";
    for (const char* part : {"", "-wal", "-shm", ".key", ".key-counter"}) {
      fs::remove(file.string() + part);
      const std::string from = (folder / "start.db").string() + part;
      if (fs::exists(from)) fs::copy_file(from, file.string() + part);
    }
    const auto store = open(file);
    EXPECT_FALSE(operation.run(*store, rows)) << operation.name;
    return content_of(store->database());
  }

  Folder folder;
  Rows rows;
  Content before, after;
  std::set<StorageError> codes;
  int tries = 0, most = 0;
};

TEST_F(EveryCall, of_what_writes_about_people_may_fail_and_nothing_committed_is_lost) {
  all_faults(operations_on_people());
}

TEST_F(EveryCall, of_what_writes_about_sessions_may_fail_and_nothing_committed_is_lost) {
  all_faults(operations_on_sessions());
}

}  // namespace
}  // namespace cusp::test
