// The switch that asks students for an own assessment.

#include <gtest/gtest.h>

#include <QCheckBox>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/editor/change_messages.h"
#include "ui/editor/points_form.h"

namespace cusp::test {
namespace {

TEST(OwnAssessmentSwitch, IsOneStepOfUndoANamedChangeAndNoReasonToTryTheExerciseAgain) {
  EditorStart start;
  start.draft = *load_builtin("channel-1");
  EditorModel model(start);
  PointsForm form(model);
  QCheckBox* box = nullptr;
  for (QCheckBox* one : form.findChildren<QCheckBox*>())
    if (one->text() == QStringLiteral("Own assessment before the result")) box = one;
  ASSERT_NE(box, nullptr);
  EXPECT_FALSE(box->isChecked());
  model.now_tried(model.scenario());
  box->click();
  EXPECT_TRUE(model.scenario().self_assessment);
  EXPECT_TRUE(model.tried());
  EXPECT_EQ(change_messages(start.draft, model.scenario()), QStringList{QStringLiteral("Own assessment before the result: new")});
  EXPECT_EQ(model.stack().count(), 1);
  model.stack().undo();
  EXPECT_FALSE(model.scenario().self_assessment);
  EXPECT_FALSE(box->isChecked());
}

}  // namespace
}  // namespace cusp::test
