#include "ui/drill/stop_card.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "tests/modules.h"
#include "ui/drill/drill_stage.h"

namespace cusp::test {
namespace {

bool shows(const StopCard& card, const char* text) {
  for (const QLabel* label : card.findChildren<QLabel*>())
    if (!label->isHidden() && label->text().contains(QLatin1String(text))) return true;
  return false;
}

TEST(StopCard, asks_for_the_same_falcon_where_another_one_would_be_taken_for_it) {
  StopCard card;
  card.show_stop(StopCard::Stop::device_gone, {}, Fault::gone);
  FalconView view;
  card.show_falcon(&view);
  card.fit({420, 2000});
  EXPECT_FALSE(shows(card, "serial number"));
  view.by_port = true;
  EXPECT_TRUE(card.show_falcon(&view)) << "the card grows";
  card.fit({420, 2000});
  EXPECT_TRUE(shows(card, "Plug it in again where it was"));
  EXPECT_TRUE(shows(card, "serial number"));
  EXPECT_FALSE(card.show_falcon(&view));
  card.show_stop(StopCard::Stop::device_back, {}, Fault::gone);
  EXPECT_TRUE(card.show_falcon(&view));
  card.fit({420, 2000});
  EXPECT_FALSE(shows(card, "serial number"));
}

TEST(StopCard, names_the_handle_where_it_alone_is_lost) {
  DrillStage stage;
  const auto* card = stage.findChild<StopCard*>();
  LiveView live;
  live.phase = LoopPhase::held;
  live.fault = Fault::gone;
  live.device = Sample::Status::gone;
  stage.set_handle_gone(true);
  stage.show_values(live);
  EXPECT_TRUE(shows(*card, "Switch the handle on again"));
  EXPECT_FALSE(shows(*card, "Plug it in again"));
  stage.set_handle_gone(false);  // now the whole device
  stage.show_values(live);
  EXPECT_TRUE(shows(*card, "Plug it in again"));
  live.device = Sample::Status::fresh;
  stage.show_values(live);
  EXPECT_TRUE(shows(*card, "answers again"));
}

}  // namespace
}  // namespace cusp::test
