#include "tests/storage/school.h"

#include "storage/exchange/exchange.h"
#include "storage/exchange/trust.h"
#include "storage/retention/thinning.h"

namespace cusp::test {

namespace fs = std::filesystem;

void copy_school(const fs::path& from, const fs::path& to) {
  for (const char* part : {"", ".key", ".key-counter"}) {
    fs::remove(to.string() + part);
    if (fs::exists(from.string() + part)) fs::copy_file(from.string() + part, to.string() + part);
  }
  for (const char* part : {"-wal", "-shm"}) fs::remove(to.string() + part);
}

School::School(SchoolTables tables) : tables_{tables} {
  auto store = open(folder_ / "a.db");
  admin = make_administrator(*store);
  instructor = make_instructor(*store);
  const Account lena = make_student(*store);
  const Account omar = must(store->accounts.create(admin.actor(), {.number = "2", .name = "Omar", .pin = "271828"}));
  open_account = must(store->accounts.create(admin.actor(), {.number = "3", .name = "Ida"})).id;
  const Cohort cohort = must(store->cohorts.create(instructor.actor(), "Year 2"));
  must(store->cohorts.create(instructor.actor(), "Year 3"));
  must(store->cohorts.add(instructor.actor(), cohort.id, lena.id));
  const std::vector<std::byte> voxels(4000, std::byte{5}), picture(300, std::byte{6}), nobodys(70, std::byte{7});
  const Hash256 specimen = must(store->blobs.put(voxels)), file_blob = must(store->blobs.put(picture));
  must(store->blobs.put(nobodys));
  const auto version = keep(*store);
  Scenario own = small_scenario();
  own.id = *ScenarioId::parse("018f0000-0000-7000-8000-000000000002");
  must(store->scenarios.publish(instructor.actor(), own, "{\"id\":2}", blake2b_256(std::string_view{"2"}),
                                {{"volume.nrrd", file_blob}}));
  must(store->scenarios.save_draft(instructor.actor(), own.id, "{}", {}));
  must(store->assignments.create(instructor.actor(), {.version = version.id, .cohort = cohort.id}));
  const SessionId first = complete_session(*store, lena, version, 40, false);
  NewSession wanted = new_session(omar, version);
  wanted.header.specimen_blob = specimen;
  const SessionId second = must(store->sessions.start(omar.actor(), wanted)).id;
  must(store->traces.append(second, second_from(1)));
  must(store->sessions.finish(second, volume_after(12), "student"));
  add_comment_row(*store, instructor.actor(), first, "Here the floor begins to rise.");
  keep_as("old.db", *store);
  second_half(*store, cohort.id, version, lena, omar, first, second);
}

void School::second_half(Store& store, CohortId cohort, const ScenarioVersion& version, const Account& lena,
                         const Account& omar, SessionId first, SessionId second) {
  add_old_grade(store, second, small_grade(62, false));
  must(store.grades.save(first, small_grade(45, false), {}, instructor.actor()));
  const SessionId third = complete_session(store, omar, version, 90, true);
  add_comment_row(store, instructor.actor(), third, "Well done.");
  if (tables_ == SchoolTables::all) sessions = {sit_assessment(store, cohort, version, lena)};
  must(store.cohorts.add(instructor.actor(), cohort, omar.id));
  must(store.accounts.rename(admin.actor(), lena.id, "20267314", "Lena Brandt-Meier"));
  must(store.accounts.set_password(admin.actor(), instructor.id, "", "another password"));
  must(store.accounts.disable(admin.actor(), omar.id));
  must(store.accounts.enable(admin.actor(), omar.id));
  EXPECT_FALSE(store.accounts.sign_in("20267314", "a wrong guess"));
  must(store.accounts.sign_in("admin", "correct horse"));
  const SessionId stopped = must(store.sessions.start(lena.actor(), new_session(lena, version))).id;
  must(store.traces.append(stopped, second_from(1)));
  must(store.sessions.interrupt(stopped, "recorder_full"));
  const SessionId running = must(store.sessions.start(lena.actor(), new_session(lena, version))).id;
  must(store.traces.append(running, second_from(1)));
  if (tables_ == SchoolTables::all) {
    read_other_station(store);
    sessions.push_back(thin_an_old_attempt(version, lena));
  }
  keep_as("now.db", store);
  sessions.insert(sessions.end(), {first, second, third, stopped, running});
  in_old = {first, second};
}

/// One attempt of another station, whose student this one knows by name alone.
void School::read_other_station(Store& store) {
  const auto other = open(folder_ / "other.db");
  const Actor keeper = make_administrator(*other).actor();
  complete_session(*other, make_student(*other, "4", "Nour"), keep(*other));
  must(give_out(other->context(), keeper, ExchangeKind::results, folder_ / "results"));
  must(trust(store.context(), admin.actor(), must(public_key_from(must(own_key(other->context(), keeper)))), KeyRole::station));
  must(read_in(store.context(), admin.actor(), folder_ / "results"));
}

/// Overridden, confirmed and released, with a comment that was taken back; assignment and version withdrawn afterwards.
SessionId School::sit_assessment(Store& store, CohortId cohort, const ScenarioVersion& version, const Account& student) {
  const Actor examiner = instructor.actor();
  must(store.device_tests.add(examiner, {.device_class = "pointer", .device = "Mouse and keys"}));
  const Assignment asked = must(store.assignments.create(
      examiner, {.version = version.id, .cohort = cohort, .kind = SessionKind::assessment, .device_classes = {"pointer"}, .self_test_days = 7, .drawn_tooth = true},
      "4711"));
  must(store.assignments.adjust(examiner, asked.id, student.id, {.extra_time_percent = 25, .large_text = true}));
  NewSession wanted = new_session(student, version);
  wanted.assignment = asked.id;
  wanted.start_code = "4711";
  wanted.header.exercise = "{\"specimen\": {\"seed\": 17}}";
  const SessionId session = must(store.sessions.start(student.actor(), wanted)).id;
  must(store.traces.append(session, second_from(1)));
  must(store.sessions.finish(session, volume_after(12), "student"));
  must(store.grades.save(session, small_grade(50, false), {}));
  must(store.statements.assess_own(student.actor(), session, {{{"target_removed", OwnRating::partly}}}));
  must(store.statements.override_points(examiner, session, "target_removed", 20, "The block was worn."));
  const SignedStatement said = must(store.statements.comment(examiner, session, "Not yours."));
  must(store.statements.withdraw(examiner, session, said.id, "Another student's."));
  must(store.statements.confirm(examiner, session));
  must(store.statements.release(examiner, session));
  must(store.assignments.withdraw(examiner, asked.id));
  must(store.scenarios.withdraw(examiner, version.id));
  return session;
}

/// Of a hundred days ago, thinned yesterday: what the log holds already is of today, so that its order makes the attempt no younger.
SessionId School::thin_an_old_attempt(const ScenarioVersion& version, const Account& student) {
  constexpr std::int64_t day_us = 86'400'000'000;
  const auto now = std::make_shared<std::int64_t>(kNow - 100 * day_us);
  const auto earlier = open(folder_ / "a.db", quick(now));
  const SessionId session = complete_session(*earlier, student, version, 70, true);
  *now = kNow - day_us;
  EXPECT_EQ(must(thin_traces(earlier->context(), admin.actor(), {.mode = ThinningMode::carry_out})).attempts, 1u);
  return session;
}

void School::keep_as(const std::string& name, Store& store) {
  must(store.database().run("PRAGMA wal_checkpoint(TRUNCATE)"));
  copy_school(folder_ / "a.db", folder_ / name);
}

}  // namespace cusp::test
