// The parent's side of worker.h.
#include "scenarios/import/worker.h"

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "engine/base/ids.h"
#include "scenarios/import/child_process.h"
#include "scenarios/import/limit_figures.h"
#include "scenarios/import/nrrd.h"
#include "scenarios/import/worker_messages.h"

namespace cusp::scenarios {
namespace {

constexpr std::string_view kFolderName = "cusp-import-";
/// No import lasts so long.
constexpr std::chrono::hours kLeftBehind{24};

/// Removes folders of programs that were killed: a patient's volume may lie there.
void remove_left_behind(const std::filesystem::path& parent) {
  std::error_code ec;
  const auto earliest = std::filesystem::file_time_type::clock::now() - kLeftBehind;
  for (std::filesystem::directory_iterator entry(parent, ec), end; !ec && entry != end; entry.increment(ec)) {
    std::error_code unknown;
    const bool folder = entry->path().filename().string().starts_with(kFolderName) && entry->symlink_status(unknown).type() == std::filesystem::file_type::directory;
    const auto written = entry->last_write_time(unknown);
    if (folder && !unknown && written < earliest) std::filesystem::remove_all(entry->path(), unknown);
  }
}

/// A folder of this import, removed with it.
class PrivateFolder {
 public:
  PrivateFolder() {
    parent_ = std::filesystem::temp_directory_path(ec_);
    if (ec_) return;
    remove_left_behind(parent_);
    const auto path = parent_ / (std::string(kFolderName) + Uuid::v7().text());
    if (!std::filesystem::create_directory(path, ec_) || ec_) return;
    path_ = path;
    std::error_code ignored;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all, ignored);
  }
  ~PrivateFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const noexcept { return path_; }
  /// Why there is none.
  ImportFailure failure() const { return {ImportError::io, parent_.empty() ? "TMPDIR" : parent_.string(), ec_.message()}; }
  /// A file that the child could not write here is named by the folder above: nobody knows the file.
  ImportFailure named(ImportFailure f, const std::filesystem::path& file) const {
    if (f.code == ImportError::io && f.where == file.filename().string()) f.where = parent_.string();
    return f;
  }

 private:
  std::filesystem::path parent_, path_;
  std::error_code ec_;
};

struct Received {
  std::optional<ImportFailure> failure;
  FileLook look;  // the preview without its values
  std::vector<ImportRemark> remarks;
  bool garbled = false;
};

/// Sizes of a preview that this program would have made.
bool preview_of(const std::vector<std::string>& w, ImagePreview& out) {
  if (w.size() != 7) return false;
  for (int i = 0; i < 3; ++i) {
    const auto n = number_of<int>(w[static_cast<std::size_t>(i) + 1]);
    const auto mm = number_of<double>(w[static_cast<std::size_t>(i) + 4]);
    if (!n || *n < 1 || *n > kPreviewEdge || !mm || !(*mm > 0.0)) return false;
    out.size[i] = *n;
    out.spacing_mm[i] = *mm;
  }
  return true;
}

void receive(std::string_view line, Received& received, const ImportProgress& progress) {
  const auto fields = fields_of_line(line);
  if (!fields) return;
  const std::vector<std::string>& w = *fields;
  if (w[0] == "progress" && w.size() == 2) {
    if (const auto share = number_of<double>(w[1]); share && progress) progress(*share);
  } else if (w[0] == "fail" && w.size() == 4) {
    if (const auto code = import_error_from_key(w[1])) received.failure = ImportFailure{*code, w[2], w[3]};
    else received.garbled = true;
  } else if (auto m = mesh_info_of(w)) {
    received.look.meshes.push_back(std::move(*m));
  } else if (auto image = image_info_of(w)) {
    received.look.image = std::move(*image);
  } else if (auto remark = remark_of(w)) {
    received.remarks.push_back(std::move(*remark));
  } else if (w[0] != "preview" || !preview_of(w, received.look.preview)) {
    received.garbled = true;
  }
}

Result<Received, ImportFailure> run(const std::filesystem::path& file, std::vector<std::string> arguments,
                                 const WorkerSettings& settings, const ImportProgress& progress, std::stop_token stop) {
  std::vector<std::string> argv = settings.program;
  if (argv.empty()) argv = {own_program(), std::string(kWorkerVerb)};
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  Received received;
  const ChildEnd end =
      run_child(argv, {settings.memory_bytes, settings.cpu, settings.wall},
                [&](std::string_view line) { receive(line, received, progress); }, stop);
  if (settings.ended) settings.ended(end);
  const std::string where = file.filename().string();
  switch (end.how) {
    case ChildEnd::How::not_started: return fail(ImportError::not_started, where, end.errors);
    case ChildEnd::How::stopped: return fail(ImportError::cancelled, where);
    case ChildEnd::How::cpu_limit:
      return fail(ImportError::time_limit, where, text_of({LimitKind::processor, 0.0, static_cast<double>(settings.cpu.count())}) + "\n" + end.errors);
    case ChildEnd::How::wall_limit:
      return fail(ImportError::time_limit, where,
                  text_of({LimitKind::wall, 0.0, std::chrono::duration<double>(settings.wall).count()}) + "\n" + end.errors);
    case ChildEnd::How::crashed:
      return fail(ImportError::crashed, where, "signal " + std::to_string(end.code) + "\n" + end.errors);
    case ChildEnd::How::exited: break;
  }
  if (received.failure) {
    if (received.failure->code == ImportError::out_of_memory) {
      received.failure->where = where;
      received.failure->detail = text_of({LimitKind::memory, 0.0, static_cast<double>(settings.memory_bytes)});
    }
    return std::unexpected(*received.failure);
  }
  if (end.code != 0 || received.garbled)
    return fail(ImportError::crashed, where, "status " + std::to_string(end.code) + "\n" + end.errors);
  return received;
}

/// The same for both kinds of import: a child that leaves a volume.
template <class Job>
Result<VoxelVolume, ImportFailure> volume_from_child(const Job& what, const WorkerSettings& settings, const ImportProgress& progress,
                                                     std::stop_token stop, std::vector<ImportRemark>* remarks) {
  const std::string where = what.path.filename().string();
  const PrivateFolder folder;
  if (folder.path().empty()) return std::unexpected(folder.failure());
  const std::filesystem::path out = folder.path() / (folder.path().filename().string() + ".nrrd");  // no user's file has its name
  auto received = run(what.path, arguments_of(what, out), settings, progress, stop);
  if (!received) return std::unexpected(folder.named(received.error(), out));
  auto volume = read_nrrd(out, what.limits);
  // What the child wrote is at fault here, not the user's file: it is no more than a crash of the child.
  if (!volume) return fail(ImportError::crashed, where, std::string(key_of(volume.error().code)));
  if (remarks) *remarks = std::move(received->remarks);
  return volume;
}

}  // namespace

Result<VoxelVolume, ImportFailure> import_mesh_in_child(const MeshImport& what, const WorkerSettings& settings,
                                                        const ImportProgress& progress, std::stop_token stop,
                                                        std::vector<ImportRemark>* remarks) {
  return volume_from_child(what, settings, progress, stop, remarks);
}

Result<VoxelVolume, ImportFailure> import_image_in_child(const ImageImport& what, const WorkerSettings& settings,
                                                         const ImportProgress& progress, std::stop_token stop,
                                                         std::vector<ImportRemark>* remarks) {
  return volume_from_child(what, settings, progress, stop, remarks);
}

Result<FileLook, ImportFailure> look_in_child(const std::vector<std::filesystem::path>& files, const WorkerSettings& settings,
                                              const ImportProgress& progress, std::stop_token stop) {
  if (files.empty()) return fail(ImportError::missing_file, {});
  const std::filesystem::path& path = files.front();
  const std::string where = path.filename().string();
  const PrivateFolder folder;
  if (folder.path().empty()) return std::unexpected(folder.failure());
  const std::filesystem::path preview = folder.path() / (folder.path().filename().string() + ".preview");
  std::vector<std::string> arguments = {"look", preview.string()};
  for (const std::filesystem::path& file : files) arguments.push_back(std::filesystem::absolute(file).string());
  auto received = run(path, std::move(arguments), settings, progress, stop);
  if (!received) return std::unexpected(folder.named(received.error(), preview));
  ImagePreview& p = received->look.preview;
  if (p.size.x > 0) {
    p.value.resize(static_cast<std::size_t>(p.size.x) * static_cast<std::size_t>(p.size.y) * static_cast<std::size_t>(p.size.z));
    std::ifstream in(preview, std::ios::binary);
    in.read(reinterpret_cast<char*>(p.value.data()), static_cast<std::streamsize>(p.value.size() * sizeof(float)));
    if (!in) return fail(ImportError::crashed, where, "preview");
    for (float& v : p.value)
      if (!std::isfinite(v)) v = 0.0f;
  }
  if (received->look.meshes.empty() && !received->look.image) return fail(ImportError::crashed, where, "no message");
  return std::move(received->look);
}

}  // namespace cusp::scenarios
