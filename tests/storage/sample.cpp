#include "tests/storage/sample.h"

#include <cstdlib>

#include "storage/records/chain_writer.h"
#include "storage/records/sealing.h"
#include "storage/records/session_summary.h"
#include "storage/repositories/session_state.h"
#include "storage/records/trace_codec.h"
#include "tests/modules.h"

namespace cusp::test {

namespace fs = std::filesystem;

Folder::Folder() {
  path_ = fs::temp_directory_path() / ("cusp-storage-" + Uuid::v7().text());
  fs::create_directories(path_);
}
Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

StoreOptions quick(const std::shared_ptr<std::int64_t>& now) {
  StoreOptions options;
  options.clock = [now] { return *now; };
  options.cost = PasswordCost::least();
  return options;
}

std::unique_ptr<Store> open(const fs::path& file, const StoreOptions& options) {
  return must(Store::open(file, options));
}

Account make_administrator(Store& store) {
  return must(store.accounts.create_first_administrator(
      {.number = "admin", .name = "Maya Okafor", .role = Role::administrator, .password = "correct horse"}));
}
Account make_student(Store& store, const std::string& number, const std::string& name) {
  const Actor program{UserId{}, Role::administrator};
  return must(
      store.accounts.create(program, {.number = number, .name = name, .password = "battery staple", .pin = "314159"}));
}
Account make_guest(Store& store) {
  const UserId id = UserId::make();
  must(store.database().run(
      "INSERT INTO people (id, number, name, role, password, pin, guest, created_at) "
      "VALUES (?1, '\nguest', 'guest', 'student', '', '', 1, ?2)",
      id, kNow));
  return must(store.accounts.find(id));
}
Account make_instructor(Store& store, const std::string& number) {
  const Actor program{UserId{}, Role::administrator};
  return must(store.accounts.create(
      program, {.number = number, .name = "Dr Okafor", .role = Role::instructor, .password = "battery staple"}));
}

Scenario small_scenario() {
  Scenario scenario;
  scenario.id = *ScenarioId::parse("018f0000-0000-7000-8000-000000000001");
  scenario.version = 1;
  scenario.key = "channel-1";
  scenario.title = {{"en", "Straight channel"}, {"de", "Gerader Kanal"}};
  return scenario;
}

ScenarioVersion keep(Store& store, const Scenario& scenario, const std::string& json) {
  return must(store.scenarios.ensure(scenario, json, blake2b_256(json)));
}

NewSession new_session(const Account& student, const ScenarioVersion& version) {
  NewSession session{.student = student.id, .version = version.id};
  session.header.build = "0.1.0 test";
  session.header.device.name = "Mouse and keys";
  session.header.device.device_class = "pointer";
  session.header.guard.limit_n = 3.3;
  session.header.specimen_hash = 0xF00DF00DF00DF00Dull;
  session.header.scene = "{}";
  return session;
}

RecordedSecond second_from(std::uint64_t first_tick, std::size_t count) {
  RecordedSecond second;
  second.first_tick = first_tick;
  for (std::size_t i = 0; i < count; ++i) {
    StepInput input;
    const auto tick = static_cast<std::int32_t>(first_tick + i);
    input.x = 10'000 + tick % 7;
    input.z = 50'000 - 3 * tick;
    input.buttons = tick % 5 == 0 ? 0 : StepInput::kCut;
    // So that a few inputs make a second, and a small session has several.
    input.elapsed_us = static_cast<std::uint32_t>(1'000'000 / count + 1);
    second.inputs.push_back(input);
  }
  second.state_hash = 0x9E3779B97F4A7C15ull * first_tick;
  second.metrics.removed = {{Tissue::enamel, 10 * first_tick, 0.125 * static_cast<double>(first_tick)}};
  second.metrics.force_peak_n = 2.1;
  second.metrics.force_mean_n = 0.8;
  second.metrics.contact_ticks = count;
  second.metrics.cutting_ticks = count - 1;
  return second;
}

void add_key_state_row(Store& store, SessionId session, const KeyState& state) {
  Transaction transaction(store.database());
  const std::uint64_t row = next_row(transaction, SessionTable::key_states, session);
  transaction.run("INSERT INTO key_states (session, row, tick, state) VALUES (?1, ?2, ?3, ?4)", session, row, state.tick,
                  pack(state.state));
  ChainWriter chain(store.context(), transaction, session);
  chain.add(SessionTable::key_states, row, trace_end(transaction, session).second());
  chain.finish();
  must(transaction.commit());
}

void keep_volume_row(Store& store, SessionId session, const FinalVolume& volume) {
  Transaction transaction(store.database());
  insert_final_volume(transaction, session, volume);
  ChainWriter chain(store.context(), transaction, session);
  chain.add(SessionTable::final_volumes, 0, trace_end(transaction, session).second());
  chain.finish();
  must(transaction.commit());
}

void add_old_grade(Store& store, SessionId session, const Grade& grade) {
  StorageContext& context = store.context();
  Transaction transaction(store.database());
  const std::uint64_t number = next_row(transaction, SessionTable::grades, session);
  transaction.run(
      "INSERT INTO grades SELECT id, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, '[]', ?10, ?11, engine_version, device_class, '' FROM sessions WHERE id = ?1",
      session, number, context.clock(), context.next_sequence(transaction), UserId{}, grade.score, grade.score_max, grade.pass_mark,
      grade.passed, Hash256{}, grade.evaluator);
  ChainWriter chain(context, transaction, session);
  chain.add(SessionTable::grades, number, -1);
  std::uint64_t row = next_row(transaction, SessionTable::criteria, session);
  for (const CriterionGrade& c : grade.criteria) {
    const Vec3 at = c.measure.where_mm.value_or(Vec3{});
    transaction.run(
        "INSERT INTO criteria VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12, ?13, ?14, ?15, ?16, '{\"limit\":2.0}')", session, row,
        number, c.id, c.measure.metric, c.measure.measured, c.measure.value, c.measure.uncertainty, c.measure.unit, at.x, at.y, at.z, c.band,
        c.points, c.points_max, c.reason_code);
    chain.add(SessionTable::criteria, row++, -1);
  }
  const TraceEnd end = trace_end(transaction, session);
  chain.add(SessionTable::session_events, insert_event(context, transaction, session, EventKind::graded, "", end), end.second());
  chain.finish();
  follow_event(transaction, session);
  log_session(context, transaction, UserId{}, session, key_of(EventKind::graded));
  must(commit_sealed(context, transaction));
}

void add_comment_row(Store& store, const Actor& author, SessionId session, const std::string& text) {
  StorageContext& context = store.context();
  const Uuid id = Uuid::v7();
  Transaction transaction(store.database());
  transaction.run(
      "INSERT INTO comments (id, session, author, at, sequence, tick, text) VALUES (?1, ?2, ?3, ?4, ?5, 12, ?6)", id,
      session, author.id, context.clock(), context.next_sequence(transaction), text);
  log_row(context, transaction, author.id, "commented", SealedTable::comments, id);
  must(commit_sealed(context, transaction));
}

FinalVolume volume_after(std::uint64_t tick) {
  FinalVolume volume;
  for (int i = 0; i < 40; ++i) volume.cuts.push_back(static_cast<std::byte>(i * i));
  volume.hash = 0xC0FFEE00C0FFEE00ull;
  volume.tick = tick;
  return volume;
}

Grade small_grade(double score, bool passed) {
  Grade grade;
  grade.score = score;
  grade.passed = passed;
  grade.critical = passed ? std::vector<std::string>{} : std::vector<std::string>{"pulp_exposure"};
  CriterionGrade removed;
  removed.id = "target_removed";
  removed.measure = {"target_removed", true, 96.8, 0.4, "%", std::nullopt};
  removed.band = "ideal";
  removed.points = 18;
  removed.points_max = 20;
  removed.reason_code = "full";
  CriterionGrade depth;
  depth.id = "floor_depth_max";
  depth.measure = {"floor_depth_max", true, 2.41, 0.03, "mm", Vec3(1.5, -0.25, 3.0)};
  depth.band = "fail";
  depth.points = 4;
  depth.points_max = 10;
  depth.reason_code = "too_deep";
  depth.reason_args = {{"limit", 2.0}, {"lost", 6.0}, {"value", 2.41}};
  grade.criteria = {removed, depth};
  return grade;
}

SessionId complete_session(Store& store, const Account& student, const ScenarioVersion& version, double score,
                           bool passed) {
  const SessionId id = must(store.sessions.start(student.actor(), new_session(student, version))).id;
  must(store.traces.append(id, second_from(1)));
  must(store.traces.append(id, second_from(13)));
  add_key_state_row(store, id, {24, std::vector<std::byte>(30, std::byte{7}), {}});
  must(store.traces.append(id, second_from(25)));
  must(store.sessions.finish(id, volume_after(36), "student"));
  must(store.grades.save(id, small_grade(score, passed), blake2b_256(std::string_view{"rubric"})));
  return id;
}

}  // namespace cusp::test
