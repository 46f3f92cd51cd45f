/// How a file for another station comes to its name.
#include <gtest/gtest.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

#include "storage/exchange/exchange_file.h"
#include "storage/exchange/pack.h"
#include "storage/exchange/session_copies.h"
#include "storage/exchange/unnamed_copies.h"
#include "tests/refused_calls.h"
#include "tests/storage/killed.h"
#include "tests/storage/statements_seen.h"
#include "tests/storage/two_stations.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

using ExchangeCopies = TwoStations;

TEST_F(ExchangeCopies, a_file_takes_its_name_once_it_is_whole) {
  const fs::path file = next_file(), failing = next_file(), taken = next_file();
  must(make_copy(file, folder / "office.db", [&](Database&) -> Stored<void> {
    EXPECT_FALSE(fs::exists(file)) << "a crash would leave a file that nobody has signed";
    return {};
  }));
  EXPECT_EQ(mode_of(file), 0600u);
  const auto failed = make_copy(failing, folder / "office.db", [](Database& to) -> Stored<void> { return fail(StorageError::disk_full, to.file().string()); });
  ASSERT_EQ(code_of(failed), StorageError::disk_full);
  EXPECT_EQ(failed.error().where, failing.string());
  EXPECT_FALSE(fs::exists(failing));
  const auto late = make_copy(taken, folder / "office.db", [&](Database&) -> Stored<void> {
    std::ofstream(taken) << "another program's";
    return {};
  });
  ASSERT_EQ(code_of(late), StorageError::duplicate);
  EXPECT_EQ(late.error().where, taken.string());
  EXPECT_EQ(fs::file_size(taken), 17u) << "another program's stays";
}

TEST_F(ExchangeCopies, a_file_is_on_the_disk_before_it_is_signed_and_not_after_each_attempt) {
  constexpr std::int64_t kOff = 0, kFull = 2;
  const auto synchronous = [](Database& to) { return must(to.first("PRAGMA synchronous", [](Row row) { return row.integer(0); })); };
  std::optional<std::int64_t> filling, finishing;
  const auto fill = [&](Database& to) -> Stored<void> {
    filling = synchronous(to);
    return to.run("INSERT INTO station SELECT * FROM source.station");
  };
  must(make_copy(next_file(), folder / "office.db", fill, [&](Database& to) -> Stored<void> {
    finishing = synchronous(to);
    return {};
  }));
  EXPECT_EQ(filling, kOff);
  EXPECT_EQ(finishing, kFull);
}

TEST_F(ExchangeCopies, a_file_whose_name_is_taken_meanwhile_has_no_last_work) {
  const fs::path taken = next_file();
  const auto fill = [&](Database&) -> Stored<void> {
    std::ofstream(taken) << "another program's";
    return {};
  };
  bool finished = false;
  const auto done = make_copy(taken, folder / "office.db", fill, [&](Database&) -> Stored<void> {
    finished = true;
    return {};
  });
  EXPECT_EQ(code_of(done), StorageError::duplicate);
  EXPECT_FALSE(finished) << "the audit log would name a file that nobody has";
}

TEST_F(ExchangeCopies, a_file_is_whole_and_has_no_log_when_its_last_work_begins) {
  const fs::path file = next_file();
  bool finished = false;
  const auto fill = [](Database& to) { return to.run("CREATE TABLE rows (a INTEGER)"); };
  must(make_copy(file, folder / "office.db", fill, [&](Database& to) -> Stored<void> {
    finished = true;
    EXPECT_FALSE(fs::exists(to.file().string() + "-wal"));
    EXPECT_FALSE(fs::exists(file));
    return to.run("INSERT INTO rows VALUES (1)");
  }));
  EXPECT_TRUE(finished);
  EXPECT_TRUE(fs::exists(file));
}

TEST_F(ExchangeCopies, a_file_that_the_disk_keeps_the_log_of_has_no_last_work) {
  const fs::path file = next_file(), office_records = folder / "office.db";
  bool refused = false, finished = false;
  Stored<void> done;
  std::thread([&] {
    const auto fill = [&](Database&) -> Stored<void> {
      std::vector<RefusedCall> removals = {{SYS_unlinkat, EIO}};
#ifdef SYS_unlink
      removals.push_back({SYS_unlink, EIO});
#endif
      refused = refuse_calls(removals);
      return {};
    };
    done = make_copy(file, office_records, fill, [&](Database&) -> Stored<void> {
      finished = true;
      return {};
    });
  }).join();
  if (!refused) GTEST_SKIP() << "the kernel admits no filter of system calls";
  EXPECT_EQ(code_of(done), StorageError::io);
  EXPECT_FALSE(finished) << "the audit log would name a file that nobody has";
  EXPECT_FALSE(fs::exists(file));
}

TEST_F(ExchangeCopies, a_name_that_no_file_can_have_is_refused_before_the_log_names_it) {
  fs::create_symlink("loop", folder / "loop");
  EXPECT_EQ(code_of(give_out(station->context(), keeper, ExchangeKind::results, folder / "loop")), StorageError::duplicate);
  EXPECT_TRUE(fs::is_symlink(folder / "loop"));
  const fs::path longest = folder / std::string(300, 'x');
  const auto refused = give_out(station->context(), keeper, ExchangeKind::results, longest);
  EXPECT_EQ(code_of(refused), StorageError::io);
  EXPECT_EQ(refused.error().where, longest.string());
  for (const AuditEntry& entry : must(station->audit.list(keeper, 100))) EXPECT_NE(entry.action, "exchange_given_out");
}

TEST_F(ExchangeCopies, a_file_is_given_out_once_under_its_name_on_a_drive_without_hard_links) {
  trust_each_other();
  const fs::path file = next_file();
  bool refused = false;
  Stored<GivenOut> given = fail(StorageError::io, "not given out"), again = given;
  std::thread([&] {
    refused = refuse_calls(links_refused(EPERM));
    if (!refused) return;
    given = give_out(station->context(), keeper, ExchangeKind::results, file);
    again = give_out(station->context(), keeper, ExchangeKind::results, file);
  }).join();
  if (!refused) GTEST_SKIP() << "the kernel admits no filter of system calls";
  must(given);
  EXPECT_EQ(code_of(again), StorageError::duplicate);
  EXPECT_EQ(at_office(file).outcome, ReadOutcome::read);
}

TEST_F(ExchangeCopies, giving_out_takes_away_what_a_killed_program_left_a_day_ago) {
  const fs::path left = folder / (".cusp-copy-" + Uuid::v7().text()), being_written = folder / (".cusp-copy-" + Uuid::v7().text()),
                 notes = folder / ".cusp-copy-notes";
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(48);
  for (const fs::path& one : {left, being_written, notes}) {
    fs::create_directories(one);
    for (const char* part : {"copy.db", "copy.db-wal"}) {
      std::ofstream(one / part) << "cut off";
      if (one != being_written) fs::last_write_time(one / part, long_ago);
    }
    if (one != being_written) fs::last_write_time(one, long_ago);
  }
  results();
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(fs::exists(being_written));
  EXPECT_TRUE(fs::exists(notes));
  const auto copies = std::count_if(fs::directory_iterator(next_file().parent_path()), fs::directory_iterator(),
                                    [](const fs::directory_entry& entry) { return entry.path().filename().string().starts_with(".cusp-copy-"); });
  EXPECT_EQ(copies, 2) << "its own folder is gone";
}

TEST_F(ExchangeCopies, an_attempt_that_is_taken_up_again_meanwhile_goes_out_with_the_next_file) {
  trust_each_other();
  const Account omar = make_student(*station, "2", "Omar");
  const SessionId session = must(station->sessions.start(omar.actor(), new_session(omar, keep(*station)))).id;
  must(station->traces.append(session, second_from(1)));
  must(station->sessions.interrupt(session, "process_gone"));
  const auto beside = open(folder / "station.db");
  const StatementsSeen seen;
  station = open(folder / "station.db");
  bool listed = false;
  std::optional<Stored<void>> resumed;
  StatementsSeen::at_each([&](std::string_view sql) {
    if (listed && !resumed) resumed = beside->sessions.resume(session, "student");
    listed = listed || sql.starts_with("SELECT m.session FROM session_summaries m JOIN sessions s");
  });
  const fs::path file = results();
  ASSERT_TRUE(resumed) << "between the list and the copy";
  must(*resumed);
  EXPECT_EQ(at_office(file).counts.sessions, 0u);
  must(beside->sessions.interrupt(session, "process_gone"));
  EXPECT_EQ(at_office(results()).counts.sessions, 1u);
}

/// A program that is killed after it has logged a file and before the file has its name.
struct GivingOutKilled : TwoStations {
  const fs::path file = folder / "results";

  void SetUp() override {
    trust_each_other();
    attempt(make_student(*station, "2", "Omar"));
  }
  /// False where the kernel admits no filter.
  bool is_killed() {
    station.reset();
    const Killed killed = kill_after(2, 0, [&](const std::function<bool()>& step) {
      const auto own = open(folder / "station.db");
      refuse_calls(links_refused(kKills));
      static_cast<void>(give_out(own->context(), keeper, ExchangeKind::results, file));
      static_cast<void>(step());
    });
    station = open(folder / "station.db");
    return killed.by_signal && killed.steps == 0;
  }
  int given_out() {
    return must(station->database().first("SELECT count(*) FROM audit_log WHERE action = 'exchange_given_out'", [](Row row) { return static_cast<int>(row.integer(0)); })).value_or(-1);
  }
  /// Folders in which a file is made.
  std::ptrdiff_t copies() {
    return std::count_if(fs::directory_iterator(file.parent_path()), fs::directory_iterator(),
                         [](const fs::directory_entry& entry) { return entry.path().filename().string().starts_with(kCopying); });
  }
};

TEST_F(GivingOutKilled, is_finished_by_the_next_call_for_the_name_which_names_that) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  ASSERT_FALSE(fs::exists(file));
  ASSERT_EQ(given_out(), 1);
  const auto again = give_out(station->context(), keeper, ExchangeKind::results, file);
  ASSERT_EQ(code_of(again), StorageError::duplicate);
  EXPECT_EQ(again.error().detail, "finished");
  EXPECT_EQ(again.error().where, "results");
  EXPECT_EQ(given_out(), 1) << "the log names each file once";
  EXPECT_EQ(copies(), 0);
  EXPECT_EQ(mode_of(file), 0600u);
  EXPECT_EQ(at_office(file).counts.sessions, 1u);
  EXPECT_EQ(code_of(give_out(station->context(), keeper, ExchangeKind::results, file)), StorageError::duplicate);
}

TEST_F(GivingOutKilled, is_finished_by_the_next_call_for_another_name_which_gives_out_its_own) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  const fs::path other = results();
  EXPECT_EQ(copies(), 0);
  EXPECT_EQ(at_office(file).description.number(), 1u);
  EXPECT_EQ(at_office(other).description.number(), 2u);
  EXPECT_EQ(whole(*office), "");
}

TEST_F(GivingOutKilled, is_finished_by_the_next_appeal_pack_in_its_folder) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  must(give_out_pack(station->context(), keeper, SessionId{Uuid::v7()}, "a pack", next_file()));
  EXPECT_EQ(copies(), 0);
  EXPECT_EQ(at_office(file).counts.sessions, 1u);
}

TEST_F(GivingOutKilled, takes_no_name_that_somebody_has_taken_since) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  std::ofstream(file) << "kept";
  EXPECT_EQ(at_office(results()).description.number(), 2u);
  EXPECT_EQ(fs::file_size(file), 4u);
}

TEST_F(GivingOutKilled, of_another_station_stays_as_it_is) {
  if (!is_killed()) GTEST_SKIP() << "the kernel admits no filter of system calls";
  office_file();
  EXPECT_FALSE(fs::exists(file));
  EXPECT_EQ(copies(), 1);
}

TEST_F(GivingOutKilled, before_its_entry_leaves_a_copy_that_nobody_names) {
  station.reset();
  const Killed killed = kill_after(1, 0, [&](const std::function<bool()>&) {
    const auto own = open(folder / "station.db");
    const auto fill = [](Database&) -> Stored<void> { return {}; };
    static_cast<void>(make_copy(file, folder / "station.db", fill, [&](Database& to) -> Stored<void> {
      must(add_description(to, sign_exchange(*own->context().key, {.station = own->context().station})));
      static_cast<void>(::raise(SIGKILL));
      return {};
    }));
  });
  ASSERT_TRUE(killed.by_signal);
  ASSERT_EQ(copies(), 1);
  station = open(folder / "station.db");
  results();
  EXPECT_FALSE(fs::exists(file));
}

}  // namespace
}  // namespace cusp::test
