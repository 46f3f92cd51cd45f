// An attempt with an Inverse3, over its service in miniature, whose handle is lost.
#include <gtest/gtest.h>

#include "tests/device/inverse/fake_service.h"
#include "tests/ui/drill/drill_end.h"

namespace cusp::test {
namespace {

using LostHandle = DrillEnd;

TEST_F(LostHandle, stops_the_attempt_and_is_named) {
  FakeService service;
  service.set_handle(FakeHandle{});
  DeviceChoice choice;
  choice.kind = "inverse3";
  choice.inverse.service.port = service.port();
  screen->use_device(choice);
  screen->begin(plan(), {QStringLiteral("Channel"), QStringLiteral("Practice")});
  ASSERT_TRUE(QTest::qWaitFor([&] { return screen->running(); }, kComesWithinMs));
  service.set_handle(std::nullopt);
  EXPECT_TRUE(wait_for_card("handle of the device"));
  EXPECT_TRUE(card_shows("Switch the handle on again"));
  screen.reset();  // before its service
}

}  // namespace
}  // namespace cusp::test
