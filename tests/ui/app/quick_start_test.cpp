// The quick start: five pictures, whole at every size.
#include <gtest/gtest.h>

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>

#include "tests/ui/looks.h"
#include "ui/app/quick_start.h"

namespace cusp::test {
namespace {

std::vector<const QLabel*> pictures_of(const QWidget& page) {
  std::vector<const QLabel*> out;
  for (const QLabel* label : page.findChildren<QLabel*>()) {
    if (!label->pixmap().isNull()) out.push_back(label);
  }
  return out;
}

void expect_whole(int percent, const QString& name) {
  apply_theme(*qApp, percent == 100 ? ColourScheme::light : ColourScheme::dark, percent);
  QuickStart page;
  page.resize(1280, 800);
  page.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&page));
  const auto pictures = pictures_of(page);
  EXPECT_EQ(pictures.size(), 5u);
  for (const QLabel* label : pictures) {
    EXPECT_GE(label->width(), label->pixmap().deviceIndependentSize().width()) << label->accessibleName().toStdString();
    EXPECT_FALSE(label->accessibleName().isEmpty());
  }
  EXPECT_EQ(page.findChild<QScrollArea*>()->horizontalScrollBar()->maximum(), 0);
  leave_picture(page, name);
}

TEST(QuickStartTest, its_five_pictures_are_whole_and_named_at_every_size) {
  expect_whole(100, QStringLiteral("quick-start-en-light"));
  install_language(*qApp, QStringLiteral("de"));
  expect_whole(200, QStringLiteral("quick-start-de-dark-200"));
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

}  // namespace
}  // namespace cusp::test
