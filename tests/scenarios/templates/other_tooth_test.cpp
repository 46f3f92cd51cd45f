// Exercises of templates on other grown teeth of their number: what follows the tooth, what stays, and what is refused.

#include "scenarios/templates/other_tooth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scenarios/checks/checks.h"
#include "scenarios/format/validate.h"
#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "scenarios/templates/templates.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

Scenario builtin(std::string_view key) { return load_builtin(key).value(); }

/// The exercises of the program that a template made.
std::vector<Scenario> made_with_templates() {
  std::vector<Scenario> out;
  for (const std::string_view key : builtin_scenarios())
    if (Scenario one = builtin(key); one.made_with) out.push_back(std::move(one));
  return out;
}

OtherToothFailure refused(const Scenario& exercise) {
  return bound_to_its_tooth(exercise).value_or(OtherToothFailure{OtherToothError::does_not_fit, "it was taken"});
}

TEST(OtherTooth, EveryExerciseThatNamesATemplateIsWhatThatTemplateMakesOfItsTooth) {
  const auto all = made_with_templates();
  EXPECT_EQ(all.size(), 12u);
  for (const Scenario& one : all) {
    const auto bound = bound_to_its_tooth(one);
    EXPECT_FALSE(bound) << one.key << " " << bound->where;
  }
}

TEST(OtherTooth, ItsOwnSeedGivesTheExerciseItself) {
  const Scenario own = builtin("class-2-26-do");
  const auto same = on_other_tooth(own, own.specimen.seed);
  ASSERT_TRUE(same);
  EXPECT_TRUE(*same == own);
}

TEST(OtherTooth, TargetAndBandsFollowTheToothAndWhatTheAuthorSetStays) {
  Scenario own = builtin("class-2-26-do");
  EXPECT_FALSE(keeps_its_texts(own));
  own.title["en"] = "Examination, spring";
  own.time_limit_s = 1200;
  own.rubric.criteria.front().weight = 33;
  own.rubric.criteria.front().bands.ideal_lo = 95.5;
  own.rubric.pass = 60;
  EXPECT_TRUE(keeps_its_texts(own));
  const auto other = on_other_tooth(own, 7);
  ASSERT_TRUE(other);
  EXPECT_EQ(other->specimen.seed, 7u);
  EXPECT_FALSE(other->target == own.target);
  EXPECT_FALSE(has_error(validate(*other)));
  EXPECT_EQ(other->title.at("en"), "Examination, spring");
  EXPECT_EQ(other->title.at("de"), own.title.at("de"));
  EXPECT_EQ(other->rubric.criteria.front(), own.rubric.criteria.front());
  Scenario but_for_the_tooth = *other;
  but_for_the_tooth.specimen = own.specimen;
  but_for_the_tooth.target = own.target;
  but_for_the_tooth.protected_parts = own.protected_parts;
  but_for_the_tooth.briefing = own.briefing;
  for (std::size_t i = 0; i < own.rubric.criteria.size(); ++i) but_for_the_tooth.rubric.criteria[i].bands = own.rubric.criteria[i].bands;
  EXPECT_TRUE(but_for_the_tooth == own) << "nothing else may change";
}

TEST(OtherTooth, AnExerciseDrawnByHandOrEditedKeepsItsTooth) {
  EXPECT_EQ(refused(builtin("class-1-36")).code, OtherToothError::by_hand);
  Scenario of_a_file = builtin("class-1-46");
  of_a_file.specimen.generator.clear();
  of_a_file.specimen.volume = "tooth.nrrd";
  EXPECT_EQ(refused(of_a_file).code, OtherToothError::by_hand);
  Scenario edited = builtin("class-1-46");
  edited.target.outline.depth_mm += 0.1;
  EXPECT_EQ(refused(edited).where, "/target");
  EXPECT_FALSE(on_other_tooth(edited, 1));
  Scenario spares_more = builtin("class-1-46");
  spares_more.protected_parts.emplace_back(Tissue::dentine);
  EXPECT_EQ(refused(spares_more).where, "/protected");
  Scenario sicker = builtin("caries-26");
  sicker.specimen.lesions.front().depth_mm += 0.1;
  EXPECT_EQ(refused(sicker).where, "/specimen/lesions");
  Scenario of_a_newer_program = builtin("class-1-46");
  of_a_newer_program.made_with->key = "class-9";
  EXPECT_EQ(refused(of_a_newer_program).code, OtherToothError::does_not_fit);
  EXPECT_EQ(refused(of_a_newer_program).where, "unknown_template");
}

TEST(OtherTooth, AValueThatItsTemplateNoLongerHasBindsNoExercise) {
  Scenario older = builtin("class-2-36-do");
  older.made_with->values["no_more"] = 3.0;
  EXPECT_FALSE(bound_to_its_tooth(older));
}

TEST(OtherTooth, AnUpperMolarWithoutRoomForItsSecondTargetIsRefused) {
  const Scenario two = builtin("class-1-16");
  ASSERT_EQ(two.target.parts.size(), 2u);
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto other = on_other_tooth(two, seed);
    if (!other) {
      EXPECT_EQ(other.error().code, OtherToothError::does_not_fit) << seed;
      continue;
    }
    EXPECT_EQ(other->target.parts.size(), 2u) << seed;
    EXPECT_EQ(other->target.parts[1].name, two.target.parts[1].name) << seed;
  }
}

// A third of the seeds must do: a candidate's tooth is drawn until one does.
TEST(OtherTooth, SuitsManyTeethOfEachExercise) {
  const int seeds = full_run() ? 12 : 2;
  for (const Scenario& own : made_with_templates()) {
    if (!full_run() && own.key != "class-1-46") continue;
    int suited = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
      const auto other = on_other_tooth(own, static_cast<std::uint64_t>(seed));
      if (!other) continue;
      const auto voxels = make_specimen(other->specimen, {});
      ASSERT_TRUE(voxels) << own.key << " " << seed;
      const auto findings = check_exercise(*other, Specimen::build(*voxels, Reading::banded));
      for (const Finding& f : findings)
        if (f.severity == Severity::error) std::printf("%s, tooth %d: %s %s\n", own.key.c_str(), seed, f.path.c_str(), f.code.c_str());
      suited += !has_error(findings);
    }
    std::printf("%s: %d of %d teeth\n", own.key.c_str(), suited, seeds);
    EXPECT_GE(3 * suited, seeds) << own.key;
  }
}

}  // namespace
}  // namespace cusp::test
