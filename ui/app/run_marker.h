/// A file that stands while the desktop runs, one for each process, and whatever ends the program on purpose removes it: its own end,
/// the end of the session, SIGTERM, SIGHUP and SIGINT. One whose process is gone tells of a crash or a power cut. QLockFile compares
/// host, boot, process and program, so that another window, or another station with the same home, counts as running. Thread: GUI.
#pragma once

#include <QLockFile>
#include <QString>
#include <memory>

namespace cusp::ui {

class RunMarker {
 public:
  /// Takes away the markers of processes that are gone, then sets its own. A folder that cannot be written has no markers.
  explicit RunMarker(const QString& folder);
  ~RunMarker();
  RunMarker(const RunMarker&) = delete;
  RunMarker& operator=(const RunMarker&) = delete;

  /// Whether a process ended without taking its marker away.
  bool found_crash() const { return found_crash_; }

 private:
  std::unique_ptr<QLockFile> own_;
  bool found_crash_ = false;
};

/// Whether SIGTERM, SIGHUP or SIGINT has asked the application to end. Any thread.
bool ended_by_signal() noexcept;

/// From now on SIGTERM, SIGHUP and SIGINT end the application as its window's closing does, and these and exit() remove the file
/// first. After the QApplication; once a program. nullptr: no file.
void remove_at_any_end(const char* file);

}  // namespace cusp::ui
