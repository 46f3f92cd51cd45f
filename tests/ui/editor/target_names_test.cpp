// Several targets of one exercise in the editor: naming, criteria, what happens to both when the tree changes.

#include "ui/editor/target_names.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QCoreApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <algorithm>

#include "scenarios/format/content_hash.h"
#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/first_bands.h"
#include "ui/editor/parts_form.h"
#include "ui/editor/points_form.h"
#include "ui/editor/target_name_form.h"
#include "ui/editor/texts_form.h"

namespace cusp::test {
namespace {

const QString kPit = QStringLiteral("Mesial pit");

/// channel-1 with a cuboid beside its slot: a union of two.
struct TwoShapes : ::testing::Test {
  EditorStart start;
  std::unique_ptr<EditorModel> model;
  void SetUp() override {
    start.draft = *load_builtin("channel-1");
    model = std::make_unique<EditorModel>(start);
    ASSERT_TRUE(model->add_part(RegionKind::box));
    ASSERT_EQ(model->scenario().target.kind, RegionKind::joined);
  }
  const Region& part(std::size_t i) const { return model->scenario().target.parts[i]; }
  bool has_criterion(const char* metric) const {
    return std::ranges::find(model->scenario().rubric.criteria, metric, &Criterion::metric) != model->scenario().rubric.criteria.end();
  }
};

TEST_F(TwoShapes, A_title_makes_a_target_and_its_name_stays_when_the_title_changes) {
  EXPECT_TRUE(model->set_target_title(0, "de", QStringLiteral("Größe Ähre")));
  EXPECT_EQ(part(0).name, "gro_e_ahre");
  EXPECT_EQ(part(0).title.at("en"), part(0).title.at("de")) << "English is never missing";
  EXPECT_TRUE(model->set_target_title(0, "en", kPit));
  EXPECT_EQ(part(0).name, "gro_e_ahre");
  EXPECT_TRUE(model->set_target_title(1, "en", QStringLiteral("Größe ähre")));
  EXPECT_EQ(part(1).name, "gro_e_ahre_2");
  EXPECT_TRUE(model->set_target_title(1, "en", QStringLiteral("中文"))) << "the name is there already";
  EXPECT_TRUE(read_scenario(canonical_json(model->scenario())));
}

TEST_F(TwoShapes, A_title_that_goes_leaves_the_others_and_the_last_one_takes_the_name_along) {
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  ASSERT_TRUE(model->set_target_title(0, "de", QStringLiteral("Grube")));
  EXPECT_TRUE(model->set_target_title(0, "en", {}));
  EXPECT_EQ(part(0).title, (LocalText{{"de", "Grube"}, {"en", "Grube"}}));
  EXPECT_TRUE(model->set_target_title(0, "de", {}));
  EXPECT_EQ(part(0).title, (LocalText{{"en", "Grube"}}));
  EXPECT_TRUE(model->set_target_title(0, "en", {}));
  EXPECT_TRUE(part(0).name.empty());
  EXPECT_FALSE(model->clear_target(2));
}

TEST_F(TwoShapes, A_title_without_latin_letters_has_a_name_too) {
  EXPECT_TRUE(model->set_target_title(0, "en", QStringLiteral("中文")));
  EXPECT_EQ(part(0).name, "target");
  EXPECT_TRUE(model->set_target_title(1, "en", QStringLiteral("8")));
  EXPECT_EQ(part(1).name, "target_2");
}

TEST_F(TwoShapes, Only_a_direct_part_of_the_union_can_be_one) {
  EXPECT_FALSE(model->set_target_title(2, "en", kPit));
  Region whole = model->scenario().target;
  whole.kind = RegionKind::difference;
  model->choose_part({});
  EXPECT_TRUE(model->set_part(whole, QStringLiteral("joined")));
  EXPECT_FALSE(model->set_target_title(0, "en", kPit));
}

TEST_F(TwoShapes, What_is_no_target_any_more_takes_its_criteria_along_in_one_step) {
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  ASSERT_TRUE(model->add_criterion("depth_mean@mesial_pit", first_bands("depth_mean@mesial_pit", model->scenario().target)));
  const Scenario before = model->scenario();
  model->end_gesture();
  EXPECT_TRUE(model->clear_target(0));
  EXPECT_TRUE(part(0).name.empty());
  EXPECT_FALSE(has_criterion("depth_mean@mesial_pit"));
  EXPECT_TRUE(has_criterion("depth_mean"));
  model->stack().undo();
  EXPECT_EQ(model->scenario(), before);

  model->choose_part({0});
  EXPECT_TRUE(model->remove_part());
  EXPECT_FALSE(has_criterion("depth_mean@mesial_pit"));
  model->stack().undo();
  EXPECT_EQ(model->scenario(), before);

  Region whole = before.target;
  whole.kind = RegionKind::common;
  model->choose_part({});
  EXPECT_TRUE(model->set_part(whole, QStringLiteral("joined")));
  EXPECT_FALSE(has_criterion("depth_mean@mesial_pit"));
  EXPECT_TRUE(read_scenario(canonical_json(model->scenario()))) << "a draft opens again";
}

TEST_F(TwoShapes, The_one_that_is_left_keeps_its_criteria) {
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  ASSERT_TRUE(model->set_target_title(1, "en", QStringLiteral("Distal pit")));
  const std::string own = "floor_tilt@mesial_pit", gone = "target_removed@distal_pit";
  for (const std::string& metric : {own, gone, std::string("depth_mean@mesial_pit")})
    ASSERT_TRUE(model->add_criterion(metric, first_bands(metric, model->scenario().target)));
  ASSERT_FALSE(has_criterion("floor_tilt"));
  const auto criterion_of = [&](const std::string& metric) {
    return *std::ranges::find(model->scenario().rubric.criteria, metric, &Criterion::metric);
  };
  const Bands bands = criterion_of(own).bands, of_whole = criterion_of("depth_mean").bands;
  const Scenario before = model->scenario();
  model->end_gesture();
  model->choose_part({1});
  ASSERT_TRUE(model->remove_part());
  ASSERT_TRUE(has_criterion("floor_tilt"));
  EXPECT_EQ(criterion_of("floor_tilt").bands, bands);
  EXPECT_EQ(criterion_of("depth_mean").bands, of_whole) << "the whole had its own";
  EXPECT_EQ(std::ranges::count_if(model->scenario().rubric.criteria, [](const Criterion& c) { return c.metric.contains('@'); }), 0);
  model->stack().undo();
  EXPECT_EQ(model->scenario(), before);
}

TEST_F(TwoShapes, The_depth_of_a_targets_own_outline_moves_its_own_bands) {
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  const Bands first = first_bands("depth_mean@mesial_pit", model->scenario().target);
  EXPECT_LE(first.ideal_lo, part(0).outline.depth_mm);
  EXPECT_GE(first.ideal_hi, part(0).outline.depth_mm);
  ASSERT_TRUE(model->add_criterion("depth_mean@mesial_pit", first));
  const auto bands_of = [&](const char* metric) {
    return std::ranges::find(model->scenario().rubric.criteria, metric, &Criterion::metric)->bands;
  };
  const Bands whole = bands_of("depth_mean");
  model->choose_part({0});
  ASSERT_TRUE(model->set_depth_mm(part(0).outline.depth_mm + 0.5));
  EXPECT_NEAR(bands_of("depth_mean@mesial_pit").ideal_lo, first.ideal_lo + 0.5, 1e-9);
  EXPECT_EQ(bands_of("depth_mean"), whole);
}

TEST_F(TwoShapes, A_language_that_is_removed_takes_its_titles) {
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  ASSERT_TRUE(model->set_target_title(0, "fr", QStringLiteral("Puits")));
  EXPECT_TRUE(model->remove_language("fr"));
  EXPECT_FALSE(part(0).title.contains("fr"));
  EXPECT_EQ(part(0).title.at("en"), "Mesial pit");
}

TEST_F(TwoShapes, The_texts_have_a_field_for_each_target_and_language) {
  TextsForm form(*model);
  const auto field = [&](const QString& name) -> QLineEdit* {
    for (QLineEdit* edit : form.findChildren<QLineEdit*>())
      if (edit->accessibleName() == name && !edit->isHidden() && !edit->parentWidget()->isHidden()) return edit;
    return nullptr;
  };
  const QString german = QStringLiteral("Name of target 1, Deutsch");
  EXPECT_EQ(field(german), nullptr);
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  ASSERT_NE(field(german), nullptr);
  EXPECT_EQ(field(german)->text(), QString());
  EXPECT_EQ(field(QStringLiteral("Name of target 1, English"))->text(), kPit);
  field(german)->setText(QStringLiteral("Mesiale Grube"));
  Q_EMIT field(german)->editingFinished();
  EXPECT_EQ(part(0).title.at("de"), "Mesiale Grube");
  ASSERT_TRUE(model->clear_target(0));
  EXPECT_EQ(field(german), nullptr);
}

TEST_F(TwoShapes, A_name_that_is_cleared_with_Return_leaves_the_field_of_the_other) {
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  ASSERT_TRUE(model->set_target_title(1, "en", QStringLiteral("Distal pit")));
  TextsForm form(*model);
  form.show();
  form.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&form));
  const auto field = [&](const QString& name) -> QLineEdit* {
    for (QLineEdit* edit : form.findChildren<QLineEdit*>())
      if (edit->accessibleName() == name && edit->isVisible()) return edit;
    return nullptr;
  };
  QLineEdit* first = field(QStringLiteral("Name of target 1, English"));
  ASSERT_NE(first, nullptr);
  first->setFocus();
  first->selectAll();
  QTest::keyClick(first, Qt::Key_Delete);
  QTest::keyClick(first, Qt::Key_Return);
  EXPECT_TRUE(part(0).name.empty());
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  EXPECT_EQ(field(QStringLiteral("Name of target 1, English")), nullptr);
  ASSERT_NE(field(QStringLiteral("Name of target 2, English")), nullptr);
  ASSERT_TRUE(model->set_target_title(1, "en", QStringLiteral("Other pit")));
  EXPECT_EQ(field(QStringLiteral("Name of target 2, English"))->text(), QStringLiteral("Other pit"));
}

TEST_F(TwoShapes, A_name_is_typed_where_the_shape_is_chosen) {
  PartsForm form(*model);
  form.show();
  auto* name = form.findChild<TargetNameForm*>()->findChild<QLineEdit*>();
  const auto type = [&](const QString& text) {
    name->setFocus();
    name->selectAll();
    QTest::keyClick(name, Qt::Key_Delete);
    QTest::keyClicks(name, text);
    QTest::keyClick(name, Qt::Key_Return);
  };
  model->choose_part({});
  EXPECT_FALSE(name->isVisible()) << "the whole target needs no name";
  model->choose_part({0});
  ASSERT_TRUE(name->isVisible());
  type(QStringLiteral(" Mesial pit "));
  EXPECT_EQ(part(0).name, "mesial_pit");
  EXPECT_EQ(part(0).title.at("en"), "Mesial pit");
  EXPECT_EQ(form.findChild<QTreeWidget*>()->topLevelItem(0)->child(0)->text(0), QStringLiteral("Mesial pit: Channel"));
  const int steps = model->stack().count();
  model->choose_part({1});
  EXPECT_EQ(name->text(), QString());
  model->choose_part({0});
  EXPECT_EQ(name->text(), kPit);
  EXPECT_EQ(model->stack().count(), steps) << "looking at it is no edit";
  ASSERT_TRUE(model->add_criterion("depth_mean@mesial_pit", first_bands("depth_mean@mesial_pit", model->scenario().target)));
  type(QStringLiteral("Distal pit"));
  EXPECT_EQ(part(0).name, "mesial_pit") << "criteria keep it";
  EXPECT_TRUE(has_criterion("depth_mean@mesial_pit"));
  type({});
  EXPECT_TRUE(part(0).name.empty());
  EXPECT_FALSE(has_criterion("depth_mean@mesial_pit"));
}

TEST_F(TwoShapes, A_half_typed_name_stays_when_the_tooth_has_grown) {
  model->choose_part({0});
  TargetNameForm form(*model);
  form.show();
  form.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&form));
  auto* name = form.findChild<QLineEdit*>();
  name->setFocus();
  QTest::keyClicks(name, QStringLiteral("Mesial"));
  model->set_facts(std::nullopt);  // changed(), as of a tooth that has grown
  QTest::keyClicks(name, QStringLiteral(" pit"));
  QTest::keyClick(name, Qt::Key_Return);
  EXPECT_EQ(name->text(), kPit);
  EXPECT_EQ(part(0).title.at("en"), "Mesial pit");
}

TEST_F(TwoShapes, The_points_follow_the_title_of_a_target) {
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  ASSERT_TRUE(model->add_criterion("depth_mean@mesial_pit", first_bands("depth_mean@mesial_pit", model->scenario().target)));
  PointsForm form(*model);
  const auto names = [&](const char* title) {
    return std::ranges::any_of(form.findChildren<QPushButton*>(), [&](const QPushButton* button) {
      return !button->isHidden() && button->accessibleName().startsWith(QStringLiteral("Bands of")) && button->accessibleName().contains(QLatin1String(title));
    });
  };
  EXPECT_TRUE(names("Mesial pit"));
  ASSERT_TRUE(model->set_target_title(0, "en", QStringLiteral("Distal pit")));
  EXPECT_TRUE(names("Distal pit"));
}

TEST_F(TwoShapes, The_criteria_to_add_name_the_target) {
  ASSERT_TRUE(model->set_target_title(0, "en", kPit));
  PointsForm form(*model);
  QComboBox* metrics = nullptr;
  for (QComboBox* box : form.findChildren<QComboBox*>())
    if (box->accessibleName() == QStringLiteral("Criterion to add")) metrics = box;
  ASSERT_NE(metrics, nullptr);
  const int row = metrics->findData(QStringLiteral("depth_most@mesial_pit"));
  ASSERT_GE(row, 0);
  EXPECT_EQ(metrics->itemText(row), QStringLiteral("Floor depth, deepest (Mesial pit)"));
  EXPECT_LT(metrics->findData(QStringLiteral("time@mesial_pit")), 0);
}

}  // namespace
}  // namespace cusp::test
