/// Writes a go into the database: one transaction a second, in order. On a thread of its own, so that a slow disk never
/// makes the mirror late; or at once, in virtual time.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "storage/store.h"
#include "ui/session/observer.h"

namespace cusp {

class Recorder {
 public:
  enum class Writing : std::uint8_t {
    on_a_thread,
    at_once,  // add() returns when the second is on the disk
  };
  /// The store is the recorder's until take_store().
  Recorder(std::unique_ptr<Store> store, SessionId session, Writing writing);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Mirror thread. Never fails: a second that cannot be written is kept, and so are those after it.
  void add(RecordedSecond second);

  /// Any thread.
  RecordingState state() const;
  std::optional<StorageFailure> failure() const;
  /// Tries the second that failed again; the state says what came of it.
  void retry();

  /// Waits until everything is written or one second failed. True: all is on the disk. After this the store is idle.
  bool drain();
  /// After drain(): the store back, for the end of the session. No add() after this.
  std::unique_ptr<Store> take_store();

 private:
  void run();
  bool write_first(std::unique_lock<std::mutex>& lock);

  // Seconds that may wait before the screen says that the disk is slow.
  static constexpr std::size_t kBehind = 3;
  std::unique_ptr<Store> store_;
  SessionId session_;
  Writing writing_;
  mutable std::mutex mutex_;
  std::condition_variable wake_, idle_;
  std::deque<RecordedSecond> waiting_;
  std::optional<StorageFailure> failure_;
  bool writing_now_ = false;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace cusp
