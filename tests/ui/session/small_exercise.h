/// A small exercise, a scripted operator for it, and a database in a folder of its own: for tests of sessions.
#pragma once

#include <filesystem>
#include <string>

#include "scenarios/grading/grade.h"
#include "storage/store.h"
#include "tests/engine/loop/block_scene.h"
#include "tests/modules.h"
#include "ui/session/exercise_session.h"

namespace cusp::test {

inline Scenario small_exercise() {
  Scenario scenario;
  scenario.id = *ScenarioId::parse("01890a5d-ac96-774b-bcce-b302099a8057");
  scenario.title["en"] = "Small block";
  scenario.briefing["en"] = "Drill.";
  scenario.specimen.generator = "block";
  scenario.specimen.voxel_mm = 0.15;
  scenario.tissues = {{Tissue::plastic, 1.0, 4.0}};
  scenario.instruments = block_burs();
  scenario.target.outline.shape = "channel";
  scenario.target.outline.paths = {{{-0.6, 0.6, 0.0}, {0.6, 0.6, 0.0}}};
  scenario.target.outline.width_mm = 1.4;
  scenario.target.outline.depth_mm = 1.0;
  scenario.rubric.pass = 60;
  scenario.rubric.criteria = {{"target_removed", 60, {0, 30, 90, 100, 100, 100}},
                              {"overcut_beyond_side", 40, {0, 0, 0, 0.2, 1, 3}}};
  return scenario;
}

/// Passwords cost next to nothing in tests.
inline StoreOptions quick_store() {
  StoreOptions options;
  options.cost = PasswordCost::least();
  return options;
}

class Workplace {
 public:
  Workplace() {
    std::string name = (std::filesystem::temp_directory_path() / "cusp-session-XXXXXX").string();
    folder = name.substr(0, name.size() - 6) + Uuid::v7().text();
    std::filesystem::create_directories(folder);
    auto store = Store::open(database(), quick_store());
    demo = store.value()->accounts.demo_student().value();
  }
  ~Workplace() { std::filesystem::remove_all(folder); }
  std::filesystem::path database() const { return folder / "cusp.db"; }
  SessionPlan plan() const {
    SessionPlan plan;
    plan.scenario = small_exercise();
    plan.specimen = Specimen::build(block_volume(), Reading::banded);
    plan.database = database();
    plan.student = demo.actor();
    plan.operator_name = "test";
    return plan;
  }
  std::unique_ptr<Store> store() const { return std::move(Store::open(database(), quick_store()).value()); }

  std::filesystem::path folder;
  Account demo;
};

}  // namespace cusp::test
