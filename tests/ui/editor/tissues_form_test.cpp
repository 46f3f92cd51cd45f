// Tilt and turn of the handpiece: their fields, ranges, undo, and where their messages lead.

#include <gtest/gtest.h>

#include <QLabel>
#include <algorithm>
#include <filesystem>

#include "scenarios/format/read.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/library/library.h"
#include "scenarios/specimens/specimens.h"
#include "tests/modules.h"
#include "tests/ui/editor/class_one.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/editor/change_messages.h"
#include "ui/editor/check_messages.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/tissues_form.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

TEST(TissuesForm, tilts_the_handpiece_within_the_range_of_the_format_and_undo_takes_it_back) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  EditorModel model(start);
  TissuesForm form(model);
  auto* tilt = named<NumberField>(form, "Tilt of the handpiece");
  ASSERT_NE(tilt, nullptr);
  EXPECT_EQ(tilt->minimum(), -80);
  EXPECT_EQ(tilt->maximum(), 80);
  tilt->setValue(20);
  EXPECT_EQ(model.scenario().tool_tilt_deg, 20);
  const QStringList changes = change_messages(start.draft, model.scenario());
  EXPECT_TRUE(changes.size() == 1 && changes.front().startsWith(QStringLiteral("Tilt of the handpiece: "))) << changes.join(u'|').toStdString();
  model.stack().undo();
  EXPECT_EQ(tilt->value(), 0);
  EXPECT_EQ(model.scenario().tool_tilt_deg, 0);
}

TEST(TissuesForm, the_handpiece_tilts_as_far_as_the_format_allows) {
  EditorModel model(class_one());
  EXPECT_TRUE(model.set_tool_tilt_deg(-80));
  EXPECT_FALSE(model.set_tool_tilt_deg(81));
  EXPECT_EQ(model.scenario().tool_tilt_deg, -80);
  EXPECT_EQ(place_of({Severity::error, "/device/tool_tilt_deg", "out_of_range", {{"value", 90}, {"least", -80}, {"most", 80}}, {}}),
            EditorPlace::tissues);
}

TEST_F(EditorPages, an_author_s_own_tissue_stands_in_the_panels_by_its_name_in_the_volume) {
  SpecimenSource block;
  block.generator = "block";
  block.voxel_mm = 0.4;
  auto volume = make_specimen(block, {});
  ASSERT_TRUE(volume.has_value());
  std::ranges::replace(volume->tissue, Tissue::plastic, Tissue{16});
  volume->names[16] = "pulp stone";
  EditorStart start = coarse();
  start.draft.specimen = {};
  start.draft.specimen.volume = "stone.nrrd";
  start.draft.specimen.voxel_mm = volume->grid.voxel_mm;
  start.draft.tissues = {{Tissue{16}, 2, 3}};
  std::filesystem::create_directories(start.folder);
  ASSERT_TRUE(write_nrrd(*volume, std::filesystem::path(start.folder) / "stone.nrrd"));
  const auto page = open(start);
  EXPECT_NE(named<NumberField>(*page, "Stiffness of pulp stone"), nullptr);
  const QList<QLabel*> labels = page->findChildren<QLabel*>();
  const auto naming_it = [](const QLabel* label) { return label->text().contains(QStringLiteral("pulp stone")); };
  EXPECT_GE(std::ranges::count_if(labels, naming_it), 2) << "above its figures, and among what the exercise holds";
}

TEST_F(EditorPages, the_turn_that_is_typed_stands_in_the_draft_and_undo_takes_it_back) {
  const EditorStart start = coarse();
  EditorModel model(start);
  TissuesForm form(model);
  auto* turn = named<NumberField>(form, "Turn of the handpiece");
  ASSERT_NE(turn, nullptr);
  EXPECT_EQ(turn->minimum(), 0);
  EXPECT_EQ(turn->maximum(), 60);
  EXPECT_EQ(turn->suffix(), QStringLiteral("\u00A0°"));
  turn->selectAll();
  QTest::keyClicks(turn, QStringLiteral("25"));
  QTest::keyClick(turn, Qt::Key_Return);
  EXPECT_EQ(model.scenario().tool_turn_deg, 25);
  std::optional<std::string> json;
  ASSERT_TRUE(keep_draft(records.store(), instructor.actor(), model, json).has_value() && json);
  EXPECT_EQ(read_scenario(*json)->tool_turn_deg, 25);
  const QStringList changes = change_messages(start.draft, model.scenario());
  EXPECT_TRUE(changes.size() == 1 && changes.front().startsWith(QStringLiteral("Turn of the handpiece: "))) << changes.join(u'|').toStdString();
  model.stack().undo();
  EXPECT_EQ(turn->value(), 0);
  EXPECT_EQ(model.scenario().tool_turn_deg, 0);
  EXPECT_EQ(place_of({Severity::error, "/device/tool_turn_deg", "out_of_range", {{"value", 90}, {"least", 0}, {"most", 60}}, {}}),
            EditorPlace::tissues);
}

}  // namespace
}  // namespace cusp::test
