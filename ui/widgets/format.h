/// Values as text: the locale's digits, a no-break space before the unit, ± with at most two digits. U+2066 … U+2069 keep the
/// order of the parts in right-to-left text. Pure functions, but for dates: those are in the local time zone.
#pragma once

#include <QDateTime>
#include <QLocale>
#include <QString>
#include <optional>
#include <span>

namespace cusp::ui {

/// Sets Qt's default, which widgets take, and installed_locale(). Thread: GUI.
void install_locale(const QLocale& locale);
/// Thread: any. Qt guards its own default by no lock.
QLocale installed_locale();

struct Measured {
  double value = 0;
  std::optional<double> uncertainty{};  // one-sided, same unit
  QString unit{};                       // "mm", "mm3", "N", "s", "%"; shown as mm³ etc.
  int decimals = -1;                    // -1: from the uncertainty, else two
};

/// "1.84 mm ± 0.03"
QString format(const Measured& m, const QLocale& locale = installed_locale());
/// The two halves of the above: "1.84 mm" and "± 0.03" (empty without uncertainty).
QString format_value(const Measured& m, const QLocale& locale = installed_locale());
QString format_uncertainty(const Measured& m, const QLocale& locale = installed_locale());
/// "mm³" for "mm3".
QString unit_text(const QString& unit);

QString format_number(double value, int decimals, const QLocale& locale = installed_locale());
/// shown_score() of scenarios/grading/maxima.h.
double shown_points(double points);
/// shown_points(): whole where they are whole, else with one decimal.
QString format_points(double points, const QLocale& locale = installed_locale());
/// Decimals of a column of points: one if any of them shows one, else none.
int points_decimals(std::span<const double> points);
/// format_points() with the decimals of its column.
QString format_points_to(double points, int decimals, const QLocale& locale = installed_locale());
/// "84 %" of `whole`: 100 % is all of them alone, 0 % none of them. Pre: 0 <= part <= whole, whole > 0.
QString format_share(int part, int whole, const QLocale& locale = installed_locale());
/// "7:38" from seconds.
QString format_clock(double seconds);
/// A stored time, µs since 1970 UTC, as local time.
QDateTime local_time(std::int64_t utc_us);
/// For a screen: "Fri 20 Nov" and "Fri 20 Nov, 10:14", in the locale's order. The year follows the month if it is not that of `now`.
QString format_day(const QDateTime& when, const QLocale& locale = installed_locale(), const QDateTime& now = QDateTime::currentDateTime());
QString format_day_time(const QDateTime& when, const QLocale& locale = installed_locale(), const QDateTime& now = QDateTime::currentDateTime());
/// Qt's pattern of a day, a month and a year: "20 Nov 2026", in German "20. Nov. 2026".
QString date_pattern(const QLocale& locale = installed_locale());
/// For what is kept: "Fri 20 Nov 2026" and "Fri 20 Nov 2026, 10:14".
QString format_date(const QDateTime& when, const QLocale& locale = installed_locale());
QString format_date_time(const QDateTime& when, const QLocale& locale = installed_locale());
/// For paper: "Fri 20 Nov 2026, 10:14 UTC+1".
QString format_date_time_zone(const QDateTime& when, const QLocale& locale = installed_locale());
/// HTML that shows `text` as it stands, with its lines, in a tool tip or a box: Qt would read HTML in it.
QString tool_tip_text(const QString& text);
/// HTML only if Qt would read HTML in `text`: a screen reader reads the tool tip of a button.
QString short_tool_tip(const QString& text);
/// A name that holds `text` without what a path or the file system of a stick reads in another way.
QString as_file_name(QString text);
/// A number or PIN without the marks that nobody sees, and without blanks around it: nobody types one when signing in.
QString without_marks(QString typed);
/// A name likewise, but with the joiners of Persian and Indian spelling; a line's end or a tab parts two words.
QString without_marks_but_joiners(QString text);
/// `text` with U+200B, where a line may end, after each `whole` characters without a blank: a name of 60 letters would widen what it
/// stands in. The longest word of the translations has 23.
QString breakable(const QString& text, int whole = 24);
/// Wraps in U+2066 … U+2069.
QString isolate(const QString& text);

}  // namespace cusp::ui
