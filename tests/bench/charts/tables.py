"""Tables of tests/bench/results: rows as dictionaries, numbers as floats, and the commit, engine version and machine that measured them."""
import csv
import math
import pathlib
import re

KINDS = ("accuracy", "cavity", "rate", "scale", "stability", "removal", "pace", "motion", "stability-full", "removal-full", "mill-full", "ablation")
OPTIONAL = ("cavity", "stability-full", "removal-full", "mill-full", "ablation")


class Missing(Exception):
    """Rows that a chart or table needs are missing; nothing is drawn."""


class Row(dict):
    """A row; an absent field is "" as text and NaN as a number."""

    def text(self, name):
        return self.get(name, "")

    def number(self, name):
        value = self.get(name, "")
        return float(value) if value != "" else math.nan

    def holds(self, name):
        return self.get(name, "") != ""

    def is_near(self, name, value):
        return math.isclose(self.number(name), value, rel_tol=1e-6)


class Table:
    def __init__(self, name, commit, engine, machine, rows):
        self.name, self.commit, self.engine, self.machine, self.rows = name, commit, engine, machine, rows

    def where(self, **texts):
        return [row for row in self.rows if all(row.text(k) == v for k, v in texts.items())]

    @property
    def source(self):
        return f"{self.machine}, {self.version}"

    @property
    def version(self):
        return f"engine {self.engine}, commit {self.short_commit}"

    @property
    def short_commit(self):
        return self.commit[:10] + "+" * self.commit.endswith("+")


def read(path):
    """Reads a table with the first line "# commit …, engine …, machine …". Raises Missing for any other file.
    A machine's name is without marks: what stands under a chart has one line."""
    with open(path, newline="", encoding="utf-8") as file:
        head = file.readline().strip()
        source = re.fullmatch(r"# commit (.+?), engine (\d+), machine (.+)", head)
        if source is None:
            raise Missing(f"{path}: no line of commit, engine version and machine")
        commit, engine, machine = source.groups()
        machine = re.sub(r"\((R|TM)\)| (Processor|CPU)$", "", machine)
        rows = [Row(row) for row in csv.DictReader(file)]
    if any(None in row or None in row.values() for row in rows):
        raise Missing(f"{path}: a line of another length")
    return Table(pathlib.Path(path).stem, commit, int(engine), machine, rows)


def read_all(folder):
    out = {}
    for kind in KINDS:
        path = pathlib.Path(folder) / f"{kind}.csv"
        if path.exists():
            out[kind] = read(path)
        elif kind not in OPTIONAL:
            raise Missing(f"{path}: no such table")
    return out


def mean(values):
    """Mean of the values that are not NaN; NaN if there are none."""
    there = [v for v in values if not math.isnan(v)]
    return sum(there) / len(there) if there else math.nan


def needed(value, what):
    if math.isnan(value):
        raise Missing(what)
    return value
