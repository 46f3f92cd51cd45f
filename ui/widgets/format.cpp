#include "ui/widgets/format.h"

#include <QRegularExpression>
#include <QTextDocument>
#include <algorithm>
#include <cmath>
#include <mutex>

#include "scenarios/grading/maxima.h"

namespace cusp::ui {
namespace {

constexpr QChar kNoBreak(0x00A0);

struct Installed {
  std::mutex mutex;  // guards what follows; held for a copy
  QLocale locale;
};
Installed& installed() {
  static Installed one;
  return one;
}

/// Decimals that show two digits of an uncertainty at most: 0.034 -> 2, 0.4 -> 1, 3 -> 0.
int decimals_from(double uncertainty) {
  if (!(uncertainty > 0) || !std::isfinite(uncertainty)) return 2;
  const int exponent = static_cast<int>(std::floor(std::log10(uncertainty)));
  return std::clamp(-exponent, 0, 3);
}

int decimals_of(const Measured& m) {
  if (m.decimals >= 0) return m.decimals;
  if (!m.uncertainty) return 2;
  return std::min(decimals_from(*m.uncertainty), 2);
}

/// A zero-width or direction mark, or a control character.
bool is_unseen(QChar c) { return c.category() == QChar::Other_Format || c.category() == QChar::Other_Control; }

QString time_after_day(const QDateTime& when, const QLocale& locale) {
  return QStringLiteral(", ") + locale.toString(when.toLocalTime(), QStringLiteral("HH:mm"));
}

}  // namespace

void install_locale(const QLocale& locale) {
  QLocale::setDefault(locale);
  const std::lock_guard lock(installed().mutex);
  installed().locale = locale;
}

QLocale installed_locale() {
  const std::lock_guard lock(installed().mutex);
  return installed().locale;
}

QString isolate(const QString& text) { return QChar(0x2066) + text + QChar(0x2069); }

QString without_marks(QString typed) { return typed.removeIf(is_unseen).trimmed(); }

QString without_marks_but_joiners(QString text) {
  for (QChar& c : text)
    if (c.isSpace()) c = u' ';
  return text.removeIf([](QChar c) { return is_unseen(c) && c != QChar(0x200C) && c != QChar(0x200D); }).simplified();
}

QString as_file_name(QString text) {
  static const QRegularExpression kSigns(QStringLiteral("[/\\\\:*?\"<>|\\x{0}-\\x{1f}]"));
  return text.replace(kSigns, QStringLiteral("-")).trimmed();
}

QString tool_tip_text(const QString& text) {
  return QStringLiteral("<span>%1</span>").arg(text.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>")));
}
QString short_tool_tip(const QString& text) { return Qt::mightBeRichText(text) ? tool_tip_text(text) : text; }

QString unit_text(const QString& unit) {
  if (unit == u"mm3") return QStringLiteral("mm³");
  if (unit == u"mm2") return QStringLiteral("mm²");
  if (unit == u"deg") return QStringLiteral("°");
  if (unit == u"K") return QStringLiteral("°C");  // of differences: a degree is a degree
  return unit;
}

QString format_number(double value, int decimals, const QLocale& locale) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  // "−0.00" would be a sign without a value.
  if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0;
  QString text = locale.toString(value, 'f', decimals);
  if (text.startsWith(u'-')) text[0] = QChar(0x2212);
  return text;
}

QString format_value(const Measured& m, const QLocale& locale) {
  QString text = format_number(m.value, decimals_of(m), locale);
  if (!m.unit.isEmpty()) text += kNoBreak + unit_text(m.unit);
  return isolate(text);
}

QString breakable(const QString& text, int whole) {
  constexpr QChar kMayBreak(0x200B);
  QString out;
  int unbroken = 0;
  for (const QChar c : text) {
    if (c.isSpace()) {
      unbroken = 0;
    } else if (unbroken >= whole && !c.isLowSurrogate()) {
      out += kMayBreak;
      unbroken = 1;
    } else {
      ++unbroken;
    }
    out += c;
  }
  return out;
}

QString format_uncertainty(const Measured& m, const QLocale& locale) {
  if (!m.uncertainty || !(*m.uncertainty > 0)) return {};
  const int decimals = decimals_of(m);
  const double least = 0.5 * std::pow(10.0, -decimals);
  // An uncertainty below what is printed would read "± 0.00": one more digit shows it.
  const int shown = *m.uncertainty < least ? std::min(decimals + 1, 3) : decimals;
  if (*m.uncertainty < 0.5 * std::pow(10.0, -shown)) return {};
  return isolate(QChar(0x00B1) + QString(kNoBreak) + format_number(*m.uncertainty, shown, locale));
}

QString format(const Measured& m, const QLocale& locale) {
  QString text = format_number(m.value, decimals_of(m), locale);
  if (!m.unit.isEmpty()) text += kNoBreak + unit_text(m.unit);
  QString uncertainty = format_uncertainty(m, locale);
  if (!uncertainty.isEmpty()) text += kNoBreak + uncertainty.mid(1, uncertainty.size() - 2);
  return isolate(text);
}

double shown_points(double points) { return scenarios::shown_score(points); }

QString format_points(double points, const QLocale& locale) {
  const double shown = shown_points(points);
  return format_number(shown, shown == std::floor(shown) ? 0 : 1, locale);
}

int points_decimals(std::span<const double> points) {
  const auto has_tenths = [](double p) { return shown_points(p) != std::floor(shown_points(p)); };
  return std::ranges::any_of(points, has_tenths) ? 1 : 0;
}

QString format_points_to(double points, int decimals, const QLocale& locale) { return format_number(shown_points(points), decimals, locale); }

QString format_share(int part, int whole, const QLocale& locale) {
  const double rounded = std::round(100.0 * part / whole);
  const double percent = part == whole || part == 0 ? rounded : std::clamp(rounded, 1.0, 99.0);
  return format({percent, std::nullopt, QStringLiteral("%"), 0}, locale);
}

QString format_clock(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return QStringLiteral("–");
  const auto whole = static_cast<long long>(std::floor(seconds));
  const auto two = [](long long v) { return QStringLiteral("%1").arg(v, 2, 10, QLatin1Char('0')); };
  if (whole >= 3600) return isolate(QString::number(whole / 3600) + u':' + two(whole / 60 % 60) + u':' + two(whole % 60));
  return isolate(QString::number(whole / 60) + u':' + two(whole % 60));
}

QDateTime local_time(std::int64_t utc_us) { return QDateTime::fromMSecsSinceEpoch(utc_us / 1000); }

QString format_day(const QDateTime& when, const QLocale& locale, const QDateTime& now) {
  const QDateTime local = when.toLocalTime();
  if (local.date().year() != now.toLocalTime().date().year()) return format_date(when, locale);
  return locale.toString(local, locale.language() == QLocale::German ? QStringLiteral("ddd d. MMM") : QStringLiteral("ddd d MMM"));
}

QString format_day_time(const QDateTime& when, const QLocale& locale, const QDateTime& now) {
  return format_day(when, locale, now) + time_after_day(when, locale);
}

QString date_pattern(const QLocale& locale) {
  return locale.language() == QLocale::German ? QStringLiteral("d. MMM yyyy") : QStringLiteral("d MMM yyyy");
}

QString format_date(const QDateTime& when, const QLocale& locale) {
  return locale.toString(when.toLocalTime(), QStringLiteral("ddd ") + date_pattern(locale));
}

QString format_date_time(const QDateTime& when, const QLocale& locale) { return format_date(when, locale) + time_after_day(when, locale); }

QString format_date_time_zone(const QDateTime& when, const QLocale& locale) {
  const int minutes = when.toLocalTime().offsetFromUtc() / 60;
  QString zone = QStringLiteral("UTC");
  if (minutes != 0) zone += (minutes < 0 ? QChar(0x2212) : QChar(u'+')) + QString::number(std::abs(minutes) / 60);
  if (minutes % 60 != 0) zone += QStringLiteral(":%1").arg(std::abs(minutes) % 60, 2, 10, QLatin1Char('0'));
  return format_date_time(when, locale) + kNoBreak + zone;
}

}  // namespace cusp::ui
