// A foot pedal that is unplugged while somebody drills: the bur stops cutting, and the panel gives the reason.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>

#include "tests/ui/drill/drill_end.h"

namespace cusp::test {
namespace {

struct PedalMissed : DrillEnd {
  bool is_missed() const {
    for (const QLabel* label : screen->findChildren<QLabel*>())
      if (label->isVisible() && label->text().startsWith(QStringLiteral("The foot pedal is not plugged in"))) return true;
    return false;
  }
  bool plugged = false;
};

TEST_F(PedalMissed, is_named_until_it_is_plugged_in_again) {
  plugged = true;
  screen->watch_pedal([this] { return plugged; });
  begin(plan());
  EXPECT_FALSE(is_missed());
  plugged = false;
  EXPECT_TRUE(QTest::qWaitFor([this] { return is_missed(); }, kComesWithinMs));
  plugged = true;
  EXPECT_TRUE(QTest::qWaitFor([this] { return !is_missed(); }, kComesWithinMs));
}

TEST_F(PedalMissed, is_not_missed_where_none_was_plugged_in) {
  screen->watch_pedal([this] { return plugged; });
  begin(plan());
  let_it_run();
  EXPECT_FALSE(is_missed());
}

}  // namespace
}  // namespace cusp::test
