"""What the tests from outside share: a folder of their own, a small exercise that plays in seconds, and the program."""
import contextlib
import json
import math
import os
import shutil
import sqlite3
import subprocess
import sys
import tempfile

SOURCE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

# One program that runs longer has hung: six times the longest on an idle machine, `play class-1-36` with 70 s. The
# factor is that of cusp_time_limit (tests/CMakeLists.txt): a busy machine fails no test.
HUNG_S = 600


class Desk:
    def __init__(self, cusp):
        self.cusp = cusp
        self.folder = tempfile.mkdtemp(prefix="cusp-outside-")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        shutil.rmtree(self.folder, ignore_errors=True)

    def path(self, *parts):
        return os.path.join(self.folder, *parts)

    def environment(self, **more):
        # Whoever runs the test may have set a database, a scale or folders for programs of their own.
        env = {name: value for name, value in os.environ.items() if not name.startswith(("CUSP_", "QT_", "XDG_"))}
        env.update(LC_ALL="C.UTF-8", HOME=self.folder)
        env.update(more)
        return env

    def run(self, *arguments, **more):
        """Exit status, stdout, stderr of one verb. A run that hangs fails the test."""
        done = subprocess.run([self.cusp, *arguments], capture_output=True, text=True, timeout=HUNG_S,
                              stdin=subprocess.DEVNULL, env=self.environment(**more))
        return done.returncode, done.stdout, done.stderr

    def json(self, *arguments):
        status, out, err = self.run(*arguments, "--json", "-")
        check(status == 0, f"{arguments}: exit {status}: {err}")
        return json.loads(out)

    def small_exercise(self, name="small.json", change=None):
        """A straight channel in coarse voxels: light enough to be played many times."""
        with open(os.path.join(SOURCE, "tests/outside/small_exercise.json"), encoding="utf-8") as f:
            scenario = json.load(f)
        if change:
            change(scenario)
        with open(self.path(name), "w", encoding="utf-8") as f:
            json.dump(scenario, f)
        return self.path(name)

    def small_script(self, seconds, name="script.csv"):
        """Down onto the block and along a wave, cutting."""
        with open(self.path(name), "w", encoding="utf-8") as f:
            f.write("elapsed_us,x,y,z,qx,qy,qz,qw,buttons,pedal\n")
            for i in range(int(seconds * 1000)):
                t = i * 1e-3
                x = 2.5 * math.sin(1.5 * t)
                y = 0.3 * math.sin(4.0 * t)
                z = 1.0 - 4.0 * t if t < 0.2 else max(0.2 - 0.3 * (t - 0.2), -1.2)
                f.write(f"1000,{round(x * 1e4)},{round(y * 1e4)},{round(z * 1e4)},0,0,0,32767,{1 if t > 0.15 else 0},0\n")
        return self.path(name)


def check(holds, what):
    if not holds:
        print("FAILED: " + what)
        sys.exit(1)


def integrity(database):
    with contextlib.closing(sqlite3.connect(database)) as db:
        return db.execute("PRAGMA integrity_check").fetchone()[0]


def one_sentence(err, what):
    """Exactly one line, for people: it names the program and is no dump of a code."""
    lines = [line for line in err.splitlines() if line.strip()]
    check(len(lines) == 1, f"{what}: stderr should be one line, it is {err!r}")
    check(lines[0].startswith("cusp: ") and len(lines[0]) > 20, f"{what}: {lines[0]!r}")
