#include "scenarios/audit/audit.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scenarios/format/validate.h"

namespace cusp::scenarios {
namespace {

/// Findings that an exercise has beyond another's: a coarser voxel may leave a bur unresolved.
bool adds_findings(const Scenario& before, const Scenario& after) {
  const auto had = validate(before);
  for (const Finding& f : validate(after)) {
    const bool known = std::ranges::any_of(had, [&](const Finding& h) { return h.code == f.code && h.path == f.path; });
    if (!known) return true;
  }
  return false;
}

/// Students see the whole specimen and touch its surroundings; scenario.json has no key for band, region and single
/// tissues of a generated specimen; no scripted operator turns its handpiece by itself.
bool only_shown(Aspect aspect) noexcept {
  return aspect == Aspect::band || aspect == Aspect::region || aspect == Aspect::around || aspect == Aspect::tissue ||
         aspect == Aspect::tilt;
}

/// A share of the whole that rises from run to run. The number of runs is unknown: each takes a fixed part of the rest.
class Progress {
 public:
  explicit Progress(const AuditWatch& watch) : watch_(watch) {}
  AuditWatch next(double part_of_what_is_left) {
    from_ = to_;
    to_ = from_ + (1.0 - from_) * part_of_what_is_left;
    return [this](double share) { return !watch_ || watch_(from_ + (to_ - from_) * share); };
  }

 private:
  const AuditWatch& watch_;
  double from_ = 0, to_ = 0;
};

class Search {
 public:
  Search(const Scenario& scenario, const AuditSettings& settings, const AuditRunner& runner, const AuditWatch& watch)
      : settings_(settings), runner_(runner), progress_(watch) {
    report_.scenario = scenario;
    report_.tolerance_points = scenario.tolerance_points;
    report_.operators = settings.operators;
    report_.leanest = scenario;
  }

  Result<AuditReport, AuditFailure> run() {
    if (auto done = measure_choices(); !done) return std::unexpected(done.error());
    if (auto done = settle_detail(); !done) return std::unexpected(done.error());
    if (auto done = coarsen(); !done) return std::unexpected(done.error());
    if (auto done = leave_out(); !done) return std::unexpected(done.error());
    if (auto done = prove(); !done) return std::unexpected(done.error());
    return std::move(report_);
  }

 private:
  using Done = Result<void, AuditFailure>;
  using Played = std::vector<std::optional<ModelResult>>;

  Result<Played, AuditFailure> play(const std::vector<Scenario>& scenarios, double part) {
    AuditRun run;
    run.home = report_.scenario;
    for (const Scenario& s : scenarios) run.models.push_back({s});
    run.operators = settings_.operators;
    run.costs = false;
    return runner_(run, progress_.next(part));
  }

  Done measure_choices() {
    AuditRun run;
    run.home = report_.scenario;
    run.operators = settings_.operators;
    run.models.push_back({report_.scenario});
    auto choices = choices_of(report_.scenario);
    if (settings_.detail_alone) std::erase_if(choices, [](const Choice& c) { return c.aspect != Aspect::voxel; });
    for (const Choice& c : choices) run.models.push_back(with(run.models.front(), c));
    auto played = runner_(run, progress_.next(0.5));
    if (!played) return std::unexpected(played.error());
    if (!played->front()) return fail(AuditError::unplayable, report_.scenario.key);
    report_.as_set = std::move(*played->front());
    ground_ = report_.as_set;
    ground_scenario_ = report_.scenario;
    for (std::size_t i = 0; i < choices.size(); ++i) {
      AuditRow row;
      row.choice = choices[i];
      row.result = std::move((*played)[i + 1]);
      if (!row.result) {
        row.verdict = Verdict::unplayable;
      } else {
        row.change = change_between(report_.as_set, *row.result);
        row.verdict = verdict_of(row);
      }
      report_.rows.push_back(std::move(row));
    }
    return {};
  }

  Verdict verdict_of(const AuditRow& row) const {
    if (!row.change.within(report_.tolerance_points)) return Verdict::needed;
    const bool finer = row.choice.aspect == Aspect::voxel && row.choice.instead < row.choice.as_set;
    if (only_shown(row.choice.aspect) || finer) return Verdict::shown;
    const Model model = with({report_.scenario}, row.choice);
    return adds_findings(report_.scenario, model.scenario) ? Verdict::unresolved : Verdict::not_needed;
  }

  static Scenario at(Scenario s, double voxel_mm) {
    s.specimen.voxel_mm = voxel_mm;
    return s;
  }
  std::optional<Scenario> halved(const Scenario& s) const {
    const double half = s.specimen.voxel_mm / 2;
    for (const Choice& c : choices_of(s)) {
      if (c.aspect == Aspect::voxel && c.instead < c.as_set) return at(s, half);
    }
    return std::nullopt;
  }

  /// If half the voxel's edge grades differently, the detail is too coarse: the ground becomes the coarsest finer size that
  /// agrees with its own half.
  Done settle_detail() {
    AuditRow* half = nullptr;
    for (AuditRow& row : report_.rows) {
      if (row.choice.aspect == Aspect::voxel && row.choice.instead < row.choice.as_set) half = &row;
    }
    if (!half || !half->result || half->change.within(report_.tolerance_points)) return {};
    const Scenario half_of_it = at(report_.scenario, half->choice.instead);
    if (auto done = in_mean_if_beyond(half->change, report_.scenario, report_.as_set, half_of_it, *half->result); !done) return done;
    half->verdict = verdict_of(*half);
    if (half->change.within(report_.tolerance_points)) return {};
    settled_ = false;
    for (const double mm : finer_voxels(report_.scenario)) {
      const Scenario finer = at(report_.scenario, mm);
      const auto beside = halved(finer);
      if (!beside) break;
      auto played = play({finer, *beside}, 0.15);
      if (!played) return std::unexpected(played.error());
      if (!(*played)[0] || !(*played)[1]) continue;
      GradeChange change = change_between(*(*played)[0], *(*played)[1]);
      if (auto done = in_mean_if_beyond(change, finer, *(*played)[0], *beside, *(*played)[1]); !done) return std::unexpected(done.error());
      const bool holds = change.within(report_.tolerance_points);
      report_.steps.push_back({{Aspect::voxel, {}, report_.scenario.specimen.voxel_mm, mm}, holds, change});
      if (!holds) continue;
      ground_ = std::move(*(*played)[0]);
      report_.leanest_result = ground_;
      ground_scenario_ = report_.leanest = finer;
      report_.at_half_voxel = change;
      settled_ = true;
      break;
    }
    return {};
  }

  /// The operators beyond the tolerance feel both models in several attempts each. If one cannot be played, `change` stays.
  Done in_mean_if_beyond(GradeChange& change, const Scenario& from, const ModelResult& before, const Scenario& to,
                         const ModelResult& after) {
    if (change.within(report_.tolerance_points)) return {};
    const std::vector<std::string> operators = operators_beyond(before, after, report_.tolerance_points);
    std::vector<AuditOperator> attempts;
    for (const std::string& name : operators) add_attempts(attempts, name, 1, settings_.attempts_for_means);
    auto played = play_felt({{from}, {to}}, attempts, 0.3);
    if (!played) return std::unexpected(played.error());
    if (!(*played)[0] || !(*played)[1]) return {};
    ModelResult &a = *(*played)[0], &b = *(*played)[1];
    attempts.clear();
    for (const std::string& name : operators) {
      const int wanted = attempts_to_decide(a, b, name, report_.tolerance_points);
      add_attempts(attempts, name, settings_.attempts_for_means + 1, std::min(wanted, settings_.max_attempts_for_means));
    }
    const GradeChange had = mean_change_between(a, b);
    const bool beyond = !had.within(report_.tolerance_points) && had.decided(report_.tolerance_points);
    if (!attempts.empty() && !beyond) {  // one operator that is beyond decides for all
      auto more = play_felt({{from}, {to}}, attempts, 0.4);
      if (!more) return std::unexpected(more.error());
      if (!(*more)[0] || !(*more)[1]) return {};
      std::ranges::move((*more)[0]->attempts, std::back_inserter(a.attempts));
      std::ranges::move((*more)[1]->attempts, std::back_inserter(b.attempts));
    }
    change = joined(mean_change_between(a, b), before, after, operators);
    return {};
  }

  static void add_attempts(std::vector<AuditOperator>& attempts, const std::string& name, int first, int last) {
    for (int seed = first; seed <= last; ++seed) attempts.push_back({name, static_cast<std::uint64_t>(seed)});
  }
  Result<Played, AuditFailure> play_felt(std::vector<Model> models, std::vector<AuditOperator> operators, double part) {
    AuditRun run;
    run.home = report_.scenario;
    run.models = std::move(models);
    run.operators = std::move(operators);
    run.costs = false;
    run.felt = true;
    return runner_(run, progress_.next(part));
  }

  /// The coarsest voxels that grade as the ground does, and as their own half does.
  Done coarsen() {
    // A model that differs from its own half cannot judge another.
    if (!settled_ || !(ground_scenario_ == report_.scenario)) return {};
    for (const double mm : coarser_voxels(ground_scenario_)) {
      const Scenario coarser = at(report_.leanest, mm);
      const auto beside = halved(coarser);
      if (!beside || adds_findings(report_.scenario, coarser)) continue;
      auto played = play({coarser}, 0.1);
      if (!played) return std::unexpected(played.error());
      if (!(*played)[0]) continue;
      AuditStep step{{Aspect::voxel, {}, ground_scenario_.specimen.voxel_mm, mm}, false, change_between(ground_, *(*played)[0])};
      if (!step.change.within(report_.tolerance_points)) {  // its half, eight times the voxels, is not needed
        report_.steps.push_back(step);
        continue;
      }
      auto finer = play({*beside}, 0.1);
      if (!finer) return std::unexpected(finer.error());
      if (!(*finer)[0]) continue;
      const GradeChange half = change_between(*(*played)[0], *(*finer)[0]);
      step.taken = half.within(report_.tolerance_points);
      if (!step.taken && std::abs(half.score) > std::abs(step.change.score)) step.change.score = half.score;
      report_.steps.push_back(step);
      if (!step.taken) continue;
      report_.leanest = coarser;
      report_.leanest_result = std::move(*(*played)[0]);
      report_.at_half_voxel = half;
      break;
    }
    return {};
  }

  /// The rest one after another, the one that saves most time first.
  Done leave_out() {
    std::vector<const AuditRow*> candidates;
    for (const AuditRow& row : report_.rows) {
      if (row.verdict == Verdict::not_needed && row.choice.aspect != Aspect::voxel) candidates.push_back(&row);
    }
    std::ranges::stable_sort(candidates, {}, [](const AuditRow* row) { return row->result->cost.us_more; });
    for (const AuditRow* row : candidates) {
      const Scenario leaner = with({report_.leanest}, row->choice).scenario;
      if (leaner == report_.leanest) continue;  // another choice removed it already
      auto played = play({leaner}, 0.15);
      if (!played) return std::unexpected(played.error());
      if (!(*played)[0]) continue;
      const GradeChange change = change_between(ground_, *(*played)[0]);
      report_.steps.push_back({row->choice, change.within(report_.tolerance_points), change});
      if (!report_.steps.back().taken) continue;
      report_.leanest = leaner;
      report_.leanest_result = std::move(*(*played)[0]);
      report_.at_half_voxel.reset();
    }
    return {};
  }

  /// All of it together at half its voxels, and what it costs beside the exercise as it was.
  Done prove() {
    if (!report_.at_half_voxel) {
      if (auto done = prove_detail(); !done) return done;
    }
    if (!report_.changed()) return {};
    if (auto done = play_leanest(); !done || !report_.changed()) return done;
    AuditRun run;
    run.home = report_.scenario;
    run.models = {{report_.scenario}, {report_.leanest}};
    auto costs = runner_(run, progress_.next(0.9));
    if (!costs) return std::unexpected(costs.error());
    report_.leanest_change = change_between(report_.as_set, *report_.leanest_result);
    if (!(*costs)[1]) return {};
    ModelResult& leanest = *report_.leanest_result;
    leanest.cost = (*costs)[1]->cost;
    leanest.force_rms_n = (*costs)[1]->force_rms_n;
    leanest.force_most_n = (*costs)[1]->force_most_n;
    return {};
  }

  /// Every operator feels the leanest and must pass or fail as before; else the leanest is dropped.
  Done play_leanest() {
    auto played = play_felt({{report_.leanest}}, settings_.operators, 0.6);
    if (!played) return std::unexpected(played.error());
    if ((*played)[0]) report_.leanest_attempts = (*played)[0]->attempts;
    if ((*played)[0] && change_between(report_.as_set, *(*played)[0]).passes_alike) return {};
    for (AuditStep& step : report_.steps) step.taken = false;
    report_.leanest = report_.scenario;
    report_.leanest_result.reset();
    report_.at_half_voxel.reset();
    return prove_detail();
  }

  Done prove_detail() {
    const auto beside = halved(report_.leanest);
    if (!beside) return {};
    if (!report_.changed()) {
      for (const AuditRow& row : report_.rows) {
        if (row.choice.aspect == Aspect::voxel && row.choice.instead < row.choice.as_set && row.result)
          report_.at_half_voxel = row.change;
      }
      return {};
    }
    auto played = play({*beside}, 0.6);
    if (!played) return std::unexpected(played.error());
    if (!(*played)[0]) return {};
    report_.at_half_voxel = change_between(*report_.leanest_result, *(*played)[0]);
    return in_mean_if_beyond(*report_.at_half_voxel, report_.leanest, *report_.leanest_result, *beside, *(*played)[0]);
  }

  const AuditSettings& settings_;
  const AuditRunner& runner_;
  Progress progress_;
  AuditReport report_;
  ModelResult ground_;        // every step is compared with it
  bool settled_ = true;       // its detail holds
  Scenario ground_scenario_;  // its exercise: as set, or in the finer detail that it needs
};

}  // namespace

std::string_view key_of(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::needed: return "needed";
    case Verdict::not_needed: return "not_needed";
    case Verdict::shown: return "shown";
    case Verdict::unplayable: return "unplayable";
    case Verdict::unresolved: return "unresolved";
  }
  return "needed";
}

Result<AuditReport, AuditFailure> audit(const Scenario& scenario, const AuditSettings& settings, const AuditRunner& runner,
                                        const AuditWatch& watch) {
  return Search(scenario, settings, runner, watch).run();
}

}  // namespace cusp::scenarios
