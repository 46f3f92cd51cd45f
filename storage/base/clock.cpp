#include "storage/base/clock.h"

#include <chrono>
#include <cstdio>

namespace cusp::storage {
namespace {

/// Same length, a digit for each 'd', every other character as it stands.
bool fits(std::string_view text, std::string_view pattern) {
  if (text.size() != pattern.size()) return false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool digit = text[i] >= '0' && text[i] <= '9';
    if (pattern[i] == 'd' ? !digit : text[i] != pattern[i]) return false;
  }
  return true;
}

}  // namespace

std::int64_t system_utc_us() {
  using namespace std::chrono;
  return duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
}

std::string iso_utc(std::int64_t utc_us) {
  using namespace std::chrono;
  const sys_time<seconds> second{floor<seconds>(microseconds{utc_us})};
  const auto day = floor<days>(second);
  const year_month_day date{day};
  const hh_mm_ss time{second - day};
  char text[64];
  std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02d:%02d:%02dZ", static_cast<int>(date.year()),
                static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                static_cast<int>(time.hours().count()), static_cast<int>(time.minutes().count()),
                static_cast<int>(time.seconds().count()));
  return text;
}

std::optional<UtcSpan> utc_span_of(std::string_view iso) {
  using namespace std::chrono;
  const bool whole_day = fits(iso, "dddd-dd-dd");
  if (!whole_day && !fits(iso, "dddd-dd-ddTdd:dd:ddZ")) return std::nullopt;
  const auto number = [iso](std::size_t at, std::size_t digits) {
    int value = 0;
    for (const char c : iso.substr(at, digits)) value = value * 10 + (c - '0');
    return value;
  };
  const year_month_day date{year{number(0, 4)}, month{static_cast<unsigned>(number(5, 2))}, day{static_cast<unsigned>(number(8, 2))}};
  if (!date.ok()) return std::nullopt;
  const microseconds midnight = sys_days{date}.time_since_epoch();
  if (whole_day) return UtcSpan{midnight.count(), (midnight + days{1}).count()};
  const int hour = number(11, 2), minute = number(14, 2), second = number(17, 2);
  if (hour > 23 || minute > 59 || second > 59) return std::nullopt;
  const microseconds begin = midnight + hours{hour} + minutes{minute} + seconds{second};
  return UtcSpan{begin.count(), (begin + seconds{1}).count()};
}

}  // namespace cusp::storage
