// The cards of the exercises: their keys.
#include <gtest/gtest.h>

#include <QPersistentModelIndex>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>

#include "scenarios/format/content_hash.h"
#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/desk_records.h"
#include "ui/student/exercise_cards.h"
#include "ui/student/exercises_page.h"
#include "ui/widgets/parts.h"

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

TEST(ExercisesPage, names_who_mends_an_exercise_that_cannot_be_read) {
  DeskRecords records;
  Store& store = records.store();
  const Actor author = store.accounts.create(records.administrator().actor(), {"berg", "Dr Berg", Role::instructor, "correct horse", ""})->actor();
  Scenario newer = *load_builtin("channel-1");
  newer.id = ScenarioId::make();
  newer.key.clear();
  ASSERT_TRUE(store.scenarios.publish(author, newer, R"({"format":99})", content_hash(newer).bytes));
  const QTemporaryDir cache;
  ThumbnailCache pictures(cache.path().toStdString());
  const ExercisesPage page(store, records.student("1", "Lena Brandt").actor(), pictures, {});
  const auto* band = page.findChild<Band*>();
  ASSERT_NE(band, nullptr);
  EXPECT_TRUE(band->text().contains(QStringLiteral("An instructor publishes them again"))) << band->text().toStdString();
}

}  // namespace
}  // namespace cusp::test
