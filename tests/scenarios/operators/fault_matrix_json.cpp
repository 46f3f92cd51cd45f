// cusp-fault-matrix KEY: the fault matrix of one exercise as JSON, for fault_matrix.py. Minutes for a tooth.
// cusp-fault-matrix --judge FILE: what it printed once, by the criteria and cross-talk as they are now.
// Without an argument: the faults, with their sizes, criteria and cross-talk.
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/scenarios/operators/fault_matrix.h"

namespace cusp::test {
namespace {

using Json = nlohmann::ordered_json;

Json faults() {
  Json out = Json::array();
  for (const SingleFaultRow& row : single_faults()) {
    const FaultRules& rules = fault_rules()[static_cast<std::size_t>(row.fault)];
    out.push_back({{"fault", row.key}, {"unit", row.unit}, {"sizes", row.sizes}, {"reason", row.reason}, {"own", rules.own},
                   {"cross_talk", rules.cross_talk}, {"cross_talk_reason", rules.reason}});
  }
  return out;
}

Json json_of(const Graded& graded) {
  Json criteria = Json::object();
  for (const auto& [metric, at] : graded.criteria) criteria[metric] = {{"value", at.value}, {"share", at.share}, {"of_rubric", at.of_rubric}};
  return {{"score", graded.score}, {"criteria", criteria}};
}

// Each violation with its reason, where that is known.
Json violations_of(const FaultRow& row, SingleFault fault, std::string_view exercise) {
  Json out = Json::array();
  const auto add = [&](std::string_view what, double loss) {
    const auto reason = reason_known(fault, exercise, what);
    out.push_back({{"what", what}, {"loss", loss}, {"reason", reason ? Json(*reason) : Json()}});
  };
  if (!row.found()) add(kNotFound, row.own[2]);
  if (!row.in_order()) add(kNotInOrder, row.own[2]);
  for (const Loss& loss : row.foreign) add(loss.metric, loss.loss);
  return out;
}

Json json_of(const FaultRow& row, SingleFault fault, std::string_view exercise) {
  Json sizes = Json::array();
  for (const Graded& graded : row.sizes) sizes.push_back(json_of(graded));
  return {{"own", row.own}, {"own_metric", row.own_metric}, {"by_rubric", row.by_rubric}, {"violations", violations_of(row, fault, exercise)},
          {"sizes", sizes}};
}

Graded graded_of(const Json& json) {
  Graded out{{}, json.at("score")};
  for (const auto& [metric, at] : json.at("criteria").items()) out.criteria[metric] = {at.at("value"), at.at("share"), at.at("of_rubric")};
  return out;
}

int measure_exercise(const std::string& key) {
  const auto scenario = load_builtin(key);
  const auto dense = scenario ? std::optional(make_specimen(scenario->specimen, {})) : std::nullopt;
  if (!dense || !*dense) {
    std::cerr << "cusp-fault-matrix: no such exercise: " << key << "\n";
    return 1;
  }
  const FaultMatrix matrix(*scenario, Specimen::build(**dense, reading_of(scenario->method)));
  Json out = {{"exercise", key}, {"evaluator", Grade().evaluator}, {"reference", json_of(matrix.reference())}, {"faults", Json::object()}};
  for (const SingleFaultRow& row : single_faults()) {
    const auto made = matrix.row(row.fault);
    out["faults"][std::string(row.key)] = made ? json_of(*made, row.fault, key) : Json();
  }
  std::cout << out.dump(1) << "\n";
  return 0;
}

int judge_again(const std::string& file) {
  std::ifstream in(file);
  Json out = Json::parse(in);
  const std::string key = out.at("exercise");
  const Graded reference = graded_of(out.at("reference"));
  for (const SingleFaultRow& row : single_faults()) {
    Json& made = out["faults"][std::string(row.key)];
    if (made.is_null()) continue;
    std::array<Graded, 3> sizes;
    for (std::size_t size = 0; size < sizes.size(); ++size) sizes[size] = graded_of(made.at("sizes").at(size));
    made = json_of(judge(row.fault, reference, std::move(sizes)), row.fault, key);
  }
  std::cout << out.dump(1) << "\n";
  return 0;
}

}  // namespace
}  // namespace cusp::test

int main(int argc, char** argv) {
  if (argc == 3 && std::string_view(argv[1]) == "--judge") return cusp::test::judge_again(argv[2]);
  if (argc == 2) return cusp::test::measure_exercise(argv[1]);
  std::cout << cusp::test::faults().dump(1) << "\n";
  return argc == 1 ? 0 : 2;
}
