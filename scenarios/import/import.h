/// Closed triangle meshes (OBJ, STL, PLY, 3DS, OFF) to a specimen volume, and volumes of others (image.h) too. Foreign readers are not to be
/// trusted with foreign files: a program calls these through worker.h, in a process of their own.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/volume/voxel_volume.h"
#include "scenarios/import/image_volume.h"
#include "scenarios/import/import_error.h"
#include "scenarios/import/limits.h"
#include "scenarios/import/mesh_repair.h"
#include "scenarios/import/remarks.h"
#include "scenarios/import/up_axis.h"
#include "scenarios/modules.h"

namespace cusp::scenarios {

/// Which of several meshes wins where they overlap.
enum class PartPrecedence : std::uint8_t {
  innermost,  // by how they lie in each other (part_precedence.h)
  given,      // the first of MeshImport::tissues wins over all that follow
};
inline constexpr std::array<std::string_view, 2> kPrecedenceKeys = {"innermost", "given"};  // as typed

struct MeshImport {
  std::filesystem::path path;
  std::vector<std::filesystem::path> more;  // further files, for a kind that holds one mesh each (STL)
  double unit_mm = 1.0;  // length of one unit of the file, > 0
  /// Name of a mesh in the file, and what it is made of. Meshes that are not named are left out.
  std::vector<std::pair<std::string, Tissue>> tissues;
  PartPrecedence precedence = PartPrecedence::innermost;
  double voxel_mm = 0.1;
  UpAxis up = UpAxis::z;  // of the file's own axes, whatever its kind
  /// Mends what is open or wound wrongly (mesh_repair.h) and closes holes up to this width; none: such a mesh is refused.
  std::optional<double> mend_holes_mm;
  VolumeLimits limits;
};

/// One mesh of a file, for a preview before its tissue is chosen. Lengths in the file's own units and axes.
struct MeshInfo {
  std::string name;
  std::size_t triangles = 0;
  Vec3 low{0.0}, high{0.0};  // bounding box
  double volume = 0.0;       // enclosed, in cubic units; 0 unless closed and oriented
  bool closed = false;       // no edge has an odd number of triangles
  bool oriented = false;     // neighbours are wound alike
  std::vector<MeshGap> gaps;  // the widest kMaxGapsListed of them
  std::size_t gap_count = 0;
  Vec3 turned_at{0.0};       // where a closed mesh is not oriented
  double left_open = 0.0;    // width of the widest gap that joining near points leaves; 0: none
  friend bool operator==(const MeshInfo&, const MeshInfo&) = default;
};

inline constexpr std::size_t kMaxGapsListed = 8;

/// Units that files are made in, in millimetres, the most usual first.
inline constexpr std::array<double, 5> kUsualUnitsMm = {1.0, 10.0, 1000.0, 25.4, 0.001};
/// The first of them that makes this length (of the longest side, in the file's units) one of a tooth or a jaw, 4 to
/// 200 mm; a millimetre when none does.
double guessed_unit_mm(double longest) noexcept;

/// A volume of others: .nrrd, .mha, .mhd, .binvox, .nii, .nii.gz, .hdr, or a CT series of DICOM files.
struct ImageImport {
  std::filesystem::path path;
  ImageTissues tissues;
  VolumeLimits limits;
};

/// What a volume file holds, for a preview before its tissues are chosen.
struct ImageInfo {
  bool specimen = false;  // tissues with their solid fractions: nothing is to be chosen
  ImageKind kind = ImageKind::grey;
  IVec3 size{0};          // along the specimen's axes
  Vec3 spacing_mm{1.0};
  bool spacing_known = true;
  double turned_degrees = 0.0;
  double low = 0.0, high = 0.0;  // least and most value
  std::vector<std::pair<std::uint32_t, std::size_t>> values;  // labels and colours but 0, and their voxels: most first, 64 at most
  std::size_t series = 0, slices = 0;  // of a CT
  friend bool operator==(const ImageInfo&, const ImageInfo&) = default;
};
/// A part of its voxels, no axis above kPreviewEdge: the nearest ones, so that a threshold means the same.
struct ImagePreview {
  IVec3 size{0};
  Vec3 spacing_mm{1.0};
  std::vector<float> value;  // [z][y][x]
};
inline constexpr int kPreviewEdge = 160;

/// What a file holds: meshes, or a volume.
struct FileLook {
  std::vector<MeshInfo> meshes;
  std::optional<ImageInfo> image;
  ImagePreview preview;  // of labels, colours and grey values
};

enum class FileKind : std::uint8_t { mesh, image, unknown };
/// By its ending, else by its first bytes; a folder is a CT series.
FileKind file_kind(const std::filesystem::path& path);
/// Whether they are DICOM files of one folder: the series of the first is read from there.
bool are_slices_of_a_folder(const std::vector<std::filesystem::path>& files);
/// Meshes in the order in which the files name them; parts of one name are one mesh. Of several files a mesh is called as
/// its file without the ending, and, where it is not alone in it, ": " and its own name. Names are UTF-8 (utf8_name).
[[nodiscard]] Result<std::vector<MeshInfo>, ImportFailure> list_meshes(const std::filesystem::path& path,
                                                                       const std::vector<std::filesystem::path>& more = {});

/// Reads, checks and voxelises. The file's coordinates times unit_mm are the specimen's; s is the exact distance to the
/// triangles within the band, padded by four voxels. Each mesh must be closed and wound alike (all inside out is
/// turned, with a remark). Not for the haptic thread: seconds.
[[nodiscard]] Result<VoxelVolume, ImportFailure> import_mesh(const MeshImport& what, const ImportProgress& progress = {},
                                                             std::vector<ImportRemark>* remarks = nullptr);

/// A volume file as a specimen (file_look.cpp).
[[nodiscard]] Result<VoxelVolume, ImportFailure> import_image(const ImageImport& what, const ImportProgress& progress = {},
                                                              std::vector<ImportRemark>* remarks = nullptr);

/// Meshes, or one volume, whichever it is (file_look.cpp). Several files must all be meshes, or slices of one CT series.
[[nodiscard]] Result<FileLook, ImportFailure> look_at_files(const std::vector<std::filesystem::path>& files,
                                                            const VolumeLimits& limits = {},
                                                            const ImportProgress& progress = {});

}  // namespace cusp::scenarios
