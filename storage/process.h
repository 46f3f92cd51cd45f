/// Names this process so that a later one can tell whether it still runs, also when its number was given again, and also
/// from another pid namespace (a container) or as a user who may not look at it.
/// "boot id:process:start time:pid namespace:place", where `place` is a byte of a lock file that the process holds
/// locked until it ends. Without the last two words: of an older program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace cusp::storage {

/// The locked byte; free again when this is destroyed, or the process has ended in any way.
class ProcessMark {
 public:
  /// Makes the file at need. One that cannot be locked still names the process, by its number alone.
  explicit ProcessMark(const std::filesystem::path& lock_file);
  ~ProcessMark();
  ProcessMark(const ProcessMark&) = delete;
  ProcessMark& operator=(const ProcessMark&) = delete;

  const std::string& text() const noexcept { return text_; }

 private:
  int descriptor_ = -1;
  std::string text_;
};

/// False only when it is certain: that process has ended, the machine was started anew, or the text is none of ours.
bool process_runs(const std::string& process, const std::filesystem::path& lock_file);

}  // namespace cusp::storage
