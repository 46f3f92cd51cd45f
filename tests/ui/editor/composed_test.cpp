// A target that is a tree of shapes: the editor shows it, says that it cannot change it, and loses nothing of it.
#include <QLabel>
#include <QTest>

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

TEST_F(ComposedTarget, is_shown_with_a_sentence_and_nothing_to_change_it) {
  EditorStart start = coarse();
  compose(start.draft);
  const Region both = start.draft.target;
  const auto page = open(start);
  bool said = false;
  for (const QLabel* label : page->findChildren<QLabel*>())
    said = said || (label->isVisible() && label->text().startsWith(QStringLiteral("This target is composed of several shapes.")));
  EXPECT_TRUE(said);
  EXPECT_FALSE(named<NumberField>(*page, "Depth")->isVisible());
  EXPECT_TRUE(knobs_of(*page->findChild<TargetView*>()).empty());
  for (const QLabel* label : page->findChildren<QLabel*>())
    EXPECT_FALSE(label->isVisible() && label->text().startsWith(QStringLiteral("Drag a handle"))) << "there is none";
  EXPECT_EQ(page->model().scenario().target, both);
  leave_pictures(start);
  const auto drawn = open();
  for (const QLabel* label : drawn->findChildren<QLabel*>())
    EXPECT_FALSE(label->isVisible() && label->text().startsWith(QStringLiteral("This target is composed"))) << "an outline can be changed";
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

TEST_F(ComposedTarget, stays_as_it_is) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  compose(start.draft);
  start.draft.leeway.faces = {{FaceName::gingival_floor, 0.1}};
  EditorModel model(start);
  const Region before = model.scenario().target;
  EXPECT_FALSE(model.has_drawn_target());
  EXPECT_FALSE(model.set_target(Outline{}, QStringLiteral("handle/0")));
  EXPECT_FALSE(model.set_shape("box"));
  EXPECT_FALSE(model.set_depth_mm(1.5));
  EXPECT_FALSE(model.set_width_mm(1.5));
  EXPECT_FALSE(model.set_top_mm(0.5));
  EXPECT_FALSE(model.set_corner_radius_mm(0.2));
  EXPECT_FALSE(model.set_box_size_mm(2, 2));
  EXPECT_FALSE(model.set_point_mm(0, 0, 1, 1));
  EXPECT_FALSE(model.add_point(0));
  EXPECT_FALSE(model.add_path());
  EXPECT_EQ(model.stack().count(), 0);
  EXPECT_TRUE(model.set_title("de", QStringLiteral("Anders")));
  EXPECT_TRUE(model.set_leeway(0.2, 0.25));
  EXPECT_EQ(model.scenario().target, before);
  EXPECT_EQ(model.scenario().leeway.faces, (std::map<FaceName, double>{{FaceName::gingival_floor, 0.1}})) << "the zones of single faces stay";
}

}  // namespace
}  // namespace cusp::test
