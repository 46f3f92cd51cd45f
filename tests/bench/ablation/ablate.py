#!/usr/bin/env python3
"""Turns each mechanism of mechanisms.py off in a copy of the tree, and measures what that changes.

  ablate.py CSV [--folder FOLDER] [--only WORD ...] [--run NAME ...] [--tests] [--part K/N] [--core C]
  ablate.py --texts                         only looks for the texts to be replaced, in the caller's tree
  ablate.py --join CSV PART ...             joins what several parts measured, of one commit and engine

FOLDER (default build/ablation) keeps the copy with its build folder; the caller's tree is never changed.
--only: mechanisms whose name holds a WORD. --run: only these of RUNS. --tests: runs TESTS instead, and notes which fail.
--part: every Nth mechanism, so that parts run beside each other in folders of their own. --core: runs stay on this core.
The tree as it stands is measured first, after every sixteenth mechanism, and last: their spread is that of the machine.
A run that fails is a row of its mechanism. Exit status 1: an edit does not build; 2: a text to be replaced is gone, so mechanisms.py is out of date.
"""
import argparse
import csv
import json
import math
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "planted"))

from mechanisms import MECHANISMS
from plant import ROOT, Copy, Planted, check_texts

FIELDS = ["mechanism", "part", "quantity", "value"]
AS_IT_STANDS = "as it stands"
EVERY = 16  # mechanisms between two measurements of the tree as it stands

# Small samples of the bench's own rows: they compare, and the tables of results/ measure.
RUNS = {
    "cavity": ["cavity", "--bur-radius-mm", "0.25", "--bur-radius-mm", "0.5", "--tremor-mm", "0.05", "--minutes", "2", "--budget-s", "0.3"],
    "heads": ["heads", "--bur", "57", "--bur", "35", "--bur", "368-023", "--bur", "862-012", "--axis", "fixed", "--samples", "250"],
    "plunge": ["rate", "--method", "surface", "--task", "perforation"],
    "mill": ["rate", "--full", "--bur", "4", "--bur", "57", "--axis", "fixed"],
    "accuracy": ["accuracy", "--method", "surface", "--bur-radius-mm", "0.5", "--samples", "600"],
    "removal": ["removal", "--method", "surface", "--measure", "slide", "--measure", "ridge", "--measure", "hole"],
}
TESTS = ("contact_tests", "step_tests", "tool_tests", "operators_test", "bench_accuracy_test", "bench_outer_edges_test", "bench_heads_test",
         "bench_rate_test", "bench_stability_test", "bench_removal_test")
CLEAN = ("face", "sphere", "pit", "cylinder", "edge", "corner", "groove", "step", "wall")


def worst(rows, field):
    return max((row[field] for row in rows if field in row), default=math.nan)


def mean(rows, field):
    values = [row[field] for row in rows if field in row]
    return sum(values) / len(values) if values else math.nan


def quantities(rows):
    """[name, with its unit]: value, from the rows of all runs."""
    out = {}

    def accuracy(name, of, over=worst, tail="p99"):
        out[f"{name}: angle mean, deg"] = over(of, "angle_deg_mean")
        out[f"{name}: angle {tail}, deg"] = over(of, f"angle_deg_{tail}")
        out[f"{name}: pose mean, um"] = over(of, "pose_um_mean")
        out[f"{name}: depth mean, um"] = over(of, "depth_um_mean")
        out[f"{name}: infeasible ticks"] = sum(row.get("infeasible_ticks", 0) for row in of) if of else math.nan

    def time(name, of):
        out[f"{name}: tick p50, us"] = mean(of, "tick_us_p50")
        out[f"{name}: tick p99, us"] = worst(of, "tick_us_p99")

    explored = [row for row in rows["cavity"] if row.get("motion") == "slide"]
    clean = [row for row in rows["accuracy"] if row["shape"] in CLEAN]
    accuracy("cavity", explored)
    time("cavity", explored)
    for name, of in (("clean", clean), ("cuts", [r for r in rows["accuracy"] if r["shape"] == "cut"]),
                     ("channel", [r for r in rows["accuracy"] if r["shape"] == "channel"])):
        accuracy(name, of)
        time(name, of)
    # Of heads the mean over the rows: at an edge, the last digit decides in which tick a head falls over it, and that tick the row's worst.
    for name, of in (("heads", [r for r in rows["heads"] if r["shape"] != "slot"]), ("head's slot", [r for r in rows["heads"] if r["shape"] == "slot"])):
        accuracy(name, of, mean, "p95")
        time(name, of)
    out["clean: most candidates"] = worst(clean, "max_candidates")
    out["heads: most candidates"] = worst(rows["heads"], "max_candidates")
    for row in rows["plunge"]:
        out[f"plunge, ball of {row['bur_radius_mm']} mm: tick mean, us"] = 1e6 / row["updates_per_s"]
    for row in rows["mill"]:
        name = "milling, " + row["bur"].replace("_", " ")
        out[f"{name}: tick mean, us"] = row["tick_us_mean"]
        out[f"{name}: tick p99.9, us"] = row["tick_us_p999"]
        out[f"{name}: most counted work, us"] = row["work_us_max"]
        out[f"{name}: ticks deferred, %"] = row["deferred_percent"]
    holes = [row for row in rows["removal"] if row["measure"] == "hole"]
    out["holes: infeasible ticks"] = sum(row["infeasible_ticks"] for row in holes) if holes else math.nan
    out["holes: ticks deferred, %"] = worst(holes, "deferred_percent")
    out["holes: without a cut, ms"] = worst(holes, "stuck_ms")
    out["holes: tick mean, us"] = mean(holes, "tick_us_mean")
    out["removal: slide beyond its wear, um"] = worst(rows["removal"], "excess_um_max")
    out["removal: ridges below their wear, um"] = worst(rows["removal"], "ridge_um")
    return out


def build(copy, targets):
    status, output = copy.build("release", targets)
    if status != 0:
        sys.exit(output[-3000:])


def report(copy, arguments, core=None):
    """Of one run of the copy's bench; None if it fails."""
    file = copy.path("build/ablation.json")
    on_core = [] if core is None else ["taskset", "-c", str(core)]
    status, output = copy.run(*on_core, copy.path("build/release/cusp-bench"), *arguments, "--json", file)
    if status != 0:
        print(f"{arguments[0]} ends with {status}: {output[-500:]}", file=sys.stderr, flush=True)
        return None
    with open(file, encoding="utf-8") as text:
        return json.load(text)


def measure(copy, runs, core):
    """Quantities of the copy as it is now."""
    build(copy, ["cusp-bench"])
    rows = {name: [] for name in RUNS}
    for name in runs:
        found = report(copy, RUNS[name], core)
        if found is None:
            return {f"fails: cusp-bench {name}": 1.0}
        rows[name] = found["rows"]
    return {name: value for name, value in quantities(rows).items() if not math.isnan(value)}


def failing(copy):
    """[test that fails]: 1, of the copy as it is now."""
    build(copy, TESTS)
    _, output = copy.test("release", TESTS)
    return {f"fails: {name}": 1.0 for name in dict.fromkeys(re.findall(r"\[  FAILED  \] (\w+\.\w+)", output))}


def commit():
    """Of the caller's tree; with a + where files have changed since."""
    run = lambda *words: subprocess.run(["git", *words], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
    return run("rev-parse", "HEAD") + ("+" if run("status", "--porcelain", "--untracked-files=no", "engine") else "")


def write(file, head, rows):
    with open(file, "w", newline="", encoding="utf-8") as out:
        out.write(head + "\n")
        table = csv.writer(out, lineterminator="\n")
        table.writerow(FIELDS)
        table.writerows(rows)


def join(file, parts):
    heads, rows = set(), []
    for part in parts:
        with open(part, newline="", encoding="utf-8") as text:
            heads.add(text.readline().strip())
            rows += list(csv.reader(text))[1:]
    if len(heads) != 1:
        sys.exit("ablate.py: the parts are of different commits, engines or machines")
    order = {AS_IT_STANDS: -1, **{m.name: i for i, m in enumerate(MECHANISMS)}}
    write(file, heads.pop(), sorted(rows, key=lambda row: order[row[0]]))


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("csv", nargs="?")
    arguments.add_argument("parts", nargs="*")
    arguments.add_argument("--folder", default=os.path.join(ROOT, "build", "ablation"))
    arguments.add_argument("--only", action="append", default=[])
    arguments.add_argument("--run", action="append", choices=RUNS)
    arguments.add_argument("--tests", action="store_true")
    arguments.add_argument("--part", default="1/1")
    arguments.add_argument("--core", type=int)
    arguments.add_argument("--texts", action="store_true")
    arguments.add_argument("--join", action="store_true")
    o = arguments.parse_args()
    check_texts(MECHANISMS)
    if o.texts:
        return
    if o.csv is None:
        arguments.error("CSV is missing")
    if o.join:
        return join(o.csv, o.parts)
    k, n = (int(word) for word in o.part.split("/"))
    asked = [m for m in MECHANISMS if not o.only or any(word in m.name for word in o.only)][k - 1::n]
    copy, at, rows = Copy(o.folder), commit(), []
    build(copy, ["cusp-bench"])
    head = report(copy, ["removal", "--method", "surface", "--measure", "mixed"])

    def note(name, part):
        found = failing(copy) if o.tests else measure(copy, o.run or RUNS, o.core)
        rows.extend([name, part, quantity, f"{value:.6g}"] for quantity, value in found.items())
        write(o.csv, f"# commit {at}, engine {head['engine']}, machine {head['machine']}", rows)
        print(name, flush=True)

    for i, mechanism in enumerate(asked):
        if i % EVERY == 0:
            note(AS_IT_STANDS, "")
        with Planted(copy, mechanism):
            note(mechanism.name, mechanism.part)
    note(AS_IT_STANDS, "")


if __name__ == "__main__":
    main()
