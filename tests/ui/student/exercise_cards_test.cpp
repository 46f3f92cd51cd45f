// The cards of the exercises: their keys.
#include <gtest/gtest.h>

#include <QPersistentModelIndex>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>

#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/exercise_cards.h"
#include "ui/student/exercises_page.h"

namespace cusp::test {
namespace {

TEST(Cards, take_the_page_along_when_keys_move_over_them) {
  DeskRecords records;
  const QTemporaryDir cache;
  ThumbnailCache pictures(cache.path().toStdString());
  ExercisesPage page(records.store(), records.student("1", "Lena Brandt").actor(), pictures, {});
  page.resize(653, 485);  // of a window of 960 x 540
  page.show();
  const auto* area = page.findChild<QScrollArea*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return area->verticalScrollBar()->maximum() > 0; }));
  ExerciseCards* cards = page.cards(ExerciseGroup::class_1);
  ASSERT_NE(cards, nullptr);
  const QModelIndex first = cards->model()->index(0, 0), last = cards->model()->index(cards->model()->rowCount() - 1, 0);
  ASSERT_TRUE(QTest::qWaitFor([&] { return cards->viewport()->rect().contains(cards->visualRect(last)); }));
  const auto in_view = [&] {
    const QRect card = cards->visualRect(cards->currentIndex());
    const int top = cards->viewport()->mapTo(area->viewport(), card.topLeft()).y();
    return area->viewport()->rect().contains(QRect(0, top, 1, card.height()));
  };
  const auto press_until_the_end = [&](Qt::Key key) {
    for (QPersistentModelIndex before; before != cards->currentIndex();) {
      before = cards->currentIndex();
      QTest::keyClick(cards, key);
    }
  };
  cards->setCurrentIndex(first);
  ASSERT_TRUE(in_view());
  press_until_the_end(Qt::Key_Down);
  ASSERT_GT(cards->visualRect(cards->currentIndex()).top(), area->viewport()->height()) << "below what the page showed first";
  EXPECT_TRUE(in_view());
  press_until_the_end(Qt::Key_Up);
  ASSERT_EQ(cards->currentIndex(), first);
  EXPECT_TRUE(in_view());
}

}  // namespace
}  // namespace cusp::test
