/// An import in a process of its own, limited in memory and time: a crash, a hang or a leak in a foreign reader is a code
/// here and nothing else. The process is this program again, called with the hidden verb `import-child`.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "scenarios/import/child_process.h"
#include "scenarios/import/import.h"

namespace cusp::scenarios {

struct WorkerSettings {
  std::size_t memory_bytes = std::size_t{6} << 30;  // of address space: libraries and thread stacks count too
  std::chrono::seconds cpu{300};                    // of all its threads together
  std::chrono::milliseconds wall{600'000};
  /// Program and leading arguments; empty: this program with the verb `import-child`.
  std::vector<std::string> program;
  /// Called for each process after it has ended, before its messages are judged; on the calling thread.
  std::function<void(const ChildEnd&)> ended;
};

/// import_mesh() in a child. Blocks; `progress` is called on the calling thread; a stop request kills the child within
/// 50 ms (code cancelled). Codes of its own besides import_mesh's: crashed, time_limit, out_of_memory, cancelled,
/// not_started.
[[nodiscard]] Result<VoxelVolume, ImportFailure> import_mesh_in_child(const MeshImport& what,
                                                                      const WorkerSettings& settings = {},
                                                                      const ImportProgress& progress = {},
                                                                      std::stop_token stop = {},
                                                                      std::vector<ImportRemark>* remarks = nullptr);

/// import_image() in a child.
[[nodiscard]] Result<VoxelVolume, ImportFailure> import_image_in_child(const ImageImport& what,
                                                                       const WorkerSettings& settings = {},
                                                                       const ImportProgress& progress = {},
                                                                       std::stop_token stop = {},
                                                                       std::vector<ImportRemark>* remarks = nullptr);

/// look_at_files() in a child.
[[nodiscard]] Result<FileLook, ImportFailure> look_in_child(const std::vector<std::filesystem::path>& files,
                                                            const WorkerSettings& settings = {},
                                                            const ImportProgress& progress = {}, std::stop_token stop = {});

/// To be called first in main(): runs the child's part and gives its exit status when argv[1] is `import-child`,
/// nullopt for any other call.
std::optional<int> import_child_main(int argc, const char* const* argv);

}  // namespace cusp::scenarios
