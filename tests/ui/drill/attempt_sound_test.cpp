// The sound of an attempt whose output comes late, or goes away and comes back.
#include "ui/drill/attempt_sound.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QSlider>
#include <QTest>
#include <QTimer>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "ui/sound/drill_sound.h"

namespace cusp::test {
namespace {

constexpr int kHeardMs = 60'000;  // waits for progress, never decides

/// An output that a test plugs and unplugs.
class PluggedSound final : public DrillSound {
 public:
  bool start() override {
    ++starts;
    open = plugged;
    return open;
  }
  bool available() const override { return open; }
  void unplug() {
    plugged = open = false;
    Q_EMIT lost();
  }
  bool plugged = true, open = false;
  int starts = 0;
};

struct SoundOfAnAttempt : testing::Test {
  SoundOfAnAttempt() {
    scenario.phenomena = {"spindle-turbine", "sound"};
    panel.set_exercise(scenario);
  }
  bool shows_that_there_is_none() const {
    for (const QLabel* label : panel.findChildren<QLabel*>())
      if (!label->isHidden() && label->text().startsWith(QStringLiteral("No sound"))) return true;
    return false;
  }
  bool is_heard() {
    return QTest::qWaitFor([this] { return sound.open; }, kHeardMs);
  }
  QTimer& again() { return *attempt.findChild<QTimer*>(); }

  Scenario scenario = load_builtin("channel-1").value();
  HandpiecePanel panel;
  PluggedSound sound;
  AttemptSound attempt{panel, nullptr, &sound};
};

TEST_F(SoundOfAnAttempt, comes_back_with_its_output_as_loud_as_it_was) {
  attempt.begin(scenario);
  EXPECT_FALSE(shows_that_there_is_none());
  auto* volume = panel.findChild<QSlider*>();
  volume->setValue(30);
  sound.unplug();
  EXPECT_TRUE(shows_that_there_is_none());
  sound.plugged = true;
  ASSERT_TRUE(is_heard());
  EXPECT_FALSE(shows_that_there_is_none());
  EXPECT_EQ(volume->value(), 30);
  EXPECT_FALSE(again().isActive());
}

TEST_F(SoundOfAnAttempt, begins_late_and_an_output_that_is_missing_is_asked_for_more_and_more_rarely) {
  sound.plugged = false;
  attempt.begin(scenario);
  EXPECT_TRUE(shows_that_there_is_none());
  const int first = again().interval();
  ASSERT_TRUE(QTest::qWaitFor([this] { return sound.starts == 2; }, kHeardMs));
  EXPECT_EQ(again().interval(), 2 * first);
  sound.plugged = true;
  ASSERT_TRUE(is_heard());
  EXPECT_FALSE(shows_that_there_is_none());
}

TEST_F(SoundOfAnAttempt, looks_for_no_output_once_it_is_over_or_where_the_exercise_has_no_sound) {
  attempt.begin(scenario);
  sound.unplug();
  EXPECT_TRUE(again().isActive());
  attempt.stop();
  EXPECT_FALSE(again().isActive());
  scenario.phenomena = {"spindle-turbine"};
  attempt.begin(scenario);
  EXPECT_FALSE(again().isActive());
  EXPECT_EQ(sound.starts, 1);
}

}  // namespace
}  // namespace cusp::test
