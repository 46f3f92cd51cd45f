// Stubs for CUSP_IMPORT=OFF: the page reports of every file that this build cannot read it.
#include "scenarios/import/worker.h"
#include "ui/modules.h"

namespace cusp::ui {
namespace {

std::unexpected<ImportFailure> absent(const std::filesystem::path& file) { return fail(ImportError::not_started, file.filename().string()); }

}  // namespace

FileKind file_kind(const std::filesystem::path&) { return FileKind::unknown; }
double guessed_unit_mm(double) noexcept { return 1.0; }

Result<FileLook, ImportFailure> look_in_child(const std::vector<std::filesystem::path>& files, const WorkerSettings&,
                                              const ImportProgress&, std::stop_token) {
  return absent(files.front());
}
Result<VoxelVolume, ImportFailure> import_mesh_in_child(const MeshImport& what, const WorkerSettings&, const ImportProgress&,
                                                        std::stop_token, std::vector<ImportRemark>*) {
  return absent(what.path);
}
Result<VoxelVolume, ImportFailure> import_image_in_child(const ImageImport& what, const WorkerSettings&, const ImportProgress&,
                                                         std::stop_token, std::vector<ImportRemark>*) {
  return absent(what.path);
}

}  // namespace cusp::ui
