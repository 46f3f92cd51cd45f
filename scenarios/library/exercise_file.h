/// NAME.cusp: an exercise as one file, to hand from station to station. A tar archive (tar.h) of, in this order:
///   cusp-exercise   "format 1\ncontent <64 hex digits>\n": the content hash of the other two (content_hash.h)
///   scenario.json   canonical
///   <volume>        the NRRD file that scenario.json names, if it names one
/// The reader refuses any other file in it, and checks sizes before it takes memory. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/format/format_error.h"
#include "scenarios/format/scenario.h"
#include "scenarios/format/validate.h"
#include "scenarios/import/import_error.h"

namespace cusp::scenarios {

inline constexpr int kExerciseFileFormat = 1;
inline constexpr std::string_view kExerciseFileSuffix = ".cusp";
/// Whether a name ends so, in letters of either case: cusp.xml gives NAME.CUSP the type, too.
bool names_exercise_file(std::string_view name) noexcept;
/// As much as the largest volume takes without packing: VolumeLimits::max_voxels, 4 bytes each.
inline constexpr std::size_t kMaxExerciseFileBytes = std::size_t{512} << 20;

struct ExerciseFile {
  Scenario scenario;
  std::vector<std::byte> volume;  // NRRD; empty for a generated specimen
};

/// What is wrong with the file, with the exercise in it, or with its volume.
using ExerciseFileFailure = std::variant<FormatFailure, Finding, ImportFailure>;

/// What the reader refuses an exercise for: a volume that cannot be read, a tissue of its own with a grown tooth's code
/// (scenarios/specimens/taken_codes.h), else the first error of validate() with the volume.
[[nodiscard]] Result<void, ExerciseFileFailure> check_exercise_file(const ExerciseFile& file);

/// The file's bytes, also of an exercise that check_exercise_file() refuses: a version stays as it was published. A volume's name that an
/// archive cannot hold is shortened (tar_name): each station names its volumes as it likes.
[[nodiscard]] Result<std::string, ExerciseFileFailure> exercise_file_bytes(const ExerciseFile& file);
/// Writes a WholeFile (scenarios/import/whole_file.h): no half file bears the name.
[[nodiscard]] Result<void, ExerciseFileFailure> write_exercise_file(const ExerciseFile& file, const std::filesystem::path& path);

/// Bytes of any origin. Refuses what check_exercise_file() refuses.
[[nodiscard]] Result<ExerciseFile, ExerciseFileFailure> parse_exercise_file(std::string_view bytes);
/// The volume's voxels. Pre: the file has one.
[[nodiscard]] Result<VoxelVolume, ImportFailure> voxels_of(const ExerciseFile& file);
/// `where` of a FormatFailure begins with the file's name.
[[nodiscard]] Result<ExerciseFile, ExerciseFileFailure> read_exercise_file(const std::filesystem::path& path);

}  // namespace cusp::scenarios
