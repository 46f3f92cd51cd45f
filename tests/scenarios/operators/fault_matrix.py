#!/usr/bin/env python3
"""Writes the fault matrix, fault_matrix.md and fault_matrix.svg beside this file.

  fault_matrix.py --program build/release/cusp-fault-matrix [--keep FOLDER] [KEY ...]
  fault_matrix.py --program build/release/cusp-fault-matrix --from FOLDER

Cuts and grades every single fault at its three sizes on these exercises (all without KEY): half a minute of a processor for a
block, one to three for a tooth, two at once. --keep leaves what was measured in FOLDER; what lies there is not measured
again. --from draws what lies in FOLDER, by the criteria and cross-talk as the program has them. Needs matplotlib, and
build/release/cusp-library-text beside the program.
"""
import argparse
import fnmatch
import io
import json
import os
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "bench" / "charts"))
import style  # noqa: E402

SIZES = ("small", "medium", "large")
# Columns of the picture: criteria that belong together.
GROUPS = (("target", ("target_removed",)), ("depth", ("depth_*",)), ("floor over-cut", ("overcut_*_floor",)),
          ("wall over-cut", ("overcut_*_side",)), ("sound lost", ("sound_lost",)), ("floor form", ("floor_*",)),
          ("wall angles", ("wall_angle_*", "convergence_*")), ("isthmus", ("isthmus_width",)), ("ridges", ("ridge_*",)),
          ("pulp", ("remaining_over_pulp", "pulp_exposure")), ("protected", ("protected_*",)),
          ("contact", ("contact_broken", "clearance_*")), ("box", ("gingival_*", "box_height", "axial_*")),
          ("margin", ("cavosurface_*", "unsupported_*")), ("surface", ("surface_within_*",)), ("caries", ("caries_*",)), ("coolant", ("dry_*",)))


def run(program, *arguments):
    return subprocess.run([str(program), *arguments], check=True, capture_output=True, text=True).stdout


def library(program):
    return run(program.parent / "cusp-library-text").split()


def measured(program, key, folder):
    file = folder / f"{key}.json"
    if not file.exists():
        text = run(program, key)
        file.write_text(text)
        print(key, flush=True)
    return file


def judged(program, file):
    return json.loads(run(program, "--judge", str(file)))


def matches(patterns, criterion):
    """A criterion of one of several targets, metric@target, is its metric's."""
    return any(fnmatch.fnmatchcase(criterion.split("@")[0], pattern) for pattern in patterns)


def losses(matrix, fault, size):
    """[criterion]: share of its points that the fault costs."""
    before = matrix["reference"]["criteria"]
    after = matrix["faults"][fault]["sizes"][size]["criteria"]
    return {key: at["share"] - after[key]["share"] for key, at in before.items() if key in after}


def shares(values):
    """0.25 0.5 1; a range where the exercises differ."""
    return " ".join(f"{low:.1f}" if f"{low:.1f}" == f"{high:.1f}" else f"{low:.1f}–{high:.1f}" for low, high in values)


def row_of(fault, matrices):
    name = fault["fault"]
    made = [m for m in matrices if m["faults"].get(name)]
    sizes = ", ".join(f"{s:g}" for s in fault["sizes"])
    if not made:
        return f"| {name} | {sizes} {fault['unit']} | 0 of {len(matrices)} | | | | |"
    rows = [m["faults"][name] for m in made]
    own = [(min(r["own"][i] for r in rows), max(r["own"][i] for r in rows)) for i in range(3)]
    lost = []
    for i in range(3):
        points = sorted(round(m["reference"]["score"] - m["faults"][name]["sizes"][i]["score"]) for m in made)
        lost.append(f"{points[0]}" if points[0] == points[-1] else f"{points[0]} to {points[-1]}")
    rubric = sum(r["by_rubric"] for r in rows)
    bad = sum(bool(r["violations"]) for r in rows)
    return (f"| {name} | {sizes} {fault['unit']} | {len(made)} of {len(matrices)} | {shares(own)} | {rubric} of {len(made)} | {', '.join(lost)} | "
            f"{'**' + str(bad) + '**' if bad else 'none'} |")


def violations(matrices):
    """(fault, what, reason): where, with the loss."""
    out = {}
    for m in matrices:
        for fault, row in m["faults"].items():
            for v in (row or {}).get("violations", []):
                out.setdefault((fault, v["what"], v["reason"] or "**unexplained**"), []).append(f"{m['exercise']} {v['loss']:.1f}")
    return out


def table(faults, matrices, missing):
    lines = [
        "# The fault matrix", "",
        f"Exercises: {', '.join(m['exercise'] for m in matrices)}. Written by `fault_matrix.py`; drawn in `fault_matrix.svg`.", "",
        f"Figures of evaluator {matrices[0]['evaluator']}.", "",
        *([f"Not measured yet: {', '.join(missing)}.", ""] if missing else []),
        "*Loss*: share of its own criteria's points that a fault costs, small, medium and large; the mean of those that lose any. "
        "It counts by the bands alone, the exercise's and for other measurements the default ones. *By rubric*: exercises whose own "
        "rubric has a criterion that loses. *Points*: what the exercise's score loses. *Violations*: exercises where the fault is not "
        "found, its losses are not in order, or it costs another's criteria more than a tenth; a default one counts there if the reference has full points by it.", "",
        "| fault | sizes | possible | loss | by rubric | points | violations |", "|---|---|---|---|---|---|---|"]
    lines += [row_of(fault, matrices) for fault in faults]
    lines += ["", "## Violations", "", "| fault | what | where, loss | cause |", "|---|---|---|---|"]
    lines += [f"| {fault} | {what} | {', '.join(where)} | {reason} |" for (fault, what, reason), where in violations(matrices).items()]
    lines += ["", "## Criteria", "", "| fault | its own | may move too | for |", "|---|---|---|---|"]
    lines += [f"| {f['fault']} | {', '.join(f['own'])} | {', '.join(f['cross_talk'])} | {f['cross_talk_reason']} |" for f in faults]
    return "\n".join(lines).replace("_*", "_\\*") + "\n"


def cell(fault, size, group, matrices):
    """(loss, kind): the largest loss over exercises and criteria of the group; kind: own, cross-talk, violation or none."""
    best, kind = None, "none"
    for m in matrices:
        if not m["faults"].get(fault["fault"]):
            continue
        wrong = {v["what"] for v in m["faults"][fault["fault"]]["violations"]}
        for key, loss in losses(m, fault["fault"], size).items():
            if not matches(group[1], key):
                continue
            if matches(fault["own"], key) and loss > 0.02:
                kind = "own"
            if key in wrong and loss > 0.1 and kind != "own":
                kind = "violation"
            best = max(loss, best if best is not None else 0.0)
    return best, kind


def picture(faults, matrices):
    shown = [f for f in faults if any(m["faults"].get(f["fault"]) for m in matrices)]
    rows = [(f, size) for f in shown for size in range(3)]
    wide, high = 980, 150 + 15 * len(rows) + 60
    fig = style.figure(wide, high, "Single faults and the criteria that they cost",
                       f"Largest loss over {len(matrices)} exercises, as a share of a criterion's points. Each fault: small, medium, large.",
                       "Frame: the fault's own criteria. Cross: a violation, named in fault_matrix.md. Grey: not measured in these exercises.")
    axes = style.panel(fig, 150, 130, wide - 60, high - 50)
    for y, (fault, size) in enumerate(rows):
        for x, group in enumerate(GROUPS):
            loss, kind = cell(fault, size, group, matrices)
            colour = "#F3F4F6" if loss is None else style.plt.cm.Blues(0.9 * min(1.0, max(0.0, loss)))
            axes.add_patch(style.plt.Rectangle((x + 0.04, y + 0.04), 0.92, 0.92, facecolor=colour,
                                               edgecolor=style.VERMILION if kind == "own" else "none", linewidth=1.1))
            if kind == "violation":
                axes.text(x + 0.5, y + 0.55, "×", ha="center", va="center", color=style.VERMILION, fontsize=11, fontweight="bold")
    axes.set_xlim(0, len(GROUPS))
    axes.set_ylim(len(rows), 0)
    axes.grid(False)
    axes.xaxis.tick_top()
    axes.set_xticks([x + 0.5 for x in range(len(GROUPS))], [name for name, _ in GROUPS], rotation=40, ha="left")
    axes.set_yticks([3 * i + 1.5 for i in range(len(shown))], [f["fault"] for f in shown])
    axes.tick_params(length=0)
    for spine in axes.spines.values():
        spine.set_visible(False)
    for i in range(1, len(shown)):
        axes.axhline(3 * i, color=style.QUIET, linewidth=0.5)
    out = io.StringIO()
    fig.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    return "\n".join(line.rstrip() for line in out.getvalue().splitlines()) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("keys", nargs="*", metavar="KEY")
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--from", dest="measured", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER")
    o = parser.parse_args()
    program = o.program.resolve()
    keys = library(program)
    if o.measured:
        files = [o.measured / f"{key}.json" for key in keys if (o.measured / f"{key}.json").exists()]
    else:
        folder = o.keep or pathlib.Path(tempfile.mkdtemp(prefix="cusp-faults-"))
        folder.mkdir(parents=True, exist_ok=True)
        with ThreadPoolExecutor(max_workers=min(2, os.cpu_count() or 1)) as pool:
            files = list(pool.map(lambda key: measured(program, key, folder), o.keys or keys))
    if not files:
        parser.error("nothing was measured")
    matrices = [judged(program, file) for file in files]
    if len({m["evaluator"] for m in matrices}) > 1:
        parser.error("some were measured by another evaluator: measure them again")
    faults = json.loads(run(program))
    missing = [key for key in keys if key not in {m["exercise"] for m in matrices}]
    (HERE / "fault_matrix.md").write_text(table(faults, matrices, missing), encoding="utf-8")
    (HERE / "fault_matrix.svg").write_text(picture(faults, matrices), encoding="utf-8")


if __name__ == "__main__":
    main()
