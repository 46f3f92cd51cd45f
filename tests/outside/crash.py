"""kill -9 at random moments of `cusp play`: the file opens and is sound, at most the last second is lost, the session
shows as interrupted, its record holds, and it can be graded as it stands.

  crash.py CUSP [--kills N] [--seed N]
"""
import argparse
import os
import random
import signal
import subprocess
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import HUNG_S, Desk, check, integrity  # noqa: E402


def play(desk, database, after_s):
    """Starts a play and kills it after so many seconds. The last second of the session that it printed."""
    errors = desk.path("progress")
    with open(errors, "w", encoding="utf-8") as err:
        process = subprocess.Popen(
            [desk.cusp, "play", desk.path("small.json"), "--script", desk.path("script.csv"), "--db", database, "--out",
             desk.path("out"), "--progress"],
            stdout=subprocess.DEVNULL, stderr=err, stdin=subprocess.DEVNULL, env=desk.environment())
        if after_s is not None:
            time.sleep(after_s)
            process.send_signal(signal.SIGKILL)
        process.wait(timeout=HUNG_S)
    with open(errors, encoding="utf-8") as err:
        lines = [line for line in err.read().splitlines() if line.replace(".", "", 1).isdigit()]
    return process.returncode, float(lines[-1]) if lines else 0.0


class Kills:
    """Counts what the kills met: `cut_short` sessions, `finished` ones, and plays `before_first` session."""

    def __init__(self, desk, seed, whole_s):
        self.desk, self.seed, self.whole_s = desk, seed, whole_s
        self.dice = random.Random(seed)
        self.cut_short = self.before_first = self.finished = 0
        self.most_lost_s = 0.0
        self.known = set()

    def kill_one(self, database, number):
        status, printed_s = play(self.desk, database, self.dice.uniform(0.02, self.whole_s))
        where = f"kill {number} (seed {self.seed}, {printed_s} s played)"
        row = self._new_session(database, printed_s, where)
        if row is None:
            self.before_first += 1
        elif status == 0 or row["state"] == "graded":
            self.finished += 1
        else:
            self._check_session(database, row, printed_s, where)

    def _new_session(self, database, printed_s, where):
        """The row of the session that the kill met; None if it had not begun."""
        if not os.path.exists(database):
            return None
        check(integrity(database) == "ok", f"{where}: {integrity(database)}")
        listed, out, err = self.desk.run("history", database, "list", "--json", "-")
        if listed != 0:
            # Killed before the first account was there, or before the file had its first table.
            none_yet = "--as" in err or "holds no records yet" in err
            check(printed_s == 0.0 and none_yet, f"{where}: the history does not open: {err}")
            return None
        check(integrity(database) == "ok", f"{where}: not sound after opening")
        rows = self.desk.json("history", database, "list")
        new = [row for row in rows if row["session"] not in self.known]
        self.known.update(row["session"] for row in rows)
        if not new:
            check(printed_s == 0.0, f"{where}: no session, although it had begun")
            return None
        check(len(new) == 1, f"{where}: {len(new)} new sessions")
        return new[0]

    def _check_session(self, database, row, printed_s, where):
        if row["state"] == "finished":  # between the finish and its grade
            self.finished += 1
        else:
            check(row["state"] == "interrupted", f"{where}: the session shows as {row['state']}")
            self.cut_short += 1
        lost_s = printed_s - row["duration_s"]
        self.most_lost_s = max(self.most_lost_s, lost_s)
        check(lost_s <= 1.0, f"{where}: {lost_s:.3f} s lost")
        proof = self.desk.json("replay", "--verify", database, row["session"])
        check(proof["holds"] and proof["chain_intact"], f"{where}: {proof}")
        report = self.desk.json("grade", database, row["session"])
        check(report["state"] == ("interrupted" if row["state"] == "interrupted" else "finished"), f"{where}: {report['state']}")
        check(report["score_max"] == 100, f"{where}: no grade")
        again = self.desk.json("replay", "--verify", database, row["session"])
        check(again["holds"] and again["grade_equal"] and again["volume_equal"], f"{where}: {again}")


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("cusp")
    arguments.add_argument("--kills", type=int, default=4)
    arguments.add_argument("--seed", type=int, default=int(time.time()))
    o = arguments.parse_args()
    print(f"seed {o.seed}")
    with Desk(o.cusp) as desk:
        desk.small_exercise()
        desk.small_script(6)
        start = time.monotonic()
        status, _ = play(desk, desk.path("whole.db"), None)
        whole_s = time.monotonic() - start
        check(status == 0, f"an undisturbed play ends with {status}")
        kills = Kills(desk, o.seed, whole_s)
        database = desk.path("0.db")
        # More of them where none of those met a running session: a loaded machine may sleep through it.
        for number in range(o.kills + 40):
            if number >= o.kills and kills.cut_short > 0:
                break
            if number % 5 == 0:  # a new file now and then: its making is a moment like any other
                database = desk.path(f"{number}.db")
                kills.known = set()
            kills.kill_one(database, number)
        print(f"{kills.cut_short + kills.finished + kills.before_first} kills in plays of {whole_s:.1f} s: {kills.cut_short} cut short, "
              f"{kills.finished} finished before, {kills.before_first} before the session began; at most {kills.most_lost_s:.3f} s lost")
        check(kills.cut_short > 0, "no kill met a running session: nothing was shown")


main()
