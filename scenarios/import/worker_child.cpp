// The child's side of worker.h.
#include <cstdio>
#include <fstream>
#include <new>

#include "scenarios/import/nrrd.h"
#include "scenarios/import/worker.h"
#include "scenarios/import/worker_words.h"

namespace cusp::scenarios {
namespace {

void say(const std::vector<std::string>& words) {
  const std::string line = worker_line(words);
  std::fwrite(line.data(), 1, line.size(), stdout);
  std::fflush(stdout);
}

/// Shares that differ by less than a hundredth are not worth a line.
class Teller {
 public:
  void operator()(double share) {
    if (share < last_ + 0.01 && share < 1.0) return;
    last_ = share;
    say({"progress", text_of(share)});
  }

 private:
  double last_ = -1.0;
};

int say_failure(const ImportFailure& f) {
  say({"fail", std::string(key_of(f.code)), f.where, f.detail});
  return 1;
}

int look(std::span<const std::string_view> a) {
  const std::filesystem::path preview = a[1];
  const std::vector<std::filesystem::path> files(a.begin() + 2, a.end());
  Teller tell;
  const auto seen = look_at_files(files, {}, std::ref(tell));
  if (!seen) return say_failure(seen.error());
  for (const MeshInfo& m : seen->meshes) say(words_of(m));
  if (!seen->image) return 0;
  say(words_of(*seen->image));
  const ImagePreview& p = seen->preview;
  if (p.value.empty()) return 0;
  std::ofstream out(preview, std::ios::binary);
  out.write(reinterpret_cast<const char*>(p.value.data()), static_cast<std::streamsize>(p.value.size() * sizeof(float)));
  out.close();
  if (!out) return say_failure({ImportError::io, preview.filename().string(), {}});
  say({"preview", text_of(p.size.x), text_of(p.size.y), text_of(p.size.z), text_of(p.spacing_mm.x), text_of(p.spacing_mm.y),
       text_of(p.spacing_mm.z)});
  return 0;
}

int child(std::span<const std::string_view> a) {
  if (a.size() >= 3 && a[0] == "look") return look(a);
  std::filesystem::path out;
  std::vector<ImportRemark> remarks;
  Teller tell;
  Result<VoxelVolume, ImportFailure> volume;
  if (const auto mesh = mesh_job(a, out)) volume = import_mesh(*mesh, std::ref(tell), &remarks);
  else if (const auto image = image_job(a, out)) volume = import_image(*image, std::ref(tell), &remarks);
  else return 2;
  if (!volume) return say_failure(volume.error());
  if (const auto r = write_nrrd(*volume, out); !r) return say_failure(r.error());
  for (const ImportRemark& remark : remarks) say(words_of(remark));
  return 0;
}

}  // namespace

std::optional<int> import_child_main(int argc, const char* const* argv) {
  if (argc < 2 || argv[1] != kWorkerVerb) return std::nullopt;
  const std::vector<std::string_view> arguments(argv + 2, argv + argc);
  try {
    return child(arguments);
  } catch (const std::bad_alloc&) {
    return say_failure({ImportError::out_of_memory, {}, {}});
  } catch (const std::exception& e) {
    return say_failure({ImportError::crashed, {}, e.what()});
  }
}

}  // namespace cusp::scenarios
