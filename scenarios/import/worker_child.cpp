// The child's side of worker.h.
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <new>
#include <system_error>

#include "scenarios/import/nrrd.h"
#include "scenarios/import/worker.h"
#include "scenarios/import/worker_messages.h"

namespace cusp::scenarios {
namespace {

void send(const std::vector<std::string>& fields) {
  const std::string line = message_line(fields);
  std::fwrite(line.data(), 1, line.size(), stdout);
  std::fflush(stdout);
}

/// Sends a progress message for each hundredth.
class ProgressReporter {
 public:
  void operator()(double share) {
    if (share < last_ + 0.01 && share < 1.0) return;
    last_ = share;
    send({"progress", text_of(share)});
  }

 private:
  double last_ = -1.0;
};

int send_failure(const ImportFailure& f) {
  send({"fail", std::string(key_of(f.code)), f.where, f.detail});
  return 1;
}

int look(std::span<const std::string_view> a) {
  const std::filesystem::path preview = a[1];
  const std::vector<std::filesystem::path> files(a.begin() + 2, a.end());
  ProgressReporter report;
  const auto seen = look_at_files(files, {}, std::ref(report));
  if (!seen) return send_failure(seen.error());
  for (const MeshInfo& m : seen->meshes) send(message_of(m));
  if (!seen->image) return 0;
  send(message_of(*seen->image));
  const ImagePreview& p = seen->preview;
  if (p.value.empty()) return 0;
  errno = 0;
  std::ofstream out(preview, std::ios::binary);
  out.write(reinterpret_cast<const char*>(p.value.data()), static_cast<std::streamsize>(p.value.size() * sizeof(float)));
  out.close();
  if (!out) return send_failure({ImportError::io, preview.filename().string(), std::generic_category().message(errno)});
  send({"preview", text_of(p.size.x), text_of(p.size.y), text_of(p.size.z), text_of(p.spacing_mm.x), text_of(p.spacing_mm.y),
       text_of(p.spacing_mm.z)});
  return 0;
}

int child(std::span<const std::string_view> a) {
  if (a.size() >= 3 && a[0] == "look") return look(a);
  std::filesystem::path out;
  std::vector<ImportRemark> remarks;
  ProgressReporter report;
  Result<VoxelVolume, ImportFailure> volume;
  if (const auto mesh = mesh_job(a, out)) volume = import_mesh(*mesh, std::ref(report), &remarks);
  else if (const auto image = image_job(a, out)) volume = import_image(*image, std::ref(report), &remarks);
  else return 2;
  if (!volume) return send_failure(volume.error());
  if (const auto r = write_nrrd(*volume, out); !r) return send_failure(r.error());
  for (const ImportRemark& remark : remarks) send(message_of(remark));
  return 0;
}

}  // namespace

std::optional<int> import_child_main(int argc, const char* const* argv) {
  if (argc < 2 || argv[1] != kWorkerVerb) return std::nullopt;
  const std::vector<std::string_view> arguments(argv + 2, argv + argc);
  try {
    return child(arguments);
  } catch (const std::bad_alloc&) {
    return send_failure({ImportError::out_of_memory, {}, {}});
  } catch (const std::exception& e) {
    return send_failure({ImportError::crashed, {}, e.what()});
  }
}

}  // namespace cusp::scenarios
