"""Several programs on one file, killed with SIGKILL at random moments, while a watcher looks at their locks and logs.

  processes.py CUSP [--crowd alone|two|five] [--kills N] [--seed N]

alone: plays of a ten-second script, one after the other. two: a play, and another play, `history list` or `history
verify`. five: a window, two plays, `history list` and `history verify`. Without --crowd: three kills among two, two among
five; CUSP_FULL=1 makes that 300 alone, 300 among two and 100 among five.

What has to hold: a play that printed its session has its grade. Whoever was not killed did not fail. A program with the
log open holds a lock on the database, and the log is not deleted under it. Once all have ended, the file is sound and every
chain is whole.
"""
import argparse
import json
import os
import random
import re
import shutil
import subprocess
import sys
import threading
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import HUNG_S, Desk, check, integrity  # noqa: E402

CROWDS = {"alone": [["play"]], "two": [["play", "play"], ["play", "list"], ["play", "verify"]],
          "five": [["window", "play", "play", "list", "verify"]]}
KILLS_A_FILE = 10  # then a new one: its making by two at once is a moment like any other


class Display:
    """An X server for the window."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-screen", "0", "1300x840x24", "-nolisten", "tcp"],
                                       pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.name = ":" + pipe.readline().strip()

    def close(self):
        self.server.terminate()
        self.server.wait()


class Watcher:
    """Looks every few milliseconds at what the running programs hold. `broken`: what must never be seen."""

    def __init__(self, database):
        self.database, self.pids, self.broken = database, set(), []
        self.looks = self.with_log = 0
        self.ends = threading.Event()
        self.thread = threading.Thread(target=self._run)
        self.thread.start()

    def close(self):
        self.ends.set()
        self.thread.join()

    def _run(self):
        while not self.ends.wait(0.01):
            for pid in list(self.pids):
                self._look(pid)

    def _log_open(self, pid):
        """Name of the log as the program has it open, None when it has not."""
        folder = f"/proc/{pid}/fd"
        try:
            for number in os.listdir(folder):
                name = os.readlink(os.path.join(folder, number))
                if name.startswith(self.database + "-wal"):
                    return name
        except OSError:  # it has ended, or has closed this one
            pass
        return None

    def _locked(self, pid):
        """Read by descriptor: the kernel does not list /proc/locks at one moment."""
        folder = f"/proc/{pid}"
        try:
            numbers = os.listdir(f"{folder}/fd")
        except OSError:  # it has ended
            return True
        for number in numbers:
            try:
                if os.readlink(f"{folder}/fd/{number}") == self.database:
                    with open(f"{folder}/fdinfo/{number}", encoding="ascii") as f:
                        if "lock:" in f.read():
                            return True
            except OSError:  # closed since
                pass
        return not os.path.exists(self.database)  # nothing to lock: only its own end takes a file away

    def _look(self, pid):
        self.looks += 1
        name = self._log_open(pid)
        if name is None:
            return
        self.with_log += 1
        if name.endswith("(deleted)"):  # SQLite closes a log before it deletes it
            self.broken.append(f"the log was deleted under process {pid}")
        elif not self._locked(pid):
            # Seen between opening and closing? Then it is not so a moment later.
            time.sleep(0.005)
            if self._log_open(pid) and not self._locked(pid) and self._log_open(pid):
                self.broken.append(f"process {pid} has the log open and no lock on the database")


class Program:
    """One running verb or window."""
    count = 0

    def __init__(self, crowd, kind):
        Program.count += 1
        self.kind, self.killed = kind, False
        self.out = crowd.desk.path(f"{Program.count}.out")
        arguments = {"play": ["play", crowd.desk.path("small.json"), "--script", crowd.desk.path("script.csv"), "--db",
                              crowd.database, "--out", crowd.desk.path(f"{Program.count}")],
                     "list": ["history", crowd.database, "list"], "verify": ["history", crowd.database, "verify"],
                     "window": ["--db", crowd.database, "--safe"]}[kind]
        with open(self.out, "w", encoding="utf-8") as out, open(self.out + ".err", "w", encoding="utf-8") as err:
            self.process = subprocess.Popen([crowd.desk.cusp, *arguments], stdout=out, stderr=err, stdin=subprocess.DEVNULL,
                                            env=crowd.environment)

    def output(self, end=""):
        with open(self.out + end, encoding="utf-8", errors="replace") as f:
            return f.read().strip()


class Crowd:
    """Programs on one new file. Whoever ends is followed by another of its kind. `finished`: sessions that a play has
    printed, with their score."""

    def __init__(self, desk, display, kinds, number):
        self.desk, self.finished, self.born = desk, {}, False
        self.database = desk.path(f"{number}.db")
        self.environment = desk.environment(DISPLAY=display.name if display else "", LIBGL_ALWAYS_SOFTWARE="1",
                                            QT_QPA_PLATFORM="xcb" if display else "offscreen")
        self.failures = []
        self.watcher = Watcher(self.database)
        self.running = [self._start(kind) for kind in kinds]

    def _start(self, kind):
        program = Program(self, kind)
        # Before the first account is made there is no history to list.
        program.early = kind in ("list", "verify") and not self.born
        self.watcher.pids.add(program.process.pid)
        return program

    def _ended(self, program):
        """Takes down what it came to."""
        self.watcher.pids.discard(program.process.pid)
        status, printed = program.process.returncode, program.output()
        # Killed after it printed the session: that counts too.
        if program.kind == "play" and re.fullmatch(r"[0-9a-f-]{36}", printed):
            report = os.path.join(program.out[:-4], "report.json")
            with open(report, encoding="utf-8") as f:
                self.finished[printed] = json.load(f)["score"]
            self.born = True
        if program.killed:
            return
        if status != 0 and not program.early:
            self.failures.append(f"{program.kind} ended with {status}: {program.output('.err')}")

    def go_on(self, seconds):
        """Keeps all places taken for so long."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            for i, program in enumerate(self.running):
                if program.process.poll() is not None:
                    self._ended(program)
                    self.running[i] = self._start(program.kind)
            time.sleep(min(0.02, max(end - time.monotonic(), 0)))

    def kill(self, dice):
        place = dice.randrange(len(self.running))
        victim = self.running[place]
        victim.killed = victim.process.poll() is None
        victim.process.kill()
        victim.process.wait()
        self._ended(victim)
        self.running[place] = self._start(victim.kind)
        return victim.killed

    def end(self, let_finish):
        """All end: the plays by themselves, or everybody at once, as in a power cut."""
        for program in self.running:
            if program.kind == "window" or not let_finish:
                program.killed = program.process.poll() is None
                program.process.kill()
        for program in self.running:
            program.process.wait(timeout=HUNG_S)
            self._ended(program)
        self.watcher.close()

    def verdict(self, where):
        problems = self.watcher.broken[:3] + self.failures[:3]
        sound = integrity(self.database) if os.path.exists(self.database) else "ok"
        if sound != "ok":
            problems.append(f"integrity_check: {len(sound.splitlines())} findings: {sound.splitlines()[0]}")
        elif self.finished:
            status, out, err = self.desk.run("history", self.database, "list", "--json", "-")
            rows = {row["session"]: row for row in json.loads(out)} if status == 0 else {}
            if status != 0:
                problems.append(f"history list: {err}")
            for session, score in self.finished.items():
                row = rows.get(session)
                if row is None or row["state"] != "graded" or abs(row["score"] - score) > 1e-9:
                    problems.append(f"the finished {session} of {score} points is {row and (row['state'], row['score'])}")
            status, out, err = self.desk.run("history", self.database, "verify")
            if status != 0:
                problems.append(f"history verify: {err}")
        return [f"{where}: {problem}" for problem in problems]


def run(desk, display, name, kills, whole_s, seed):
    """So many kills in crowds of one name. What went wrong."""
    dice = random.Random(f"{seed} {name}")
    problems, done, files, finished, looks, with_log = [], 0, 0, 0, 0, 0
    start = time.monotonic()
    while done < kills:
        crowd = Crowd(desk, display, CROWDS[name][files % len(CROWDS[name])], f"{name}-{files}")
        of_this = 0
        while of_this < min(KILLS_A_FILE, kills - done):
            crowd.go_on(dice.uniform(0.02, whole_s))
            of_this += crowd.kill(dice)
        crowd.end(let_finish=files % 2 == 0)
        problems += crowd.verdict(f"{name}, file {files} (seed {seed})")
        done, files, finished = done + of_this, files + 1, finished + len(crowd.finished)
        looks, with_log = looks + crowd.watcher.looks, with_log + crowd.watcher.with_log
        for entry in os.listdir(desk.folder):
            if entry[0].isdigit() or entry.startswith(name):
                path = desk.path(entry)
                shutil.rmtree(path) if os.path.isdir(path) else os.remove(path)
    print(f"{name}: {done} kills on {files} files in {time.monotonic() - start:.0f} s; {finished} plays finished; {looks} looks, "
          f"{with_log} at a program with the log open; {len(problems)} problems", flush=True)
    check(with_log > 0, "nobody was ever seen with the log open: nothing was shown")
    return problems


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("cusp")
    arguments.add_argument("--crowd", choices=CROWDS)
    arguments.add_argument("--kills", type=int, default=10)
    arguments.add_argument("--seed", type=int, default=int(time.time()))
    o = arguments.parse_args()
    print(f"seed {o.seed}", flush=True)
    plan = {o.crowd: o.kills} if o.crowd else {"two": 3, "five": 2}
    if os.environ.get("CUSP_FULL") and not o.crowd:
        plan = {"alone": 300, "two": 300, "five": 100}
    problems = []
    with Desk(os.path.abspath(o.cusp)) as desk:
        desk.small_exercise(change=lambda scenario: scenario["specimen"].update(voxel_mm=0.5))
        desk.small_script(10 if os.environ.get("CUSP_FULL") else 5)
        start = time.monotonic()
        status, _, err = desk.run("play", desk.path("small.json"), "--script", desk.path("script.csv"), "--db",
                                  desk.path("whole.db"), "--out", desk.path("whole"))
        whole_s = time.monotonic() - start
        check(status == 0, f"an undisturbed play: {err}")
        display = Display() if "five" in plan else None
        try:
            for name, kills in plan.items():
                problems += run(desk, display, name, kills, whole_s, o.seed)
        finally:
            if display:
                display.close()
    for problem in problems[:20]:
        print(problem)
    check(not problems, f"{len(problems)} problems")


main()
