// The people's page with large text, where each length is twice as long.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLayout>
#include <QScrollBar>

#include "tests/modules.h"
#include "tests/ui/admin/admin_pages.h"
#include "tests/ui/looks.h"
#include "tests/ui/whole_texts.h"
#include "ui/admin/people_model.h"
#include "ui/admin/people_page.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct PeopleInLargeText : AdminPages {
  void TearDown() override {
    install_language(*qApp, QStringLiteral("en"));
    apply_theme(*qApp, ColourScheme::light, 100);
  }
};

TEST_F(PeopleInLargeText, show_name_number_and_role_of_each_side_by_side_on_1280_px) {
  records.student("20267314", "Lena Brandt");
  for (const char* language : {"en", "de"}) {
    install_language(*qApp, QLatin1String(language));
    apply_theme(*qApp, ColourScheme::light, 200);
    for (const int width : {880, 1280}) {  // the sidebar takes 400 px; without it
      SCOPED_TRACE(std::string(language) + ' ' + std::to_string(width));
      QWidget window;
      window.resize(width, 800);
      PeoplePage page(records.store(), records.administrator().actor(), ports, &window);
      page.resize(width, 800);
      window.show();
      QApplication::processEvents();
      page.resize(width, page.layout()->totalMinimumHeightForWidth(width));  // the desktop scrolls a page to what it needs
      window.resize(page.size());
      QApplication::processEvents();
      const Table& table = *page.table();
      EXPECT_EQ(table.horizontalScrollBar()->value(), 0);
      for (const int column : {PeopleModel::kName, PeopleModel::kNumber, PeopleModel::kRole})
        EXPECT_LE(table.columnViewportPosition(column) + table.columnWidth(column), table.viewport()->width()) << "column " << column;
      const QAbstractItemView& view = table;
      EXPECT_GE(table.columnWidth(PeopleModel::kRole), view.sizeHintForColumn(PeopleModel::kRole)) << "the role is cut";
      EXPECT_LE(page.minimumSizeHint().width(), width) << "the page scrolls sideways";
      expect_nothing_clipped(page, "people");
      leave_picture(page, QStringLiteral("people-%1-200-%2").arg(QLatin1String(language)).arg(width));
    }
  }
}

}  // namespace
}  // namespace cusp::test
