/// Command-line options. An empty filter leaves the verb's own set.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cusp::bench {

/// Whether the operator feels the guarded force or the method's own.
enum class GuardUse : std::uint8_t { off, on };

struct Options {
  std::vector<std::string> methods;
  std::vector<std::string> shapes;
  std::vector<std::string> motions;
  std::vector<std::string> tasks;
  std::vector<std::string> cases;    // stability
  std::vector<std::string> guards;   // stability: on, off
  std::vector<std::string> devices;  // stability
  std::vector<std::string> grips;    // stability
  std::vector<double> frictions_n;   // stability
  std::vector<double> delays_ms;     // stability
  std::vector<std::string> measures;    // removal
  std::vector<std::string> tissues;     // removal
  std::vector<std::string> directions;  // removal
  std::vector<double> ticks_ms;         // removal
  std::vector<double> alphas;           // removal
  std::vector<std::string> burs;        // heads, mill: catalogue numbers
  std::vector<std::string> axes;        // heads: fixed, turning, jitter; mill: fixed, jitter
  bool full = false;                    // removal: full product, every bur; stability: k_max on every device; rate: mill, every bur
  std::vector<double> speeds_mm_s;
  std::vector<double> bur_radii_mm;
  std::vector<double> voxels_mm;
  std::vector<double> minutes;          // cavity, mill: of milling
  std::vector<double> tremors_mm;       // cavity, mill
  double seconds = 10.0;          // latency: of each row
  std::vector<std::string> loads; // latency: off, on
  double budget_s = 1.0;          // wall clock of a row; sets the number of presses and ticks
  std::int64_t samples = 0;       // accuracy, heads: presses or ticks of a slide, whatever they take; 0: the budget ends a row
  std::uint64_t seed = 1;         // of every random choice
  std::string json;               // file, "-" for stdout, empty for a table
  std::string out;                // chart: folder
  std::vector<std::string> from;  // chart: files to read instead of measuring
};

inline bool asked(const std::vector<std::string>& filter, std::string_view value) {
  if (filter.empty()) return true;
  for (const std::string& f : filter)
    if (f == value) return true;
  return false;
}

/// Within 0.5 %: 0.078 means 10/128.
inline bool same(double a, double b) { return std::fabs(a - b) <= 0.005 * std::fabs(b); }

/// The verb's own values, or the filter's with near values replaced by the standard ones.
inline std::vector<double> chosen(const std::vector<double>& filter, const std::vector<double>& standard) {
  if (filter.empty()) return standard;
  std::vector<double> out;
  for (const double f : filter) {
    double value = f;
    for (const double s : standard)
      if (same(f, s)) value = s;
    out.push_back(value);
  }
  return out;
}

}  // namespace cusp::bench
