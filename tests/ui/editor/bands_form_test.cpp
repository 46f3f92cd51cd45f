// The bands of a criterion as a picture: an edge is dragged, moved by keys and by a screen reader, and each is one step of undo.

#include <gtest/gtest.h>

#include <QAccessible>
#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "scenarios/grading/bands.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/looks.h"
#include "ui/editor/band_picture.h"
#include "ui/editor/bands_form.h"
#include "ui/editor/editor_model.h"
#include "ui/editor/first_bands.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

constexpr Bands kDrawn{1.2, 1.3, 1.5, 2.0, 2.5, 3.0};  // mm

/// channel-1 with bands of depth_mean as above, in a form of its own.
struct BandsForms : ::testing::Test {
  std::unique_ptr<EditorModel> model;
  std::unique_ptr<BandsForm> form;
  std::size_t index = 0;
  void SetUp() override {
    EditorStart start;
    start.draft = *load_builtin("channel-1");
    auto& criteria = start.draft.rubric.criteria;
    index = static_cast<std::size_t>(std::ranges::find(criteria, "depth_mean", &Criterion::metric) - criteria.begin());
    ASSERT_LT(index, criteria.size());
    criteria[index].bands = kDrawn;
    model = std::make_unique<EditorModel>(start);
    form = std::make_unique<BandsForm>(*model, index);
    QObject::connect(model.get(), &EditorModel::changed, form.get(), &BandsForm::follow_model);
    form->resize(336, 400);
    form->show();
    QCoreApplication::processEvents();
  }
  BandPicture& picture() { return form->picture(); }
  const Bands& bands() const { return model->scenario().rubric.criteria[index].bands; }
  QPoint spot(std::size_t edge) {
    const BandSpot at = picture().scale().spot_of(edge, picture().plot());
    return {qRound(at.x), qRound(at.y)};
  }
  NumberField* number(const char* name) {
    for (NumberField* field : form->findChildren<NumberField*>())
      if (field->accessibleName() == QLatin1String(name)) return field;
    return nullptr;
  }
  TryOut of(TriedBy by, double mm, double uncertainty) {
    TryOut out{by, model->scenario(), {}};
    out.measures.push_back({"depth_mean", true, mm, uncertainty, "mm", {}});
    return out;
  }
};

TEST_F(BandsForms, an_edge_is_dragged_with_snapped_steps_and_one_undo_takes_the_drag_back) {
  const QPoint from = spot(3), to(qRound(picture().scale().x_of(2.21, picture().plot())), from.y() + 20);
  QTest::mousePress(&picture(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 5; ++i) QTest::mouseMove(&picture(), from + (to - from) * i / 5);
  EXPECT_DOUBLE_EQ(bands().ideal_hi, 2.2) << "while it is dragged";
  QTest::mouseRelease(&picture(), Qt::LeftButton, {}, to);
  EXPECT_DOUBLE_EQ(bands().ideal_hi, 2.2);
  EXPECT_DOUBLE_EQ(number("Floor depth, mean: Full to")->value(), 2.2);
  EXPECT_EQ(model->stack().count(), 1);
  model->stack().undo();
  EXPECT_EQ(bands(), kDrawn);
  EXPECT_DOUBLE_EQ(number("Floor depth, mean: Full to")->value(), 2.0);
  EXPECT_EQ(spot(3), from) << "the picture follows";
}

TEST_F(BandsForms, an_edge_stops_at_its_neighbour) {
  QTest::mousePress(&picture(), Qt::LeftButton, {}, spot(3));
  QTest::mouseMove(&picture(), QPoint(picture().width() + 50, spot(3).y()));
  QTest::mouseRelease(&picture(), Qt::LeftButton, {}, QPoint(picture().width() + 50, spot(3).y()));
  EXPECT_DOUBLE_EQ(bands().ideal_hi, bands().acc_hi);
  EXPECT_DOUBLE_EQ(bands().acc_hi, 2.5);
}

TEST_F(BandsForms, a_press_beside_every_edge_changes_nothing) {
  const BandPlot plot = picture().plot();
  const QPoint middle(qRound(picture().scale().x_of(1.75, plot)), qRound(plot.top + plot.height));
  QTest::mousePress(&picture(), Qt::LeftButton, {}, middle);
  QTest::mouseMove(&picture(), middle + QPoint(60, 0));
  QTest::mouseRelease(&picture(), Qt::LeftButton, {}, middle + QPoint(60, 0));
  EXPECT_EQ(bands(), kDrawn);
  EXPECT_FALSE(model->stack().canUndo());
}

TEST_F(BandsForms, keys_move_an_edge_by_a_step_and_with_shift_by_a_fine_one) {
  BandKnob* knob = picture().knob(2);
  QTest::keyClick(knob, Qt::Key_Left);
  EXPECT_DOUBLE_EQ(bands().ideal_lo, 1.45);
  QTest::keyClick(knob, Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(bands().ideal_lo, 1.46);
  EXPECT_EQ(model->stack().count(), 2) << "one step of undo for each key";
}

TEST_F(BandsForms, a_screen_reader_finds_each_edge_with_name_value_and_limits_and_sets_it) {
  QAccessibleInterface* edge = QAccessible::queryAccessibleInterface(picture().knob(3));
  ASSERT_NE(edge, nullptr);
  EXPECT_EQ(edge->role(), QAccessible::Slider);
  EXPECT_EQ(edge->text(QAccessible::Name), QStringLiteral("Floor depth, mean: Full to"));
  EXPECT_TRUE(edge->text(QAccessible::Value).contains(QStringLiteral("2.00")));
  QAccessibleValueInterface* value = edge->valueInterface();
  ASSERT_NE(value, nullptr);
  EXPECT_DOUBLE_EQ(value->minimumValue().toDouble(), 1.5);
  EXPECT_DOUBLE_EQ(value->maximumValue().toDouble(), 2.5);
  value->setCurrentValue(2.13);
  EXPECT_DOUBLE_EQ(bands().ideal_hi, 2.13);
}

TEST_F(BandsForms, a_mark_stands_for_a_measured_value_and_goes_when_the_target_changes) {
  const auto texts = [&] {
    QString out;
    for (const QLabel* label : form->findChildren<QLabel*>()) out += label->text() + u'\n';
    return out;
  };
  const int bare = picture().sizeHint().height();
  EXPECT_FALSE(texts().contains(QStringLiteral("operator")));
  model->now_tried(of(TriedBy::reference, 1.98, 0.02));
  model->now_tried(of(TriedBy::author, 2.31, 0.05));
  EXPECT_TRUE(texts().contains(QStringLiteral("Reference operator"))) << texts().toStdString();
  EXPECT_TRUE(texts().contains(QStringLiteral("Your try-out"))) << texts().toStdString();
  EXPECT_FALSE(texts().contains(QStringLiteral("Novice"))) << "it was never measured";
  EXPECT_GT(picture().sizeHint().height(), bare);
  model->set_pass(80);
  EXPECT_TRUE(texts().contains(QStringLiteral("Reference operator"))) << "a rubric measures nothing";
  model->set_depth_mm(1.7);
  EXPECT_FALSE(texts().contains(QStringLiteral("Reference operator"))) << "it cut another target";
  model->stack().undo();
  EXPECT_TRUE(texts().contains(QStringLiteral("Reference operator")));
}

TEST_F(BandsForms, bands_out_of_order_have_numbers_and_no_picture) {
  Bands wrong = kDrawn;
  wrong.ideal_hi = 2.8;
  ASSERT_TRUE(model->set_bands(index, wrong));
  EXPECT_FALSE(picture().isVisible());
  ASSERT_TRUE(model->set_bands(index, kDrawn));
  EXPECT_TRUE(picture().isVisible());
}

TEST_F(EditorPages, measuring_the_operators_is_stopped_by_its_button_and_by_a_change_that_it_would_not_show) {
  const auto page = open();
  auto* button = named<QPushButton>(*page, "Measure the operators");
  ASSERT_NE(button, nullptr);
  const auto says = [&](const char* words) {
    return std::ranges::any_of(page->findChildren<QLabel*>(), [&](const QLabel* label) { return label->text() == QLatin1String(words); });
  };
  ASSERT_TRUE(button->isEnabled());
  button->click();
  EXPECT_TRUE(says("Measuring"));
  EXPECT_EQ(button->accessibleName(), QStringLiteral("Stop measuring"));
  ASSERT_TRUE(button->isEnabled());
  button->click();
  EXPECT_FALSE(says("Measuring"));
  EXPECT_EQ(button->accessibleName(), QStringLiteral("Measure the operators"));

  button->click();
  ASSERT_TRUE(page->model().set_pass(80));
  EXPECT_TRUE(says("Measuring")) << "a rubric measures nothing";
  ASSERT_TRUE(page->model().set_depth_mm(1.7));
  EXPECT_FALSE(says("Measuring"));
  EXPECT_TRUE(says("Stopped: the exercise was changed."));
  EXPECT_EQ(button->accessibleName(), QStringLiteral("Measure the operators"));
}

TEST_F(BandsForms, look_as_they_are_meant) {
  if (!pictures_wanted()) return;
  in_each_look([&](const QString& look) {
    SetUp();
    model->now_tried(of(TriedBy::reference, 1.98, 0.02));
    model->now_tried(of(TriedBy::author, 2.31, 0.05));
    model->now_tried(of(TriedBy::competent, 2.2, 0.02));
    model->now_tried(of(TriedBy::novice, 7.0, 0.02));
    picture().knob(3)->setFocus();
    QTest::qWait(50);
    leave_picture(*form, QStringLiteral("bands-") + look);
  });
}

TEST(BandsForm, takes_any_time_that_an_attempt_can_last_and_a_new_criterion_of_time_costs_no_points) {
  constexpr double kLongestS = 8 * 3600.0;  // a day's course
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  EditorModel model(start);
  const Bands first = first_bands("time", model.scenario().target);
  EXPECT_EQ(share_of_points(first, 0.0), 1.0);
  EXPECT_EQ(share_of_points(first, kLongestS), 1.0);
  ASSERT_TRUE(model.add_criterion("time", first));
  const BandsForm form(model, model.scenario().rubric.criteria.size() - 1);
  for (const NumberField* field : form.findChildren<NumberField*>()) EXPECT_GE(field->maximum(), kLongestS);
}

}  // namespace
}  // namespace cusp::test
