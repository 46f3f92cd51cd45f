// What is read of a spreadsheet's list of students.
#include "tests/modules.h"
#include "ui/admin/people_csv.h"
#include "ui/admin/people_import_work.h"

#include <gtest/gtest.h>

#include <QRegularExpression>

namespace cusp::test {
namespace {

using State = ListedStudent::State;
using Problem = ListedStudent::Problem;

TEST(Csv, reads_quotes_separators_and_line_breaks_in_cells) {
  const auto table = read_csv(QStringLiteral("a;b\r\n\"x;\"\"y\"\"\";\"two\nlines\"\r\n\r\nlast;1"));
  ASSERT_TRUE(table);
  ASSERT_EQ(table->rows.size(), 3u);
  EXPECT_EQ(table->rows[1], (std::vector<QString>{QStringLiteral("x;\"y\""), QStringLiteral("two\nlines")}));
  EXPECT_EQ(table->lines, (std::vector<int>{1, 2, 5}));
}

TEST(Csv, names_the_line_of_a_quote_that_never_closes) {
  const auto table = read_csv(QStringLiteral("a,b\n1,2\n\"3,4\n5,6"));
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().where, "3");
}

TEST(Csv, reads_names_in_either_encoding) {
  EXPECT_EQ(decode_text("\xEF\xBB\xBFM\xC3\xBCller"), QStringLiteral("Müller"));
  EXPECT_EQ(decode_text("M\xFCller, \x8A"), QStringLiteral("Müller, Š"));
  EXPECT_EQ(decode_text(QByteArray("\xFF\xFEM\0\xFC\0", 6)), QStringLiteral("Mü")) << "a spreadsheet's Unicode text";
}

std::vector<ListedStudent> list_of(const char* text, const std::vector<Account>& accounts = {}) {
  const auto list = read_student_list(text, accounts);
  return list ? *list : std::vector<ListedStudent>{};
}

TEST(StudentList, takes_its_columns_by_their_heads_in_english_and_german) {
  const auto english = list_of("Name,Student number,Cohort\nLena Brandt,4711,Year 3\n");
  ASSERT_EQ(english.size(), 1u);
  EXPECT_EQ(english[0].name, QStringLiteral("Lena Brandt"));
  EXPECT_EQ(english[0].number, QStringLiteral("4711"));
  EXPECT_EQ(english[0].cohort, QStringLiteral("Year 3"));
  const auto german = list_of("Nachname;Vorname;Matrikel-Nr.;PIN\nBrandt;Lena;4711;123456\n");
  ASSERT_EQ(german.size(), 1u);
  EXPECT_EQ(german[0].name, QStringLiteral("Lena Brandt"));
  EXPECT_EQ(german[0].pin, QStringLiteral("123456"));
}

TEST(StudentList, is_read_whatever_ends_its_lines_and_parts_its_cells) {
  const auto mac = list_of("Number,Name\r1,Lena Brandt\r2,Omar Haddad\r");
  ASSERT_EQ(mac.size(), 2u) << "lines of an older Mac";
  EXPECT_EQ(mac[1].name, QStringLiteral("Omar Haddad"));
  EXPECT_EQ(mac[1].line, 3);
  const auto quoted = list_of("Matrikelnummer;Name;\"Ort, PLZ, Land\"\n4711;Lena Brandt;\"Bonn, 53111, D\"\n");
  ASSERT_EQ(quoted.size(), 1u) << "commas in a quoted head";
  EXPECT_EQ(quoted[0].number, QStringLiteral("4711"));
  const auto named = list_of("sep=;\r\nName;Matrikelnummer\r\n\"Brandt, Lena\";4711\r\n");
  ASSERT_EQ(named.size(), 1u) << "a first line that only names the separator";
  EXPECT_EQ(named[0].name, QStringLiteral("Brandt, Lena"));
  EXPECT_EQ(named[0].line, 3);
}

TEST(StudentList, takes_the_student_number_and_no_id_of_the_line) {
  const auto list = list_of("ID;Nachname;Vorname;Matrikelnummer\n1;Brandt;Lena;4711\n");
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].number, QStringLiteral("4711"));
}

TEST(StudentList, a_name_beside_a_first_name_is_the_surname_unless_it_holds_both) {
  const auto surname = list_of("Name;Vorname;Matrikelnummer\nBrandt;Lena;4711\n");
  ASSERT_EQ(surname.size(), 1u);
  EXPECT_EQ(surname[0].name, QStringLiteral("Lena Brandt"));
  const auto both = list_of("Number,First name,Name\n4711,Lena,Lena Brandt\n4712,Omar,\"Said, Omar\"\n4713,Anna,Annan\n4714,Ida,\n");
  ASSERT_EQ(both.size(), 4u);
  EXPECT_EQ(both[0].name, QStringLiteral("Lena Brandt"));
  EXPECT_EQ(both[1].name, QStringLiteral("Said, Omar"));
  EXPECT_EQ(both[2].name, QStringLiteral("Anna Annan"));
  EXPECT_EQ(both[3].name, QStringLiteral("Ida"));
}

TEST(StudentList, says_of_each_line_why_it_is_left_out) {
  const auto list = list_of("number,name,pin\n,Nobody,\n1,,\n2,Two,12345\n3,Three,\n3,Three,\n");
  ASSERT_EQ(list.size(), 5u);
  const Problem expected[] = {Problem::no_number, Problem::no_name, Problem::bad_pin, Problem::none, Problem::twice};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(list[i].problem, expected[i]) << i;
  EXPECT_EQ(list[2].line, 4);
}

TEST(StudentList, leaves_out_what_is_too_long_for_an_account) {
  const std::string number(64, '1'), name(199, 'n');
  const auto list = list_of(("number,name,cohort\n" + number + "," + name + ",\n" + number + "2,Two,\n3," + name + "\xC3\xA9\xC3\xA9,\n4,Four," + name + "xx\n5," + name + "\xC3\xA9,\n").c_str());
  ASSERT_EQ(list.size(), 5u);
  const Problem expected[] = {Problem::none, Problem::too_long, Problem::too_long, Problem::too_long, Problem::none};
  for (std::size_t i = 0; i < 5; ++i) EXPECT_EQ(list[i].problem, expected[i]) << i;
}

TEST(StudentList, leaves_accounts_that_stand_as_they_are) {
  Account lena, berg;
  lena.number = "4711", lena.name = "Lena Brandt";
  berg.number = "berg", berg.name = "Dr Berg", berg.role = Role::instructor;
  const auto list = list_of("number,name\n4711,Lena Brandt\n4711 ,Someone\nBERG,Dr Berg\n", {lena, berg});
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].state, State::known);
  EXPECT_EQ(list[1].problem, Problem::twice);
  EXPECT_EQ(list[2].problem, Problem::staff);
  EXPECT_EQ(list_of("number,name\n4711,Someone\n", {lena})[0].state, State::other_name);
}

TEST(StudentList, names_the_account_that_has_the_name_of_a_new_line_unless_the_list_names_both) {
  const Account lena{.number = "4711", .name = "Lena Brandt"}, omar{.number = "4712", .name = "Omar Haddad"};
  const auto list = list_of("number,name\n0815,\"Brandt, Lena\"\n4712,Omar Haddad\n0816,Omar Haddad\n", {lena, omar});
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].namesake, QStringLiteral("4711"));
  EXPECT_EQ(list[2].namesake, QString());
}

TEST(StudentList, knows_an_account_whose_name_an_older_program_took_with_its_marks_and_blanks) {
  Account lena, omar;
  lena.number = "1", lena.name = "Lena  Brandt";
  omar.number = "2", omar.name = "\u200EOmar Haddad";
  const auto list = list_of("number,name\n1,Lena  Brandt\n2,\u200EOmar Haddad\n", {lena, omar});
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].state, State::known);
  EXPECT_EQ(list[1].state, State::known);
}

TEST(StudentList, takes_no_mark_that_nobody_sees) {
  const auto list = list_of("number,name,pin,cohort\n\u200B4711\u202C,\u202ELena\u202C\u0007 Brandt,\u200E123456,Year\u2066 3\n4711,Other,,\n8,\"Omar\nHaddad\",,\n9,\u0645\u06CC\u200C\u0646\u0627,,\n");
  ASSERT_EQ(list.size(), 4u);
  EXPECT_EQ(list[0].number, QStringLiteral("4711"));
  EXPECT_EQ(list[0].name, QStringLiteral("Lena Brandt"));
  EXPECT_EQ(list[0].pin, QStringLiteral("123456"));
  EXPECT_EQ(list[0].cohort, QStringLiteral("Year 3"));
  EXPECT_EQ(list[1].problem, Problem::twice) << "both look the same";
  EXPECT_EQ(list[2].name, QStringLiteral("Omar Haddad"));
  EXPECT_EQ(list[3].name, QString::fromUtf8("\u0645\u06CC\u200C\u0646\u0627")) << "a joiner is part of the spelling";
}

TEST(StudentList, writes_a_letter_and_its_mark_as_the_one_character_that_is_typed) {
  const Account known{.number = "2", .name = "Mu\u0308ller"};  // of an older program
  const auto list = list_of("number,name,cohort\nu\u03081,Mu\u0308ller,U\u0308bung\n\u00FC1,Other,\n2,M\u00FCller,\n", {known});
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].number + list[0].name, QString::fromUtf8("\u00FC1M\u00FCller"));
  EXPECT_EQ(list[0].cohort, QString::fromUtf8("\u00DCbung"));
  EXPECT_EQ(list[1].problem, Problem::twice);
  EXPECT_EQ(list[2].state, State::known);
}

TEST(StudentList, a_tab_or_a_line_s_end_within_a_cell_parts_two_words) {
  const auto list = list_of("number,name,cohort\n1,Lena\tBrandt,Year\t3\n2,\"Omar\r\nHaddad\",\n3,\"Ida\rLind\",\n");
  ASSERT_EQ(list.size(), 3u);
  EXPECT_EQ(list[0].name, QStringLiteral("Lena Brandt"));
  EXPECT_EQ(list[0].cohort, QStringLiteral("Year 3"));
  EXPECT_EQ(list[1].name, QStringLiteral("Omar Haddad"));
  EXPECT_EQ(list[2].name, QStringLiteral("Ida Lind"));
}

TEST(StudentList, is_refused_without_heads_or_lines) {
  EXPECT_EQ(read_student_list("4711,Lena\n", {}).error().code, ListError::no_columns);
  EXPECT_EQ(read_student_list("number,name\n", {}).error().code, ListError::empty);
  EXPECT_EQ(read_student_list("", {}).error().code, ListError::empty);
}

TEST(Pins, are_six_digits_for_each_new_line_that_brings_none) {
  auto lines = list_of("number,name,pin\n1,Known One,\n2,New Two,222222\n3,New Three,\n,Nobody,\n", {{.number = "1", .name = "Known One"}});
  ASSERT_EQ(lines.size(), 4u);
  give_pins(lines);
  EXPECT_EQ(lines[0].pin, QString()) << "an account that stands keeps its own";
  EXPECT_EQ(lines[1].pin, QStringLiteral("222222"));
  EXPECT_TRUE(QRegularExpression(QStringLiteral("^[0-9]{6}$")).match(lines[2].pin).hasMatch()) << lines[2].pin.toStdString();
  EXPECT_EQ(lines[3].pin, QString());
}

}  // namespace
}  // namespace cusp::test
