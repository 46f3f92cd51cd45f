/// The two ways of packing a CT slice without loss, made byte by byte (DICOM PS3.5 annex G; ITU-T T.81 annex H).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cusp::test {

inline constexpr const char* kRleLossless = "1.2.840.10008.1.2.5";
inline constexpr const char* kJpegLossless = "1.2.840.10008.1.2.4.70";

/// Two segments, the upper bytes first; runs where there are some.
std::string rle_frame(const std::vector<std::int16_t>& values);
/// Process 14, selection value 1: each pixel as its difference from the one before it.
std::string jpeg_lossless_frame(const std::vector<std::int16_t>& values, int columns, int rows);

}  // namespace cusp::test
