// The people's page over real records.

#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <algorithm>
#include <functional>
#include <tuple>

#include "tests/modules.h"
#include "tests/ui/admin/admin_pages.h"
#include "tests/ui/whole_texts.h"
#include "ui/admin/people_model.h"
#include "ui/admin/people_page.h"
#include "ui/widgets/parts.h"
#include "ui/widgets/table.h"

namespace cusp::test {
namespace {

/// Presses, and waits for the records: they are asked on a thread of their own.
void save(PeoplePage& page, const char* name) {
  press(page, name);
  ASSERT_TRUE(QTest::qWaitFor([&page] { return !page.waiting(); }, 60'000));
}

TEST_F(AdminPages, a_student_is_added_and_signs_in_with_the_pin) {
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  press(page, "Add a person");
  field(page, "Name")->setText(QStringLiteral("Lena Brandt"));
  field(page, "Number or user name")->setText(QStringLiteral("20267314"));
  field(page, "PIN, six digits")->setText(QStringLiteral("271828"));
  save(page, "Add");
  EXPECT_EQ(page.message().toStdString(), "Lena Brandt is added.");
  press(page, "Add");  // a double click presses it twice
  EXPECT_EQ(page.message().toStdString(), "Lena Brandt is added.");
  EXPECT_EQ(page.model()->rowCount(), 2);
  EXPECT_TRUE(records.store().accounts.sign_in_with_pin("20267314", "271828").has_value());
}

TEST_F(AdminPages, a_number_that_is_pasted_with_marks_signs_in_as_it_reads) {
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  press(page, "Add a person");
  field(page, "Name")->setText(QStringLiteral("\u202ELena\u202C Brandt"));
  field(page, "Number or user name")->setText(QStringLiteral("\u200E4711\u200B"));
  field(page, "PIN, six digits")->setText(QStringLiteral("271828"));
  save(page, "Add");
  const auto lena = records.store().accounts.sign_in_with_pin("4711", "271828");
  ASSERT_TRUE(lena.has_value());
  EXPECT_EQ(lena->name, "Lena Brandt");
}

TEST_F(AdminPages, the_same_number_twice_and_a_short_pin_are_refused_with_a_message) {
  records.student("20267314", "Lena Brandt");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  press(page, "Add a person");
  save(page, "Add");
  EXPECT_EQ(page.message().toStdString(), "Name and number are needed.");
  field(page, "Name")->setText(QStringLiteral("Another"));
  field(page, "Number or user name")->setText(QStringLiteral("20267314"));
  save(page, "Add");
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("The number \u206620267314\u2069 is taken."))) << page.message().toStdString();
  field(page, "Number or user name")->setText(QStringLiteral("20267315"));
  field(page, "PIN, six digits")->setText(QStringLiteral("12"));
  save(page, "Add");
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("A PIN has exactly six digits."))) << page.message().toStdString();
  EXPECT_EQ(page.model()->rowCount(), 2);
}

TEST_F(AdminPages, a_refusal_is_gone_once_another_person_is_chosen_or_begun) {
  const Account lena = records.student("1", "Lena Brandt"), omar = records.student("2", "Omar Said");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  const auto refused = [&](const Account& person) {
    page.table()->choose_row(page.model()->row_of(person.id));
    field(page, "New PIN, six digits")->setText(QStringLiteral("12"));
    save(page, "Save changes");
    return page.message().startsWith(QStringLiteral("A PIN has exactly six digits."));
  };
  ASSERT_TRUE(refused(lena)) << page.message().toStdString();
  page.table()->choose_row(page.model()->row_of(omar.id));
  EXPECT_EQ(page.message(), QString());
  ASSERT_TRUE(refused(omar)) << page.message().toStdString();
  press(page, "Add a person");
  EXPECT_EQ(page.message(), QString());
}

TEST_F(AdminPages, switching_an_account_off_asks_first_and_keeps_the_results) {
  const Account lena = records.student("1", "Lena Brandt");
  records.attempt(lena, "channel-1", 78, 100);
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  answer = false;
  press(page, "Switch account off");
  EXPECT_FALSE(records.store().accounts.find(lena.id)->disabled);
  answer = true;
  press(page, "Switch account off");
  ASSERT_EQ(asked.size(), 2u);
  EXPECT_EQ(asked[0].toStdString(), "Switch off the account of Lena Brandt?");
  EXPECT_TRUE(records.store().accounts.find(lena.id)->disabled);
  EXPECT_EQ(records.store().history.list(records.administrator().actor())->size(), 1u);
  press(page, "Switch account on");  // gives back: nothing to ask
  EXPECT_EQ(asked.size(), 2u);
  EXPECT_FALSE(records.store().accounts.find(lena.id)->disabled);
}

TEST_F(AdminPages, people_are_found_by_role_and_by_cohort) {
  const Account lena = records.student("1", "Lena Brandt");
  records.student("2", "Noah Adler");
  const auto cohort = records.store().cohorts.create(records.administrator().actor(), "Year 2");
  ASSERT_TRUE(cohort && records.store().cohorts.add(records.administrator().actor(), cohort->id, lena.id));
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  EXPECT_EQ(page.model()->rowCount(), 3);
  for (QComboBox* box : page.findChildren<QComboBox*>())
    if (box->accessibleName() == QStringLiteral("Shown roles")) box->setCurrentIndex(1);
  EXPECT_EQ(page.model()->rowCount(), 2) << "the students";
  page.model()->narrow(QStringLiteral("year 2"));
  ASSERT_EQ(page.model()->rowCount(), 1);
  EXPECT_EQ(page.model()->account(0).id, lena.id);
  EXPECT_EQ(page.model()->index(0, PeopleModel::kCohort).data().toString(), QStringLiteral("Year 2"));
}

TEST_F(AdminPages, people_are_sorted_by_the_head_of_a_column_and_the_chosen_one_stays) {
  const Account noah = records.student("2", "Noah Adler"), lena = records.student("10", "Lena Brandt", "314159");
  ASSERT_TRUE(records.store().accounts.disable(records.administrator().actor(), noah.id));
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  const auto numbers = [&](PeopleModel::Column column, Qt::SortOrder order) {
    page.table()->sortByColumn(column, order);
    EXPECT_EQ(page.table()->chosen_row(), page.model()->row_of(lena.id));
    QStringList out;
    for (int i = 0; i < page.model()->rowCount(); ++i) out += QString::fromStdString(page.model()->account(i).number);
    return out.join(u' ').toStdString();
  };
  EXPECT_EQ(numbers(PeopleModel::kNumber, Qt::AscendingOrder), "2 10 anna") << "by value";
  EXPECT_EQ(numbers(PeopleModel::kNumber, Qt::DescendingOrder), "anna 10 2");
  EXPECT_EQ(numbers(PeopleModel::kRole, Qt::AscendingOrder), "10 2 anna") << "students by name";
  EXPECT_EQ(numbers(PeopleModel::kState, Qt::DescendingOrder).substr(0, 1), "2") << "who is switched off";
  EXPECT_EQ(numbers(PeopleModel::kSignIn, Qt::AscendingOrder), "2 10 anna") << "number alone, PIN, password";
  page.model()->narrow(QStringLiteral("a"), Role::student);
  EXPECT_EQ(page.model()->account(0).id, noah.id) << "a search keeps the order";
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Lena Brandt"));
}

TEST_F(AdminPages, a_pin_that_is_typed_stays_when_the_account_is_switched_on) {
  const Account lena = records.student("1", "Lena Brandt");
  ASSERT_TRUE(records.store().accounts.disable(records.administrator().actor(), lena.id));
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  field(page, "New PIN, six digits")->setText(QStringLiteral("271828"));
  press(page, "Switch account on");
  EXPECT_EQ(field(page, "New PIN, six digits")->text(), QStringLiteral("271828"));
  save(page, "Save changes");
  EXPECT_TRUE(records.store().accounts.sign_in_with_pin("1", "271828").has_value());
}

TEST_F(AdminPages, a_pin_that_is_typed_does_not_take_back_what_another_desk_changed) {
  const Account lena = records.student("1", "Lena Brandt");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  field(page, "New PIN, six digits")->setText(QStringLiteral("271828"));
  ASSERT_TRUE(records.store().accounts.rename(records.administrator().actor(), lena.id, "1", "Lena Weber"));
  press(page, "Switch account off");  // the list is read anew
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Lena Weber"));
  save(page, "Save changes");
  EXPECT_EQ(records.store().accounts.find(lena.id)->name, "Lena Weber");
  EXPECT_TRUE(records.store().accounts.find(lena.id)->has_pin);
}

TEST_F(AdminPages, a_changed_name_leaves_the_number_that_another_desk_has_changed) {
  const Account lena = records.student("1", "Lena Brandt");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  ASSERT_TRUE(records.store().accounts.rename(records.administrator().actor(), lena.id, "2", "Lena Brandt"));
  field(page, "Name")->setText(QStringLiteral("Lena Weber"));
  save(page, "Save changes");
  EXPECT_EQ(records.store().accounts.find(lena.id)->name, "Lena Weber");
  EXPECT_EQ(records.store().accounts.find(lena.id)->number, "2");
  EXPECT_EQ(field(page, "Number or user name")->text(), QStringLiteral("2"));
}

TEST_F(AdminPages, a_person_who_was_erased_at_another_desk_leaves_the_list_with_the_next_act) {
  const Account lena = records.student("1", "Lena Brandt"), omar = records.student("2", "Omar Said");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  for (const Account& gone : {lena, omar}) {
    page.table()->choose_row(page.model()->row_of(gone.id));
    ASSERT_TRUE(records.store().accounts.erase(records.administrator().actor(), gone.id));
    if (gone.id == lena.id) {
      field(page, "Name")->setText(QStringLiteral("Lena Weber"));
      save(page, "Save changes");
    } else {
      press(page, "Switch account off");
    }
    EXPECT_EQ(plain_text(page.message()).find("There is no account " + gone.number + "."), 0u) << page.message().toStdString();
    EXPECT_EQ(page.model()->row_of(gone.id), -1);
    EXPECT_EQ(records.store().accounts.find(gone.id)->name, "–");
  }
}

TEST_F(AdminPages, a_person_whom_a_search_hides_is_shown_as_the_records_have_them) {
  const Account lena = records.student("1", "Lena Brandt");
  records.student("2", "Omar Said");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  field(page, "Name")->setText(QStringLiteral("Lena Weber"));
  field(page, "Find somebody")->setText(QStringLiteral("Omar"));
  save(page, "Save changes");
  for (const QPushButton* b : page.findChildren<QPushButton*>()) {
    if (b->accessibleName() == QStringLiteral("Save changes")) {
      EXPECT_FALSE(b->isEnabled()) << "it is saved";
    }
  }
  press(page, "Switch account off");
  press(page, "Switch account on");
  EXPECT_FALSE(records.store().accounts.find(lena.id)->disabled);
}

TEST_F(AdminPages, looking_for_somebody_keeps_what_is_typed_about_a_new_person) {
  records.student("1", "Lena Brandt");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  press(page, "Add a person");
  field(page, "Name")->setText(QStringLiteral("Omar Said"));
  field(page, "Find somebody")->setText(QStringLiteral("Lena"));
  EXPECT_EQ(page.model()->rowCount(), 1);
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Omar Said"));
  field(page, "Number or user name")->setText(QStringLiteral("2"));
  save(page, "Add");
  EXPECT_EQ(page.message().toStdString(), "Omar Said is added.");
  EXPECT_TRUE(records.store().accounts.find_number("2"));
}

TEST_F(AdminPages, another_person_takes_the_place_of_a_half_filled_form_after_a_question) {
  const Account lena = records.student("1", "Lena Brandt"), omar = records.student("2", "Omar Said");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  field(page, "Name")->setText(QStringLiteral("Lena Weber"));
  answer = false;
  page.table()->choose_row(page.model()->row_of(omar.id));
  EXPECT_EQ(asked, std::vector<QString>{QStringLiteral("Leave without saving the form?")});
  EXPECT_EQ(page.table()->chosen_row(), page.model()->row_of(lena.id));
  press(page, "Add a person");
  EXPECT_EQ(asked.size(), 2u);
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Lena Weber"));
  answer = true;
  page.table()->choose_row(page.model()->row_of(omar.id));
  EXPECT_EQ(asked.size(), 3u);
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Omar Said"));
  page.table()->choose_row(page.model()->row_of(lena.id));
  EXPECT_EQ(asked.size(), 3u) << "nothing is typed";
  EXPECT_EQ(field(page, "Name")->text(), QStringLiteral("Lena Brandt"));
}

TEST_F(AdminPages, the_form_shows_the_whole_of_a_long_name) {
  const char* name = "Maximiliane Charlotte Friederike von Hohenstein-Schwarzenberg";
  const Account one = records.student("1", name);
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.resize(1280, 800);
  page.show();
  page.table()->choose_row(page.model()->row_of(one.id));
  QTest::qWait(0);
  const QList<QLabel*> labels = page.findChildren<QLabel*>();
  const auto title = std::ranges::find(labels, QString::fromLatin1(name), &QLabel::text);
  ASSERT_NE(title, labels.end());
  EXPECT_FALSE(clipped(**title)) << (*title)->width() << " of " << (*title)->sizeHint().width();
  EXPECT_EQ(field(page, "Name")->cursorPosition(), 0) << "the field shows its beginning";
}

TEST_F(AdminPages, an_own_password_is_not_offered_where_it_cannot_be_changed) {
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(records.administrator().id));
  EXPECT_FALSE(field(page, "New password, at least 8 characters")->isEnabled());
  press(page, "Add a person");
  EXPECT_TRUE(field(page, "PIN, six digits")->isEnabled());
}

TEST_F(AdminPages, nothing_is_saved_of_a_person_that_nobody_changed) {
  const Account lena = records.student("1", "Lena Brandt");
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  QPushButton* save_button = nullptr;
  for (QPushButton* one : page.findChildren<QPushButton*>())
    if (one->accessibleName() == QStringLiteral("Save changes")) save_button = one;
  ASSERT_NE(save_button, nullptr);
  EXPECT_FALSE(save_button->isEnabled());
  field(page, "Name")->setText(QStringLiteral("Lena Weber"));
  EXPECT_TRUE(save_button->isEnabled());
  save(page, "Save changes");
  EXPECT_EQ(records.store().accounts.find(lena.id)->name, "Lena Weber");
  EXPECT_FALSE(save_button->isEnabled()) << "it is saved";
}

void choose_role(PeoplePage& page, int role) {
  for (QComboBox* box : page.findChildren<QComboBox*>())
    if (box->accessibleName() == QStringLiteral("Role")) box->setCurrentIndex(role);
}

TEST_F(AdminPages, staff_become_a_student_with_a_pin_at_once) {
  const Account berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(berg.id));
  choose_role(page, 0);
  field(page, "New PIN, six digits")->setText(QStringLiteral("271828"));
  save(page, "Save changes");
  EXPECT_EQ(page.message().toStdString(), "Mara Berg is saved.");
  EXPECT_EQ(records.store().accounts.find(berg.id)->role, Role::student);
  EXPECT_TRUE(records.store().accounts.sign_in_with_pin("berg", "271828").has_value());
}

TEST_F(AdminPages, a_taken_number_leaves_the_pin_as_it_was) {
  const Account lena = records.student("1", "Lena Brandt");
  records.student("2", "Omar Said");
  ASSERT_TRUE(records.store().accounts.set_pin(records.administrator().actor(), lena.id, "314159"));
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(page.model()->row_of(lena.id));
  field(page, "Number or user name")->setText(QStringLiteral("2"));
  field(page, "New PIN, six digits")->setText(QStringLiteral("271828"));
  save(page, "Save changes");
  EXPECT_TRUE(page.message().contains(QStringLiteral("Nothing was changed."))) << page.message().toStdString();
  EXPECT_TRUE(records.store().accounts.sign_in_with_pin("1", "314159").has_value());
}

/// A student and an instructor. Their form asks for the other role with its secret, and for a number or name that is refused.
struct RefusedForm : AdminPages {
  Account lena, berg;
  void SetUp() override {
    AdminPages::SetUp();
    lena = records.student("1", "Lena Brandt");
    berg = *records.store().accounts.create(records.administrator().actor(), {"berg", "Mara Berg", Role::instructor, "correct horse", ""});
  }
  /// `fill` types what is refused of that account.
  void expect_both_as_they_were(const std::function<void(PeoplePage& page, const Account& account)>& fill) {
    PeoplePage page(records.store(), records.administrator().actor(), ports);
    page.show();
    for (const auto& [account, role, secret] : {std::tuple{lena, 1, "battery staple"}, {berg, 0, "271828"}}) {
      page.table()->choose_row(page.model()->row_of(account.id));
      choose_role(page, role);
      fill(page, account);
      field(page, role == 0 ? "New PIN, six digits" : "New password, at least 8 characters")->setText(QString::fromLatin1(secret));
      save(page, "Save changes");
      EXPECT_TRUE(page.message().contains(QStringLiteral("Nothing was changed."))) << page.message().toStdString();
    }
    EXPECT_EQ(records.store().accounts.find(lena.id)->role, Role::student);
    EXPECT_FALSE(records.store().accounts.find(lena.id)->has_password);
    EXPECT_EQ(records.store().accounts.find(berg.id)->role, Role::instructor);
    EXPECT_TRUE(records.store().accounts.sign_in("berg", "correct horse").has_value());
  }
};

TEST_F(RefusedForm, of_a_taken_number_leaves_the_role_and_the_password_as_they_were) {
  expect_both_as_they_were([this](PeoplePage& page, const Account& account) {
    field(page, "Number or user name")->setText(account.id == lena.id ? QStringLiteral("berg") : QStringLiteral("1"));
  });
}

TEST_F(RefusedForm, of_a_number_or_name_that_is_too_long_leaves_the_role_and_the_password_as_they_were) {
  expect_both_as_they_were([this](PeoplePage& page, const Account& account) {
    if (account.id == lena.id) {
      field(page, "Number or user name")->setText(QString(65, u'1'));
    } else {
      field(page, "Name")->setText(QString(201, u'n'));
    }
  });
}

TEST_F(AdminPages, the_last_administrator_stays_one) {
  PeoplePage page(records.store(), records.administrator().actor(), ports);
  page.show();
  page.table()->choose_row(0);
  for (QComboBox* box : page.findChildren<QComboBox*>())
    if (box->accessibleName() == QStringLiteral("Role")) box->setCurrentIndex(0);
  save(page, "Save changes");
  EXPECT_TRUE(page.message().startsWith(QStringLiteral("This is the last administrator."))) << page.message().toStdString();
  EXPECT_EQ(records.store().accounts.find(records.administrator().id)->role, Role::administrator);
}

}  // namespace
}  // namespace cusp::test
