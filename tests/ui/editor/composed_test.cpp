// A target that is a tree of shapes: each is chosen, changed, added and removed, and nothing of it is lost.
#include <QTest>
#include <QApplication>
#include <QLabel>
#include <QTreeWidget>
#include <algorithm>

#include "tests/scenarios/regions.h"
#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/looks.h"
#include "ui/editor/check_messages.h"
#include "ui/text/language.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

struct ComposedTarget : EditorPages {
  /// Joins a ball to the drawn target.
  static void compose(Scenario& draft) { draft.target = node(RegionKind::joined, {draft.target, sphere({1, 0, -1}, 1)}); }
  void leave_pictures(const EditorStart& start);
};

/// The page in each language and look, if pictures are wanted.
void ComposedTarget::leave_pictures(const EditorStart& start) {
  if (!pictures_wanted()) return;
  in_each_look([&](const QString& look) {
    const auto page = open(start);
    QTest::qWait(2000);  // the view draws the target when it rests
    leave_picture(*page, QStringLiteral("editor-tree-") + look);
  });
}

TEST_F(ComposedTarget, begins_at_its_first_outline_with_its_handles_and_numbers) {
  EditorStart start = coarse();
  compose(start.draft);
  const auto page = open(start);
  EXPECT_EQ(page->model().part(), PartPath{0});
  EXPECT_TRUE(named<NumberField>(*page, "Depth")->isVisible());
  EXPECT_FALSE(knobs_of(*page->findChild<TargetView*>()).empty());
  named<NumberField>(*page, "Depth")->setValue(1.35);
  EXPECT_DOUBLE_EQ(page->model().scenario().target.parts[0].outline.depth_mm, 1.35);
  named<NumberField>(*page, "Lean, towards buccal")->setValue(6);
  EXPECT_DOUBLE_EQ(page->model().scenario().target.parts[0].outline.taper_deg[3], 6);
  leave_pictures(start);
}

TEST_F(ComposedTarget, a_shape_that_is_chosen_in_the_list_has_its_own_numbers) {
  EditorStart start = coarse();
  compose(start.draft);
  const auto page = open(start);
  auto* list = named<QTreeWidget>(*page, "Shapes of the target");
  QTreeWidgetItem* ball = list->topLevelItem(0)->child(1);
  EXPECT_EQ(ball->text(0), QStringLiteral("Sphere"));
  list->setCurrentItem(ball);
  EXPECT_EQ(page->model().part(), PartPath{1});
  EXPECT_FALSE(named<NumberField>(*page, "Depth")->isVisible());
  EXPECT_EQ(knobs_of(*page->findChild<TargetView*>()).size(), 2u) << "place and radius";
  named<NumberField>(*page, "Radius")->setValue(0.75);
  named<NumberField>(*page, "Place: Height")->setValue(-0.5);
  const Region& changed = page->model().scenario().target.parts[1];
  EXPECT_DOUBLE_EQ(changed.radius_mm, 0.75);
  EXPECT_DOUBLE_EQ(changed.from_mm.z, -0.5);
  page->model().stack().undo();
  page->model().stack().undo();
  EXPECT_DOUBLE_EQ(page->model().scenario().target.parts[1].radius_mm, 1);
  list->setCurrentItem(list->topLevelItem(0));
  named<NumberField>(*page, "Rounding of the edges")->setValue(0.2);
  EXPECT_DOUBLE_EQ(page->model().scenario().target.rounding_mm, 0.2);
}

TEST_F(ComposedTarget, of_a_lesion_or_a_tissue_is_shown_and_checked) {
  EditorStart start = coarse();
  Region lesion, pulp;
  lesion.kind = RegionKind::lesion;
  pulp.kind = RegionKind::tissue;
  pulp.tissue = Tissue::pulp;
  start.draft.target = node(RegionKind::joined, {start.draft.target, lesion, node(RegionKind::offset, {pulp}, 0.5)});
  const Region whole = start.draft.target;
  const auto page = open(start);
  EXPECT_EQ(page->model().scenario().target, whole);
  bool missing = false;
  for (const Finding& f : page->model().findings()) {
    missing = missing || f.code == "lesion_missing";
    EXPECT_FALSE(check_message(f).startsWith(QStringLiteral("Something is wrong at"))) << f.code;
  }
  EXPECT_TRUE(missing) << "the tooth of the draft has no lesion";
}

TEST_F(ComposedTarget, a_shape_is_added_beside_the_chosen_one_and_removed_again) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  EditorModel model(start);
  const Region drawn = model.scenario().target;
  ASSERT_TRUE(model.add_part(RegionKind::sphere));
  EXPECT_EQ(model.scenario().target.kind, RegionKind::joined);
  EXPECT_EQ(model.part(), PartPath{1});
  ASSERT_TRUE(model.add_part(RegionKind::box));
  EXPECT_EQ(model.part(), PartPath{2});
  ASSERT_TRUE(model.remove_part());
  ASSERT_EQ(model.scenario().target.parts.size(), 2u);
  model.choose_part({1});
  ASSERT_TRUE(model.remove_part());
  EXPECT_EQ(model.scenario().target, drawn) << "a union of one shape is that shape";
  EXPECT_TRUE(model.part().empty());
  EXPECT_FALSE(model.remove_part()) << "a target keeps its last shape";
  while (model.stack().canUndo()) model.stack().undo();
  EXPECT_EQ(model.scenario().target, drawn);
}

TEST_F(ComposedTarget, a_short_list_stands_right_below_its_title_in_a_tall_window) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  const auto page = open(start);
  page->resize(1920, 1400);
  page->show();
  QApplication::processEvents();
  const auto* list = named<QTreeWidget>(*page, "Shapes of the target");
  const auto labels = list->parentWidget()->findChildren<QLabel*>();
  const auto title = std::find_if(labels.begin(), labels.end(), [](const QLabel* l) { return l->text() == QStringLiteral("Shapes of the target"); });
  ASSERT_NE(title, labels.end());
  EXPECT_EQ((*title)->height(), (*title)->sizeHint().height());
  EXPECT_LT(list->y() - (*title)->geometry().bottom(), px(14));
}

TEST_F(ComposedTarget, undo_of_the_chosen_shape_chooses_what_holds_it) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  EditorModel model(start);
  model.add_part(RegionKind::sphere);
  model.stack().undo();
  EXPECT_TRUE(model.part().empty());
  EXPECT_TRUE(model.has_outline());
}

TEST_F(ComposedTarget, the_zones_of_single_faces_stay) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  compose(start.draft);
  start.draft.leeway.faces = {{FaceName::gingival_floor, 0.1}};
  EditorModel model(start);
  EXPECT_TRUE(model.set_leeway(0.2, 0.25));
  EXPECT_EQ(model.scenario().leeway.faces, (std::map<FaceName, double>{{FaceName::gingival_floor, 0.1}}));
}

}  // namespace
}  // namespace cusp::test
