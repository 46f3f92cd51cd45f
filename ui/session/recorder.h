/// Writes an attempt into the database: one transaction a second, in order. On a thread of its own, so that a slow disk never
/// makes the mirror late; or at once, in virtual time. A file that another process holds and a full disk are tried again
/// until they pass; nothing is dropped.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "storage/store.h"
#include "ui/modules.h"
#include "ui/session/observer.h"
#include "ui/session/patience.h"

namespace cusp::ui {

/// Of session time between two key states: a jump in a replay is then at most 5,000 ticks.
inline constexpr std::uint64_t kKeyStateUs = 5'000'000;

class Recorder {
 public:
  enum class Writing : std::uint8_t {
    on_a_thread,
    at_once,  // add() returns when the second is on the disk, or was tried often enough
  };
  /// The store is the recorder's until take_store().
  Recorder(std::unique_ptr<Store> store, SessionId session, Writing writing, const Patience& patience = {});
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Mirror thread. Never fails: a second that cannot be written is kept, and so are those after it. `key_state` is of
  /// the second's last tick and goes to the cache once the second is on the disk; a failure of the cache is ignored.
  void add(RecordedSecond second, std::optional<KeyState> key_state = std::nullopt);

  /// Any thread. behind: it waits for the disk or another process, and tries by itself. failed: for good, or for so long
  /// that the session is to be held; what passes is tried further, and then it records again.
  /// behind, too, until a try that retry() asked for has ended.
  RecordingState state() const;
  std::optional<StorageFailure> failure() const;
  /// Any thread. Session time of the seconds that stand on the disk, us.
  std::uint64_t stored_us() const;
  /// Tries the second that failed again; see state().
  void retry();

  /// Waits until everything is written, one second failed for good, or was tried often enough. True: all is on the disk.
  /// After this the store is idle.
  bool drain();
  /// After drain(): the store back, for the end of the session. No add() after this.
  std::unique_ptr<Store> take_store();

 private:
  struct Waiting {
    RecordedSecond second;
    std::optional<KeyState> key_state;
  };
  void run();
  bool write_first(std::unique_lock<std::mutex>& lock);
  void write_all_at_once(std::unique_lock<std::mutex>& lock);

  // Seconds that may wait before state() is behind.
  static constexpr std::size_t kBehind = 3;
  std::unique_ptr<Store> store_;
  SessionId session_;
  Writing writing_;
  Patience patience_;
  mutable std::mutex mutex_;
  std::condition_variable wake_, idle_;
  std::deque<Waiting> waiting_;
  std::optional<StorageFailure> failure_;
  std::uint64_t stored_us_ = 0;
  std::uint64_t refusals_ = 0;  // tries that failed, of the whole session
  bool writing_now_ = false;
  bool again_ = false;    // retry() was called, and no try has ended since
  bool gave_up_ = false;  // at_once: tried often enough
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace cusp::ui
