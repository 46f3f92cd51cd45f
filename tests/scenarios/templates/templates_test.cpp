// Templates on every premolar and molar, their arithmetic, and what they refuse.

#include "scenarios/templates/templates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "scenarios/format/validate.h"
#include "scenarios/shapes/target.h"
#include "scenarios/teeth/landmarks.h"
#include "scenarios/teeth/tooth.h"
#include "scenarios/templates/expression.h"
#include "scenarios/templates/outline_paths.h"
#include "tests/full_run.h"
#include "tests/modules.h"

namespace cusp::test {
namespace {

std::vector<int> posterior_teeth() {
  std::vector<int> out;
  for (const int quadrant : {10, 20, 30, 40})
    for (int place = 4; place <= 8; ++place) out.push_back(quadrant + place);
  return out;
}

Result<Scenario, FitFailure> fitted(const std::string& key, int fdi, std::map<std::string, double> values = {}) {
  return fit_template({.key = key, .fdi = fdi, .seed = 0, .values = std::move(values), .id = {}});
}
std::string text_of(const FitFailure& f) { return std::string(key_of(f.code)) + " " + f.where + " " + f.detail; }

TEST(Templates, FitEveryPremolarAndMolarWithoutAFinding) {
  ASSERT_EQ(exercise_templates().size(), 6u);
  std::size_t n = 0;  // by default each template on five teeth, the first four on all twenty
  for (const ExerciseTemplate& one : exercise_templates())
    for (const int fdi : posterior_teeth()) {
      const std::size_t at = n++;
      if (!full_run() && at % 4 != at / 20 % 4) continue;
      const auto scenario = fitted(one.key, fdi);
      EXPECT_TRUE(scenario) << one.key << " " << fdi << ": " << (scenario ? "" : text_of(scenario.error()));
      if (!scenario) continue;
      for (const Finding& f : validate(*scenario)) ADD_FAILURE() << one.key << " " << fdi << ": " << f.path << " " << f.code;
      for (const auto& [language, text] : scenario->briefing) {
        EXPECT_EQ(text.find('{'), std::string::npos) << one.key << ": a mark was not filled in: " << text;
        EXPECT_EQ(text.find("[M]"), std::string::npos) << one.key;
        EXPECT_NE(text.find(std::to_string(fdi)), std::string::npos) << one.key;
      }
      EXPECT_TRUE(scenario->title.contains("en") && scenario->title.contains("de")) << one.key;
    }
}

/// An occlusal part that leans by more than 31 degrees is wider buccolingually than across: no reference would earn its points.
TEST(Templates, AskForAnIsthmusWhereTheOcclusalPartRunsAlongTheTooth) {
  for (const int fdi : {14, 34, 15, 35, 16, 36})
    for (const auto& [mesial, distal] : {std::pair(1.0, 0.0), {0.0, 1.0}, {1.0, 1.0}})
      for (const double beyond : {-0.15, 0.1}) {
        const auto scenario = fitted("class-2-adhesive", fdi, {{"mesial", mesial}, {"distal", distal}, {"beyond", beyond}});
        ASSERT_TRUE(scenario) << fdi;
        double weights = 0.0;
        for (const Criterion& one : scenario->rubric.criteria) weights += one.weight;
        EXPECT_NEAR(weights, 100.0, 1e-9) << fdi << " " << mesial << distal << " " << beyond;
        const bool asked = std::ranges::any_of(scenario->rubric.criteria, [](const Criterion& c) { return c.metric == "isthmus_width"; });
        EXPECT_EQ(asked, fdi % 10 != 4) << fdi;
        EXPECT_EQ(scenario->briefing.at("en").find("isthmus") != std::string::npos, asked) << fdi;
      }
}

TEST(Templates, StateLevelAndExpectedTimeByWhatIsAskedFor) {
  const auto states = [](const std::string& key, std::map<std::string, double> values, Level level, double minutes) {
    const auto scenario = fitted(key, 46, std::move(values));
    ASSERT_TRUE(scenario) << key;
    EXPECT_EQ(scenario->level, level) << key;
    EXPECT_EQ(scenario->expected_time_s, 60 * minutes) << key;
  };
  states("class-1-adhesive", {}, Level::beginner, 15);
  states("class-2-adhesive", {}, Level::intermediate, 25);
  states("class-2-classical", {{"mesial", 1}, {"distal", 1}}, Level::advanced, 35);
}

TEST(Templates, MirrorATargetOnTheOtherSideOfTheMouth) {
  for (const ExerciseTemplate& one : exercise_templates()) {
    const auto left = fitted(one.key, 36), right = fitted(one.key, 46);
    ASSERT_TRUE(left && right) << one.key;
    const TargetShape a(left->target), b(right->target);
    for (double x = -6; x <= 6; x += 0.7)
      for (double y = -4; y <= 4; y += 0.6)
        for (double z = 1; z <= 6; z += 0.5) {
          const Near p = a.near({x, y, z}), q = b.near({-x, y, z});
          // Lines are rounded to hundredths of a millimetre, half of one up.
          EXPECT_NEAR(p.distance_mm, q.distance_mm, 0.02) << one.key << " at " << x << " " << y << " " << z;
        }
  }
}

TEST(Templates, NameTheFacesOnEitherSideOfTheMouth) {
  for (const int fdi : {36, 46}) {
    const auto landmarks = tooth_landmarks({.fdi = fdi});
    const auto box = fitted("class-2-adhesive", fdi, {{"axial", 1.4}}), fissures = fitted("class-1-classical", fdi);
    ASSERT_TRUE(landmarks && box && fissures);
    const Vec3 contact = landmarks->mesial_contact, mesial(mesial_x(fdi), 0, 0);
    // Beside the box, towards buccal and away from the slot; between its floors.
    const Vec3 axial = contact - 1.5 * mesial + Vec3(0, 1.0, -1.5), gingival = contact - 0.7 * mesial + Vec3(0, 0, -3.0);
    EXPECT_EQ(TargetShape(box->target).near(axial).face, FaceName::axial_wall) << fdi;
    EXPECT_EQ(TargetShape(box->target).near(gingival).face, FaceName::gingival_floor) << fdi;
    EXPECT_EQ(TargetShape(fissures->target).near(contact).face, FaceName::mesial_wall) << fdi;
  }
}

TEST(Templates, OpenTheBoxesThatAreAskedFor) {
  const auto landmarks = tooth_landmarks({.fdi = 36});
  ASSERT_TRUE(landmarks);
  struct Row {
    double mesial, distal;
    const char* name;
  };
  for (const Row& row : {Row{1, 0, "MO"}, Row{0, 1, "DO"}, Row{1, 1, "MOD"}}) {
    const auto scenario = fitted("class-2-adhesive", 36, {{"mesial", row.mesial}, {"distal", row.distal}});
    ASSERT_TRUE(scenario) << row.name;
    const TargetShape target(scenario->target);
    // A millimetre inside the contact, at its height.
    const Vec3 mesial = landmarks->mesial_contact - Vec3(1, 0, 0), distal = landmarks->distal_contact + Vec3(1, 0, 0);
    EXPECT_EQ(target.distance_mm(mesial) < 0.0, row.mesial != 0) << row.name;
    EXPECT_EQ(target.distance_mm(distal) < 0.0, row.distal != 0) << row.name;
    EXPECT_NE(scenario->title.at("en").find(row.name), std::string::npos) << scenario->title.at("en");
  }
}

TEST(Templates, EndABoxAboveTheJunctionAndBelowThePulpalFloor) {
  for (const int fdi : posterior_teeth()) {
    const auto landmarks = tooth_landmarks({.fdi = fdi});
    const auto scenario = fitted("class-2-classical", fdi, {{"mesial", 1}, {"distal", fdi % 10 == 8 ? 0.0 : 1.0}});
    ASSERT_TRUE(scenario && landmarks) << fdi;
    const double neck = std::ranges::max(landmarks->cej, {}, [](const Vec3& p) { return p.z; }).z;
    EXPECT_GT(TargetShape(scenario->target).floor_mm(), 0.0) << fdi << ": the buccal CEJ is z = 0";
    for (const Region& part : scenario->target.parts) {
      if (part.kind != RegionKind::common) continue;
      const double floor = TargetShape(part).floor_mm();
      const bool mesial = (part.parts.back().from_mm.x > 0) == (mesial_x(fdi) > 0);
      EXPECT_GE(floor, (mesial ? neck : 0.0) + 0.9) << fdi;
      EXPECT_LT(floor, scenario->target.parts.front().outline.top_mm - scenario->target.parts.front().outline.depth_mm) << fdi;
    }
  }
}

TEST(Templates, AskForEachCavityBesideAnUpperMolarsObliqueRidge) {
  const auto asks = [](const Scenario& of, std::string_view metric) { return std::ranges::count(of.rubric.criteria, metric, &Criterion::metric) == 1; };
  for (const char* key : {"class-1-adhesive", "class-1-classical"}) {
    const auto upper = fitted(key, 16, {{"ridge", 1.6}, {"arm", 1.4}}), lower = fitted(key, 36), premolar = fitted(key, 14);
    ASSERT_TRUE(upper && lower && premolar) << key;
    const auto targets = named_targets(upper->target);
    ASSERT_EQ(targets.size(), 2u) << key;
    EXPECT_EQ(targets[0]->name, "mesial");
    EXPECT_EQ(targets[1]->title.at("de"), "distale Kavität");
    for (const char* metric : {"target_removed@mesial", "target_removed@distal", "depth_mean@mesial", "depth_mean@distal", "depth_most"})
      EXPECT_TRUE(asks(*upper, metric)) << key << " " << metric;
    EXPECT_FALSE(asks(*upper, "target_removed") || asks(*upper, "depth_mean")) << key;
    EXPECT_NE(upper->briefing.at("en").find("oblique ridge between them"), std::string::npos) << key;
    for (const Scenario& other : {*lower, *premolar}) {
      EXPECT_EQ(other.target.kind, RegionKind::outline) << key;
      EXPECT_TRUE(other.target.name.empty() && other.target.title.empty()) << key;
      EXPECT_TRUE(asks(other, "target_removed") && asks(other, "depth_mean") && !asks(other, "depth_mean@distal")) << key;
      EXPECT_EQ(other.briefing.at("en").find("oblique"), std::string::npos) << key;
    }
    double weights = 0;
    for (const Criterion& c : upper->rubric.criteria) weights += c.weight;
    for (const Criterion& c : lower->rubric.criteria) weights -= c.weight;
    EXPECT_NEAR(weights, 0.0, 1e-9) << key;
  }
}

// So much of the ridge stays that nothing is left of the distal groove.
TEST(Templates, LeaveOutATargetThatNothingIsLeftOf) {
  const auto scenario = fitted("class-1-classical", 16, {{"ridge", 2.0}});
  ASSERT_TRUE(scenario) << text_of(scenario.error());
  EXPECT_EQ(scenario->target.kind, RegionKind::outline);
  EXPECT_EQ(std::ranges::count(scenario->rubric.criteria, "depth_mean", &Criterion::metric), 1);
  EXPECT_EQ(std::ranges::count(scenario->rubric.criteria, "depth_mean@distal", &Criterion::metric), 0);
  EXPECT_EQ(named_targets(fitted("class-1-classical", 16, {{"ridge", 1.6}}).value().target).size(), 2u);
  const auto stated = std::ranges::find(exercise_templates(), "class-1-classical", &ExerciseTemplate::key);
  ASSERT_TRUE(stated != exercise_templates().end());
  for (const char* ridge : {"2.0 mm", "1.6 mm"}) EXPECT_NE(stated->about.at("en").find(ridge), std::string::npos) << "an author reads why: " << ridge;
}

TEST(Templates, TellWhetherTheBoxBreaksTheContact) {
  for (const double beyond : {0.0, -0.15}) {
    const auto scenario = fitted("class-2-adhesive", 36, {{"beyond", beyond}});
    ASSERT_TRUE(scenario) << beyond;
    const bool opens = beyond > -0.1;
    EXPECT_EQ(std::ranges::count(scenario->rubric.criteria, "contact_broken", &Criterion::metric), opens ? 1 : 0);
    EXPECT_EQ(scenario->briefing.at("en").find("breaks the contact") != std::string::npos, opens);
    EXPECT_EQ(scenario->briefing.at("en").find("thin shell of enamel") != std::string::npos, !opens);
  }
}

TEST(Templates, PlaceALesionAndAskForItsSoftPartOverThePulpWhereItIsDeep) {
  for (const double deep : {1.5, 2.0}) {
    const auto scenario = fitted("caries-fissure", 47, {{"deep", deep}, {"radius", 1.1}});
    ASSERT_TRUE(scenario) << deep;
    ASSERT_EQ(scenario->specimen.lesions.size(), 1u);
    EXPECT_DOUBLE_EQ(scenario->specimen.lesions[0].depth_mm, deep);
    EXPECT_DOUBLE_EQ(scenario->specimen.lesions[0].radius_mm, 1.1);
    const bool asked = deep > 1.7;  // 0.85 * 0.85 of it is soft, and 1 mm is the periphery
    EXPECT_EQ(std::ranges::count(scenario->rubric.criteria, "caries_left_pulp", &Criterion::metric), asked ? 1 : 0) << deep;
    EXPECT_EQ(scenario->briefing.at("en").find("in enamel and over the pulp") != std::string::npos, asked) << deep;
  }
}

TEST(Templates, PlaceALesionBelowTheContactThatIsAskedFor) {
  for (const double distal : {0.0, 1.0}) {
    const auto scenario = fitted("caries-proximal", 46, {{"distal", distal}, {"beyond", 0.1 - 0.2 * distal}});
    ASSERT_TRUE(scenario) << distal;
    ASSERT_EQ(scenario->specimen.lesions.size(), 1u);
    EXPECT_EQ(scenario->specimen.lesions[0].kind, "proximal");
    const std::string side = distal != 0 ? "distal" : "mesial";
    EXPECT_EQ(scenario->specimen.lesions[0].site, side);
    EXPECT_NE(scenario->title.at("en").find(side), std::string::npos);
    EXPECT_NE(scenario->briefing.at("de").find(side + "en Kontaktpunkt"), std::string::npos);
    // The shell of enamel that stays at the contact is asked for as little as its clearance.
    const bool opens = distal == 0;
    EXPECT_EQ(std::ranges::count(scenario->rubric.criteria, "contact_broken", &Criterion::metric), opens ? 1 : 0);
    EXPECT_EQ(scenario->briefing.at("en").find("breaks the contact") != std::string::npos, opens);
    // One box and the lesion's two parts.
    ASSERT_EQ(scenario->target.parts.size(), 3u);
    const auto landmarks = tooth_landmarks({.fdi = 46});
    const Vec3 contact = distal != 0 ? landmarks->distal_contact : landmarks->mesial_contact;
    EXPECT_LT(TargetShape(scenario->target.parts[0]).distance_mm(contact - Vec3(std::copysign(0.5, contact.x), 0, 0.5)), 0.0);
  }
}

TEST(Templates, MakeAnExerciseOfTheSmallestLesionBelowAContact) {
  const auto scenario = fitted("caries-proximal", 46, {{"radius", 0.6}, {"deep", 0.7}});
  ASSERT_TRUE(scenario) << text_of(scenario.error());
  EXPECT_FALSE(has_error(validate(*scenario)));
}

TEST(Templates, TakeTheValuesOfParameters) {
  const auto scenario = fitted("class-1-adhesive", 46, {{"depth", 2.1}, {"width", 1.3}});
  ASSERT_TRUE(scenario);
  EXPECT_DOUBLE_EQ(scenario->target.outline.depth_mm, 2.1);
  EXPECT_DOUBLE_EQ(scenario->target.outline.width_mm, 1.3);
  EXPECT_NE(scenario->briefing.at("de").find("2,1 mm"), std::string::npos);
  EXPECT_NE(scenario->briefing.at("en").find("2.1 mm"), std::string::npos);
}

TEST(Templates, NameTheHundredthsOfALengthInTheBriefing) {
  const auto scenario = fitted("class-1-adhesive", 46, {{"depth", 2.0}, {"width", 1.25}});
  ASSERT_TRUE(scenario);
  EXPECT_NE(scenario->briefing.at("en").find(" 1.25 mm wide"), std::string::npos) << scenario->briefing.at("en");
  EXPECT_NE(scenario->briefing.at("de").find(" 1,25 mm breit"), std::string::npos) << scenario->briefing.at("de");
  EXPECT_NE(scenario->briefing.at("en").find(" 2.0 mm below"), std::string::npos) << "one digit is enough";
}

TEST(Templates, SpeakOfTwoBoxesWhereTwoAreAskedFor) {
  for (const char* key : {"class-2-adhesive", "class-2-classical"})
    for (const double distal : {0.0, 1.0})
      for (const double beyond : {0.0, -0.15}) {
        const auto scenario = fitted(key, 14, {{"distal", distal}, {"beyond", beyond}});
        ASSERT_TRUE(scenario) << key;
        const bool two = distal != 0;
        const auto says = [&](const char* language, const char* words) {
          return scenario->briefing.at(language).find(words) != std::string::npos;
        };
        for (const char* words : {"two proximal boxes", "The boxes end", "axial walls", "their mesiodistal depth"})
          EXPECT_EQ(says("en", words), two) << key << ": " << words;
        for (const char* words : {"a proximal box", "The box ", "axial wall in", "its mesiodistal depth", "the contact is broken"})
          EXPECT_EQ(says("en", words), !two && (beyond == 0.0 || std::string_view(words) != "the contact is broken")) << key << ": " << words;
        for (const char* words : {"zwei approximale Kästen", "Die Kästen enden", "axialen Wände", "ihre mesiodistale Tiefe"})
          EXPECT_EQ(says("de", words), two) << key << ": " << words;
        for (const char* words : {"einen approximalen Kasten", "Der Kasten", "axialen Wand", "seine mesiodistale Tiefe"})
          EXPECT_EQ(says("de", words), !two) << key << ": " << words;
      }
}

TEST(Templates, NameTheDefaultsThatTheyTake) {
  for (const ExerciseTemplate& one : exercise_templates())
    for (const int fdi : {14, 36, 48}) {
      const auto defaults = template_defaults(one.key, fdi);
      ASSERT_TRUE(defaults) << one.key << " " << fdi;
      EXPECT_EQ(defaults->size(), one.parameters.size());
      for (const TemplateParameter& p : one.parameters) {
        EXPECT_GE(defaults->at(p.key), p.least) << one.key << " " << p.key;
        EXPECT_LE(defaults->at(p.key), p.most) << one.key << " " << p.key;
      }
      auto asked = fitted(one.key, fdi, *defaults), left_out = fitted(one.key, fdi, {});
      ASSERT_TRUE(asked && left_out) << one.key << " " << fdi;
      EXPECT_EQ(asked->made_with, (TemplateUse{one.key, *defaults})) << "the exercise names what was asked for";
      EXPECT_EQ(left_out->made_with, (TemplateUse{one.key, {}}));
      asked->made_with = left_out->made_with;
      EXPECT_TRUE(*asked == *left_out) << one.key << " " << fdi;
    }
  EXPECT_DOUBLE_EQ(template_defaults("class-1-adhesive", 36)->at("ridge"), 2.0);  // of a molar, in the JSON
  EXPECT_DOUBLE_EQ(template_defaults("class-1-adhesive", 14)->at("ridge"), 1.6);  // of a premolar
  EXPECT_EQ(template_defaults("class-1-adhesive", 11).error().code, FitError::unsuitable_tooth);
}

TEST(Templates, KeepTheMarginalRidges) {
  const auto landmarks = tooth_landmarks({.fdi = 36});
  const auto scenario = fitted("class-1-classical", 36, {{"ridge", 3.0}});
  ASSERT_TRUE(scenario && landmarks);
  for (const auto& path : scenario->target.outline.paths)
    for (const Vec3& p : path) {
      EXPECT_LE(p.x + 0.5 * scenario->target.outline.width_mm, landmarks->mesial_contact.x - 3.0);
      EXPECT_GE(p.x - 0.5 * scenario->target.outline.width_mm, landmarks->distal_contact.x + 3.0);
    }
}

TEST(Templates, GiveEachParameterARangeAUnitAndASource) {
  for (const ExerciseTemplate& one : exercise_templates())
    for (const TemplateParameter& p : one.parameters) {
      EXPECT_LT(p.least, p.most) << one.key << " " << p.key;
      EXPECT_FALSE(p.source.empty()) << one.key << " " << p.key;
      EXPECT_TRUE(p.unit == "mm" || p.unit == "deg" || p.unit.empty()) << one.key << " " << p.key;
      EXPECT_TRUE(p.name.contains("en") && p.name.contains("de")) << one.key << " " << p.key;
    }
}

struct Refusal {
  const char* key;
  int fdi;
  std::map<std::string, double> values;
  FitError code;
  const char* where;
};

TEST(Templates, RefuseWhatTheyCannotFit) {
  for (const Refusal& r : std::vector<Refusal>{{"class-9", 36, {}, FitError::unknown_template, "class-9"},
                                               {"class-1-adhesive", 11, {}, FitError::unsuitable_tooth, "11"},
                                               {"class-1-adhesive", 33, {}, FitError::unsuitable_tooth, "33"},
                                               {"class-1-adhesive", 0, {}, FitError::unsuitable_tooth, "0"},
                                               {"class-1-adhesive", 56, {}, FitError::unsuitable_tooth, "56"},
                                               {"class-1-adhesive", -36, {}, FitError::unsuitable_tooth, "-36"},
                                               {"class-1-adhesive", 36, {{"dept", 2}}, FitError::unknown_parameter, "dept"},
                                               {"class-1-adhesive", 36, {{"depth", 9}}, FitError::out_of_range, "depth"},
                                               {"class-1-adhesive", 36, {{"depth", NAN}}, FitError::out_of_range, "depth"},
                                               {"class-2-adhesive", 36, {{"distal", 0.5}}, FitError::out_of_range, "distal"},
                                               {"caries-proximal", 46, {{"distal", 0.5}}, FitError::out_of_range, "distal"},
                                               {"class-2-adhesive", 36, {{"mesial", 0}}, FitError::unmet_need, "box"},
                                               {"class-2-classical", 36, {{"mesial", 0}}, FitError::unmet_need, "box"},
                                               {"class-2-adhesive", 36, {{"depth", 2.6}}, FitError::unmet_need, "mesial_step"},
                                               {"class-2-classical", 36, {{"above_cej", 3}}, FitError::unmet_need, "mesial_step"},
                                               {"class-2-adhesive", 38, {{"distal", 1}}, FitError::unmet_need, "neighbour"},
                                               {"caries-proximal", 48, {{"distal", 1}}, FitError::unmet_need, "neighbour"}}) {
    const auto scenario = fitted(r.key, r.fdi, r.values);
    ASSERT_FALSE(scenario) << r.key << " " << r.fdi;
    EXPECT_EQ(scenario.error().code, r.code) << r.key << " " << r.fdi << ": " << text_of(scenario.error());
    EXPECT_EQ(scenario.error().where, r.where);
  }
}

TEST(Templates, TellARidgeThatLeavesNoRoomFromAMissingFissure) {
  const auto scenario = fitted("class-1-adhesive", 25, {{"ridge", 3.5}});
  ASSERT_FALSE(scenario);
  EXPECT_EQ(text_of(scenario.error()), "missing_landmark central* no_room");
}

TEST(Expression, Reckons) {
  const Scope scope = {{"a", 2.0}, {"contact.mesial.x", 5.5}};
  const auto value = [&](const char* text) { return evaluate(text, scope).value_or(NAN); };
  EXPECT_DOUBLE_EQ(value("1 + 2 * 3"), 7.0);
  EXPECT_DOUBLE_EQ(value("(1 + a) * -3"), -9.0);
  EXPECT_DOUBLE_EQ(value("contact.mesial.x - 0.5 * a"), 4.5);
  EXPECT_DOUBLE_EQ(value("max(a, min(3, 9)) / 2"), 1.5);
  EXPECT_DOUBLE_EQ(value("at_least(3, 3) + 10 * at_least(2, 3)"), 1.0);
  EXPECT_DOUBLE_EQ(value(" 7 - 2 - 1 "), 4.0);
}

TEST(Expression, RefusesWhatItDoesNotUnderstand) {
  const auto code = [](const std::string& text) {
    const auto value = evaluate(text, {{"a", 1.0}});
    return value ? std::optional<ExpressionError>() : std::optional(value.error().code);
  };
  for (const char* text : {"", "1 +", "(1", "1)", "1 2", "a b", "max(1)", "min(1, 2", "*3", "1 ! 2", "\xff"})
    EXPECT_EQ(code(text), ExpressionError::syntax) << text;
  EXPECT_EQ(code("b"), ExpressionError::unknown_name);
  EXPECT_EQ(code("max"), ExpressionError::unknown_name);
  EXPECT_EQ(code("1 / 0"), ExpressionError::not_finite);
  EXPECT_EQ(code("1e999"), ExpressionError::not_finite);
  EXPECT_EQ(code(std::string(100000, '(')), ExpressionError::syntax) << "deep, and the stack holds";
  EXPECT_EQ(code(std::string(100000, '-')), ExpressionError::syntax);
}

TEST(FissurePaths, FollowAFissureBetweenItsBounds) {
  ToothLandmarks tooth;
  tooth.fissures = {{"central mesial", {{3, 0, 4}, {2, 0.01, 4}, {1, 0, 4}, {0, 0, 4}}}, {"lingual", {{0, 0, 4}, {0, -1, 4}, {0, -2, 4}}}};
  const auto lines = fissure_paths(tooth, {.names = {"central*"}, .most_x = 2.5, .least_x = -9, .longest_mm = 99});
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].size(), 2u) << "straight within 0.08 mm";
  EXPECT_DOUBLE_EQ(lines[0].front().x, 2.0);
  const auto arm = fissure_paths(tooth, {.names = {"lingual", "buccal"}, .most_x = 9, .least_x = -9, .longest_mm = 1.5});
  ASSERT_EQ(arm.size(), 1u);
  EXPECT_DOUBLE_EQ(arm[0].back().y, -1.0);
  EXPECT_TRUE(fissure_paths(tooth, {.names = {"buccal"}, .most_x = 9, .least_x = -9, .longest_mm = 9}).empty());
  EXPECT_TRUE(fissure_paths({}, {.names = {"central*"}, .most_x = 9, .least_x = -9, .longest_mm = 9}).empty());
}

}  // namespace
}  // namespace cusp::test
