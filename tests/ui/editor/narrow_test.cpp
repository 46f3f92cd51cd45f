// The editor in narrow windows, in German: every tab in the one that full HD has at 200 %, and 1280 px at 150 % and 200 %.

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabBar>
#include <QTabWidget>

#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/whole_texts.h"
#include "ui/editor/specimen_form.h"
#include "ui/text/language.h"
#include "ui/widgets/format.h"
#include "ui/widgets/theme.h"

namespace cusp::test {
namespace {

TEST_F(EditorPages, half_of_full_hd_holds_every_tab_in_german) {
  install_language(*qApp, QStringLiteral("de"));
  const auto page = open();
  page->resize(kHalfOfFullHd);
  for (QTabWidget* tabs : page->findChildren<QTabWidget*>())
    for (int i = 0; i < tabs->count(); ++i) {
      tabs->setCurrentIndex(i);
      expect_whole_at_half_of_full_hd(*page, tabs->tabText(i).toStdString());
    }
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(EditorPages, every_panel_ends_within_1280_pixels_at_150_percent) {
  install_language(*qApp, QStringLiteral("de"));
  apply_theme(*qApp, ColourScheme::light, 150);
  const auto page = open();
  ASSERT_EQ(page->width(), 1280);
  for (const QTabWidget* tabs : page->findChildren<QTabWidget*>()) EXPECT_LE(tabs->mapTo(page.get(), QPoint(tabs->width(), 0)).x(), 1280);
  EXPECT_LE(page->minimumSizeHint().width(), 1280);
  apply_theme(*qApp, ColourScheme::light, 100);
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(EditorPages, at_200_percent_1280_pixels_hold_the_tooth_and_one_panel_in_german) {
  install_language(*qApp, QStringLiteral("de"));
  apply_theme(*qApp, ColourScheme::light, 200);
  const auto page = open();
  EXPECT_EQ(page->width(), 1280);
  EXPECT_LE(page->minimumSizeHint().width(), 1280);
  const auto* tabs = page->findChild<QTabWidget*>();
  EXPECT_LE(tabs->mapTo(page.get(), QPoint(tabs->width(), 0)).x(), 1280);
  EXPECT_LE(page->stage()->mapTo(page.get(), QPoint(page->stage()->width(), 0)).x(), tabs->mapTo(page.get(), QPoint()).x());
  for (const QPushButton* button : page->findChildren<QPushButton*>()) {
    const QWidget* bar = button->parentWidget();
    if (!button->isVisible() || bar->property("kind") != QStringLiteral("bar_top")) continue;
    // The left panel becomes a tab, and texts signs, in later turns of the event loop.
    EXPECT_TRUE(QTest::qWaitFor([&] { return !clipped(*button); })) << described(*button) << ", " << button->width() << " of " << button->sizeHint().width();
    EXPECT_FALSE(beyond_parent(*button)) << described(*button);
  }
  apply_theme(*qApp, ColourScheme::light, 100);
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(EditorPages, at_200_percent_the_page_is_as_high_as_a_window_of_800_pixels_and_no_tab_is_cut) {
  for (const char* language : {"de", "en"}) {
    install_language(*qApp, QLatin1String(language));
    apply_theme(*qApp, ColourScheme::light, 200);
    const auto page = open();
    EXPECT_EQ(page->size(), QSize(1280, 800)) << language;
    EXPECT_LT(page->minimumSizeHint().height(), 760) << language;
    auto* tabs = page->findChild<QTabWidget*>();
    ASSERT_EQ(tabs->count(), 7) << language;
    EXPECT_LE(tabs->tabBar()->sizeHint().width(), tabs->width()) << language << ": an arrow hides a tab";
    tabs->setCurrentIndex(6);
    QTest::qWait(0);
    const auto* target = tabs->currentWidget()->findChild<QScrollArea*>();
    ASSERT_TRUE(target->isVisible()) << language;
    EXPECT_EQ(target->horizontalScrollBar()->maximum(), 0) << language;
    EXPECT_FALSE(target->horizontalScrollBar()->isVisible()) << language;
    EXPECT_GE(page->stage()->height(), 500) << language << ": of 800, 96 are the bar's and 160 the checks'";
  }
  apply_theme(*qApp, ColourScheme::light, 100);
  install_language(*qApp, QStringLiteral("en"));
}

TEST_F(EditorPages, the_checks_take_the_whole_width_while_the_left_panel_is_a_tab) {
  apply_theme(*qApp, ColourScheme::light, 200);
  const auto page = open();
  const auto* checks = named<QFrame>(*page, "Checks");
  ASSERT_NE(checks, nullptr);
  EXPECT_EQ(checks->width(), 1280);
  EXPECT_EQ(checks->mapTo(page.get(), QPoint(0, checks->height())).y(), page->height());
  page->resize(1800, 1000);
  EXPECT_TRUE(QTest::qWaitFor([&] { return checks->width() == page->stage()->width(); }));
  page->resize(1280, 800);
  EXPECT_TRUE(QTest::qWaitFor([&] { return checks->width() == 1280; }));
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST_F(EditorPages, a_low_view_shows_the_section_without_the_legend) {
  apply_theme(*qApp, ColourScheme::light, 200);
  const auto page = open();
  const auto legend = [&] {
    for (const QLabel* label : page->stage()->findChildren<QLabel*>())
      if (label->text() == QStringLiteral("Tolerance zone")) return label->isVisible();
    ADD_FAILURE() << "no legend";
    return false;
  };
  EXPECT_TRUE(legend());
  auto* section = named<QPushButton>(*page->stage(), "Section");
  ASSERT_NE(section, nullptr);
  section->click();
  EXPECT_FALSE(legend());
  section->click();
  EXPECT_TRUE(legend());
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST_F(EditorPages, the_left_panel_is_a_tab_while_the_window_is_too_narrow_for_three) {
  apply_theme(*qApp, ColourScheme::light, 200);
  const auto page = open();
  auto* tabs = page->findChild<QTabWidget*>();
  const auto* change = named<QPushButton>(*page, "Change the tooth");
  ASSERT_EQ(tabs->count(), 7);
  EXPECT_EQ(tabs->currentIndex(), 0);
  EXPECT_FALSE(change->isVisible());
  tabs->setCurrentIndex(6);
  EXPECT_EQ(tabs->tabText(6), QStringLiteral("Target"));
  EXPECT_TRUE(change->isVisible());
  EXPECT_NE(named<QPushButton>(*page, "Publish version 4"), nullptr) << "a screen reader hears the whole name";
  page->resize(1800, 1000);
  EXPECT_TRUE(QTest::qWaitFor([&] { return tabs->count() == 6; }));
  EXPECT_TRUE(change->isVisible());
  page->resize(1280, 1000);
  EXPECT_TRUE(QTest::qWaitFor([&] { return tabs->count() == 7; }));
  apply_theme(*qApp, ColourScheme::light, 100);
}

TEST(SpecimenName, of_a_file_takes_lines_instead_of_widening_its_panel) {
  const QString name = QString(60, u'm') + QStringLiteral(".nrrd");
  EXPECT_EQ(breakable(name, kWholeInPanel).remove(QChar(0x200B)), name) << "nothing but places to break is added";
  EXPECT_EQ(breakable(QStringLiteral("tooth.nrrd"), kWholeInPanel), QStringLiteral("tooth.nrrd"));
  QLabel whole(name), wrapped(breakable(name, kWholeInPanel));
  wrapped.setWordWrap(true);
  EXPECT_LT(wrapped.minimumSizeHint().width(), whole.sizeHint().width() / 3);
}

}  // namespace
}  // namespace cusp::test
