/// Whether the process of a session still runs: reused numbers, other pid namespaces, other users.
#include "storage/base/process.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <sstream>

#include "storage/base/locked_folder.h"
#include "tests/modules.h"
#include "tests/storage/sample.h"

namespace cusp::test {
namespace {

namespace fs = std::filesystem;

/// Splits the text at its colons.
std::vector<std::string> fields_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string field; std::getline(in, field, ':');) out.push_back(field);
  return out;
}

/// The first three fields: the format of older programs.
std::string old_form(const std::string& text) {
  const auto fields = fields_of(text);
  return fields[0] + ":" + fields[1] + ":" + fields[2];
}

/// A process that holds a mark until end(). `enter` runs before it, and returns whether it succeeded.
class Marked {
 public:
  Marked(const fs::path& lock_file, const std::function<bool()>& enter = [] { return true; }) {
    int mark_pipe[2], wait[2];
    if (pipe(mark_pipe) != 0 || pipe(wait) != 0) return;
    child_ = fork();
    if (child_ == 0) {
      close(wait[1]);
      close(mark_pipe[0]);
      if (!enter()) _exit(1);
      // The second one is the first process of a pid namespace that `enter` made.
      const pid_t inner = fork();
      if (inner == 0) {
        const ProcessMark mark(lock_file);
        if (write(mark_pipe[1], mark.text().data(), mark.text().size()) < 0) _exit(1);
        close(mark_pipe[1]);
        char byte = 0;
        if (read(wait[0], &byte, 1) < 0) _exit(1);
        raise(SIGKILL);
      }
      close(mark_pipe[1]);
      waitpid(inner, nullptr, 0);
      _exit(0);
    }
    close(mark_pipe[1]);
    close(wait[0]);
    end_ = wait[1];
    char part[256];
    for (ssize_t got = 0; (got = read(mark_pipe[0], part, sizeof part)) > 0;) text_.append(part, static_cast<std::size_t>(got));
    close(mark_pipe[0]);
  }
  ~Marked() { end(); }
  void end() {
    if (end_ < 0) return;
    close(end_);
    end_ = -1;
    waitpid(child_, nullptr, 0);
  }
  const std::string& text() const { return text_; }  // empty: `enter` was refused

 private:
  pid_t child_ = -1;
  int end_ = -1;
  std::string text_;
};

TEST(Processes, one_runs_until_it_has_ended_and_one_that_never_was_does_not) {
  const Folder folder;
  const fs::path locks = folder / "a.db.running";
  const ProcessMark mine(locks);
  EXPECT_TRUE(process_runs(mine.text(), locks));
  EXPECT_TRUE(process_runs(old_form(mine.text()), locks));
  EXPECT_FALSE(process_runs("another" + mine.text(), locks)) << "before the machine was started anew";
  for (const char* nonsense : {"", ":", "::", "a:b:c", "x:-1:1", "::::", "a:b:c:d:e:f"}) {
    EXPECT_FALSE(process_runs(nonsense, locks)) << nonsense;
  }
  Marked other(locks);
  EXPECT_NE(other.text(), mine.text());
  EXPECT_TRUE(process_runs(other.text(), locks));
  EXPECT_TRUE(process_runs(old_form(other.text()), locks));
  other.end();
  EXPECT_FALSE(process_runs(other.text(), locks));
  EXPECT_FALSE(process_runs(old_form(other.text()), locks));
  EXPECT_TRUE(process_runs(mine.text(), locks)) << "the other's end frees its own place alone";
}

TEST(Processes, a_number_that_another_process_got_is_not_the_one_that_had_it) {
  const Folder folder;
  const fs::path locks = folder / "a.db.running";
  const ProcessMark mine(locks);
  const auto fields = fields_of(mine.text());
  ASSERT_EQ(fields.size(), 5u);
  const std::string before = fields[0] + ":" + fields[1] + ":" + fields[2] + "0:" + fields[3] + ":77";
  EXPECT_FALSE(process_runs(before, locks));
  EXPECT_FALSE(process_runs(old_form(mine.text()) + "0", locks));
}

TEST(Processes, one_of_another_pid_namespace_runs_until_it_has_ended) {
  const Folder folder;
  const fs::path locks = folder / "a.db.running";
  Marked other(locks, [] { return unshare(CLONE_NEWPID) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWPID) == 0; });
  if (other.text().empty()) GTEST_SKIP() << "no pid namespace may be made here";
  // Its number means this machine's first process here, which did not start when it did.
  EXPECT_EQ(fields_of(other.text())[1], "1");
  EXPECT_TRUE(process_runs(other.text(), locks));
  other.end();
  EXPECT_FALSE(process_runs(other.text(), locks));
}

TEST(Processes, one_of_another_namespace_without_its_lock_file_is_not_taken_for_ended) {
  const Folder folder;
  const ProcessMark mine(folder / "a.db.running");
  const auto fields = fields_of(mine.text());
  const std::string elsewhere = fields[0] + ":999999:1:1:" + fields[4];
  EXPECT_TRUE(process_runs(elsewhere, folder / "none.running"));
  EXPECT_TRUE(process_runs(fields[0] + ":999999:1:1:", folder / "a.db.running")) << "it held no lock";
  ASSERT_EQ(::mkfifo((folder / "pipe.running").c_str(), 0600), 0);
  EXPECT_TRUE(process_runs(elsewhere, folder / "pipe.running")) << "and nobody waits for its other end";
}

TEST(Processes, one_of_another_user_who_hides_it_runs_until_it_has_ended) {
  if (geteuid() != 0) GTEST_SKIP() << "only root may hide /proc and become another user";
  const Folder folder;
  const fs::path locks = folder / "a.db.running";
  fs::permissions(folder / "", fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
  Marked ended(locks);
  ended.end();
  const ProcessMark mine(locks);
  const pid_t child = fork();
  if (child == 0) {
    if (unshare(CLONE_NEWNS) != 0 || mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        mount("proc", "/proc", "proc", 0, "hidepid=2") != 0 || setgid(65534) != 0 || setuid(65534) != 0) {
      _exit(77);
    }
    if (fs::exists("/proc/" + fields_of(mine.text())[1] + "/stat")) _exit(78);
    _exit((process_runs(mine.text(), locks) ? 0 : 1) | (process_runs(old_form(mine.text()), locks) ? 0 : 2) |
          (process_runs(ended.text(), locks) ? 4 : 0));
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  if (WEXITSTATUS(status) >= 77) GTEST_SKIP() << "/proc cannot be hidden here";
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(Processes, a_session_of_another_pid_namespace_is_marked_only_when_its_process_has_ended) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Account student = make_student(*store);
  const SessionId id = must(store->sessions.start(student.actor(), new_session(student, keep(*store)))).id;
  Marked other(store->context().lock_file(),
               [] { return unshare(CLONE_NEWPID) == 0 || unshare(CLONE_NEWUSER | CLONE_NEWPID) == 0; });
  if (other.text().empty()) GTEST_SKIP() << "no pid namespace may be made here";
  must(store->database().run("UPDATE session_events SET process = ?1", other.text()));
  EXPECT_TRUE(must(store->sessions.mark_interrupted()).empty());
  other.end();
  EXPECT_EQ(must(store->sessions.mark_interrupted()), std::vector<SessionId>{id});
}

TEST(Processes, a_session_of_another_station_is_not_marked) {
  const Folder folder;
  const auto store = open(folder / "a.db");
  const Account student = make_student(*store);
  must(store->sessions.start(student.actor(), new_session(student, keep(*store))));
  must(store->database().run("UPDATE session_events SET process = 'gone:1:1'"));
  must(store->database().run("UPDATE sessions SET station = ?1", Uuid::v7()));
  EXPECT_TRUE(must(store->sessions.mark_interrupted()).empty());
}

TEST(LockedFolder, is_shared_by_many_or_held_by_one_alone) {
  const Folder folder;
  const fs::path path = folder / "";
  {
    const LockedFolder one(path, FolderLock::shared), another(path, FolderLock::shared);
    EXPECT_TRUE(one.locked() && another.locked());
    EXPECT_FALSE(LockedFolder(path, FolderLock::alone_at_once).locked());
  }
  const LockedFolder alone(path, FolderLock::alone);
  EXPECT_TRUE(alone.locked());
  EXPECT_FALSE(LockedFolder(path, FolderLock::alone_at_once).locked());
  EXPECT_FALSE(LockedFolder(folder / "nothing", FolderLock::shared).locked());
}

}  // namespace
}  // namespace cusp::test
