/// Identifies a process, so that a later one can find out whether it still runs. The test also holds if the system reused
/// the process id, from another pid namespace (a container), and for a user who may not see the process.
/// Format: "boot id:process id:start time:pid namespace:place". `place` is a byte of a lock file that the process keeps
/// locked until it ends. Older programs wrote the first three fields only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace cusp::storage {

/// The locked byte. Unlocked when this is destroyed or the process ends.
class ProcessMark {
 public:
  /// Creates the file if it does not exist. If no byte can be locked, the text identifies the process by its id alone.
  explicit ProcessMark(const std::filesystem::path& lock_file);
  ~ProcessMark();
  ProcessMark(const ProcessMark&) = delete;
  ProcessMark& operator=(const ProcessMark&) = delete;

  const std::string& text() const noexcept { return text_; }

 private:
  int descriptor_ = -1;
  std::string text_;
};

/// False only if certain: the process has ended, the machine has restarted, or the text has another format.
bool process_runs(const std::string& process, const std::filesystem::path& lock_file);

}  // namespace cusp::storage
