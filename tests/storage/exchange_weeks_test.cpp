/// Three stations that meet by files alone: weeks of work drawn with a seed, files late, twice, out of order and lost. In the end
/// each holds the same records. CUSP_EXCHANGE_SEED=N draws another programme; CUSP_FULL=1: fifty of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "storage/exchange/exchange.h"
#include "storage/exchange/trust.h"
#include "tests/full_run.h"
#include "tests/storage/shared_records.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kDay_us = 86'400'000'000;

struct Station {
  std::string name;
  fs::path file;
  std::unique_ptr<Store> store;
  Actor admin{};
  std::vector<fs::path> inbox{};
};

class Weeks {
 public:
  explicit Weeks(unsigned seed) : random_{seed} {
    for (const char* name : {"a", "b", "c"}) {
      Station s{.name = name, .file = folder_ / (std::string(name) + ".db"), .store = {}};
      s.store = open(s.file, quick(now_));
      s.admin = must(s.store->accounts.create_first_administrator(
                         {.number = std::string("own-") + name, .name = "Keeper", .role = Role::administrator, .password = "correct horse"}))
                    .actor();
      stations_.push_back(std::move(s));
    }
    for (Station& here : stations_)
      for (Station& there : stations_)
        if (here.name != there.name) {
          const auto key = must(public_key_from(must(own_key(there.store->context(), there.admin))));
          must(trust(here.store->context(), here.admin, key, there.name == "a" ? KeyRole::office : KeyRole::station));
        }
    instructor_ = make_instructor(*office().store).actor();
    cohort_ = must(office().store->cohorts.create(office().admin, "Year 2")).id;
  }

  Station& office() { return stations_[0]; }
  std::vector<Station>& stations() { return stations_; }
  std::size_t sessions() { return must(sessions_to_verify(office().store->context())).size(); }

  void live(int days) {
    for (int day = 0; day < days; ++day, *now_ += kDay_us) {
      if (one_in(2)) enrol();
      if (one_in(4)) assign();
      for (Station& s : stations_) {
        *now_ += 1'000'000 * static_cast<std::int64_t>(draw(3600));
        if (one_in(2)) drill(s);
        if (one_in(3)) state(s);
        if (one_in(3)) give(s, one_in(2) && s.name == "a" ? ExchangeKind::office : ExchangeKind::results);
        if (one_in(2)) read_some(s);
      }
    }
  }
  /// Everything once more: each file of each station, then what speaks of it.
  void deliver_all() {
    for (int round = 0; round < 2; ++round) {
      for (Station& s : stations_) give(s, ExchangeKind::results, Delivery::certain);
      give(office(), ExchangeKind::office, Delivery::certain);
      for (Station& s : stations_) {
        std::ranges::shuffle(s.inbox, random_);
        for (const fs::path& file : s.inbox) read(s, file);
        s.inbox.clear();
      }
    }
  }
  fs::path next_file() { return folder_ / ("file-" + std::to_string(++files_)); }
  std::map<std::string, int> outcomes{};

 private:
  enum class Delivery { certain, chance };
  std::size_t draw(std::size_t below) { return random_() % below; }
  bool one_in(std::size_t n) { return draw(n) == 0; }

  void enrol() {
    Store& store = *office().store;
    const std::string number = std::to_string(1000 + files_ * 7 + static_cast<int>(students_.size()));
    const Account student = make_student(store, number, "Student " + number);
    students_.push_back(student);
    must(store.cohorts.add(office().admin, cohort_, student.id));
    if (one_in(3)) must(store.accounts.rename(office().admin, one_of(students_).id, "9" + number, "Renamed " + number));
    if (one_in(4)) must(store.cohorts.add(office().admin, cohort_, one_of(students_).id));
    const auto members = must(store.cohorts.students(cohort_));
    if (members.size() > 3 && one_in(3)) must(store.cohorts.remove(office().admin, cohort_, members[draw(members.size())]));
  }
  template <class T>
  const T& one_of(const std::vector<T>& some) {
    return some[draw(some.size())];
  }
  void assign() {
    Store& store = *office().store;
    Scenario scenario = small_scenario();
    const std::string json = "{\"id\":" + std::to_string(100 + draw(6)) + "}";
    const auto version = keep(store, scenario, json);
    const bool exam = one_in(2);
    const Assignment asked = must(store.assignments.create(
        instructor_, {.version = version.id, .cohort = cohort_, .kind = exam ? SessionKind::assessment : SessionKind::practice}, exam ? "4711" : ""));
    const auto members = must(store.cohorts.students(cohort_));
    if (exam && !members.empty()) must(store.assignments.adjust(instructor_, asked.id, one_of(members), {.extra_time_percent = 25}));
    if (one_in(4)) must(store.assignments.withdraw(instructor_, asked.id));
  }
  /// Somebody whom the station knows drills an exercise of its own, or what is assigned there.
  void drill(Station& s) {
    Store& store = *s.store;
    if (one_in(3)) make_student(store, "local-" + s.name + std::to_string(++files_), "Local");
    const auto known = must(store.database().all(
        "SELECT id FROM people WHERE role = 'student' AND disabled = 0 ORDER BY id", [](Row row) { return row.id<UserId>(0); }));
    if (known.empty()) return;
    const UserId who = one_of(known);
    auto assigned = must(store.assignments.for_student(who));
    std::erase_if(assigned, &Assignment::withdrawn);
    NewSession wanted = new_session(must(store.accounts.find(who)), {});
    const std::string own = "{\"id\":" + std::to_string(100 + draw(9)) + "}";
    if (assigned.empty() || !one_in(2)) {
      wanted.version = keep(store, small_scenario(), own).id;  // a version without an attempt is in no file
    } else {
      const Assignment& a = one_of(assigned);
      wanted.version = a.version;
      wanted.assignment = a.id;
      if (a.kind == SessionKind::assessment) wanted.start_code = "4711";
    }
    const SessionId session = must(store.sessions.start(Actor{who, Role::student}, wanted)).id;
    must(store.traces.append(session, second_from(1)));
    if (one_in(5)) return must(store.sessions.interrupt(session, "recorder_full"));
    must(store.sessions.finish(session, volume_after(12), "student"));
    if (!one_in(4)) must(store.grades.save(session, small_grade(static_cast<double>(40 + draw(60)), one_in(2)), {}));
  }
  /// An instructor of the office states about any session that the station holds; the station's own rows are graded later at times.
  void state(Station& s) {
    Store& store = *s.store;
    const auto author = store.accounts.find(instructor_.id);
    const auto graded = must(store.database().all("SELECT session FROM session_summaries WHERE state = 'graded' ORDER BY session",
                                                  [](Row row) { return row.id<SessionId>(0); }));
    if (!author || author->disabled || graded.empty()) return;
    const SessionId session = one_of(graded);
    switch (draw(4)) {
      case 0:
        must(store.statements.comment(instructor_, session, "Look here."));
        break;
      case 1:
        must(store.statements.override_points(instructor_, session, "target_removed", static_cast<double>(draw(20)), "The block was worn."));
        break;
      case 2:
        must(store.statements.confirm(instructor_, session));
        static_cast<void>(store.statements.release(instructor_, session));
        break;
      default:
        for (const SignedStatement& standing : in_force(must(store.statements.of(instructor_, session)))) {
          if (standing.kind == StatementKind::comment) return static_cast<void>(must(store.statements.withdraw(instructor_, session, standing.id, "Not so.")));
        }
    }
  }
  void give(Station& from, ExchangeKind kind, Delivery delivery = Delivery::chance) {
    const fs::path file = next_file();
    must(give_out(from.store->context(), from.admin, kind, file));
    for (Station& to : stations_) {
      if (to.name == from.name || (delivery == Delivery::chance && one_in(4))) continue;
      to.inbox.push_back(file);
      if (one_in(4)) to.inbox.push_back(file);
    }
  }
  void read_some(Station& s) {
    std::ranges::shuffle(s.inbox, random_);
    for (std::size_t n = draw(4); n > 0 && !s.inbox.empty(); --n) {
      read(s, s.inbox.back());
      s.inbox.pop_back();
    }
  }
  void read(Station& s, const fs::path& file) {
    const ReadIn done = must(read_in(s.store->context(), s.admin, file));
    ++outcomes[std::string(key_of(done.outcome))];
    if (done.waiting > 0) ++outcomes["with statements that wait"];
  }

  Folder folder_;
  std::mt19937 random_;
  std::shared_ptr<std::int64_t> now_ = std::make_shared<std::int64_t>(kNow);
  std::vector<Station> stations_;
  Actor instructor_{};
  CohortId cohort_{};
  std::vector<Account> students_;
  int files_ = 0;
};

std::string findings_of(Store& store) {
  std::string out;
  for (const ChainFinding& f : must(verify_store(store.context())).findings)
    out += std::string(key_of(f.code)) + ' ' + f.table + ' ' + f.owner.text() + ' ' + f.what + '\n';
  return out;
}

unsigned first_seed() {
  const char* given = std::getenv("CUSP_EXCHANGE_SEED");
  return given != nullptr ? static_cast<unsigned>(std::atoi(given)) : 1;
}

TEST(ExchangeWeeks, three_stations_hold_the_same_records_once_every_file_has_arrived) {
  const unsigned programmes = full_run() ? 50 : 1;
  for (unsigned seed = first_seed(); seed < first_seed() + programmes; ++seed) {
    SCOPED_TRACE("CUSP_EXCHANGE_SEED=" + std::to_string(seed));
    Weeks weeks(seed);
    weeks.live(full_run() ? 42 : 21);
    weeks.deliver_all();
    const auto office = shared_records(*weeks.office().store);
    for (Station& s : weeks.stations()) {
      EXPECT_EQ(shared_records(*s.store), office) << s.name;
      EXPECT_EQ(findings_of(*s.store), "") << s.name;
    }
    std::printf("seed %u: %zu sessions;", seed, weeks.sessions());
    for (const auto& [outcome, count] : weeks.outcomes) std::printf(" %d %s", count, outcome.c_str());
    std::printf("\n");
  }
}

TEST(ExchangeWeeks, a_station_that_was_put_back_to_an_old_copy_is_named) {
  Weeks weeks(first_seed());
  weeks.live(7);
  weeks.deliver_all();
  Station& b = weeks.stations()[1];
  const auto give = [&] {
    const fs::path file = weeks.next_file();
    must(give_out(b.store->context(), b.admin, ExchangeKind::results, file));
    return file;
  };
  must(b.store->database().run("PRAGMA wal_checkpoint(TRUNCATE)"));
  for (const char* part : {"", ".key", ".key-counter"}) fs::copy_file(b.file.string() + part, b.file.string() + ".old" + part);
  must(read_in(weeks.office().store->context(), weeks.office().admin, give()));
  const auto before = shared_records(*weeks.office().store);
  b.store.reset();
  for (const char* part : {"", ".key", ".key-counter"})
    fs::copy_file(b.file.string() + ".old" + part, b.file.string() + part, fs::copy_options::overwrite_existing);
  b.store = open(b.file);
  must(b.store->accounts.create(b.admin, {.number = "after", .name = "After"}));
  for (int i = 0; i < 2; ++i) {
    const auto refused = read_in(weeks.office().store->context(), weeks.office().admin, give());
    ASSERT_EQ(code_of(refused), StorageError::put_back) << "the first file after it, and every later one";
    EXPECT_EQ(refused.error().where, b.store->context().station.text());
  }
  EXPECT_EQ(shared_records(*weeks.office().store), before);
  // With a new key it is a station that begins anew.
  b.store.reset();
  fs::remove(b.file.string() + ".key");
  b.store = open(b.file);
  must(trust(weeks.office().store->context(), weeks.office().admin, must(public_key_from(must(own_key(b.store->context(), b.admin)))), KeyRole::station));
  must(read_in(weeks.office().store->context(), weeks.office().admin, give()));
  EXPECT_EQ(findings_of(*weeks.office().store), "");
}

}  // namespace
}  // namespace cusp::test
