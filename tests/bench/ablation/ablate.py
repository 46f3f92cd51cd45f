#!/usr/bin/env python3
"""Turns each mechanism of mechanisms.py off in a copy of the tree, and measures what that changes.

  ablate.py CSV [--folder FOLDER] [--only WORD] [--part K/N] [--core C]
  ablate.py --texts                         only looks for the texts to be replaced, in the caller's tree
  ablate.py --join CSV PART ...             joins what several parts measured, of one commit and engine

FOLDER (default build/ablation) keeps the copy with its build folder; the caller's tree is never changed. --part: every Nth
mechanism, so that parts run beside each other in folders of their own. --core: runs stay on this core.
The tree as it stands is measured first, after every eighth mechanism, and last: their spread is that of the machine.
Exit status 1: an edit does not build or a run fails; 2: a text to be replaced is gone, so mechanisms.py is out of date.
"""
import argparse
import csv
import json
import math
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "planted"))

from mechanisms import MECHANISMS
from plant import ROOT, Copy, Planted, check_texts

FIELDS = ["mechanism", "part", "quantity", "value"]
AS_IT_STANDS = "as it stands"
EVERY = 8  # mechanisms between two measurements of the tree as it stands

# Small samples of the bench's own rows: they compare, and the tables of results/ measure.
RUNS = {
    "cavity": ["cavity", "--bur-radius-mm", "0.25", "--tremor-mm", "0.05", "--minutes", "2", "--budget-s", "0.6"],
    "heads": ["heads", "--bur", "57", "--bur", "35", "--bur", "368-023", "--axis", "fixed", "--samples", "400"],
    "mill": ["rate", "--full", "--bur", "4", "--bur", "57", "--axis", "fixed"],
    "accuracy": ["accuracy", "--method", "surface", "--bur-radius-mm", "0.5", "--samples", "1000"],
    "removal": ["removal", "--method", "surface", "--measure", "slide", "--measure", "ridge"],
}
CLEAN = ("face", "sphere", "pit", "cylinder", "edge", "corner", "groove", "step", "wall")


def worst(rows, field):
    return max((row[field] for row in rows if field in row), default=math.nan)


def slowest(rows):
    return min((row["updates_per_s"] for row in rows if "updates_per_s" in row), default=math.nan)


def mean(rows, field):
    values = [row[field] for row in rows if field in row]
    return sum(values) / len(values) if values else math.nan


def quantities(rows):
    """[name, with its unit]: value, from the rows of all runs."""
    out = {}

    def accuracy(name, of):
        out[f"{name}: angle mean, deg"] = worst(of, "angle_deg_mean")
        out[f"{name}: angle p99, deg"] = worst(of, "angle_deg_p99")
        out[f"{name}: pose mean, um"] = worst(of, "pose_um_mean")
        out[f"{name}: depth mean, um"] = worst(of, "depth_um_mean")
        out[f"{name}: infeasible ticks"] = sum(row.get("infeasible_ticks", 0) for row in of)

    def time(name, of):
        out[f"{name}: tick p50, us"] = mean(of, "tick_us_p50")
        out[f"{name}: tick p99, us"] = worst(of, "tick_us_p99")

    explored = [row for row in rows["cavity"] if row.get("motion") == "slide"]
    accuracy("cavity", explored)
    time("cavity", explored)
    for name, of in (("clean", [r for r in rows["accuracy"] if r["shape"] in CLEAN]), ("cuts", [r for r in rows["accuracy"] if r["shape"] == "cut"]),
                     ("channel", [r for r in rows["accuracy"] if r["shape"] == "channel"]),
                     ("heads", [r for r in rows["heads"] if r["shape"] != "slot"]), ("head's slot", [r for r in rows["heads"] if r["shape"] == "slot"])):
        accuracy(name, of)
        time(name, of)
        if name != "clean":
            out[f"{name}: updates/s, k"] = slowest(of) / 1000.0
    out["clean: candidates, most"] = worst([r for r in rows["accuracy"] if r["shape"] in CLEAN], "max_candidates")
    out["heads: candidates, most"] = worst(rows["heads"], "max_candidates")
    for row in rows["mill"]:
        name = "milling, " + row["bur"].replace("_", " ")
        out[f"{name}: tick mean, us"] = row["tick_us_mean"]
        out[f"{name}: tick p99.9, us"] = row["tick_us_p999"]
        out[f"{name}: ticks deferred, %"] = row["deferred_percent"]
    out["removal: slide beyond its wear, um"] = worst(rows["removal"], "excess_um_max")
    out["removal: ridges, um"] = max((abs(row["ridge_um"]) for row in rows["removal"] if "ridge_um" in row), default=math.nan)
    return out


def measure(copy, core):
    """Quantities, engine and machine of the copy as it is now."""
    status, output = copy.build("release", ["cusp-bench"])
    if status != 0:
        sys.exit(output[-3000:])
    rows, head = {}, {}
    for name, arguments in RUNS.items():
        file = copy.path(f"build/{name}.json")
        on_core = [] if core is None else ["taskset", "-c", str(core)]
        status, output = copy.run(*on_core, copy.path("build/release/cusp-bench"), *arguments, "--json", file)
        if status != 0:
            print(f"{name} ends with {status}: {output[-500:]}", file=sys.stderr, flush=True)
            return None, head  # a mechanism without which the bench's own check fails
        with open(file, encoding="utf-8") as text:
            head = json.load(text)
        rows[name] = head["rows"]
    return quantities(rows), head


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
    arguments.add_argument("--only", default="")
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
    asked = [m for m in MECHANISMS if o.only in m.name][k - 1::n]
    copy, at, rows = Copy(o.folder), commit(), []

    def note(name, part):
        found, head = measure(copy, o.core)
        if found is None:
            found = {"fails": 1.0}
        rows.extend([name, part, quantity, f"{value:.6g}"] for quantity, value in found.items() if not math.isnan(value))
        if head:
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
