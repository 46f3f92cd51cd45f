// Sends damaged files through the import's child and holds it to its promise: read or refused, within ten seconds and a
// gigabyte, and this program lives. `mutate [COUNT] [SEED] [KIND]`; kinds: stl obj ply 3ds nii dcm (all in turn).
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/import/child_process.h"
#include "scenarios/import/worker.h"
#include "tests/scenarios/import/image_files.h"

namespace {

using namespace cusp;
using namespace cusp::testing;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kMost{8};  // of the ten: a busy machine needs the rest for the kill
constexpr std::size_t kMemory = std::size_t{1} << 30;

struct Seed {
  std::string ending, bytes;
};

std::vector<Seed> seeds() {
  const Mesh ball = sphere("ball", {0, 0, 0}, 2.0, 2), core = sphere("core", {0, 0, 0}, 1.0, 1);
  const TempFolder folder;
  write_obj(folder / "m.obj", {ball, core});
  write_stl(folder / "m.stl", core);
  NiftiWish nifti;
  nifti.size = {12, 10, 8};
  nifti.values = values_of(nifti.size, [](IVec3 v) { return (v.x - 6) * (v.x - 6) + (v.y - 5) * (v.y - 5) + (v.z - 4) * (v.z - 4) < 12 ? 3 : 0; });
  NiftiWish turned = nifti;
  turned.affine = {-0.1f, 0, 0, 5, 0, -0.1f, 0, 6, 0, 0, 0.3f, 7};
  turned.slope = 2.0f;
  DicomWish dicom;
  dicom.columns = 16;
  dicom.rows = 12;
  dicom.values = values_of({16, 12, 1}, [](IVec3 v) { return v.x * 100; });
  return {{"stl", binary_stl(ball)},
          {"stl", read_text(folder / "m.stl")},
          {"obj", read_text(folder / "m.obj")},
          {"ply", ply_file(ball, true)},
          {"ply", ply_file(core, false)},
          {"3ds", three_ds_file({ball, core})},
          {"nii", nifti_file(nifti)},
          {"nii", nifti_file(turned)},
          {"dcm", dicom_file(dicom)}};
}

/// One to four wounds, more often one: bytes turned, numbers made extreme, pieces cut, doubled or moved; the head is hit more often than its share.
std::string mutated(std::string bytes, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return n == 0 ? std::size_t{0} : static_cast<std::size_t>(random() % n); };
  const auto place = [&] { return random() % 3 == 0 ? below(std::min<std::size_t>(bytes.size(), 512)) : below(bytes.size()); };
  static constexpr std::array<std::uint32_t, 8> extreme = {0, 0xffffffff, 0x7fffffff, 0x80000000, 1, 0xffff, 0x7f800000, 0x10000};
  for (std::size_t n = 1 + below(1 + below(4)); n > 0 && !bytes.empty(); --n) {
    const std::size_t at = place();
    switch (random() % 7) {
      case 0: bytes[at] = static_cast<char>(random()); break;
      case 1: bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8))); break;
      case 2: {
        const std::uint32_t v = extreme[below(extreme.size())];
        for (std::size_t i = 0; i < 4 && at + i < bytes.size(); ++i) bytes[at + i] = static_cast<char>(v >> (8 * i));
        break;
      }
      case 3: bytes.erase(at, 1 + below(64)); break;
      case 4: bytes.insert(at, bytes.substr(below(bytes.size()), 1 + below(64))); break;
      case 5: bytes.resize(1 + below(bytes.size())); break;
      default: {
        static constexpr const char* words[] = {"-1", "999999999999", "nan", "inf", "1e308", "\n", " ", "/", "%n", "0x"};
        bytes.replace(at, std::min<std::size_t>(bytes.size() - at, 1 + below(4)), words[below(10)]);
      }
    }
  }
  return bytes;
}

struct Tally {
  std::mutex lock;
  std::map<std::string, std::size_t> ends;  // "stl read", "stl corrupt", ...
  double slowest_s = 0.0;
  std::size_t broken = 0;
};

void one(const Seed& seed, std::uint64_t number, const TempFolder& folder, Tally& tally) {
  std::mt19937_64 random(number);
  const std::string name = std::to_string(number) + "." + seed.ending;
  // A folder of its own: a slice of a CT looks for its neighbours.
  const std::filesystem::path place = folder / std::to_string(number);
  std::filesystem::create_directory(place);
  write_text(place / name, mutated(seed.bytes, random));
  WorkerSettings settings;
  settings.memory_bytes = kMemory;
  settings.wall = kMost;
  settings.cpu = kMost;
  const auto start = Clock::now();
  const auto seen = look_in_child({place / name}, settings);
  std::string end = seen ? "read" : std::string(key_of(seen.error().code));
  // What was read is made into a specimen too, for that is where its numbers are used.
  if (seen && random() % 4 == 0) {
    Result<VoxelVolume, ImportFailure> made = fail(ImportError::cancelled, {});
    if (seen->image) {
      ImageImport what;
      what.path = place / name;
      what.tissues.thresholds = {{1.0, Tissue::dentine}};
      made = import_image_in_child(what, settings);
    } else {
      MeshImport what;
      what.path = place / name;
      what.mend_holes_mm = 1.0;
      what.tissues = {{seen->meshes.front().name, Tissue::dentine}};
      made = import_mesh_in_child(what, settings);
    }
    end += made ? ", made" : ", " + std::string(key_of(made.error().code));
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  std::filesystem::remove_all(place);
  const std::lock_guard hold(tally.lock);
  ++tally.ends[seed.ending + " " + end];
  tally.slowest_s = std::max(tally.slowest_s, seconds);
  // Two children, each with its time and two seconds for the kill.
  if (seconds > 2.0 * static_cast<double>(kMost.count() + 2)) {
    ++tally.broken;
    std::fprintf(stderr, "file %llu took %.1f s\n", static_cast<unsigned long long>(number), seconds);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto status = import_child_main(argc, argv)) return *status;
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  std::vector<Seed> all = seeds();
  if (argc > 3) std::erase_if(all, [&](const Seed& s) { return s.ending != argv[3]; });
  if (all.empty() || count == 0) return 2;
  const TempFolder folder;
  Tally tally;
  std::atomic<std::uint64_t> next{0};
  {
    std::vector<std::jthread> workers;
    for (unsigned n = 0; n < std::max(1u, std::thread::hardware_concurrency()); ++n)
      workers.emplace_back([&] {
        for (std::uint64_t i; (i = next.fetch_add(1)) < count;) one(all[i % all.size()], first + i, folder, tally);
      });
  }
  for (const auto& [end, n] : tally.ends) std::printf("%7zu  %s\n", n, end.c_str());
  rusage children{};
  getrusage(RUSAGE_CHILDREN, &children);
  std::printf("%llu files; slowest %.2f s; largest child %ld MB resident\n", static_cast<unsigned long long>(count), tally.slowest_s,
              children.ru_maxrss / 1024);
  return tally.broken == 0 ? 0 : 1;
}
