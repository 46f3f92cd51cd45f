"""What `cmake --install` puts where: the whole list, the man page against --help, and the files that a desktop reads.

    python3 tests/package/files.py cmake build/release

Validators that are not installed are named and left out.
"""
import configparser
import gzip
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

SOURCE = os.path.abspath(__file__ + "/../../..")
sys.path.insert(0, os.path.join(SOURCE, "package"))
import man_page  # noqa: E402

FILES = {
    "bin/cusp",
    "lib/udev/rules.d/51-cusp.rules",
    "lib/udev/rules.d/52-cusp-hid.rules",
    "share/applications/cusp.desktop",
    "share/doc/cusp/changelog.Debian.gz",
    "share/doc/cusp/copyright",
    "share/icons/hicolor/scalable/apps/cusp.svg",
    "share/icons/hicolor/scalable/mimetypes/application-x-cusp-exercise.svg",
    "share/man/man1/cusp.1.gz",
    "share/metainfo/org.cusp.cusp.metainfo.xml",
    "share/mime/packages/cusp.xml",
}
TYPE = "application/x-cusp-exercise"
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)


def text_of(path):
    opened = gzip.open(path, "rt", encoding="utf-8") if path.endswith(".gz") else open(path, encoding="utf-8")
    with opened as f:
        return f.read()


def files_below(folder):
    return {os.path.relpath(os.path.join(at, name), folder) for at, _, names in os.walk(folder) for name in names}


def spoken(roff):
    """Roff's text as --help prints it."""
    for mark, sign in (("\\-", "-"), ("\\e", "\\"), ("\\(cq", "’"), ("\\(lq", "“"), ("\\(rq", "”"), ("\\(aq", "'"), ("\\&...", "…"), ("\\&", "")):
        roff = roff.replace(mark, sign)
    return roff


def check_man_page(cusp, page):
    """Every verb has a section, and in it each option of its --help."""
    sections = {}
    for part in spoken(page).split("\n.SS ")[1:]:
        head, _, body = part.partition("\n")
        sections[head] = body.split("\n.SH ")[0]

    def look(words, name):
        listed = subprocess.run([cusp, *words, "--help"], capture_output=True, text=True, check=True,
                                env=dict(os.environ, LC_ALL="C.UTF-8")).stdout
        check(name in sections, f"cusp.1 has no section {name!r}")
        options = set(re.findall(r"^ {2}(?:-\w,)?(--[\w-]+)", listed, re.M)) - {"--help"}
        for option in options:
            check(option in sections.get(name, ""), f"cusp.1 does not name {option} of {name!r}")
        for verb in re.findall(r"^ {2}(\w+) {2,}", listed.partition("Subcommands:\n")[2], re.M):
            look([*words, *man_page.BEHIND.get(words[-1], []), verb], f"{words[-1]} {verb}")
        return len(options)

    verbs = man_page.verbs_of(cusp)
    check({"play", "validate", "history"} <= set(verbs), f"--help lists {verbs}")
    options = sum(look([verb], verb) for verb in verbs)
    check(options > 40, f"--help lists {options} options of all verbs")
    print(f"cusp.1: {len(sections)} sections for {len(verbs)} verbs, {options} options")


def check_desktop_entry(path):
    entry = configparser.ConfigParser(interpolation=None, delimiters="=")
    entry.optionxform = str
    entry.read(path, encoding="utf-8")
    entry = entry["Desktop Entry"]
    check(entry["Exec"] == "cusp %f", f"Exec={entry['Exec']}")
    check(TYPE in entry["MimeType"].split(";"), f"MimeType={entry['MimeType']}")
    for key in ("GenericName", "Comment", "Keywords"):
        check(entry.get(key) and entry.get(key + "[de]"), f"cusp.desktop has no {key} in English and German")


def check_xml(prefix):
    mime = xml.parse(os.path.join(prefix, "share/mime/packages/cusp.xml")).getroot()
    space = "{http://www.freedesktop.org/standards/shared-mime-info}"
    kind = mime.find(space + "mime-type")
    check(kind.get("type") == TYPE, f"cusp.xml describes {kind.get('type')}")
    icon = kind.find(space + "icon").get("name")
    check(f"share/icons/hicolor/scalable/mimetypes/{icon}.svg" in FILES, f"no icon {icon}")
    suffix = re.search(r'kExerciseFileSuffix = "(.*)"', text_of(os.path.join(SOURCE, "scenarios/library/exercise_file.h"))).group(1)
    check(kind.find(space + "glob").get("pattern") == "*" + suffix, f"an exercise file ends in {suffix}")
    info = xml.parse(os.path.join(prefix, "share/metainfo/org.cusp.cusp.metainfo.xml")).getroot()
    check(info.findtext("launchable") == "cusp.desktop", f"metainfo launches {info.findtext('launchable')}")
    check(info.findtext("provides/mediatype") == TYPE, f"metainfo provides {info.findtext('provides/mediatype')}")


def validate(prefix):
    """What each validator of the desktop's own says."""
    commands = [
        ["desktop-file-validate", os.path.join(prefix, "share/applications/cusp.desktop")],
        ["appstreamcli", "validate", "--no-net", os.path.join(prefix, "share/metainfo/org.cusp.cusp.metainfo.xml")],
        ["man", "--warnings", "-E", "UTF-8", "-l", "-Tutf8", "-Z", os.path.join(prefix, "share/man/man1/cusp.1.gz")],
    ]
    for command in commands:
        if shutil.which(command[0]) is None:
            print(f"left out: {command[0]} is not installed")
            continue
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", env=dict(os.environ, LC_ALL="C.UTF-8"))
        check(done.returncode == 0 and not done.stderr.strip(), f"{command[0]}: {done.stdout[-2000:] if command[0] != 'man' else ''}{done.stderr}")
    if shutil.which("update-mime-database") is None:
        print("left out: update-mime-database is not installed")
        return
    done = subprocess.run(["update-mime-database", os.path.join(prefix, "share/mime")], capture_output=True, text=True,
                          env=dict(os.environ, XDG_DATA_HOME=os.path.join(prefix, "share")))
    check(done.returncode == 0 and not done.stderr, f"update-mime-database: {done.stderr}")
    check(f":{TYPE}:*.cusp" in text_of(os.path.join(prefix, "share/mime/globs2")), "no file name leads to the type")


def main():
    cmake, build = sys.argv[1:]
    with tempfile.TemporaryDirectory(prefix="cusp-package-") as prefix:
        subprocess.run([cmake, "--install", build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
        found = files_below(prefix)
        check(found == FILES, f"installed and not listed: {sorted(found - FILES)}; listed and not installed: {sorted(FILES - found)}")
        check_man_page(os.path.join(prefix, "bin/cusp"), text_of(os.path.join(prefix, "share/man/man1/cusp.1.gz")))
        check_desktop_entry(os.path.join(prefix, "share/applications/cusp.desktop"))
        check_xml(prefix)
        validate(prefix)
    for failure in failures:
        print("FAILED: " + failure)
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
