"""The faults: each is one change of the sources that a test of the default ./check must answer with a failure.

preset, target, test: what ./check builds and runs; test names its CTest entry, None: the compiler itself must refuse.
expected: a regular expression of the failure, so that a test which fails for another reason does not count.
edits: (file, text to find, text to put); the text stands in the file exactly once.
"""
from dataclasses import dataclass


@dataclass(frozen=True)
class Fault:
    name: str
    preset: str
    target: str
    test: str | None
    expected: str
    edits: tuple


def fault(name, preset, test, expected, *edits, target=None):
    return Fault(name, preset, target or test, test, expected, edits)


MEMORY = r"ERROR: AddressSanitizer|runtime error: "
RACE = r"WARNING: ThreadSanitizer: data race"
TICK = "engine/loop/tick.cpp"
STEPS = "  output_ = step(state_, input);\n"

FAULTS = [
    # The tick.
    fault("heap in the tick", "release", "no_heap_no_lock", r"counts\.allocations",
          (TICK, STEPS, "  static std::vector<StepInput> planted;\n  planted.push_back(input);\n" + STEPS)),
    fault("heap in a rival's contact", "release", "no_heap_no_lock", r"counts\.allocations",
          ("engine/contact/methods/penalty.cpp", "  std::array<double, kTissueCodes> of{};", "  std::vector<double> of = std::vector<double>(kTissueCodes);")),
    fault("lock in the tick", "release", "no_heap_no_lock", r"counts\.locks",
          (TICK, "#include <utility>\n", "#include <mutex>\n#include <utility>\n"),
          (TICK, STEPS, "  static std::mutex planted;\n  const std::lock_guard hold(planted);\n" + STEPS)),
    fault("contact's normal turned round", "release", "step_tests", r": Failure$",
          ("engine/contact/surface_gather.cpp", "  out.normal = Vec3(feature->normal);\n", "  out.normal = -Vec3(feature->normal);\n")),
    fault("contact's normal off by three degrees", "release", "step_tests", r"angle / kTicks",
          ("engine/contact/surface_gather.cpp", "  out.normal = Vec3(feature->normal);\n",
           "  out.normal = Vec3(feature->normal);\n  out.normal += 0.05 * glm::cross(out.normal, Vec3(0.36, 0.48, 0.8));\n")),
    fault("force capped half too high", "release", "step_tests", r"FAILED  \] Guard\.force_rises_no_faster_than_the_slew",
          ("engine/step/guard.cpp", "    given = settings.limit_n;\n", "    given = 1.5 * settings.limit_n;\n")),
    fault("field left out of the state's list", "release", "golden_hash_tests", r"Failure",
          ("engine/step/state_fields.h", '  f("guard.stale_ms", stale_ms);\n', "")),
    fault("member missing in the state's list", "release", None, r"names? provided for structured binding|decomposes into",
          ("engine/step/guard.h", "  PassivityState passivity;\n};", "  PassivityState passivity;\n  double planted = 0.0;\n};"),
          target="golden_hash_tests"),

    # Threads.
    fault("plain variable between tick and screen", "tsan", "haptic_loop_test", RACE,
          ("engine/base/triple_buffer.h", "std::atomic<std::uint8_t> middle_{1};", """struct {
    std::uint8_t value = 1;
    std::uint8_t load(std::memory_order) const noexcept { return value; }
    std::uint8_t exchange(int next, std::memory_order) noexcept {
      const std::uint8_t before = value;
      value = static_cast<std::uint8_t>(next);
      return before;
    }
  } middle_;""")),
    fault("ring that publishes before it has written", "tsan", "mirror_test", RACE,
          ("engine/base/spsc_ring.h", "tail_.store(tail + 1, std::memory_order_release)", "tail_.store(tail + 1, std::memory_order_relaxed)")),

    # Own parsers, each without one of its checks.
    fault("NRRD header: too few directions", "asan", "import_nrrd_test", MEMORY,
          ("scenarios/import/nrrd_header.cpp", "      if (list.size() != first_ + 3) return refuse(ImportError::bad_header, key, *text);\n", "")),
    fault("NRRD data: a row one voxel short", "asan", "import_nrrd_test", MEMORY,
          ("scenarios/import/nrrd.cpp", "row(static_cast<std::size_t>(h.file_size.x) * bytes)", "row(static_cast<std::size_t>(h.file_size.x - 1) * bytes)")),
    fault("NRRD image: a row one voxel short", "asan", "import_image_test", MEMORY,
          ("scenarios/import/nrrd_image.cpp", "row(static_cast<std::size_t>(h.file_size.x) * voxel_bytes)",
           "row(static_cast<std::size_t>(h.file_size.x - 1) * voxel_bytes)")),
    fault("MetaImage: fewer files than slices", "asan", "import_image_test", MEMORY,
          ("scenarios/import/metaimage.cpp", """    if (files_.size() != 1 && files_.size() != static_cast<std::size_t>(out_.layout.file_size.z))
      return refuse(ImportError::bad_sizes, "ElementDataFile");
""", "")),
    fault("binvox: one layer too many", "asan", "import_image_test", MEMORY,
          ("scenarios/import/binvox.cpp", "z < static_cast<std::size_t>(size.z)", "z <= static_cast<std::size_t>(size.z)")),
    fault("import's child: a message too short", "asan", "import_worker_test", MEMORY,
          ("scenarios/import/worker_messages.cpp", "    if (at_ >= fields_.size()) ok_ = false;\n", "")),
    fault("scenario: one item too many", "asan", "format_tests", MEMORY,
          ("scenarios/format/json_values.h", "i < node_.size(); ++i) read(item(i));", "i <= node_.size(); ++i) read(item(i));")),
    fault("scenario: a point of two numbers", "asan", "format_tests", MEMORY,
          ("scenarios/format/json_values.h", "if (!node_.is_array() || node_.size() != 3)", "if (!node_.is_array())")),
    fault("specimen in a record: too few bytes", "asan", "specimen_blob_test", MEMORY,
          ("ui/session/specimen_blob.cpp", "  if (!r.ok() || r.left() != grid.voxels() * 3) return std::nullopt;\n", "")),
    fault("trace: shorter than its seal", "asan", "test_storage_codec", MEMORY,
          ("storage/records/trace_codec.cpp", '  if (bytes.size() <= kTraceSeal) return bad("length");\n', "")),
    fault("trace: a number that never ends", "asan", "test_storage_codec", MEMORY,
          ("storage/records/trace_codec.cpp", "      if (bytes.empty()) break;\n", "")),
    fault("key state: too few bytes", "asan", "step_tests", MEMORY,
          ("engine/step/state_fields.cpp", "    if (!good_ || left() < static_cast<std::size_t>(n)) {\n", "    if (!good_) {\n")),
    fault("key state's file: shorter than its seal", "asan", "test_storage_sessions", MEMORY,
          ("storage/cache/key_state_cache.cpp", "  if (body.size() < kHeader + kSeal) return std::nullopt;\n", "")),
    fault("database's log: shorter than its header", "asan", "test_storage_processes", MEMORY,
          ("storage/sqlite/log_replay.cpp", "  if (log.size() < kLogHeader) return out;\n", "")),
    fault("database's log: a torn frame", "asan", "test_storage_processes", MEMORY,
          ("storage/sqlite/log_replay.cpp", "at + kFrameHeader + page_size <= log.size()", "at + page_size <= log.size()")),
    fault("database's log: a page beyond the file", "asan", "test_storage_processes", MEMORY,
          ("storage/sqlite/log_replay.cpp", "    if (page > log.pages) continue;  // the file has become smaller since\n", "")),
    fault("Falcon: a frame that does not end", "asan", "falcon_tests", MEMORY,
          ("device/falcon/protocol.cpp", "  size_ = 0;\n  last_flawed_", "  last_flawed_")),
    fault("Falcon: a packet of one byte", "asan", "falcon_tests", MEMORY,
          ("device/falcon/ftdi.h", "      ++errors.short_packets;\n      continue;\n", "      ++errors.short_packets;\n")),
    fault("Falcon: a firmware block beyond the image", "asan", "falcon_tests", MEMORY,
          ("device/falcon/firmware_image.cpp", "    if (!words.left(2 + size)) return refuse(ImageError::truncated, words.index());\n", "")),
    fault("HID: a descriptor cut within an item", "asan", "hid_tests", MEMORY,
          ("device/hid/report_descriptor.cpp", "      if (bytes_.size() - at_ < size) return bad(DescriptorError::cut_off, begun);\n", "")),
    fault("HID: a value beyond the report", "asan", "hid_tests", MEMORY,
          ("device/hid/report_descriptor.cpp", "  if (begin + field.bits > payload.size() * 8) return std::nullopt;\n", "")),
    fault("SpaceMouse: a short report", "asan", "hid_tests", MEMORY,
          ("device/hid/space_mouse.cpp", "    case kTurnReport:\n      if (report.size() < 7) return false;\n", "    case kTurnReport:\n")),
    fault("Inverse3: a list without a handle", "asan", "inverse_tests",
          MEMORY + r"|Assertion `m_it\.array_iterator != ",  # of nlohmann::json, before ASan sees the read
          ("device/inverse/frames.cpp", "  if (*handles != nullptr && !(*handles)->empty()) {\n", "  if (*handles != nullptr) {\n")),
    fault("script: a row of twelve cells", "asan", "device_tests", MEMORY,
          ("device/scripted/csv_trace.cpp", "    if (out.count == kMostColumns) {\n      ++out.count;\n      return out;\n    }\n", "")),

    # Storage.
    fault("landed migration changed", "asan", "test_storage_opening", r"FAILED  \] Migrations\.one_that_has_landed_is_never_edited",
          ("storage/sqlite/migrations/0001.sql", "  wrong_tries INTEGER NOT NULL DEFAULT 0,\n", "  wrong_tries INTEGER NOT NULL DEFAULT 1,\n")),
    fault("log deleted at opening", "asan", "test_storage_processes",
          r"FAILED  \] Locks\.another_program_that_opens_and_closes_leaves_the_log_of_this_one",
          ("storage/sqlite/open.cpp", "  // SQLite waits for a lock, but not if two connections",
           '  std::error_code planted;\n  fs::remove(file.string() + "-wal", planted);\n  // SQLite waits for a lock, but not if two connections')),

    # Structure.
    fault("cycle of two folders", "release", "architecture_tests", r"engine: volume includes step",
          ("engine/volume/volume.cpp", '#include "engine/volume/volume.h"\n', '#include "engine/volume/volume.h"\n#include "engine/step/step.h"\n')),
    fault("drawing against the includes", "release", "architecture_tests", r"ui/README\.md: view includes render",
          ("ui/README.md", "    view ──► render", "    view ◄── render")),
    fault("engine includes scenarios", "release", "architecture_tests", r"an arrow that points the wrong way",
          ("engine/step/step.cpp", '#include "engine/step/step.h"\n', '#include "engine/step/step.h"\n#include "scenarios/format/scenario.h"\n')),
    fault("Qt outside ui", "release", "architecture_tests", r"Qt lives in ui alone",
          ("storage/base/clock.cpp", '#include "storage/base/clock.h"\n', '#include "storage/base/clock.h"\n#include <QString>\n')),
    fault("database opened past SQLite", "release", "architecture_tests", r"goes past SQLite to a database's file",
          ("storage/export/csv.cpp", "namespace cusp::storage {\n",
           "namespace cusp::storage {\nvoid planted(const char* db) { std::ifstream in(db); }\n")),
    fault("private word", "release", "architecture_tests", r'"bur+"; write bur',
          ("engine/removal/spindle.cpp", "namespace cusp::engine {\n", "namespace cusp::engine {\n// A bur" + "r.\n")),
    fault("library function in the step", "release", "architecture_tests", r"std::hypot",
          ("engine/step/step.cpp", "axis = axis / std::sqrt(glm::dot(axis, axis));", "axis = axis / std::hypot(axis.x, axis.y, axis.z);")),
    fault("products and sums fused", "release", "architecture_tests", r"ffp-contract=off",
          ("CMakeLists.txt", "-Wshadow -ffp-contract=off)", "-Wshadow)")),
]
