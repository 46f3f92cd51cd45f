#include "ui/session/audit_run.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <memory>

#include "engine/base/fp_guard.h"
#include "engine/loop/haptic_loop.h"
#include "engine/mirror/fragment_finder.h"
#include "scenarios/grading/grader.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/operators/faults.h"
#include "scenarios/operators/operator_port.h"
#include "scenarios/specimens/specimens.h"
#include "ui/modules.h"
#include "ui/session/cpu_meter.h"
#include "ui/session/scene_builder.h"

namespace cusp::ui {
namespace {

// Costs: what an expert does first, in ticks of 1 ms, in blocks that the models take in turn.
constexpr std::uint64_t kBlockTicks = 500;
constexpr std::size_t kBlocks = 24;
// As play_through: searched for fragments this often.
constexpr std::uint64_t kAuditTurn = 25;
constexpr double kSwayS = 4.0;  // [M] period of the handpiece turning from side to side, where the exercise lets it turn

/// A model as the engine takes it.
struct Table {
  Scenario scenario;
  std::shared_ptr<const Specimen> specimen;
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const Reference> reference;
  double start_s = 0;
  std::uint64_t bytes = 0;
};

/// Progress in [0, 1]; false: stop.
using Progress = std::function<bool(double share)>;

Outcome<Table> make_table(const Model& model, const std::filesystem::path& folder, const Progress& progress) {
  Table out;
  out.scenario = model.scenario;
  const double began = thread_cpu_s();
  std::atomic<bool> stop = false;
  auto dense = make_specimen(model.scenario.specimen, folder, &stop, [&](double share) { stop = stop || !progress(share); });
  if (!dense) return session_fail(SessionError::specimen, dense.error());
  const double grown = thread_cpu_s();
  *dense = prepared(std::move(*dense), model);
  const double ready = thread_cpu_s();
  const std::uint64_t before = heap_bytes();
  out.specimen = Specimen::build(*dense, reading_of(model.scenario.method));
  OperatorPort device(ScriptedOperator({}, {}, model.scenario));
  auto scene = build_scene(model.scenario, out.specimen, device.limits());
  if (!scene) return std::unexpected(scene.error());
  out.scene = std::move(*scene);
  {
    const StepState state(out.scene);
    const std::uint64_t after = heap_bytes();
    out.bytes = after > before ? after - before : 0;
  }
  // What preparing takes is the audit's, not the exercise's.
  out.start_s = (grown - began) + (thread_cpu_s() - ready);
  out.reference = std::make_shared<const Reference>(out.scenario, out.specimen);
  return out;
}

using Tables = std::vector<std::shared_ptr<const Table>>;  // null: cannot be played

/// A scripted operator that sways the handpiece where the exercise lets it turn.
class Swaying final : public HapticPort {
 public:
  Swaying(ScriptedOperator scripted, double dt_s, double turn_deg) : operator_(std::move(scripted), dt_s), dt_s_(dt_s), turn_deg_(turn_deg) {}
  Result<void, PortFailure> open() override { return {}; }
  Sample wait(std::chrono::steady_clock::time_point deadline) noexcept override {
    Sample sample = operator_.wait(deadline);
    if (turn_deg_ > 0) {
      const double half = 0.25 * turn_deg_ * (3.141592653589793 / 180.0) * std::sin(6.283185307179586 * clock_s_ / kSwayS);
      sample.orientation = {std::cos(half), std::sin(half), 0.0, 0.0};
    }
    clock_s_ += dt_s_;
    return sample;
  }
  void write(const Feedback& feedback) noexcept override { operator_.write(feedback); }
  DeviceLimits limits() const override { return operator_.limits(); }
  void close() noexcept override {}

 private:
  OperatorPort operator_;
  double dt_s_, turn_deg_, clock_s_ = 0;
};

/// The same path once more, whatever is felt.
class Replayed final : public HapticPort {
 public:
  explicit Replayed(const std::vector<StepInput>& path) : path_(path) {}
  Result<void, PortFailure> open() override { return {}; }
  Sample wait(std::chrono::steady_clock::time_point) noexcept override {
    Sample sample;
    if (next_ >= path_.size()) return sample;
    const StepInput& input = path_[next_++];
    sample.status = Sample::Status::fresh;
    sample.position_mm = input.position_mm();
    sample.orientation = {input.qw / 32767.0, input.qx / 32767.0, input.qy / 32767.0, input.qz / 32767.0};
    sample.buttons = input.buttons;
    sample.bur = input.bur;
    return sample;
  }
  void write(const Feedback&) noexcept override {}
  DeviceLimits limits() const override { return {}; }
  void close() noexcept override {}

 private:
  const std::vector<StepInput>& path_;
  std::size_t next_ = 0;
};

struct AuditAttempt {
  Grade grade;
  std::vector<StepInput> path;
  double seconds = 0;
  std::uint64_t lost = 0;
  bool touched = false;
};

/// As play_through plays, without mirror and record. nullopt: stopped.
std::optional<AuditAttempt> play(const Table& table, HapticPort& port, const std::function<bool()>& go_on) {
  LoopSettings settings;
  settings.period = std::chrono::microseconds(kAuditTickUs);
  VirtualLoop loop(port, StepState(table.scene), settings);
  FragmentFinder finder(loop.hand_over());
  Process process;
  AuditAttempt out;
  for (std::uint64_t tick = 1; loop.run(1) == 1; ++tick) {
    StepInput input;
    while (loop.hand_over().inputs.pop(input)) out.path.push_back(input);
    const StepOutput& o = loop.state().last();
    process.add(o);
    out.touched = out.touched || o.contact;
    out.lost += (o.infeasible || o.overflow) ? 1 : 0;
    if (tick % kAuditTurn == 0) {
      finder.search(loop.state());
      if (!go_on()) return std::nullopt;
    }
  }
  DigestMark mark;
  while (loop.hand_over().marks.pop(mark)) {
  }
  out.seconds = process.time_s();
  out.grade = grade(table.scenario, measure(*table.reference, loop.state().volume(), process));
  return out;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// The samples of an expert's device, in ticks of 1 ms: up to the first touch, and so many ticks from there on.
struct Path {
  std::vector<StepInput> inputs;
  std::size_t touched_at = 0;
};
Path path_for_costs(const Table& table) {
  auto scripted = operator_by_name("expert", table.scenario, *table.specimen, 1);
  Path out;
  if (!scripted) return out;
  Swaying port(std::move(*scripted), 0.001, table.scenario.tool_turn_deg);
  StepState state(table.scene);
  StepInput last;
  bool touched = false;
  while (!touched || out.inputs.size() < out.touched_at + kBlockTicks * kBlocks) {
    const Sample sample = port.wait({});
    if (sample.status == Sample::Status::gone) break;
    last = quantise(sample, 1000, last);
    const StepOutput o = step(state, last);
    if (!touched) out.touched_at = out.inputs.size();
    touched = touched || o.contact;
    out.inputs.push_back(last);
    Feedback felt;
    felt.force_n = o.force_n;
    felt.proxy_mm = o.proxy_mm;
    felt.stiffness_n_per_mm = o.stiffness_n_per_mm;
    felt.in_contact = o.contact;
    felt.faulted = o.faulted;
    port.write(felt);
  }
  return out;
}

/// The models take the path in blocks, one after another in turn: whatever slows the machine slows all of a block's. False: stopped.
bool take_costs(const Tables& tables, std::vector<std::optional<ModelResult>>& results, const std::function<bool()>& go_on) {
  const FpGuard fp;
  const Path path = path_for_costs(*tables.front());
  struct Lane {
    StepState state;
    std::vector<double> us, more;
    std::uint64_t instructions = 0;
    double square_n2 = 0;
    std::size_t touched = 0;
  };
  std::vector<std::optional<Lane>> lanes;
  for (const auto& table : tables) {
    lanes.emplace_back();
    if (!table) continue;
    lanes.back().emplace(Lane{StepState(table->scene), {}, {}, 0, 0, 0});
    for (std::size_t i = 0; i < path.touched_at; ++i) static_cast<void>(step(lanes.back()->state, path.inputs[i]));
  }
  const InstructionCounter counter;
  const bool counts = counter.read().has_value();
  std::vector<Vec3> felt(kBlockTicks), first(kBlockTicks);
  for (std::size_t begin = path.touched_at; begin + kBlockTicks <= path.inputs.size(); begin += kBlockTicks) {
    for (std::size_t m = 0; m < lanes.size(); ++m) {
      if (!lanes[m]) continue;
      if (!go_on()) return false;
      Lane& lane = *lanes[m];
      const std::uint64_t counted = counter.read().value_or(0);
      const double at = thread_cpu_s();
      for (std::size_t i = 0; i < kBlockTicks; ++i) felt[i] = step(lane.state, path.inputs[begin + i]).force_raw_n;
      lane.us.push_back((thread_cpu_s() - at) * 1e6 / static_cast<double>(kBlockTicks));
      lane.instructions += counter.read().value_or(0) - counted;
      lane.more.push_back(lane.us.back() - lanes.front()->us.back());
      if (m == 0) first = felt;
      for (std::size_t i = 0; i < kBlockTicks; ++i) {
        if (first[i] == Vec3(0.0) && felt[i] == Vec3(0.0)) continue;
        const double apart = glm::length(felt[i] - first[i]);
        lane.square_n2 += apart * apart;
        ++lane.touched;
        results[m]->force_most_n = std::max(results[m]->force_most_n, apart);
      }
    }
  }
  for (std::size_t m = 0; m < lanes.size(); ++m) {
    if (!lanes[m]) continue;
    const Lane& lane = *lanes[m];
    ModelCost& cost = results[m]->cost;
    cost.us_a_tick = median(lane.us);
    cost.us_more = median(lane.more);
    if (counts && !lane.us.empty())
      cost.instructions_a_tick = static_cast<double>(lane.instructions) / static_cast<double>(lane.us.size() * kBlockTicks);
    if (lane.touched > 0) results[m]->force_rms_n = std::sqrt(lane.square_n2 / static_cast<double>(lane.touched));
    cost.start_s = tables[m]->start_s;
    cost.bytes = tables[m]->bytes;
  }
  return true;
}

/// Plays the models of one exercise, and keeps each operator's path through the exercise as it is.
class Player {
 public:
  explicit Player(std::filesystem::path folder) : folder_(std::move(folder)) {}
  Result<std::vector<std::optional<ModelResult>>, AuditFailure> play_all(const AuditRun& run, const AuditWatch& watch);

 private:
  struct Known {
    AuditOperator scripted;
    AuditAttempt attempt;
  };
  /// A model is grown once for as long as runs ask for it, and for one run longer: a jaw of fine voxels takes half a
  /// minute. The exercise as it is stays.
  struct CachedTable {
    Model model;
    std::shared_ptr<const Table> table;
    std::size_t asked_in = 0;
  };
  Outcome<std::shared_ptr<const Table>> table_of(const Model& model, const Progress& progress);
  void drop_unused(const AuditRun& run);
  /// The operator's own attempt at home; played once.
  Result<const AuditAttempt*, AuditFailure> at_home(const Scenario& home, const AuditOperator& who, const std::function<bool()>& go_on);
  Result<std::optional<AuditAttempt>, AuditFailure> felt(const Table& table, const AuditOperator& who, const std::function<bool()>& go_on);

  std::filesystem::path folder_;
  Scenario home_;
  std::shared_ptr<const Table> home_table_;
  std::deque<Known> known_;
  std::vector<CachedTable> tables_;
  std::size_t run_ = 0;
};

Outcome<std::shared_ptr<const Table>> Player::table_of(const Model& model, const Progress& progress) {
  for (CachedTable& one : tables_) {
    if (!(one.model == model)) continue;
    one.asked_in = run_;
    return one.table;
  }
  auto table = make_table(model, folder_, progress);
  if (!table) return std::unexpected(table.error());
  tables_.push_back({model, std::make_shared<const Table>(std::move(*table)), run_});
  return tables_.back().table;
}

void Player::drop_unused(const AuditRun& run) {
  ++run_;
  std::erase_if(tables_, [&](const CachedTable& one) {
    return one.asked_in + 1 < run_ && one.table != home_table_ && std::ranges::find(run.models, one.model) == run.models.end();
  });
}

Result<std::optional<AuditAttempt>, AuditFailure> Player::felt(const Table& table, const AuditOperator& who, const std::function<bool()>& go_on) {
  auto scripted = operator_by_name(who.name, table.scenario, *table.specimen, who.seed);
  if (!scripted || scripted->plan().strokes.empty()) return fail(AuditError::no_path, who.name);
  Swaying port(std::move(*scripted), kAuditTickUs * 1e-6, table.scenario.tool_turn_deg);
  return play(table, port, go_on);
}

Result<const AuditAttempt*, AuditFailure> Player::at_home(const Scenario& home, const AuditOperator& who, const std::function<bool()>& go_on) {
  if (!home_table_ || !(home_ == home)) {
    bool stop = false;
    auto table = table_of({home}, [&](double) { return !(stop = stop || !go_on()); });
    if (stop) return fail(AuditError::cancelled, {});
    if (!table) return fail(AuditError::unplayable, std::string(key_of(table.error().code)), table.error().where);
    home_table_ = std::move(*table);
    home_ = home;
    known_.clear();
  }
  for (const Known& one : known_)
    if (one.scripted == who) return &one.attempt;
  auto attempt = felt(*home_table_, who, go_on);
  if (!attempt) return std::unexpected(attempt.error());
  if (!*attempt) return fail(AuditError::cancelled, {});
  if (!(*attempt)->touched) return fail(AuditError::no_path, who.name);  // nothing would be compared
  known_.push_back({who, std::move(**attempt)});
  return &known_.back().attempt;
}

Result<std::vector<std::optional<ModelResult>>, AuditFailure> Player::play_all(const AuditRun& run, const AuditWatch& watch) {
  drop_unused(run);
  Tables tables;
  std::vector<std::optional<ModelResult>> results;
  const auto stopped = [] { return fail(AuditError::cancelled, {}); };
  // Making the tables counts as a tenth, the attempts as the rest.
  const double attempts = static_cast<double>(run.models.size() * run.operators.size());
  for (const Model& model : run.models) {
    bool stop = false;
    const auto progress = [&](double share) {
      stop = stop || (watch && !watch(0.1 * (static_cast<double>(tables.size()) + share) / static_cast<double>(run.models.size())));
      return !stop;
    };
    if (!progress(0.0)) return stopped();
    auto table = table_of(model, progress);
    if (stop) return stopped();
    if (!table && tables.empty()) return fail(AuditError::unplayable, std::string(key_of(table.error().code)), table.error().where);
    tables.push_back(table ? *table : nullptr);
    results.push_back(tables.back() ? std::optional<ModelResult>(ModelResult{}) : std::nullopt);
  }
  double done = 0;
  const auto go_on = [&] { return !watch || watch(0.1 + 0.9 * done / std::max(attempts, 1.0)); };
  if (run.costs && !take_costs(tables, results, go_on)) return stopped();
  for (const AuditOperator& who : run.operators) {
    const bool home_first = !run.models.empty() && run.models.front().scenario == run.home;
    Result<const AuditAttempt*, AuditFailure> home = nullptr;
    if (!run.felt || home_first) home = at_home(run.home, who, go_on);
    if (!home) return std::unexpected(home.error());
    for (std::size_t m = 0; m < tables.size(); ++m, ++done) {
      if (!tables[m]) continue;
      const bool is_home = home_first && m == 0;
      std::optional<AuditAttempt> own;
      if (run.felt && !is_home) {
        auto played = felt(*tables[m], who, go_on);
        if (!played) return std::unexpected(played.error());
        own = std::move(*played);
      } else if (!is_home) {
        Replayed replayed((*home)->path);
        own = play(*tables[m], replayed, go_on);
      }
      if (!own && !is_home) return stopped();
      const AuditAttempt& came = own ? *own : **home;
      results[m]->attempts.push_back({who, came.grade, came.seconds, came.lost});
    }
  }
  if (watch) static_cast<void>(watch(1.0));
  return results;
}

}  // namespace

AuditRunner audit_runner(std::filesystem::path folder) {
  return [player = std::make_shared<Player>(std::move(folder))](const AuditRun& run, const AuditWatch& watch) {
    return player->play_all(run, watch);
  };
}

}  // namespace cusp::ui
