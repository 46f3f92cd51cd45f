// What the library hands to the editor: an exercise of the program, a copy, a new one.

#include <gtest/gtest.h>

#include <QSignalSpy>

#include "scenarios/library/library.h"
#include "tests/modules.h"
#include "tests/ui/editor/editor_pages.h"
#include "ui/editor/editor_page.h"
#include "ui/editor/editor_records.h"
#include "ui/instructor/library_page.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

TEST_F(EditorPages, the_library_lists_the_builtin_exercises_and_opens_one) {
  LibraryPage page(records.store(), instructor.actor(), ports, records.file(), folder.path().toStdString());
  page.show();
  EXPECT_EQ(page.model().rowCount(), static_cast<int>(builtin_scenarios().size()));
  QSignalSpy wanted(&page, &LibraryPage::edit_wanted);
  page.table()->choose_row(1);
  page.open_chosen();
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_TRUE(wanted[0][0].value<EditorStart>().draft.title == page.model().row(1).shown().title);
  page.copy_chosen();
  page.begin_new();
  ASSERT_EQ(wanted.count(), 3);
  EXPECT_FALSE(wanted[1][0].value<EditorStart>().published.has_value());
}

}  // namespace
}  // namespace cusp::test
