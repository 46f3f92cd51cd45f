// The editor in narrow windows, in German: every tab in the one that full HD has at 200 %, and 1280 px at 150 %.

#include <QTabWidget>

#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/whole_texts.h"
#include "ui/text/language.h"
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

}  // namespace
}  // namespace cusp::test
