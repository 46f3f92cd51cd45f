#include "scenarios/import/worker.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <new>
#include <span>
#include <string_view>

#include "engine/base/ids.h"
#include "scenarios/import/child_process.h"
#include "scenarios/import/nrrd.h"

namespace cusp {
namespace {

// Parent to child: the verb, then `mesh` or `list` and plain arguments. Child to parent, on its standard output: lines
// of this mark and words parted by tabs; what foreign libraries print there besides is not for us.
constexpr std::string_view kVerb = "import-child";
constexpr std::string_view kMark = "cusp-import\t";

template <class Number>
std::string text_of(Number value) {
  char buffer[40];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}
template <class Number>
std::optional<Number> number_of(std::string_view t) {
  Number value{};
  const auto [end, error] = std::from_chars(t.data(), t.data() + t.size(), value);
  if (error != std::errc{} || end != t.data() + t.size()) return std::nullopt;
  return value;
}

std::string escaped(std::string_view t) {
  std::string out;
  for (const char c : t) {
    if (c == '\\') out += "\\\\";
    else if (c == '\n') out += "\\n";
    else if (c == '\t') out += "\\t";
    else out += c;
  }
  return out;
}

std::vector<std::string> words_of(std::string_view t) {
  std::vector<std::string> out(1);
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t[i] == '\t') {
      out.emplace_back();
    } else if (t[i] == '\\' && i + 1 < t.size()) {
      ++i;
      out.back() += t[i] == 'n' ? '\n' : t[i] == 't' ? '\t' : t[i];
    } else {
      out.back() += t[i];
    }
  }
  return out;
}

void say(std::initializer_list<std::string> words) {
  std::string line(kMark);
  bool first = true;
  for (const std::string& w : words) {
    if (!first) line += '\t';
    line += escaped(w);
    first = false;
  }
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stdout);
  std::fflush(stdout);
}

// ---- the child's side

int say_failure(const ImportFailure& f) {
  say({"fail", std::string(key_of(f.code)), f.where, f.detail});
  return 1;
}

std::optional<MeshImport> job_of(std::span<const std::string_view> a, std::filesystem::path& out) {
  // mesh FILE UNIT VOXEL UP MAX_EDGE MAX_VOXELS MIN_VOXEL MAX_VOXEL OUT (NAME CODE)...
  if (a.size() < 10 || a.size() % 2 != 0) return std::nullopt;
  MeshImport job;
  job.path = a[1];
  const auto unit = number_of<double>(a[2]), voxel = number_of<double>(a[3]);
  const auto up = number_of<unsigned>(a[4]);
  const auto edge = number_of<int>(a[5]);
  const auto voxels = number_of<std::size_t>(a[6]);
  const auto least = number_of<double>(a[7]), most = number_of<double>(a[8]);
  if (!least || !most || !unit || !voxel || !up || *up >= kUpAxisKeys.size() || !edge || !voxels) return std::nullopt;
  job.unit_mm = *unit;
  job.voxel_mm = *voxel;
  job.up = static_cast<UpAxis>(*up);
  job.limits.max_edge_voxels = *edge;
  job.limits.max_voxels = *voxels;
  job.limits.min_voxel_mm = *least;
  job.limits.max_voxel_mm = *most;
  out = a[9];
  for (std::size_t i = 10; i < a.size(); i += 2) {
    const auto code = number_of<unsigned>(a[i + 1]);
    if (!code || *code >= kTissueCodes) return std::nullopt;
    job.tissues.emplace_back(a[i], static_cast<Tissue>(*code));
  }
  return job;
}

int child(std::span<const std::string_view> a) {
  if (a.size() == 2 && a[0] == "list") {
    const auto meshes = list_meshes(a[1]);
    if (!meshes) return say_failure(meshes.error());
    for (const MeshInfo& m : *meshes) {
      say({"mesh", m.name, text_of(m.triangles), text_of(m.low.x), text_of(m.low.y), text_of(m.low.z),
           text_of(m.high.x), text_of(m.high.y), text_of(m.high.z), text_of(m.volume), m.closed ? "1" : "0",
           m.oriented ? "1" : "0"});
    }
    return 0;
  }
  std::filesystem::path out;
  if (a.empty() || a[0] != "mesh") return 2;
  const auto job = job_of(a, out);
  if (!job) return 2;
  const auto volume = import_mesh(*job, [](double share) { say({"progress", text_of(share)}); });
  if (!volume) return say_failure(volume.error());
  if (const auto r = write_nrrd(*volume, out); !r) return say_failure(r.error());
  return 0;
}

// ---- the parent's side

/// A folder of this import's own, gone with it.
class PrivateFolder {
 public:
  PrivateFolder() {
    std::error_code ec;
    const auto parent = std::filesystem::temp_directory_path(ec);
    if (ec) return;
    const auto path = parent / ("cusp-import-" + Uuid::v7().text());
    if (!std::filesystem::create_directory(path, ec) || ec) return;
    path_ = path;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all, ec);
  }
  ~PrivateFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;
  const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

struct Heard {
  std::optional<ImportFailure> failure;
  std::vector<MeshInfo> meshes;
  bool garbled = false;
};

std::optional<MeshInfo> mesh_info_of(const std::vector<std::string>& w) {
  if (w.size() != 12) return std::nullopt;
  MeshInfo m;
  m.name = w[1];
  const auto triangles = number_of<std::size_t>(w[2]);
  if (!triangles) return std::nullopt;
  m.triangles = *triangles;
  std::array<double, 7> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto n = number_of<double>(w[3 + i]);
    if (!n) return std::nullopt;
    numbers[i] = *n;
  }
  m.low = {numbers[0], numbers[1], numbers[2]};
  m.high = {numbers[3], numbers[4], numbers[5]};
  m.volume = numbers[6];
  m.closed = w[10] == "1";
  m.oriented = w[11] == "1";
  return m;
}

void hear(std::string_view line, Heard& heard, const ImportProgress& progress) {
  if (!line.starts_with(kMark)) return;
  const auto w = words_of(line.substr(kMark.size()));
  if (w[0] == "progress" && w.size() == 2) {
    if (const auto share = number_of<double>(w[1]); share && progress) progress(*share);
  } else if (w[0] == "fail" && w.size() == 4) {
    if (const auto code = import_error_from_key(w[1])) heard.failure = ImportFailure{*code, w[2], w[3]};
    else heard.garbled = true;
  } else if (auto m = w[0] == "mesh" ? mesh_info_of(w) : std::nullopt) {
    heard.meshes.push_back(std::move(*m));
  } else {
    heard.garbled = true;
  }
}

Result<Heard, ImportFailure> run(const std::filesystem::path& file, std::vector<std::string> arguments,
                                 const WorkerSettings& settings, const ImportProgress& progress, std::stop_token stop) {
  std::vector<std::string> argv = settings.program;
  if (argv.empty()) argv = {own_program(), std::string(kVerb)};
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  Heard heard;
  const ChildEnd end =
      run_child(argv, {settings.memory_bytes, settings.cpu, settings.wall},
                [&](std::string_view line) { hear(line, heard, progress); }, stop);
  const std::string where = file.filename().string();
  switch (end.how) {
    case ChildEnd::How::not_started: return fail(ImportError::not_started, where, end.errors);
    case ChildEnd::How::stopped: return fail(ImportError::cancelled, where);
    case ChildEnd::How::cpu_limit:
    case ChildEnd::How::wall_limit: return fail(ImportError::time_limit, where, end.errors);
    case ChildEnd::How::crashed:
      return fail(ImportError::crashed, where, "signal " + std::to_string(end.code) + "\n" + end.errors);
    case ChildEnd::How::exited: break;
  }
  if (heard.failure) return std::unexpected(*heard.failure);
  if (end.code != 0 || heard.garbled)
    return fail(ImportError::crashed, where, "status " + std::to_string(end.code) + "\n" + end.errors);
  return heard;
}

}  // namespace

std::optional<int> import_child_main(int argc, const char* const* argv) {
  if (argc < 2 || argv[1] != kVerb) return std::nullopt;
  const std::vector<std::string_view> arguments(argv + 2, argv + argc);
  try {
    return child(arguments);
  } catch (const std::bad_alloc&) {
    return say_failure({ImportError::out_of_memory, {}, {}});
  } catch (const std::exception& e) {
    return say_failure({ImportError::crashed, {}, e.what()});
  }
}

Result<VoxelVolume, ImportFailure> import_mesh_in_child(const MeshImport& what, const WorkerSettings& settings,
                                                        const ImportProgress& progress, std::stop_token stop) {
  const std::string where = what.path.filename().string();
  const PrivateFolder folder;
  if (folder.path().empty()) return fail(ImportError::io, where, "no temporary folder");
  const std::filesystem::path out = folder.path() / "volume.nrrd";
  std::vector<std::string> arguments = {"mesh",
                                        std::filesystem::absolute(what.path).string(),
                                        text_of(what.unit_mm),
                                        text_of(what.voxel_mm),
                                        text_of(static_cast<unsigned>(what.up)),
                                        text_of(what.limits.max_edge_voxels),
                                        text_of(what.limits.max_voxels),
                                        text_of(what.limits.min_voxel_mm),
                                        text_of(what.limits.max_voxel_mm),
                                        out.string()};
  for (const auto& [name, tissue] : what.tissues) {
    arguments.push_back(name);
    arguments.push_back(text_of(static_cast<unsigned>(tissue)));
  }
  if (const auto heard = run(what.path, std::move(arguments), settings, progress, stop); !heard)
    return std::unexpected(heard.error());
  auto volume = read_nrrd(out, what.limits);
  // What the child wrote is at fault here, not the user's file: it is no more than a crash of the child.
  if (!volume) return fail(ImportError::crashed, where, std::string(key_of(volume.error().code)));
  return volume;
}

Result<std::vector<MeshInfo>, ImportFailure> list_meshes_in_child(const std::filesystem::path& path,
                                                                  const WorkerSettings& settings,
                                                                  std::stop_token stop) {
  auto heard = run(path, {"list", std::filesystem::absolute(path).string()}, settings, {}, stop);
  if (!heard) return std::unexpected(heard.error());
  return std::move(heard->meshes);
}

}  // namespace cusp
