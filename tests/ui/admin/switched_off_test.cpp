// A list of students some of whose accounts are switched off: an import makes no new ones, and nobody signs in with these.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>

#include "tests/ui/admin/admin_pages.h"
#include "ui/admin/people_import.h"
#include "ui/admin/student_list_model.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct SwitchedOff : AdminPages {
  void choose(PeopleImport& page) {
    file = folder.filePath(QStringLiteral("list.csv"));
    QFile list(file);
    ASSERT_TRUE(list.open(QIODevice::WriteOnly));
    list.write("number,name\n4711,Lena Brandt\n4712,Omar Haddad\n");
    list.close();
    page.choose_file();
  }
  static QString state(PeopleImport& page, int row) { return page.findChild<Table*>()->model()->index(row, StudentListModel::kState).data().toString(); }
  const QTemporaryDir folder;
};

TEST_F(SwitchedOff, accounts_of_a_list_are_named_as_such) {
  const Account lena = records.student("4711", "Lena Brandt");
  records.student("4712", "Omar Haddad");
  PeopleImport before(records.store(), records.administrator().actor(), ports);
  choose(before);
  EXPECT_FALSE(before.message().contains(QStringLiteral("Switched off"))) << before.message().toStdString();
  ASSERT_TRUE(records.store().accounts.disable(records.administrator().actor(), lena.id));
  PeopleImport page(records.store(), records.administrator().actor(), ports);
  choose(page);
  EXPECT_TRUE(page.message().contains(QStringLiteral("Switched off, so that nobody signs in with them: 1."))) << page.message().toStdString();
  EXPECT_EQ(state(page, 0), QStringLiteral("has an account, switched off"));
  EXPECT_EQ(state(page, 1), QStringLiteral("has an account"));
}

}  // namespace
}  // namespace cusp::test
