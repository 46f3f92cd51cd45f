// Forms that are made one a turn of the event loop.
#include "ui/editor/later_forms.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QScrollArea>
#include <QTest>
#include <memory>

#include "tests/modules.h"

namespace cusp::test {
namespace {

struct LaterFormsTest : ::testing::Test {
  LaterForms forms;
  QStringList made;
  std::unique_ptr<QWidget> page(const char* name) {
    return std::unique_ptr<QWidget>(forms.add([this, name] {
      made << QLatin1String(name);
      return new QLabel(QLatin1String(name));
    }));
  }
};

TEST_F(LaterFormsTest, forms_come_once_each_in_their_order) {
  const auto shape = page("shape"), points = page("points"), burs = page("burs");
  EXPECT_TRUE(made.isEmpty()) << "none in the turn that asked for them";
  EXPECT_TRUE(QTest::qWaitFor([this] { return made.size() == 3; }, 60'000));
  QTest::qWait(0);
  EXPECT_EQ(made, QStringList({QStringLiteral("shape"), QStringLiteral("points"), QStringLiteral("burs")}));
  EXPECT_NE(points->findChild<QLabel*>(), nullptr);
}

TEST_F(LaterFormsTest, a_page_that_is_chosen_is_filled_at_once_and_not_again) {
  const auto shape = page("shape"), burs = page("burs");
  forms.fill(burs.get());
  EXPECT_EQ(made, QStringList(QStringLiteral("burs")));
  forms.fill(burs.get());
  EXPECT_TRUE(QTest::qWaitFor([this] { return made.size() == 2; }, 60'000));
  EXPECT_EQ(made.back(), QStringLiteral("shape"));
}

TEST_F(LaterFormsTest, a_page_that_is_gone_gets_no_form) {
  auto shape = page("shape");
  const auto burs = page("burs");
  shape.reset();
  EXPECT_TRUE(QTest::qWaitFor([this] { return made.size() == 1; }, 60'000));
  EXPECT_EQ(made, QStringList(QStringLiteral("burs")));
}

}  // namespace
}  // namespace cusp::test
