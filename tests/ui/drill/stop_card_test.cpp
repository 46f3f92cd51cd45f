#include "ui/drill/stop_card.h"

#include <gtest/gtest.h>

#include <QLabel>

#include "tests/modules.h"

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

}  // namespace
}  // namespace cusp::test
