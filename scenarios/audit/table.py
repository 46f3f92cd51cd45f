#!/usr/bin/env python3
"""Writes the audited library, scenarios/audit/library.md.

  table.py --cusp build/release/cusp [KEY ...]   audits these exercises (all without KEY), about a minute of a processor
                                                 each, two at once, and writes their rows
  table.py --from FOLDER [KEY ...]               likewise, from what an earlier run of it has left there

With --cuts KEY the exercise is audited by cuts alone (README.md): what reference, competent and novice cut at once, in the
voxels that are set and in half of them. Minutes for a tooth between neighbours, where attempts would take hours.

With --keep FOLDER the audits' reports stay there. `--was KEY=MM` audits an exercise in another size of voxels, as evidence
of a change. Rows of exercises that are not named stay. Needs build/release/cusp-library-text.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

HERE = pathlib.Path(__file__).resolve().parent
TEXT = HERE.parent.parent / "build/release/cusp-library-text"  # prints built-in exercises
TABLE = HERE / "library.md"
ROW_HEAD = "| exercise | voxels; what may change | expert, competent, novice | a tick; memory | twice the voxels | half the voxels | the audit |"
WAS_HEAD = "| exercise | from | to | which is | at half of the former | one against the other | at half of the new | a tick; memory |"


def keys():
    return subprocess.run([TEXT], check=True, capture_output=True, text=True).stdout.split()


def text_of(key):
    text = subprocess.run([TEXT, key], check=True, capture_output=True, text=True).stdout
    source = HERE.parent / "library" / key / "scenario.json"
    if source.exists() and json.loads(source.read_text()) != json.loads(text):
        sys.exit(f"{TEXT} was built before {source} changed: build cusp-library-text")
    return text


def voxel_of(key):
    return float(json.loads(text_of(key))["specimen"]["voxel_mm"])


def mm(value):
    return f"{value:.3f}".rstrip("0").rstrip(".") + " mm"


def change(c, tolerance):
    edge = abs(abs(c["score"]) - tolerance) < 0.05  # one digit would hide on which side
    text = f"{c['score']:+.{3 if edge else 1}f}"
    if c["goes_a_hand"] > 1:
        text += f" ± {c['standard_error']:.1f} ({c['goes_a_hand']} attempts)"
    if not c["passes_alike"]:
        text += ", a pass or fail parts"
    if not c["measures_alike"]:
        text += ", a measure is lost"
    return text


def cost(result):
    return f"{result['cost']['us_a_tick']:.0f} µs; {result['cost']['mb']:.0f} MB"


def scores(result):
    return ", ".join(f"{attempt['score']:.0f}" for attempt in result["goes"])


def voxel_row(report, finer):
    for row in report["choices"]:
        c = row["choice"]
        if c["aspect"] == "voxel" and (c["instead"] < c["as_set"]) == finer and "change" in row:
            return row
    return None


def twice(report):
    row = voxel_row(report, False)
    if row is None:
        return ""
    return change(row["change"], report["tolerance_points"]) + (", too coarse for its burs" if row["verdict"] == "unresolved" else "")


def half(report):
    row = voxel_row(report, True)
    return "one size" if row is None else change(row["change"], report["tolerance_points"])


def verdict(report):
    lean, now, points = report["leanest"], report["scenario"]["voxel_mm"], report["tolerance_points"]
    if voxel_row(report, True) is None and voxel_row(report, False) is None:
        return "as set"
    if not lean["detail_holds"] and not lean["changed"]:
        return "does not hold, and no finer size was taken"
    if not lean["changed"]:
        tried = "; ".join(f"{mm(s['choice']['instead'])}: {change(s['change'], points)}" for s in lean["steps"])
        return "as set" + (f" ({tried})" if tried else "")
    word = "{} would do" if lean["voxel_mm"] > now else "does not hold; {} would"
    return f"{word.format(mm(lean['voxel_mm']))}: {change(lean['change'], points)}, at half of it {change(lean['at_half_voxel'], points)}"


def row_of(report):
    s = report["scenario"]
    return (f"| {s['key']} | {mm(s['voxel_mm'])}; within {report['tolerance_points']:g} | {scores(report['as_set'])} | "
            f"{cost(report['as_set'])} | {twice(report)} | {half(report)} | {verdict(report)} |")


def was_of(report, now, report_now):
    """`report_now`: on the exercise as it is; None where this run has none."""
    s, lean, points = report["scenario"], report["leanest"], report["tolerance_points"]
    leads_there = lean["changed"] and abs(lean["voxel_mm"] - now) < 1e-9
    if not leads_there and not report_now:
        sys.exit(f"{s['key']}: from {mm(s['voxel_mm'])} the audit does not go to {mm(now)}: audit the exercise as it is too")
    refused = [st["change"] for st in (report_now or report)["leanest"]["steps"]
               if not st["taken"] and abs(st["choice"]["instead"] - s["voxel_mm"]) < 1e-9]
    against = change(lean["change"], points) if leads_there else change(refused[0], points) if refused else ""
    half_now = half(report_now) if report_now else change(lean["at_half_voxel"], points)
    result = report_now["as_set"] if report_now else lean["result"]
    return (f"| {s['key']} | {mm(s['voxel_mm'])} | {mm(now)} | {'coarser' if now > s['voxel_mm'] else 'finer'} | {half(report)} | "
            f"{against} | {half_now} | {cost(report['as_set'])} → {cost(result)} |")


def audit(cusp, key, size, folder):
    """The report's file. `size`: another than the exercise has."""
    out, scenario = folder / f"{key}.json", key
    if size:
        text = text_of(key)
        text = re.sub(r'("voxel_mm": )[0-9.]+', rf"\g<1>{size:g}", text)
        scenario = folder / f"{key}-{size:g}"
        scenario.mkdir(exist_ok=True)
        (scenario / "scenario.json").write_text(text)
        out = folder / f"{key}-{size:g}.json"
    subprocess.run([cusp, "audit", str(scenario), "--detail", "--seeds", "1", "--json", str(out)], check=True,
                   stdout=subprocess.DEVNULL)
    print(out.stem, flush=True)
    return out


def coarser_or_finer(key, size, folder):
    """A folder with the exercise in voxels of that size."""
    scenario = folder / f"{key}-{size:g}"
    scenario.mkdir(parents=True, exist_ok=True)
    text, file = re.sub(r'("voxel_mm": )[0-9.]+', rf"\g<1>{size:g}", text_of(key)), scenario / "scenario.json"
    if not file.exists() or file.read_text() != text:
        for old in scenario.glob("*.json"):  # grades of another version
            old.unlink()
        file.write_text(text)
    return scenario


def cut_score(cusp, key, size, operator, folder):
    """Kept in the folder: --keep continues an audit that was cut off. A grade of another exercise or program is made anew."""
    report = coarser_or_finer(key, size, folder) / f"{operator}.json"
    if not report.exists() or report.stat().st_mtime < os.stat(cusp).st_mtime:
        subprocess.run([cusp, "grade", str(report.parent), "--operator", operator, "--json", str(report)], check=True,
                       stdout=subprocess.DEVNULL)
    grade = json.loads(report.read_text())
    print(key, mm(size), operator, f"{grade['score']:.1f}", flush=True)
    return grade


def cuts_row(cusp, key, folder):
    size, points = voxel_of(key), json.loads(text_of(key))["tolerance"]["points"]
    with ThreadPoolExecutor(max_workers=min(2, os.cpu_count() or 1)) as pool:
        pairs = list(pool.map(lambda operator: (cut_score(cusp, key, size, operator, folder), cut_score(cusp, key, size / 2, operator, folder)),
                              ["reference", "competent", "novice"]))
    engine = pairs[0][0]["engine"]
    changes = [half["score"] - now["score"] for now, half in pairs]
    most = max(changes, key=abs)
    text = f"{most:+.1f}" + ("" if all(now["passed"] == half["passed"] for now, half in pairs) else ", a pass or fail parts")
    scores = ", ".join(f"{now['score']:.0f}" for now, half in pairs)
    return f"| {key} | {mm(size)}; within {points:g} | {scores} | by cuts alone, engine version {engine} |  | {text} | as set |"


def read_table():
    """By table: the rows that stand there, by key."""
    tables, rows = {ROW_HEAD: {}, WAS_HEAD: {}}, None
    for line in TABLE.read_text().splitlines() if TABLE.exists() else []:
        if line in tables:
            rows = tables[line]
            continue
        cell = re.match(r"\| ([a-z0-9-]+) \|", line)
        if rows is not None and cell:
            rows[cell[1]] = line
    return tables


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("keys", nargs="*", metavar="KEY")
    parser.add_argument("--cusp", help="the program")
    parser.add_argument("--from", dest="reports", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--keep", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--cuts", action="append", default=[], metavar="KEY")
    parser.add_argument("--was", action="append", default=[], metavar="KEY=MM")
    o = parser.parse_args()
    if bool(o.cusp) == bool(o.reports) or (o.cuts and not o.cusp):
        parser.error("one of --cusp and --from")

    if o.reports:
        files = [f for f in sorted(o.reports.glob("*.json")) if not o.keys or json.loads(f.read_text())["scenario"]["key"] in o.keys]
    else:
        folder = o.keep or pathlib.Path(tempfile.mkdtemp(prefix="cusp-audit-"))
        folder.mkdir(parents=True, exist_ok=True)
        jobs = [(key, None) for key in o.keys or ([] if o.was or o.cuts else keys())]
        jobs += [(key, float(size)) for key, size in (was.split("=") for was in o.was)]
        with ThreadPoolExecutor(max_workers=min(2, os.cpu_count() or 1)) as pool:
            files = list(pool.map(lambda job: audit(o.cusp, *job, folder), jobs))

    reports = [json.loads(file.read_text()) for file in files]
    now_of = {r["scenario"]["key"]: r for r in reports if abs(r["scenario"]["voxel_mm"] - voxel_of(r["scenario"]["key"])) < 1e-9}
    engines = {str(r["engine_version"]) for r in reports}
    tables = read_table()
    if set(keys()) - set(now_of) and TABLE.exists():  # rows of earlier runs stay
        engines |= set(re.findall(r"\d+", re.search(r"^Engine version ([0-9, ]+)", TABLE.read_text(), re.M)[1]))
    for report in reports:
        key = report["scenario"]["key"]
        if now_of.get(key) is report:
            tables[ROW_HEAD][key] = row_of(report)
        else:
            tables[WAS_HEAD][key] = was_of(report, voxel_of(key), now_of.get(key))
    for key in o.cuts:
        tables[ROW_HEAD][key] = cuts_row(o.cusp, key, folder)
    for key in keys():
        if key not in tables[ROW_HEAD]:
            scenario = json.loads(text_of(key))
            tables[ROW_HEAD][key] = (f"| {key} | {mm(voxel_of(key))}; within {scenario['tolerance']['points']:g} |  |  |  |  | "
                                     "not measured |")
    order = {key: i for i, key in enumerate(keys())}

    lines = [
        "# The library, audited",
        "",
        f"Engine version {', '.join(sorted(engines, key=int))}; operators: expert, competent, novice, one attempt each. Written by `table.py`.",
        "",
        "Change: of the score of the operator that it changes most, in points; over several attempts the mean and its standard error. "
        "A tick: median CPU time over the first 12 s of touch, in ticks of 1 ms (about a tooth most of them are in the air). "
        "*By cuts alone*: what reference, competent and novice cut at once (`README.md`); no attempt was played, and the row names its engine version. "
        "*Would do*: a coarser size that the search found (`README.md`) and that is not set.",
        "",
    ]
    for head, rows in tables.items():
        if head == WAS_HEAD:
            lines += ["", "## What was changed because of it", ""]
        lines += [head, "|---" * (head.count("|") - 1) + "|"]
        lines += [rows[key] for key in sorted(rows, key=lambda k: order[k])]
    TABLE.write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
