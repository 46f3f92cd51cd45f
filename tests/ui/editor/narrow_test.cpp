// The editor in the window that full HD has at 200 %: every tab, in German.

#include <QTabWidget>

#include "tests/ui/editor/editor_pages.h"
#include "tests/ui/whole_texts.h"
#include "ui/text/language.h"

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

}  // namespace
}  // namespace cusp::test
