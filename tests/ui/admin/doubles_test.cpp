// What the people's page shows of a person who may have an account of another station, too.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTemporaryDir>
#include <algorithm>

#include "tests/ui/admin/admin_pages.h"
#include "ui/admin/people_model.h"
#include "ui/admin/people_page.h"
#include "ui/settings/settings.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

struct Doubles : AdminPages {
  /// As a file of another station brings it.
  Account made_elsewhere() {
    const Account other = records.student("elsewhere", "L. Brandt");
    records.attempt(other, "channel-1", 70, 60);
    EXPECT_TRUE(records.store().database().run("UPDATE people SET number = '4711 ' || substr(hex(id), 25) WHERE id = ?1", other.id));
    return other;
  }
  /// Of a person's form; empty: it shows none.
  QString same_person(PeoplePage& page, const Account& person) {
    page.table()->choose_row(page.model()->row_of(person.id));
    for (const QLabel* label : page.findChildren<QLabel*>())
      if (label->isVisibleTo(&page) && label->text().startsWith(QStringLiteral("Perhaps the same person"))) return label->text();
    return {};
  }
};

TEST_F(Doubles, are_named_on_both_accounts_with_the_station_and_on_no_other) {
  const Account lena = records.student("4711", "Lena Brandt"), omar = records.student("4712", "Omar Haddad"), other = made_elsewhere();
  const QTemporaryDir folder;
  Settings settings(folder.filePath(QStringLiteral("Cusp.ini")));
  ASSERT_TRUE(settings.set_station_name(QString::fromStdString(records.store().context().station.text()), QStringLiteral("Room 2")));
  PeoplePage page(records.store(), records.administrator().actor(), ports, nullptr, &settings);
  page.show();
  EXPECT_TRUE(same_person(page, lena).startsWith(QStringLiteral("Perhaps the same person as L. Brandt, 4711 "))) << same_person(page, lena).toStdString();
  EXPECT_TRUE(same_person(page, lena).endsWith(QStringLiteral("That account was made by: Room 2."))) << same_person(page, lena).toStdString();
  EXPECT_EQ(same_person(page, other).toStdString(), "Perhaps the same person as Lena Brandt, 4711. This account was made by: Room 2.");
  EXPECT_EQ(same_person(page, omar), QString());
}

TEST_F(Doubles, of_which_the_names_alone_agree_are_named_without_a_station) {
  const Account lena = records.student("4711", "Lena Brandt"), other = records.student("0815", "Brandt, Lena");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  EXPECT_EQ(same_person(page, lena).toStdString(), "Perhaps the same person as Brandt, Lena, 0815: the names agree, and no cohort holds both.");
  EXPECT_EQ(same_person(page, other).toStdString(), "Perhaps the same person as Lena Brandt, 4711: the names agree, and no cohort holds both.");
}

}  // namespace
}  // namespace cusp::test
