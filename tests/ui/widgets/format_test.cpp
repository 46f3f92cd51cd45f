// format(): values as text.

#include <gtest/gtest.h>

#include <time.h>

#include <QLocale>
#include <QTimeZone>
#include <atomic>
#include <limits>
#include <thread>
#include <vector>

#include "tests/modules.h"
#include "ui/widgets/format.h"

namespace cusp::test {
namespace {

const QLocale kEnglish(QLocale::English, QLocale::UnitedStates), kGerman(QLocale::German);

/// Without the isolates, with plain spaces, for comparing.
std::string plain(QString text) {
  EXPECT_TRUE(text.isEmpty() || (text.startsWith(QChar(0x2066)) && text.endsWith(QChar(0x2069))));
  text.remove(QChar(0x2066));
  text.remove(QChar(0x2069));
  text.replace(QChar(0x00A0), u' ');
  return text.toStdString();
}

TEST(Format, a_name_of_a_file_holds_no_sign_of_a_path) {
  EXPECT_EQ(as_file_name(QStringLiteral(" Müller w/o 2: \\ ..\n?")), QStringLiteral("Müller w-o 2- - ..--"));
  EXPECT_EQ(as_file_name(QStringLiteral("Class II, tooth 46")), QStringLiteral("Class II, tooth 46"));
}

TEST(Format, a_measured_value_has_unit_and_uncertainty_within_isolates) {
  EXPECT_EQ(plain(format({1.8449, 0.03, QStringLiteral("mm")}, kEnglish)), "1.84 mm ± 0.03");
  EXPECT_EQ(plain(format({1.8449, 0.03, QStringLiteral("mm")}, kGerman)), "1,84 mm ± 0,03");
  EXPECT_EQ(plain(format({0.93, 0.1, QStringLiteral("mm3")}, kEnglish)), "0.9 mm³ ± 0.1");
  EXPECT_EQ(plain(format({96.84, 0.4, QStringLiteral("%")}, kEnglish)), "96.8 % ± 0.4");
}

TEST(Format, nothing_reads_as_minus_zero_or_as_plus_minus_zero) {
  EXPECT_EQ(plain(format({-0.001, std::nullopt, QStringLiteral("mm"), 2}, kEnglish)), "0.00 mm");
  EXPECT_EQ(plain(format({1.0, 0.0004, QStringLiteral("mm"), 2}, kEnglish)), "1.00 mm");
  EXPECT_EQ(plain(format({1.0, 0.002, QStringLiteral("mm"), 2}, kEnglish)), "1.00 mm ± 0.002");
  EXPECT_EQ(plain(format({1.0, 0.0, QStringLiteral("mm"), 2}, kEnglish)), "1.00 mm");
}

TEST(Format, a_negative_number_has_a_real_minus_and_no_number_has_a_dash) {
  EXPECT_EQ(format_number(-3.26, 1, kEnglish).toStdString(), "−3.3");
  EXPECT_EQ(format_number(std::numeric_limits<double>::quiet_NaN(), 1, kEnglish).toStdString(), "–");
}

TEST(Format, points_are_whole_where_they_are_whole) {
  EXPECT_EQ(format_points(81.0, kEnglish).toStdString(), "81");
  EXPECT_EQ(format_points(81.46, kEnglish).toStdString(), "81.5");
  EXPECT_EQ(format_points(81.46, kGerman).toStdString(), "81,5");
}

TEST(Format, points_just_below_a_mark_do_not_read_as_the_mark) {
  EXPECT_EQ(format_points(69.96, kEnglish).toStdString(), "69.9");
  EXPECT_EQ(format_points(69.999, kEnglish).toStdString(), "69.9");
  EXPECT_EQ(format_points(70.04, kEnglish).toStdString(), "70");
  EXPECT_EQ(format_points(69.96 + 0.04, kEnglish).toStdString(), "70");
  EXPECT_EQ(format_points(0.7 * 100, kEnglish).toStdString(), "70");
  EXPECT_EQ(format_points(0.02, kEnglish).toStdString(), "0");
  EXPECT_EQ(format_points(-0.02, kEnglish).toStdString(), "0");
}

TEST(Format, a_share_is_100_percent_of_all_alone_and_0_percent_of_none) {
  EXPECT_EQ(plain(format_share(199, 200, kEnglish)), "99 %") << "one of a year's attempts failed";
  EXPECT_EQ(plain(format_share(200, 200, kEnglish)), "100 %");
  EXPECT_EQ(plain(format_share(1, 300, kEnglish)), "1 %");
  EXPECT_EQ(plain(format_share(0, 300, kEnglish)), "0 %");
  EXPECT_EQ(plain(format_share(2, 3, kGerman)), "67 %");
}

TEST(Format, a_clock_counts_minutes_and_from_an_hour_on_hours) {
  EXPECT_EQ(plain(format_clock(458.9)), "7:38");
  EXPECT_EQ(plain(format_clock(5)), "0:05");
  EXPECT_EQ(plain(format_clock(3661)), "1:01:01");
}

TEST(Format, a_task_writes_numbers_while_the_window_installs_another_locale) {
  const QLocale before = installed_locale();
  install_locale(kGerman);
  QLocale::setDefault(kEnglish);  // Qt's own, which a task may not read
  EXPECT_EQ(format_number(1.5, 1).toStdString(), "1,5");
  std::atomic<bool> over = false;
  int other = 0;
  std::thread task([&] {
    while (!over) {
      const std::string text = format_number(1.5, 1).toStdString();
      other += text != "1,5" && text != "1.5" ? 1 : 0;
    }
  });
  for (int i = 0; i < 2000; ++i) install_locale(i % 2 == 0 ? kEnglish : kGerman);
  over = true;
  task.join();
  EXPECT_EQ(other, 0);
  install_locale(before);
}

TEST(Format, a_day_is_written_in_the_order_of_the_language) {
  const QDateTime when(QDate(2026, 11, 20), QTime(10, 14));
  EXPECT_EQ(format_day_time(when, kEnglish, when).toStdString(), "Fri 20 Nov, 10:14");
  EXPECT_EQ(format_day(when, kGerman, when).toStdString(), "Fr. 20. Nov.");
}

TEST(Format, a_day_of_another_year_than_now_has_its_year) {
  const QDateTime last(QDate(2026, 12, 31), QTime(23, 59)), first = last.addSecs(60);
  EXPECT_EQ(format_day(last, kEnglish, last).toStdString(), "Thu 31 Dec");
  EXPECT_EQ(format_day(last, kEnglish, first).toStdString(), "Thu 31 Dec 2026");
  EXPECT_EQ(format_day_time(last, kGerman, first).toStdString(), "Do. 31. Dez. 2026, 23:59");
  EXPECT_EQ(format_day(first, kEnglish, last).toStdString(), "Fri 1 Jan 2027");
}

/// The local time zone while it lives.
class LocalZone {
 public:
  explicit LocalZone(const char* name) : before_(qgetenv("TZ")) { set(name); }
  ~LocalZone() {
    if (before_.isNull()) qunsetenv("TZ");
    else set(before_);
    tzset();
  }
  LocalZone(const LocalZone&) = delete;
  LocalZone& operator=(const LocalZone&) = delete;

 private:
  static void set(const QByteArray& name) {
    qputenv("TZ", name);
    tzset();
  }
  QByteArray before_;
};

TEST(Format, points_of_a_column_have_the_same_decimals) {
  const std::vector<double> whole = {81, 100, 0}, tenths = {81, 69.96, 100};
  EXPECT_EQ(points_decimals(whole), 0);
  EXPECT_EQ(points_decimals(tenths), 1);
  EXPECT_EQ(points_decimals({}), 0);
  EXPECT_EQ(format_points_to(81, 1, kEnglish).toStdString(), "81.0");
  EXPECT_EQ(format_points_to(69.96, 1, kEnglish).toStdString(), "69.9") << "never up to the pass mark";
  EXPECT_EQ(format_points_to(81, 0, kEnglish).toStdString(), "81");
}

TEST(Format, what_is_kept_has_its_year_and_on_paper_the_offset_from_utc) {
  const QDateTime when(QDate(2026, 11, 27), QTime(8, 21), QTimeZone::utc());
  // POSIX counts west of Greenwich as positive.
  for (const auto& [zone, shown] : {std::pair{"UTC0", "08:21 UTC"}, {"CET-1", "09:21 UTC+1"}, {"IST-5:30", "13:51 UTC+5:30"}, {"NST3:30", "04:51 UTC\u22123:30"}}) {
    const LocalZone local(zone);
    EXPECT_EQ(format_date_time_zone(when, kEnglish).replace(QChar(0x00A0), u' ').toStdString(), std::string("Fri 27 Nov 2026, ") + shown);
  }
  const QDateTime here(QDate(2026, 11, 27), QTime(8, 21));
  EXPECT_EQ(format_date_time(here, kEnglish).toStdString(), "Fri 27 Nov 2026, 08:21");
  EXPECT_EQ(format_date(here, kGerman).toStdString(), "Fr. 27. Nov. 2026");
  EXPECT_EQ(kGerman.toString(here, date_pattern(kGerman)).toStdString(), "27. Nov. 2026");
  EXPECT_EQ(kEnglish.toString(here, date_pattern(kEnglish)).toStdString(), "27 Nov 2026");
}

TEST(Format, lets_a_line_end_only_in_words_that_are_too_long) {
  const QString longest = QStringLiteral("Zusammenhangskomponente");  // of the translations
  EXPECT_EQ(breakable(longest + u' ' + longest), longest + u' ' + longest);
  EXPECT_EQ(breakable(QStringLiteral("abcde"), 2), QStringLiteral("ab\u200Bcd\u200Be"));
  EXPECT_EQ(breakable(QStringLiteral("ab cd"), 2), QStringLiteral("ab cd"));
  EXPECT_EQ(breakable(QStringLiteral("a\U0001F9B7b"), 2), QStringLiteral("a\U0001F9B7\u200Bb")) << "a pair of surrogates stays whole";
}

}  // namespace
}  // namespace cusp::test
