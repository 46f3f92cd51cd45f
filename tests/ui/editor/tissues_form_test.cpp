// The tilt of the handpiece: its field, its range, undo, and where its messages lead.

#include <gtest/gtest.h>

#include "scenarios/library/library.h"
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

}  // namespace
}  // namespace cusp::test
