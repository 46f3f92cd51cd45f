// What a new station shows: the first start, and the quick start, whose five pictures are whole at every size.
#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTemporaryDir>
#include <QTest>

#include "tests/modules.h"
#include "tests/ui/looks.h"
#include "ui/app/desktop.h"
#include "ui/app/quick_start.h"
#include "ui/signin/sign_in.h"

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
  ASSERT_EQ(pictures.size(), 5u);
  EXPECT_EQ(pictures[0]->pixmap().toImage().pixelColor(2, 2).lightness() < 128, tokens().dark) << "in the colours of the page";
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

TEST(FirstStart, keeps_the_typed_names_over_a_change_of_theme_and_language) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  Desktop desktop(settings, Ports::of_the_system(), folder.filePath(QStringLiteral("new.db")).toStdString());
  desktop.start();
  desktop.show();
  const auto texts = [&] {
    QStringList out;
    for (const QLineEdit* field : desktop.page()->findChildren<QLineEdit*>()) out += field->text();
    return out;
  };
  desktop.page()->findChildren<QLineEdit*>()[0]->setText(QStringLiteral("Anna Weber"));
  desktop.page()->findChildren<QLineEdit*>()[1]->setText(QStringLiteral("anna"));
  desktop.set_scheme(ColourScheme::dark);
  EXPECT_EQ(texts(), QStringList({QStringLiteral("Anna Weber"), QStringLiteral("anna"), {}, {}}));
  desktop.set_language(QStringLiteral("de"));
  EXPECT_EQ(texts(), QStringList({QStringLiteral("Anna Weber"), QStringLiteral("anna"), {}, {}}));
  install_language(*qApp, QStringLiteral("en"));
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST(FirstStart, leads_to_sign_in_once_another_window_has_made_the_administrator) {
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  Desktop desktop(settings, Ports::of_the_system(), folder.filePath(QStringLiteral("new.db")).toStdString());
  desktop.start();
  desktop.show();
  const QList<QLineEdit*> fields = desktop.page()->findChildren<QLineEdit*>();
  ASSERT_EQ(fields.size(), 4);
  ASSERT_TRUE(desktop.store()->accounts.create_first_administrator({"berg", "Mara Berg", Role::administrator, "correct horse", ""}));
  const char* const typed[] = {"Anna Weber", "anna", "correct horse", "correct horse"};
  for (int i = 0; i < 4; ++i) fields[i]->setText(QLatin1String(typed[i]));
  QTest::keyClick(fields[3], Qt::Key_Return);
  const SignIn* page = nullptr;
  EXPECT_TRUE(QTest::qWaitFor([&] {
    page = qobject_cast<SignIn*>(desktop.page());
    return page != nullptr && !page->waiting() && !page->message().isEmpty();
  }, 60'000));
  ASSERT_NE(page, nullptr);
  EXPECT_EQ(page->who(), SignIn::Who::staff) << "the page signs in and makes nobody";
  EXPECT_TRUE(page->message().contains(QStringLiteral("Another window"))) << page->message().toStdString();
}

}  // namespace
}  // namespace cusp::test
