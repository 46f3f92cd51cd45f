#include "storage/base/clock.h"

#include <chrono>
#include <cstdio>

namespace cusp::storage {

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

}  // namespace cusp::storage
