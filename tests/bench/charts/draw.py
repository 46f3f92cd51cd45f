#!/usr/bin/env python3
"""Draws every chart and table of the bench from its CSV files.

  draw.py FOLDER [--readme FILE ...] [--check]

FOLDER holds the tables that `cusp-bench chart --out FOLDER` measured; charts (SVG) and tables (Markdown) are written beside
them. --readme puts each table between its marks in a README. --check writes nothing, and fails if a file differs.
Exit status: 0 done, 1 failed with one line on stderr, 2 wrong usage.
"""
import argparse
import io
import pathlib
import sys

import contact_charts
import markdown_tables
import removal_charts
import stability_charts
import style
import task_charts
from tables import Missing, read_all


def svg(figure):
    """The figure as SVG without date and random ids, so that equal figures give equal text."""
    out = io.StringIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    style.plt.close(figure)
    return "\n".join(line.rstrip() for line in out.getvalue().splitlines()) + "\n"


def write_tables(tables):
    """[name]: text of every Markdown table. Raises Missing with the names of missing rows."""
    t = tables
    return {
        "methods.md": markdown_tables.methods(t["accuracy"], t["rate"], t.get("cavity")),
        "stability.md": markdown_tables.stability(t["stability"]),
        "removal.md": markdown_tables.removal(t["removal"], t.get("removal-full")),
        "figures.md": markdown_tables.figures(t),
        **({"milling.md": markdown_tables.milling(t["mill-full"])} if "mill-full" in t else {}),
        **({"ablation.md": markdown_tables.ablation(t["ablation"])} if "ablation" in t else {}),
    }


def draw_all(tables):
    """[name]: text of every file. Raises Missing with the names of missing rows."""
    t = tables
    out = {
        **write_tables(t),
        "speed-accuracy-r025.svg": svg(contact_charts.speed_against_accuracy(t["accuracy"], t["rate"], 0.25, t.get("cavity"))),
        "speed-accuracy-r050.svg": svg(contact_charts.speed_against_accuracy(t["accuracy"], t["rate"], 0.5, t.get("cavity"))),
        "error-voxel.svg": svg(contact_charts.error_against_voxel(t["accuracy"])),
        "cost-size.svg": svg(contact_charts.cost_against_size(t["rate"], t["scale"])),
        "rates-by-task.svg": svg(task_charts.rates_by_task(t["pace"])),
        "displacement-force.svg": svg(task_charts.displacement_and_force(t["motion"])),
        "stability-map.svg": svg(stability_charts.stability_map(t["stability"])),
        "stability-damping.svg": svg(stability_charts.stiffness_against_damping(t["stability"])),
        "drilling-depth.svg": svg(removal_charts.depth_over_time(t["removal"])),
        "drilling-speed-error.svg": svg(removal_charts.speed_error(t["removal"])),
    }
    if "stability-full" in t:
        out["stability-cells.svg"] = svg(stability_charts.stiffness_by_cell(t["stability-full"]))
    return out


TABLES = ("methods", "stability", "removal", "figures")


def placed(text, drawn, name):
    """The README's text with each table between its two marks. Raises Missing without marks, or for a mark without its pair."""
    shown = [table for table in TABLES if f"<!-- {table}: written by draw.py -->" in text or f"<!-- /{table} -->" in text]
    if not shown:
        raise Missing(f"{name}: no place for a table")
    for table in shown:
        begin, end = f"<!-- {table}: written by draw.py -->\n", f"<!-- /{table} -->\n"
        if text.count(begin) != 1 or text.count(end) != 1:
            raise Missing(f"{name}: no place for the table of {table}")
        text = text[: text.index(begin) + len(begin)] + drawn[f"{table}.md"] + text[text.index(end):]
    return text


def differing(files):
    """The Markdown files whose text on disk differs, and every file that is missing."""
    # Charts depend on the release of matplotlib; tables do not.
    return [str(f) for f, text in files.items()
            if not f.exists() or (f.suffix == ".md" and f.read_text(encoding="utf-8") != text)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--readme", type=pathlib.Path, action="append", default=[])
    parser.add_argument("--check", action="store_true")
    args = parser.parse_args()
    try:
        drawn = draw_all(read_all(args.folder))
        files = {args.folder / name: text for name, text in drawn.items()}
        for readme in args.readme:
            files[readme] = placed(readme.read_text(encoding="utf-8"), drawn, readme)
        if args.check:
            if names := differing(files):
                raise Missing("not what the tables give: " + ", ".join(names))
            return 0
        for file, text in files.items():
            file.write_text(text, encoding="utf-8")
    except (Missing, OSError) as failure:
        print(f"draw.py: {failure}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
