// How a briefing names the depth that its exercise asks for, and where the keyboard begins.

#include <gtest/gtest.h>

#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>

#include "scenarios/library/library.h"
#include "scenarios/import/nrrd.h"
#include "tests/modules.h"
#include "tests/ui/named_block.h"
#include "ui/student/briefing.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

/// The value beside a name of the list of facts; empty without such a line.
std::string fact(const Scenario& scenario, const QString& of) {
  const QTemporaryDir cache;
  ThumbnailCache pictures(cache.path().toStdString());
  Exercise exercise;
  exercise.scenario = scenario;
  const Briefing page(exercise, pictures, {}, nullptr);
  for (const QFormLayout* form : page.findChildren<QFormLayout*>())
    for (int row = 0; row < form->rowCount(); ++row) {
      const auto* name = qobject_cast<QLabel*>(form->itemAt(row, QFormLayout::LabelRole)->widget());
      const auto* value = qobject_cast<QLabel*>(form->itemAt(row, QFormLayout::FieldRole)->widget());
      if (name->text() == of)
        return value->text().remove(QChar(0x2066)).remove(QChar(0x2069)).replace(QChar(0x00A0), u' ').toStdString();
    }
  return {};
}

std::string required_depth(const Scenario& scenario) { return fact(scenario, QStringLiteral("Required depth")); }

TEST(RequiredDepth, is_that_of_the_floor_that_is_measured) {
  EXPECT_EQ(required_depth(*load_builtin("class-1-36")), "1.8 mm");
  EXPECT_EQ(required_depth(*load_builtin("class-2-36-do")), "1.6 mm");
  Scenario finer = *load_builtin("class-1-36");
  finer.target.outline.depth_mm = 1.85;
  EXPECT_EQ(required_depth(finer), "1.85 mm");
}

TEST(RequiredDepth, is_not_that_of_the_way_to_a_lesion) {
  for (const char* key : {"caries-26", "caries-46"}) EXPECT_EQ(required_depth(*load_builtin(key)), "") << key << " ends where the caries does";
}

TEST(RequiredDepth, of_several_targets_is_given_once_or_for_each) {
  Scenario two = *load_builtin("class-1-16");
  EXPECT_EQ(required_depth(two), "1.8 mm");
  ASSERT_EQ(two.target.parts.size(), 2u);
  two.target.parts[1].outline.depth_mm = 2.2;
  EXPECT_EQ(required_depth(two), "mesial cavity: 1.8 mm\ndistal cavity: 2.2 mm");
}

TEST(Briefing, names_what_an_attempt_is_to_spare) {
  const auto spared = [](const Scenario& scenario) { return fact(scenario, QStringLiteral("Protected")); };
  EXPECT_EQ(spared(*load_builtin("class-1-36")), "Pulp");
  EXPECT_EQ(spared(*load_builtin("class-2-36-do")), "Pulp\nNeighbour enamel: cut at most 0.2 mm deep\nNeighbour dentine");
  EXPECT_EQ(spared(*load_builtin("channel-1")), "");
  Scenario drawn = *load_builtin("class-1-36");
  drawn.protected_parts = {Protected(Tissue::pulp, Damage::touch), Protected(drawn.target)};
  EXPECT_EQ(spared(drawn), "Pulp: not to be laid bare\nA part of the specimen");
}

TEST(Briefing, names_the_tolerance_of_a_face_that_has_its_own) {
  const auto tolerance = [](const char* key) { return fact(*load_builtin(key), QStringLiteral("Tolerance zone")); };
  EXPECT_EQ(tolerance("class-1-36"), "0.30 mm at the floor, 0.30 mm at the sides");
  EXPECT_EQ(tolerance("class-2-36-do"), "0.30 mm at the floor, 0.30 mm at the sides\nother walls: none");
}

TEST(Briefing, begins_the_keyboard_on_a_button_that_can_be_pressed) {
  const QTemporaryDir cache;
  ThumbnailCache pictures(cache.path().toStdString());
  Exercise exercise;
  exercise.scenario = *load_builtin("class-1-36");
  const auto first = [&](const QString& refusal) {
    const Briefing page(exercise, pictures, {}, nullptr, refusal);
    const auto* button = qobject_cast<QPushButton*>(page.focusProxy());
    return button != nullptr && button->isEnabled() ? button->text().trimmed() : QString();
  };
  EXPECT_EQ(first({}), QStringLiteral("Start"));
  EXPECT_EQ(first(QStringLiteral("Your assessment of this exercise is not handed in yet.")), QStringLiteral("Back"));
}

TEST(Briefing, names_a_tissue_among_the_criteria_as_the_volume_does) {
  const QTemporaryDir folder;
  const std::filesystem::path in = folder.path().toStdString();
  ASSERT_TRUE(write_nrrd(named_block(), in / "block.nrrd"));
  ThumbnailCache pictures(in / "pictures");
  Exercise exercise;
  exercise.scenario = *load_builtin("channel-1");
  exercise.scenario.specimen = {};
  exercise.scenario.specimen.volume = "block.nrrd";
  exercise.scenario.rubric.criteria.front().metric = "removed_16";
  const auto first_criterion = [&](const std::filesystem::path& volumes) {
    const Briefing page(exercise, pictures, volumes, nullptr);
    const auto* table = page.findChild<Table*>();
    return table != nullptr ? table->model()->index(0, 0).data().toString().toStdString() : std::string();
  };
  EXPECT_EQ(first_criterion(in), "pulp stone removed");
  EXPECT_EQ(first_criterion(in / "elsewhere"), "Material 1 removed") << "the volume is not there";
}

}  // namespace
}  // namespace cusp::test
