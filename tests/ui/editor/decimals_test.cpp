// Points, pass mark and expected time with decimals.

#include <gtest/gtest.h>

#include <QApplication>
#include <QLineEdit>
#include <QTest>
#include <algorithm>

#include "scenarios/format/read.h"
#include "scenarios/format/write.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/editor/points_form.h"
#include "ui/editor/texts_form.h"
#include "ui/text/grade_text.h"
#include "ui/text/language.h"
#include "ui/widgets/number_field.h"

namespace cusp::test {
namespace {

struct EditorDecimals : ::testing::Test {
  EditorStart start;
  std::unique_ptr<EditorModel> model;
  std::unique_ptr<PointsForm> points;
  std::unique_ptr<TextsForm> texts;
  void open() {
    start.draft = *load_builtin("channel-1");
    start.draft.rubric.pass = 70;
    start.draft.rubric.criteria[0].weight = 30;
    start.draft.expected_time_s = 900;
    model = std::make_unique<EditorModel>(start);
    points = std::make_unique<PointsForm>(*model);
    texts = std::make_unique<TextsForm>(*model);
  }
  ~EditorDecimals() override { install_language(*qApp, QStringLiteral("en")); }
  NumberField* pass() { return field(*points, [](const NumberField& f) { return f.maximum() == 100; }); }
  NumberField* weight() { return field(*points, [](const NumberField& f) { return f.maximum() == 1000; }); }
  NumberField* minutes() { return field(*texts, [](const NumberField& f) { return f.suffix().endsWith(QStringLiteral("min")); }); }
  static void type(NumberField* field, const char* text) {
    field->selectAll();
    QTest::keyClicks(field, QString::fromUtf8(text));
    QTest::keyClick(field, Qt::Key_Return);
  }

 private:
  template <class Which>
  static NumberField* field(QWidget& form, const Which& which) {
    const auto all = form.findChildren<NumberField*>();
    const auto at = std::ranges::find_if(all, [&](const NumberField* f) { return which(*f); });
    return at == all.end() ? nullptr : *at;
  }
};

TEST_F(EditorDecimals, are_taken_kept_in_the_file_and_undone_one_by_one) {
  open();
  const std::size_t found = model->findings().size();
  type(weight(), "30.25");
  type(pass(), "66.5");
  type(minutes(), "12.5");
  const Scenario& now = model->scenario();
  EXPECT_EQ(now.rubric.criteria[0].weight, 30.25);
  EXPECT_EQ(now.rubric.pass, 66.5);
  EXPECT_EQ(now.expected_time_s, 750);
  EXPECT_EQ(model->findings().size(), found);
  const auto read = read_scenario(canonical_json(now));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, now);
  EXPECT_EQ(model->stack().count(), 3);
  model->stack().undo();
  EXPECT_EQ(minutes()->value(), 15);
  model->stack().undo();
  EXPECT_EQ(pass()->value(), 70);
  model->stack().undo();
  EXPECT_EQ(weight()->value(), 30);
  EXPECT_EQ(now, start.draft);
}

TEST_F(EditorDecimals, stand_only_where_a_value_needs_them_and_with_the_language_s_sign) {
  install_language(*qApp, QStringLiteral("de"));
  open();
  EXPECT_EQ(weight()->text(), QStringLiteral("30"));
  EXPECT_EQ(pass()->text(), QStringLiteral("70"));
  EXPECT_EQ(minutes()->text(), QStringLiteral("15\u00A0min"));
  type(weight(), "12,50");
  type(pass(), "66,5");
  type(minutes(), "7,5");
  EXPECT_EQ(model->scenario().rubric.criteria[0].weight, 12.5);
  EXPECT_EQ(weight()->text(), QStringLiteral("12,5"));
  EXPECT_EQ(pass()->text(), QStringLiteral("66,5"));
  EXPECT_EQ(minutes()->text(), QStringLiteral("7,5\u00A0min"));
  type(weight(), "100");
  EXPECT_EQ(weight()->text(), QStringLiteral("100"));
}

TEST_F(EditorDecimals, of_a_file_stay_when_their_fields_are_left) {
  open();
  ASSERT_TRUE(model->set_expected_time_s(100));  // 1.667 min
  ASSERT_TRUE(model->set_pass(66.67));
  model->end_gesture();
  const Scenario before = model->scenario();
  for (NumberField* field : {minutes(), pass()}) QTest::keyClick(field, Qt::Key_Return);
  EXPECT_EQ(model->scenario(), before);
  EXPECT_EQ(minutes()->text(), QStringLiteral("1.7\u00A0min"));
}

TEST_F(EditorDecimals, below_the_format_s_range_are_named_by_the_checks) {
  open();
  type(weight(), "0.05");
  EXPECT_EQ(model->scenario().rubric.criteria[0].weight, 0.05);
  EXPECT_TRUE(std::ranges::any_of(model->findings(), [](const auto& f) { return f.path == "/rubric/criteria/0/weight"; }));
  type(weight(), "0.1");
  EXPECT_TRUE(std::ranges::none_of(model->findings(), [](const auto& f) { return f.path == "/rubric/criteria/0/weight" && f.code == "out_of_range"; }));
}

}  // namespace
}  // namespace cusp::test
