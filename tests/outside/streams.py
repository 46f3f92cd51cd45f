"""What goes through the standard streams and --json: written where it leads to, never lost in silence, and no secret is shown.

  streams.py CUSP
"""
import json
import os
import pty
import signal
import stat
import subprocess
import sys
import termios

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import HUNG_S, Desk, check, one_sentence  # noqa: E402


def outputs(desk):
    """What --json names is written where it leads to, keeps its permissions, and may be a pipe; lost output is no success."""
    target, link, pipe = desk.path("target.json"), desk.path("link.json"), desk.path("pipe.json")
    with open(target, "w", encoding="utf-8") as f:
        f.write("old")
    os.chmod(target, 0o600)
    os.symlink(target, link)
    status, _, err = desk.run("template", "list", "--json", link)
    check(status == 0 and os.path.islink(link), f"a link was replaced: {err}")
    check(stat.S_IMODE(os.stat(target).st_mode) == 0o600, f"permissions of a file that was there: {os.stat(target)}")
    with open(target, encoding="utf-8") as f:
        listed = json.load(f)
    os.mkfifo(pipe)
    with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE) as reader:
        status, _, err = desk.run("template", "list", "--json", pipe)
        is_pipe = stat.S_ISFIFO(os.stat(pipe).st_mode)
        if status != 0 or not is_pipe:
            reader.kill()
        check(status == 0 and is_pipe, f"a pipe was replaced: {err}")
        check(json.loads(reader.communicate(timeout=HUNG_S)[0]) == listed, "what came through the pipe")
    for arguments in (("template", "list"), ("template", "list", "--json", "-"), ("--help",)):
        with open("/dev/full", "wb") as full:
            done = subprocess.run([desk.cusp, *arguments], stdin=subprocess.DEVNULL, stdout=full, stderr=subprocess.PIPE, text=True,
                                  timeout=HUNG_S, env=desk.environment())
        check(done.returncode == 1 and "standard output" in done.stderr and "No space left" in done.stderr,
              f"{arguments} to a full disk: exit {done.returncode}: {done.stderr}")
        one_sentence(done.stderr, f"{arguments} to a full disk")


def unread_pipes(desk):
    """A reader that goes away, as head does, changes neither the work nor the status."""
    listed = desk.path("listed.json")
    check(desk.run("specimen", "block", "--voxel-mm", "0.5", "-o", desk.path("coarse.nrrd"))[0] == 0, "a coarse block is grown")
    for arguments in (("template", "list"), ("template", "list", "--json", "-"), ("play", "--help"), ("--version",),
                      ("import", desk.path("coarse.nrrd"), "--list", "--json", listed)):
        reading, writing = os.pipe()
        os.close(reading)
        done = subprocess.run([desk.cusp, *arguments], stdin=subprocess.DEVNULL, stdout=writing, stderr=subprocess.PIPE, text=True,
                              timeout=HUNG_S, env=desk.environment())
        os.close(writing)
        check(done.returncode == 0 and done.stderr == "", f"{arguments} without a reader: exit {done.returncode}: {done.stderr}")
    check(os.path.exists(listed), "what follows the output was not done")
    reading, writing = os.pipe()
    os.close(reading)
    done = subprocess.run([desk.cusp, "-platform", "offscreen", "--saef"], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=writing,
                          timeout=HUNG_S, env=desk.environment())
    os.close(writing)
    check(done.returncode == 2, f"the window without a reader of its messages: exit {done.returncode}")


def closed_streams(desk):
    """What goes to a closed stream goes into no other file, and lost output is no success."""
    for arguments in (("template", "list"), ("template", "list", "--json", "-"), ("--version",)):
        done = subprocess.run([desk.cusp, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                              timeout=HUNG_S, env=desk.environment(), preexec_fn=lambda: os.close(1))
        check(done.returncode == 1 and "standard output" in done.stderr and "Bad file descriptor" in done.stderr,
              f"{arguments} without stdout: exit {done.returncode}: {done.stderr}")
        one_sentence(done.stderr, f"{arguments} without stdout")
    status, listed, _ = desk.run("template", "list")
    done = subprocess.run([desk.cusp, "template", "list"], stdout=subprocess.PIPE, text=True, timeout=HUNG_S, env=desk.environment(),
                          preexec_fn=lambda: (os.close(0), os.close(2)))
    check(status == 0 and done.returncode == 0 and done.stdout == listed, f"without stdin and stderr: exit {done.returncode}: {done.stdout}")


def prompts(desk):
    """Ctrl+C while a password is typed: the terminal shows again what is typed."""
    database = desk.path("good.db")
    status, _, err = desk.run("play", desk.small_exercise(), "--script", desk.small_script(1), "--db", database, "--out", desk.path("o"))
    check(status == 0, f"play: {err}")
    terminal, end = pty.openpty()

    def shows():
        return bool(termios.tcgetattr(end)[3] & termios.ECHO)

    def wait_for_prompt(run):
        asked = b""
        while not asked.endswith(b": "):
            read = run.stderr.read(1)
            check(read != b"", f"no password was asked for: {asked}")
            asked += read

    for number in (signal.SIGINT, signal.SIGTERM):
        check(shows(), "a new terminal shows what is typed")
        with subprocess.Popen([desk.cusp, "history", database, "list", "--as", "nobody"], stdin=end, stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, env=desk.environment(), preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)) as run:
            wait_for_prompt(run)
            check(not shows(), "a password is shown while it is typed")
            run.send_signal(number)
            run.communicate(timeout=HUNG_S)
        check(run.returncode == -number and shows(), f"stopped at the password: exit {run.returncode}")
    with subprocess.Popen([desk.cusp, "history", database, "list", "--as", "nobody"], stdin=end, stdout=subprocess.DEVNULL,
                          stderr=subprocess.PIPE, env=desk.environment()) as run:
        wait_for_prompt(run)
        os.write(terminal, b"wrong\n")
        _, err = run.communicate(timeout=HUNG_S)
    check(run.returncode == 1 and b"nobody" in err and shows(), f"a password that was typed: exit {run.returncode}: {err}")
    os.close(terminal)
    os.close(end)


with Desk(sys.argv[1]) as the_desk:
    outputs(the_desk)
    unread_pipes(the_desk)
    closed_streams(the_desk)
    prompts(the_desk)
