// The section through the tooth of the editor.
#include <QLabel>
#include <QPushButton>
#include <QSlider>

#include "tests/ui/editor/editor_pages.h"
#include "ui/view/section_bar.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

struct EditorSection : EditorPages {};

TEST_F(EditorSection, opens_with_a_slider_and_closes_again) {
  const auto page = open();
  TargetView& stage = *page->stage();
  EXPECT_FALSE(stage.section()->isVisible());
  auto* button = named<QPushButton>(*page, "Section");
  ASSERT_NE(button, nullptr);
  button->click();
  EXPECT_TRUE(stage.section()->isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] { return stage.view()->scene().cutaway.has_value(); }, kGrowsWithinMs));
  EXPECT_TRUE(stage.rect().contains(stage.section()->geometry()));
  button->click();
  EXPECT_FALSE(stage.section()->isVisible());
  EXPECT_FALSE(stage.view()->scene().cutaway);
}

TEST_F(EditorSection, follows_an_edit_of_the_target_and_keeps_its_handles) {
  const auto page = open();
  TargetView& stage = *page->stage();
  named<QPushButton>(*page, "Section")->click();
  ASSERT_TRUE(QTest::qWaitFor([&] { return stage.view()->scene().cutaway.has_value(); }, kGrowsWithinMs));
  stage.section()->slider()->setValue(3);
  EXPECT_FALSE(knobs_of(stage).empty());
  QSignalSpy drawn(stage.section(), &SectionBar::shown);
  page->model().set_depth_mm(2.4);
  EXPECT_TRUE(QTest::qWaitFor([&] { return drawn.count() > 0; }, kGrowsWithinMs));
  EXPECT_DOUBLE_EQ(stage.section()->place_mm(), 0.3);
}

}  // namespace
}  // namespace cusp::test
