/// Whether a length is one of a tooth. A wrong unit makes a whole import wrong, so the user is asked.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "engine/base/vec.h"
#include "scenarios/import/remarks.h"

namespace cusp::scenarios {

/// Longest sides that are believed, mm: the crown of a deciduous incisor is 5 mm high, a dental arch 65 mm wide.
/// tests/scenarios/import/precedence_test.cpp holds both ends.
inline constexpr double kLeastBelievedMm = 4.0, kMostBelievedMm = 100.0;

/// Powers of ten between the metric units, and inches, by which files are off.
inline constexpr std::array<double, 8> kUsualFactors = {10.0, 100.0, 1000.0, 0.1, 0.01, 0.001, 25.4, 1.0 / 25.4};

inline bool believed(double longest_mm) noexcept { return longest_mm >= kLeastBelievedMm && longest_mm <= kMostBelievedMm; }

/// The usual factors that make this length a believed one; empty when it is one already, or when none does.
inline std::vector<double> size_factors(double longest_mm) {
  std::vector<double> out;
  if (believed(longest_mm)) return out;
  for (const double factor : kUsualFactors)
    if (believed(longest_mm * factor)) out.push_back(factor);
  return out;
}

/// The remark on a specimen of this size; nullopt when its longest side is believed.
inline std::optional<ImportRemark> odd_size(Vec3 size_mm) {
  const double longest = std::max({size_mm.x, size_mm.y, size_mm.z});
  if (believed(longest)) return std::nullopt;
  ImportRemark out{RemarkCode::size_odd, {}, {longest}};
  for (const double factor : size_factors(longest)) out.numbers.push_back(factor);
  return out;
}

}  // namespace cusp::scenarios
