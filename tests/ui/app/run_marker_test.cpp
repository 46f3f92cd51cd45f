#include "ui/app/run_marker.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <csignal>

#include "tests/modules.h"

namespace cusp::test {
namespace {

/// A second process with a marker of its own, as another window has.
class OtherWindow {
 public:
  explicit OtherWindow(const QString& folder) {
    int ready[2];
    if (pipe(ready) != 0) return;
    child_ = fork();
    if (child_ == 0) {
      const RunMarker marker(folder);
      const char byte = marker.found_crash() ? 1 : 0;
      if (write(ready[1], &byte, 1) != 1) _exit(2);
      for (;;) pause();
    }
    char byte = 0;
    if (read(ready[0], &byte, 1) == 1) found_crash_ = byte != 0;
    close(ready[0]);
    close(ready[1]);
  }
  ~OtherWindow() { end_by(SIGKILL); }
  OtherWindow(const OtherWindow&) = delete;
  OtherWindow& operator=(const OtherWindow&) = delete;

  bool found_crash() const { return found_crash_; }
  void send(int signal) { kill(child_, signal); }
  void end_by(int signal) {
    if (child_ <= 0) return;
    send(signal);
    wait_for_end();
  }

 private:
  void wait_for_end() {
    waitpid(child_, nullptr, 0);
    child_ = -1;
  }
  pid_t child_ = -1;
  bool found_crash_ = false;
};

class RunMarkerTest : public testing::Test {
 protected:
  bool found_crash() const { return RunMarker(folder.path()).found_crash(); }
  int files() const { return static_cast<int>(QDir(folder.path()).entryList(QDir::Files).size()); }
  bool becomes_empty() const {
    for (int i = 0; i < 60'000 && files() > 0; ++i) usleep(1000);
    return files() == 0;
  }
  QTemporaryDir folder;
};

TEST_F(RunMarkerTest, finds_no_crash_at_the_first_start_nor_after_a_normal_end) {
  EXPECT_FALSE(found_crash());
  EXPECT_FALSE(found_crash());
  EXPECT_EQ(files(), 0);
}

TEST_F(RunMarkerTest, finds_a_killed_program_once) {
  OtherWindow(folder.path()).end_by(SIGKILL);
  EXPECT_EQ(files(), 1);
  EXPECT_TRUE(found_crash());
  EXPECT_FALSE(found_crash());
}

TEST_F(RunMarkerTest, takes_a_window_that_runs_for_no_crash) {
  OtherWindow other(folder.path());
  EXPECT_FALSE(found_crash());
  const OtherWindow third(folder.path());
  EXPECT_FALSE(third.found_crash());
  other.end_by(SIGKILL);
  EXPECT_TRUE(found_crash());
}

TEST_F(RunMarkerTest, takes_sigterm_sighup_and_sigint_for_no_crash_even_if_the_program_is_killed_after_them) {
  for (const int signal : {SIGTERM, SIGHUP, SIGINT}) {
    OtherWindow other(folder.path());
    other.send(signal);
    EXPECT_TRUE(becomes_empty()) << signal;
    other.end_by(SIGKILL);
    EXPECT_FALSE(found_crash()) << signal;
  }
}

TEST_F(RunMarkerTest, knows_that_a_signal_ends_the_program_and_not_its_window) {
  EXPECT_FALSE(ended_by_signal());
  const pid_t child = fork();
  if (child == 0) {
    const RunMarker marker(folder.path());
    raise(SIGTERM);
    _exit(ended_by_signal() ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST_F(RunMarkerTest, takes_a_window_of_another_station_for_no_crash) {
  // A home that two stations share; the format is QLockFile's: process, program, host, machine, boot.
  QFile file(folder.filePath(QStringLiteral("999999999.running")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("999999999\ncusp\nanother-station\n0123456789abcdef\nfedcba98\n");
  file.close();
  EXPECT_FALSE(found_crash());
  EXPECT_EQ(files(), 1) << "it is not this station's to remove";
}

TEST_F(RunMarkerTest, starts_where_no_file_can_be_made) {
  EXPECT_FALSE(RunMarker(QStringLiteral("/sys/cusp-running")).found_crash());
}

}  // namespace
}  // namespace cusp::test
