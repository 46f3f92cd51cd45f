/// Broken scenarios: each is refused with its place and a reason, or it can be played and gives an idle student nothing.
/// Seeded; a part by default, all of it with CUSP_FULL.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "scenarios/checks/checks.h"
#include "scenarios/format/read.h"
#include "scenarios/format/validate.h"
#include "scenarios/grading/grader.h"
#include "scenarios/library/library.h"
#include "scenarios/metrics/measure.h"
#include "scenarios/specimens/specimens.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

using nlohmann::json;


/// A specimen with what the checks know of it. Teeth are measured in voxels of 0.4 mm at least: what is asked of them here
/// does not hang on the fineness.
struct Built {
  SpecimenFacts facts;
  std::shared_ptr<const Specimen> specimen;
};

class Outcomes {
 public:
  int refused = 0, playable = 0, wrong = 0;

  void take(const std::string& text, const std::string& what) {
    const std::vector<Finding> form = validate_text(text);
    if (has_error(form)) return refuse(form, what);
    auto scenario = read_scenario(text);
    if (!scenario) return miss(what, "validate took what does not read");
    scenario->specimen.voxel_mm = std::max(scenario->specimen.voxel_mm, 0.4);
    const Built* built = specimen_of(*scenario);
    if (built == nullptr) return refuse_specimen(*scenario, what);
    std::vector<Finding> more = validate(*scenario, &built->facts);
    if (scenario->specimen.generator == "paper-block") std::erase_if(more, [](const Finding& f) { return f.code == "voxel_mismatch"; });
    if (has_error(more)) return refuse(more, what);
    const std::vector<Finding> checks = check_exercise(*scenario, built->specimen);
    if (has_error(checks)) return refuse(checks, what);
    const Reference reference(*scenario, built->specimen);
    StepOutput waited;
    waited.elapsed_us = 5'000'000;
    Process process;
    process.add(waited);
    const Grade idle = grade(*scenario, measure(reference, Volume(built->specimen), process));
    if (idle.passed || idle.score != 0.0 || !std::isfinite(idle.score)) return miss(what, "idleness earns " + std::to_string(idle.score));
    ++playable;
  }

 private:
  void miss(const std::string& what, const std::string& why) {
    ++wrong;
    ADD_FAILURE() << what << ": " << why;
  }
  void refuse(const std::vector<Finding>& findings, const std::string& what) {
    for (const Finding& f : findings) {
      if (f.severity != Severity::error) continue;
      // The whole document has the empty path.
      const bool placed = !f.path.empty() || f.code == "wrong_type" || f.code == "schema";
      if (f.code.empty() || !placed) return miss(what, "refused without a place or a reason: " + f.code + " " + f.path);
    }
    ++refused;
  }
  void refuse_specimen(const Scenario& s, const std::string& what) {
    const auto made = make_specimen(s.specimen, {});
    if (made || made.error().where.empty()) return miss(what, "no specimen, and no place");
    ++refused;
  }
  /// Grown once each; nullptr where it cannot be.
  const Built* specimen_of(const Scenario& s) {
    const bool filled = reading_of(s.method) == Reading::filled;
    auto& found = built_[json({s.specimen.generator, s.specimen.fdi, s.specimen.seed, s.specimen.voxel_mm, filled,
                               s.specimen.around, s.specimen.typodont, s.specimen.volume}).dump()];
    if (found) return found->specimen ? &*found : nullptr;
    found.emplace();
    auto volume = make_specimen(s.specimen, {});
    if (!volume) return nullptr;
    found->facts = facts_of(*volume);
    found->specimen = Specimen::build(*volume, reading_of(s.method));
    return &*found;
  }
  std::map<std::string, std::optional<Built>> built_;
};

/// Pointers to every value of a document, itself left out.
enum class Nodes : std::uint8_t { all, numbers };

void places_of(const json& node, const std::string& at, Nodes which, std::vector<std::string>& out) {
  if (!at.empty() && (which == Nodes::all || node.is_number())) out.push_back(at);
  if (!node.is_structured()) return;
  for (const auto& [key, value] : node.items()) places_of(value, at + "/" + key, which, out);
}

/// A document with one value as bare text: NaN and 1e999 are no JSON that the library would write.
std::string with_text(json document, const std::string& place, const std::string& bare) {
  const std::string mark = "@@here@@";
  document[json::json_pointer(place)] = mark;
  std::string text = document.dump();
  return text.replace(text.find('"' + mark + '"'), mark.size() + 2, bare);
}

constexpr std::array kBareNumbers = {"0", "-1", "1e-300", "1e300", "NaN", "-Infinity", "1e999", "99999999999999999999999", "-0.0", "1e-9"};

TEST(Mutations, EveryNumberOfEveryExerciseIsRefusedOrHarmlessWhateverItBecomes) {
  Outcomes outcomes;
  std::size_t n = 0;
  for (const std::string_view key : builtin_scenarios()) {
    const json document = json::parse(builtin_scenario_text(key));
    std::vector<std::string> places;
    places_of(document, "", Nodes::numbers, places);
    for (const std::string& place : places)
      for (const char* bare : kBareNumbers) {
        if (!full_run() && n++ % 661 != 0) continue;
        outcomes.take(with_text(document, place, bare), std::string(key) + place + " = " + bare);
      }
  }
  std::printf("numbers: %d refused, %d playable, %d wrong\n", outcomes.refused, outcomes.playable, outcomes.wrong);
  EXPECT_GT(outcomes.refused, 0);
  EXPECT_GT(outcomes.playable, 0);
}

class Mutator {
 public:
  explicit Mutator(std::uint64_t seed) : random_(seed) {}

  /// One to three changes; what they were is appended to `what`.
  std::string mutate(json document, std::string& what) {
    std::string text;
    for (int left = 1 + pick(3); left > 0; --left) {
      const int kind = pick(9);
      what += " kind " + std::to_string(kind);
      if (kind == 8) {
        text = document.dump();
        return text.substr(0, static_cast<std::size_t>(pick(static_cast<int>(text.size()))));
      }
      if (kind <= 1) {
        const std::string place = place_in(document, Nodes::numbers);
        what += " " + place;
        text = with_text(document, place, kBareNumbers[static_cast<std::size_t>(pick(kBareNumbers.size()))]);
        const json next = json::parse(text, nullptr, false);
        if (next.is_discarded()) return text;
        document = next;
      } else {
        change(document, kind, what);
      }
    }
    return document.dump();
  }

 private:
  int pick(std::size_t count) { return static_cast<int>(random_() % std::max<std::size_t>(count, 1)); }
  std::string place_in(const json& document, Nodes which) {
    std::vector<std::string> places;
    places_of(document, "", which, places);
    return places.empty() ? "/format" : places[static_cast<std::size_t>(pick(places.size()))];
  }
  json other_type() {
    const std::array<json, 7> values = {nullptr, true, "text", 7, 0.5, json::array(), json::object()};
    return values[static_cast<std::size_t>(pick(values.size()))];
  }
  void change(json& document, int kind, std::string& what) {
    const json::json_pointer at(place_in(document, kind == 5 ? Nodes::numbers : Nodes::all));
    what += " " + at.to_string();
    if (!document.contains(at)) return;
    json& parent = document[at.parent_pointer()];
    if (kind == 2) {
      document[at] = other_type();
    } else if (kind == 3) {
      if (parent.is_object()) parent.erase(at.back());
      else parent.erase(static_cast<std::size_t>(std::stoul(at.back())));
    } else if (kind == 4) {
      if (parent.is_object()) parent["extra"] = 1;
      else parent.push_back(parent.front());
    } else if (kind == 5) {
      const json::json_pointer with(place_in(document, Nodes::numbers));
      what += " with " + with.to_string();
      std::swap(document[at], document[with]);
    } else if (kind == 6) {
      const json::json_pointer from(place_in(document, Nodes::all));
      const json copy = document[from];
      document[at] = copy;
    } else if (document[at].is_number()) {
      document[at] = document[at].get<double>() * std::pow(10.0, pick(13) - 6);
    }
  }
  std::mt19937_64 random_;
};

TEST(Mutations, TwoThousandBrokenScenariosAreRefusedOrHarmless) {
  Outcomes outcomes;
  const auto keys = builtin_scenarios();
  const std::uint64_t count = full_run() ? 2000 : 100;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    Mutator mutator(seed);
    const std::string_view key = keys[seed % keys.size()];
    std::string what = "seed " + std::to_string(seed) + " " + std::string(key);
    const std::string text = mutator.mutate(json::parse(builtin_scenario_text(key)), what);
    outcomes.take(text, what);
  }
  std::printf("mutated: %d refused, %d playable, %d wrong\n", outcomes.refused, outcomes.playable, outcomes.wrong);
  EXPECT_GT(outcomes.refused, 0);
}

}  // namespace
}  // namespace cusp::test
