/// Waits for what a window comes to show, never for a length of time.
#pragma once

#include <QTest>

namespace cusp::test {

/// Runs the window's events until `condition` holds; false when it never did, and then something is wrong.
template <class Condition>
bool eventually(Condition&& condition) {
  constexpr int kRounds = 3000, kRoundMs = 10;
  for (int i = 0; i < kRounds; ++i) {
    if (condition()) return true;
    QTest::qWait(kRoundMs);
  }
  return false;
}

}  // namespace cusp::test
