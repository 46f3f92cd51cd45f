/// A volume as a foreign file holds it: one number a voxel, along axes that have been turned into the specimen's. Its
/// voxels need not be cubes, and its numbers mean nothing yet: image_volume.h makes tissues of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "scenarios/import/import_error.h"
#include "scenarios/import/limits.h"

namespace cusp::scenarios {

/// Share done, 0 to 1; called on the calling thread.
using ImportProgress = std::function<void(double)>;

enum class ImageKind : std::uint8_t {
  labels,   // few whole numbers from 0 (nothing) on
  colours,  // 0xRRGGBB, 0 (nothing) for black and for what is wholly transparent
  grey,     // a measured density, as of a CT
};
inline constexpr std::array<std::string_view, 3> kImageKindKeys = {"labels", "colours", "grey"};

/// Where a file's voxels lie in the specimen's frame.
struct ImageLayout {
  IVec3 file_size{0};       // along the file's own axes, fastest first
  IVec3 size{0};            // along x, y, z of the specimen
  Vec3 spacing_mm{1.0};     // distance of voxel centres along each
  Vec3 origin_mm{0.0};      // centre of voxel (0,0,0)
  double turned_degrees = 0.0;  // by which oblique axes were straightened: the shape is kept, its pose is not
  std::ptrdiff_t first = 0;     // place of the file's first voxel in [z][y][x]
  std::array<std::ptrdiff_t, 3> step{};  // [file axis]: places to go on by

  std::size_t place(int i, int j, int k) const noexcept {
    return static_cast<std::size_t>(first + i * step[0] + j * step[1] + k * step[2]);
  }
};

/// `step_mm[i]`: from one voxel to the next along file axis i, in the specimen's frame (right-anterior-superior).
/// Axes in any order and direction; right-angled to 0.1 %, else bad_orientation. Sizes and their product are held
/// against the limits here, before memory is taken.
[[nodiscard]] Result<ImageLayout, ImportError> lay_out(IVec3 file_size, const std::array<Vec3, 3>& step_mm,
                                                       Vec3 first_mm, const VolumeLimits& limits);

struct Image {
  ImageLayout layout;
  ImageKind kind = ImageKind::grey;
  bool spacing_known = true;  // false: the file has none; 1 mm until the user answers
  bool sides_known = true;    // false: the file does not state which way its axes run; the tooth may be mirrored
  std::vector<float> value;   // [z][y][x], finite
  double measured_from = -1e300;  // grey: nothing was measured where the value is below, so that no threshold takes it
};

/// Numbers that are none, or beyond a thousand million, become 0 among labels, else a value below all that are measured.
/// nothing_solid: no voxel has a number.
[[nodiscard]] Result<void, ImportError> tidy_values(Image& image);
/// Labels when there are at most kMaxLabels different numbers, whole and from 0 to 65535; else grey. Leaves out what tidy_values() replaces.
inline constexpr std::size_t kMaxLabels = 64;
ImageKind kind_of_values(const std::vector<float>& values);

/// Two grey values that part what is there into three by Otsu's criterion, the second among what is above the first: a
/// beginning for the eye. The least and the most value when all are alike.
std::array<double, 2> suggested_thresholds(const std::vector<float>& values);

}  // namespace cusp::scenarios
