// Sends damaged files through the import's child and holds it to its promise: read or refused, within ten seconds and a
// gigabyte, and this program lives. `mutate [COUNT] [SEED] [assimp|dcmtk|niftilib] [SECONDS] [FOLDER]`: COUNT files for that
// library, or for each of the three; within SECONDS each, if given. FOLDER keeps a line for each file in LIBRARY.csv, with
// which a later call continues, and each file whose child crashed. Fails when a promise is broken, or
// when not all had their turn.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/import/child_process.h"
#include "scenarios/import/worker.h"
#include "tests/modules.h"
#include "tests/scenarios/import/image_files.h"
#include "tests/scenarios/import/packed_dicom.h"

namespace {

using namespace cusp;
using namespace cusp::test;
using Clock = std::chrono::steady_clock;

constexpr double kPromisedS = 10.0;
constexpr std::chrono::seconds kMost{8};  // of the ten: a busy machine needs the rest for the kill
constexpr std::size_t kMemory = std::size_t{1} << 30;

struct Seed {
  std::string library, ending, bytes;
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
  DicomWish rle = dicom, jpeg = dicom;
  rle.transfer = kRleLossless;
  rle.frame = rle_frame(dicom.values);
  jpeg.transfer = kJpegLossless;
  jpeg.frame = jpeg_lossless_frame(dicom.values, dicom.columns, dicom.rows);
  return {{"assimp", "stl", binary_stl(ball)},
          {"assimp", "stl", read_text(folder / "m.stl")},
          {"assimp", "obj", read_text(folder / "m.obj")},
          {"assimp", "ply", ply_file(ball, cusp::test::PlyData::binary)},
          {"assimp", "ply", ply_file(core, cusp::test::PlyData::text)},
          {"assimp", "3ds", three_ds_file({ball, core})},
          {"dcmtk", "dcm", dicom_file(dicom)},
          {"dcmtk", "dcm", dicom_file(rle)},
          {"dcmtk", "dcm", dicom_file(jpeg)},
          {"niftilib", "nii", nifti_file(nifti)},
          {"niftilib", "nii", nifti_file(turned)}};
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

/// What became of one file: of its one child, or of the worse of two.
struct Fate {
  std::uint64_t number = 0;
  std::string end;  // "stl read", "stl read, made", "stl corrupt", ...
  double wall_s = 0.0, cpu_s = 0.0;
  std::uint64_t resident_bytes = 0;

  bool has(const char* word) const { return end.find(word) != end.npos; }
  /// Ended by the clock while other programs had the processor: nothing is known of it, and it has its turn again.
  bool only_waited() const { return has("time_limit") && cpu_s < 1.0; }
};

struct Tally {
  std::map<std::string, std::size_t> ends;
  std::size_t files = 0, read = 0, crashed = 0, out_of_time = 0, waited = 0, late_by_clock = 0, broken = 0;
  double slowest_s = 0.0, most_cpu_s = 0.0;
  std::uint64_t most_bytes = 0;

  void add(const Fate& fate) {
    if (fate.only_waited()) {
      ++waited;
      return;
    }
    ++ends[fate.end];
    ++files;
    read += fate.has(" read");
    crashed += fate.has("crashed");
    out_of_time += fate.has("time_limit");
    late_by_clock += fate.wall_s > kPromisedS;
    slowest_s = std::max(slowest_s, fate.wall_s);
    most_cpu_s = std::max(most_cpu_s, fate.cpu_s);
    most_bytes = std::max(most_bytes, fate.resident_bytes);
    if (fate.cpu_s > kPromisedS || fate.resident_bytes > kMemory) {
      ++broken;
      std::fprintf(stderr, "file %llu: %.1f s, %.1f s of a processor, %llu MB\n", static_cast<unsigned long long>(fate.number),
                   fate.wall_s, fate.cpu_s, static_cast<unsigned long long>(fate.resident_bytes >> 20));
    }
  }
};

/// The lines of LIBRARY.csv: number,wall_s,cpu_s,resident_bytes,end. A broken last line is no line.
std::vector<Fate> fates_in(const std::filesystem::path& path) {
  std::vector<Fate> all;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    Fate fate;
    char comma = 0;
    if (words >> fate.number >> comma >> fate.wall_s >> comma >> fate.cpu_s >> comma >> fate.resident_bytes >> comma &&
        std::getline(words, fate.end) && !fate.end.empty())
      all.push_back(fate);
  }
  return all;
}

Fate one(const Seed& seed, std::uint64_t number, const TempFolder& folder, const std::filesystem::path& keep) {
  std::mt19937_64 random(number);
  const std::string name = std::to_string(number) + "." + seed.ending;
  // A folder of its own: the reader of a CT slice searches for its neighbours.
  const std::filesystem::path place = folder / std::to_string(number);
  std::filesystem::create_directory(place);
  write_text(place / name, mutated(seed.bytes, random));
  WorkerSettings settings;
  settings.memory_bytes = kMemory;
  settings.wall = kMost;
  settings.cpu = kMost;
  Fate fate;
  fate.number = number;
  settings.ended = [&](const ChildEnd& child) {
    fate.wall_s = std::max(fate.wall_s, child.wall_s);
    fate.cpu_s = std::max(fate.cpu_s, child.cpu_s);
    fate.resident_bytes = std::max(fate.resident_bytes, child.resident_bytes);
    if (child.how == ChildEnd::How::crashed)
      std::fprintf(stderr, "file %s: crashed, signal %d\n%s", name.c_str(), child.code, child.errors.c_str());
  };
  const auto seen = look_in_child({place / name}, settings);
  fate.end = seed.ending + " " + (seen ? "read" : std::string(key_of(seen.error().code)));
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
    fate.end += made ? ", made" : ", " + std::string(key_of(made.error().code));
  }
  if (!keep.empty() && fate.has("crashed"))
    std::filesystem::copy_file(place / name, keep / name, std::filesystem::copy_options::overwrite_existing);
  std::filesystem::remove_all(place);
  return fate;
}

/// False when a promise was broken or not all files had their turn.
bool run(const std::string& library, std::vector<Seed> seeds, std::uint64_t count, std::uint64_t first, double seconds,
         const TempFolder& folder, const std::filesystem::path& keep) {
  std::erase_if(seeds, [&](const Seed& s) { return s.library != library; });
  Tally tally;
  std::set<std::uint64_t> done;
  std::ofstream lines;
  if (!keep.empty()) {
    const std::filesystem::path path = keep / (library + ".csv");
    for (const Fate& fate : fates_in(path)) {
      if (fate.number >= first && fate.number - first < count && done.insert(fate.number).second) tally.add(fate);
    }
    lines.open(path, std::ios::app);
    if (!done.empty()) lines << '\n';  // a call that was killed may have left half a line
  }
  std::mutex lock;
  std::atomic<std::uint64_t> next{0};
  const auto start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  {
    std::vector<std::jthread> workers;
    for (unsigned n = 0; n < std::max(1u, std::thread::hardware_concurrency()); ++n)
      workers.emplace_back([&] {
        for (std::uint64_t i; passed() < seconds && (i = next.fetch_add(1)) < count;) {
          if (done.contains(first + i)) continue;
          const Fate fate = one(seeds[i % seeds.size()], first + i, folder, keep);
          const std::lock_guard hold(lock);
          tally.add(fate);
          if (lines.is_open() && !fate.only_waited())
            lines << fate.number << ',' << fate.wall_s << ',' << fate.cpu_s << ',' << fate.resident_bytes << ',' << fate.end << std::endl;
        }
      });
  }
  const double took = passed();
  for (const auto& [end, n] : tally.ends) std::printf("%7zu  %s\n", n, end.c_str());
  std::printf("%s: %zu of %llu files, %zu read, %zu refused (%zu crashes of the child, %zu at the limit on time; %zu only waited and "
              "have their turn again); one child at most %.2f s (%zu beyond ten), %.2f s of a processor, %llu MB resident; %.0f s, "
              "%.1f files a second\n",
              library.c_str(), tally.files, static_cast<unsigned long long>(count), tally.read, tally.files - tally.read,
              tally.crashed, tally.out_of_time, tally.waited, tally.slowest_s, tally.late_by_clock, tally.most_cpu_s,
              static_cast<unsigned long long>(tally.most_bytes >> 20), took,
              static_cast<double>(tally.files - done.size()) / took);
  std::fflush(stdout);
  return tally.broken == 0 && tally.files == count;
}

}  // namespace

int main(int argc, char** argv) {
  if (const auto status = import_child_main(argc, argv)) return *status;
  const std::uint64_t count = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 10000;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const std::string wanted = argc > 3 ? argv[3] : "";
  const double seconds = argc > 4 ? std::atof(argv[4]) : 1e9;
  const std::array<std::string, 3> libraries = {"assimp", "dcmtk", "niftilib"};
  const std::filesystem::path keep = argc > 5 ? argv[5] : "";
  if (count == 0 || !(seconds > 0.0) || (!wanted.empty() && std::ranges::find(libraries, wanted) == libraries.end())) return 2;
  const std::vector<Seed> all = seeds();
  const TempFolder folder;
  if (!keep.empty()) std::filesystem::create_directories(keep);
  bool good = true;
  for (const std::string& library : libraries) {
    if (wanted.empty() || wanted == library) good = run(library, all, count, first, seconds, folder, keep) && good;
  }
  return good ? 0 : 1;
}
