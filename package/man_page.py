#!/usr/bin/env python3
"""Writes cusp.1: the template with the verbs and options that the program itself lists under --help.

    package/man_page.py build/release/cusp package/cusp.1.in cusp.1
"""
import os
import re
import subprocess
import sys

# Verbs whose own verbs stand behind a positional: what to type before them.
BEHIND = {"history": ["DB"]}


def help_of(cusp, *words):
    env = dict(os.environ, LC_ALL="C.UTF-8")
    return subprocess.run([cusp, *words, "--help"], capture_output=True, encoding="utf-8", check=True, env=env).stdout


class Help:
    """One --help: what it does, its usage, and by section the pairs (name, text)."""

    def __init__(self, text):
        self.about, self.usage, self.sections = "", "", {}
        rows = None
        for line in text.splitlines():
            if line.startswith("Usage: "):
                self.usage = line.removeprefix("Usage: ")
            elif re.fullmatch(r"[A-Z]\w+:", line):
                rows = self.sections.setdefault(line[:-1], [])
            elif rows is None:
                self.about += line
            elif line.startswith("   "):
                rows[-1][1] = (rows[-1][1] + " " + line.strip()).strip()
            elif line.strip():
                name, _, what = line.strip().partition("  ")
                rows.append([name, what.strip()])

    def rows(self, section):
        return [(name, what) for name, what in self.sections.get(section, []) if not name.startswith("-h,")]


def roff(text):
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("’", "\\(cq").replace("“", "\\(lq").replace("”", "\\(rq")
    text = text.replace("…", "\\&...").replace("'", "\\(aq")
    return "\\&" + text if text.startswith((".", "'")) else text


def sentence(text):
    return text if text.endswith(".") else text + "."


def name_of(row):
    """The option without the values that its text lists again."""
    return re.sub(r":\{.*\}", "", row)


def section(cusp, words, heading):
    """A verb, and the verbs below it."""
    page = Help(help_of(cusp, *words))
    usage = page.usage.removeprefix(" ".join(["cusp", *(w for w in words if w.islower())]))
    out = [heading, roff(sentence(page.about)), ".PP", "\\fB" + roff(" ".join(["cusp", *words]) + usage) + "\\fR"]
    for kind in ("Positionals", "Options"):
        for name, what in page.rows(kind):
            out += [".TP", "\\fB" + roff(name_of(name)) + "\\fR", roff(sentence(what or name))]
    for verb, _ in page.rows("Subcommands"):
        out += section(cusp, [*words, *BEHIND.get(words[-1], []), verb], f".SS {roff(words[-1])} {roff(verb)}")
    return out


def verbs_of(cusp):
    return [name for name, _ in Help(help_of(cusp)).rows("Subcommands")]


def page(cusp, template):
    verbs = [line for verb in verbs_of(cusp) for line in section(cusp, [verb], f".SS {roff(verb)}")]
    version = subprocess.run([cusp, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    return template.replace("@VERSION@", version).replace("@VERBS@", "\n".join(verbs))


def main():
    cusp, template, out = sys.argv[1:]
    with open(template, encoding="utf-8") as f:
        text = page(os.path.abspath(cusp), f.read())
    with open(out, "w", encoding="utf-8") as f:
        f.write(text)


if __name__ == "__main__":
    main()
