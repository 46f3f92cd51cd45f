// The reference preparation as it is watched, without pictures: platform "offscreen".

#include "ui/replay/reference_page.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/replay/playback_bar.h"
#include "ui/view/tooth_view.h"
#include "ui/widgets/empty_state.h"

namespace cusp::test {
namespace {

constexpr int kPatienceMs = 60'000;  // waits for progress, never decides

Scenario coarse_channel() {
  Scenario out = *load_builtin("channel-1");
  out.specimen.voxel_mm = 0.4;
  return out;
}

struct Watching : testing::Test {
  explicit Watching(const Scenario& scenario = coarse_channel())
      : page(std::make_shared<ToothCache>(std::filesystem::path()), {scenario, {}, Guidance::full, nullptr}, QStringLiteral("Channel")) {
    page.show();
  }
  void wait_until_ready() { ASSERT_TRUE(QTest::qWaitFor([&] { return page.ready(); }, kPatienceMs)); }
  void wait_until_shown(double s) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return page.shown_s() == s; }, kPatienceMs)) << page.shown_s();
  }
  /// Of the surface in the view, in the middle of the target.
  double height_mm() const {
    Ray down{page.view()->camera().centre_mm(), {0, 0, -1}};
    down.from_mm.z += 20;
    const auto hit = page.view()->store().pick(down);
    return hit ? hit->at_mm.z : -1e9;
  }
  bool shows(const QString& part) const {
    for (const QLabel* label : page.findChildren<QLabel*>())
      if (label->isVisible() && label->text().contains(part)) return true;
    return false;
  }
  ReferencePage page;
};

TEST(Reference, of_a_very_long_name_is_no_wider_than_its_window) {
  const QString name = QString(QStringLiteral("Class II cavity with two boxes ")).repeated(10);
  const ReferencePage page(std::make_shared<ToothCache>(std::filesystem::path()), {coarse_channel(), {}, Guidance::full, nullptr}, name);
  EXPECT_LE(page.minimumSizeHint().width(), 1080);
}

TEST_F(Watching, begins_by_itself_with_the_tooth_uncut_and_names_what_it_shows) {
  wait_until_ready();
  EXPECT_TRUE(page.bar()->playing());
  EXPECT_TRUE(page.bur_now().has_value());
  EXPECT_TRUE(shows(QStringLiteral("Ideal preparation")));
}

TEST_F(Watching, ends_with_the_finished_preparation_and_without_the_bur) {
  wait_until_ready();
  page.bar()->set_playing(false);
  QTest::keyClick(&page, Qt::Key_Home);
  wait_until_shown(0);
  const double uncut_mm = height_mm();
  QTest::keyClick(&page, Qt::Key_End);
  wait_until_shown(30);
  EXPECT_FALSE(page.bur_now().has_value());
  EXPECT_TRUE(shows(QStringLiteral("finished")));
  const auto lies_deeper = [&] { return height_mm() < uncut_mm - 0.8; };  // the channel is 1 mm deep or more
  EXPECT_TRUE(QTest::qWaitFor(lies_deeper, kPatienceMs)) << uncut_mm << ", " << height_mm();
  QTest::keyClick(&page, Qt::Key_Home);
  wait_until_shown(0);
  // Going back takes the cuts back.
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::abs(height_mm() - uncut_mm) < 0.01; }, kPatienceMs)) << uncut_mm << ", " << height_mm();
}

TEST_F(Watching, is_called_finished_no_sooner_than_the_tooth_is_cut) {
  wait_until_ready();
  page.bar()->set_playing(false);
  page.bar()->seek(0);
  wait_until_shown(0);
  page.bar()->seek(30);  // the cuts follow behind
  ASSERT_LT(page.shown_s(), 30);
  EXPECT_FALSE(shows(QStringLiteral("finished")));
  EXPECT_TRUE(page.bur_now().has_value());
  wait_until_shown(30);
  EXPECT_TRUE(shows(QStringLiteral("finished")));
  EXPECT_FALSE(page.bur_now().has_value());
}

TEST_F(Watching, the_bur_cuts_only_while_it_plays) {
  wait_until_ready();
  page.bar()->set_playing(false);
  page.bar()->seek(15);
  wait_until_shown(15);
  ASSERT_TRUE(page.bur_now().has_value());
  EXPECT_FALSE(page.bur_now()->turning);
}

TEST_F(Watching, the_keyboard_alone_plays_turns_and_leaves) {
  wait_until_ready();
  QTest::keyClick(&page, Qt::Key_Space);
  EXPECT_FALSE(page.bar()->playing());
  const Camera before = page.view()->camera();
  QTest::keyClick(&page, Qt::Key_3);
  EXPECT_NE(page.view()->camera(), before);
  QTest::keyClick(&page, Qt::Key_1);
  QSignalSpy back(&page, &ReferencePage::back_wanted);
  QTest::keyClick(&page, Qt::Key_Escape);
  EXPECT_EQ(back.count(), 1);
}

struct WatchingNothing : Watching {
  static Scenario without_its_tooth() {
    Scenario out = coarse_channel();
    out.specimen = {};
    out.specimen.volume = "missing.nrrd";
    return out;
  }
  WatchingNothing() : Watching(without_its_tooth()) {}
};

TEST_F(WatchingNothing, an_exercise_whose_tooth_is_missing_gives_the_reason_and_one_way_back) {
  EXPECT_TRUE(QTest::qWaitFor([&] { return page.findChild<EmptyState*>() != nullptr; }, kPatienceMs));
  EXPECT_FALSE(page.ready());
  EXPECT_FALSE(page.bar()->isEnabled());
  QSignalSpy back(&page, &ReferencePage::back_wanted);
  page.findChild<EmptyState*>()->button()->click();
  EXPECT_EQ(back.count(), 1);
}

TEST(Reference, is_not_offered_without_target_or_bur) {
  Scenario scenario = coarse_channel();
  EXPECT_TRUE(ReferencePage::offered(scenario));
  scenario.instruments.clear();
  EXPECT_FALSE(ReferencePage::offered(scenario));
  scenario = coarse_channel();
  scenario.target = {};
  EXPECT_FALSE(ReferencePage::offered(scenario));
}

TEST(Reference, is_offered_of_a_target_whose_leaves_are_of_the_tooths_voxels) {
  EXPECT_TRUE(ReferencePage::offered(load_builtin("caries-26").value()));
}

}  // namespace
}  // namespace cusp::test
