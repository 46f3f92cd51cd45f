// The section of a report: the drilled walls beside those of the reference preparation.

#include "ui/report/report_section.h"

#include <gtest/gtest.h>

#include <QSlider>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/report/pinned_tooth.h"
#include "ui/session/scene_builder.h"
#include "ui/view/section_bar.h"
#include "ui/view/tooth_view.h"

namespace cusp::test {
namespace {

constexpr int kSectionPatienceMs = 60'000;  // waits for progress, never decides

struct SectionOfAReport : testing::Test {
  SectionOfAReport() {
    scenario.specimen.voxel_mm = 0.4;
    uncut = std::make_shared<const Volume>(build_specimen(scenario, {}).value());
    tooth = std::make_unique<PinnedTooth>(uncut, scenario);
    section = std::make_unique<ReportSection>(*tooth, uncut, scenario);
    tooth->resize(600, 500);
    tooth->show();
    EXPECT_TRUE(QTest::qWaitFor([&] { return tooth->tooth_shown(); }, kSectionPatienceMs));
  }
  Scenario scenario = *load_builtin("channel-1");
  std::shared_ptr<const Volume> uncut;
  std::unique_ptr<PinnedTooth> tooth;
  std::unique_ptr<ReportSection> section;
};

TEST_F(SectionOfAReport, shows_the_walls_of_the_reference_preparation_once_it_is_opened) {
  EXPECT_FALSE(section->reference_known());
  section->set_open(true);
  ASSERT_TRUE(QTest::qWaitFor([&] { return section->reference_known(); }, kSectionPatienceMs));
  EXPECT_TRUE(QTest::qWaitFor([&] { return tooth->view()->scene().cutaway.has_value(); }, kSectionPatienceMs));
  section->set_open(false);
  EXPECT_FALSE(tooth->view()->scene().cutaway);
}

TEST_F(SectionOfAReport, goes_through_the_pinned_place_and_marks_it_while_it_is_there) {
  const Vec3 place = section->bar()->plane().centre_mm + Vec3(0.4, 0.3, 5.0);
  tooth->pin(place, QStringLiteral("Floor"), {});
  section->set_open(true);
  EXPECT_NEAR(glm::dot(section->bar()->plane().centre_mm - place, section->bar()->plane().normal()), 0.0, 1e-9);
  EXPECT_TRUE(tooth->ring_shown());
  section->bar()->slider()->setValue(section->bar()->slider()->value() + 5);
  EXPECT_FALSE(tooth->ring_shown());
  section->go_through(place);
  EXPECT_TRUE(tooth->ring_shown());
}

TEST_F(SectionOfAReport, leaves_a_place_to_the_view_again_when_it_is_closed) {
  tooth->pin(section->bar()->plane().centre_mm + Vec3(0.0, 0.0, 5.0), QStringLiteral("Floor"), {});  // 1 mm below the uncut surface
  EXPECT_FALSE(tooth->ring_shown());
  section->set_open(true);
  EXPECT_TRUE(tooth->ring_shown());
  section->set_open(false);
  EXPECT_FALSE(tooth->ring_shown());
}

}  // namespace
}  // namespace cusp::test
