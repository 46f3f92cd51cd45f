"""Broken, missing, newer and unwritable things: one clear sentence, exit status 1, nothing half-written.

  bad_input.py CUSP
"""
import contextlib
import json
import os
import resource
import shutil
import signal
import sqlite3
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import HUNG_S, Desk, check, integrity, one_sentence  # noqa: E402


def refused(desk, what, *arguments, names=(), **more):
    status, out, err = desk.run(*arguments, **more)
    check(status == 1, f"{what}: exit {status}: {out}{err}")
    one_sentence(err, what)
    for name in names:
        check(name in err, f"{what}: {name!r} is not in {err!r}")
    check(out.strip() == "" or arguments[0] == "validate", f"{what}: stdout {out!r}")
    print(f"{what}: {err.strip()}")


def scenarios(desk):
    script = desk.small_script(1)

    def play(scenario):
        return ("play", scenario, "--script", script, "--db", desk.path("s.db"), "--out", desk.path("o"))

    def broken(name, text):
        with open(desk.path(name), "w", encoding="utf-8") as f:
            f.write(text)
        return desk.path(name)

    for verb in (lambda s: ("validate", s), play):
        refused(desk, "missing scenario", *verb(desk.path("none.json")), names=("none.json",))
        refused(desk, "broken JSON", *verb(broken("broken.json", '{"format": 1,\n  "id": }')))
        refused(desk, "unknown key", *verb(desk.small_exercise("key.json", lambda s: s.update(colour="red"))), names=("colour",))
        refused(desk, "future format", *verb(desk.small_exercise("future.json", lambda s: s.update(format=99))))

        def bad_depth(s):
            s["target"]["depth_mm"] = "deep"

        refused(desk, "wrong type", *verb(desk.small_exercise("type.json", bad_depth)), names=("depth_mm",))

        def soft(s):
            s["tissues"][0]["stiffness_n_per_mm"] = 1e-300

        refused(desk, "a number out of its range", *verb(desk.small_exercise("soft.json", soft)), names=("/tissues/0/stiffness_n_per_mm",))
        refused(desk, "a pass mark of nothing", *verb(desk.small_exercise("pass.json", lambda s: s["rubric"].update({"pass": 0}))),
                names=("/rubric/pass",))

        def lost_volume(s):
            s["specimen"] = {"volume": "none.nrrd"}

        refused(desk, "missing volume", *verb(desk.small_exercise("volume.json", lost_volume)), names=("none.nrrd",))
    refused(desk, "no exercise file", "validate", broken("notes.cusp", "not an exercise"), names=("notes.cusp",))
    refused(desk, "no exercise file in capitals", "validate", broken("NOTES.CUSP", "not an exercise"), names=("not an exercise that Cusp saved",))
    refused(desk, "missing exercise file", "validate", desk.path("none.cusp"), names=("none.cusp",))
    refused(desk, "missing script", "play", "channel-1", "--script", desk.path("none.csv"), "--db", desk.path("s.db"),
            "--out", desk.path("o"), names=("none.csv",))
    for script in (desk.folder, "/dev/zero"):
        refused(desk, f"{script} as a script", "play", "channel-1", "--script", script, "--db", desk.path("s.db"), "--out", desk.path("o"),
                names=(script, "cannot be read"))
    with open(desk.path("endless.csv"), "wb") as f:
        f.truncate(1 << 34)  # of zeros that the disk need not hold
    refused(desk, "a script larger than memory", "play", "channel-1", "--script", desk.path("endless.csv"), "--db", desk.path("s.db"),
            "--out", desk.path("o"), names=("endless.csv", "larger"))
    os.remove(desk.path("endless.csv"))
    refused(desk, "a device without an end as a pack", "verify", "/dev/zero", names=("/dev/zero", "cannot be read"))
    with open(desk.path("bad.csv"), "w", encoding="utf-8") as f:
        f.write("elapsed_us,x,y,z,qx,qy,qz,qw,buttons,pedal\n1000,0,0,zero,0,0,0,32767,0,0\n")
    refused(desk, "broken script", "play", desk.small_exercise(), "--script", desk.path("bad.csv"), "--db", desk.path("s.db"),
            "--out", desk.path("o"), names=("bad.csv",))
    check(not os.path.exists(desk.path("s.db")), "what was refused left a database")


def audits(desk):
    """Before what takes minutes is begun, everything that can be refused is; and a stop leaves the exercise as it was."""
    refused(desk, "audit of nothing", "audit", desk.path("none.json"), names=("none.json",))
    refused(desk, "audit of broken JSON", "audit", desk.path("broken.json"), "--apply", names=("broken.json",))
    refused(desk, "audit of a folder without an exercise", "audit", desk.folder)
    small = desk.small_exercise("audit.json")
    with open(small, "rb") as f:
        before = f.read()
    refused(desk, "a copy into no folder", "audit", small, "--apply", "-o", desk.path("none", "c.json"), names=("c.json",))
    refused(desk, "figures into no folder", "audit", small, "--json", desk.path("none", "f.json"), names=("f.json",))
    os.mkdir(desk.path("folder.json"))
    refused(desk, "figures over a folder", "audit", small, "--json", desk.path("folder.json"), names=("folder.json",))
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        there = sorted(os.listdir(desk.folder))
        with subprocess.Popen([desk.cusp, "audit", small, "--seeds", "1", "--apply", "--progress"], stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=desk.environment(),
                              preexec_fn=lambda: signal.signal(signal.SIGHUP, signal.SIG_DFL)) as run:  # nohup may have it ignored
            check("%" in run.stderr.readline(), "no progress was printed")
            run.send_signal(number)
            out, err = run.communicate(timeout=HUNG_S)
        last = err.strip().splitlines()[-1]
        check(run.returncode == 1 and out == "", f"stopped audit: exit {run.returncode}: {out}{err}")
        check(last.startswith("cusp: ") and "%" not in last, f"stopped audit: {err!r}")
        with open(small, "rb") as f:
            check(f.read() == before, "a stopped audit touched the exercise")
        check(sorted(os.listdir(desk.folder)) == there, "a stopped audit left files")


def audits_of_what_changes(desk):
    """An edit that is saved while the exercise is audited stays. A copy is not parted from its volume."""
    def quick(s):
        s["phenomena"], s["tolerance"] = ["friction"], {"points": 20}
        s["tissues"][0]["speed_mm_s"] = 20

    for out_file in ((), ("-o", desk.path("edited.json"))):
        edited = desk.small_exercise("edited.json", quick)
        with subprocess.Popen([desk.cusp, "audit", edited, "--seeds", "1", "--apply", "--progress", *out_file], stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=desk.environment()) as run:
            check("%" in run.stderr.readline(), "no progress was printed")
            desk.small_exercise("edited.json", lambda s: (quick(s), s["title"].update(en="Edited meanwhile")))
            out, err = run.communicate(timeout=HUNG_S)
        check(run.returncode == 1 and "Written" not in out and "edited.json" in err,
              f"audit of what changes {out_file}: exit {run.returncode}: {out}{err}")
        with open(edited, encoding="utf-8") as f:
            check(json.load(f)["title"]["en"] == "Edited meanwhile", f"an audit wrote over an edit {out_file}")

    status, _, err = desk.run("specimen", "block", "--voxel-mm", "0.4", "-o", desk.path("block.nrrd"))
    check(status == 0, f"a block: {err}")
    with_volume = desk.small_exercise("own.json", lambda s: s.update(specimen={"volume": "block.nrrd", "voxel_mm": 0.4}))
    os.mkdir(desk.path("elsewhere"))
    refused(desk, "a copy without its volume", "audit", with_volume, "--seeds", "1", "--apply", "-o", desk.path("elsewhere", "c.json"),
            names=("block.nrrd", "folder"))


def databases(desk):
    scenario, script = desk.small_exercise(), desk.small_script(1)
    status, out, err = desk.run("play", scenario, "--script", script, "--db", desk.path("good.db"), "--out", desk.path("o"))
    check(status == 0, f"play: {err}")
    session = out.strip()
    check(len(session) == 36 and out == session + "\n", f"the id stands alone on stdout: {out!r}")
    refused(desk, "missing database", "replay", desk.path("none.db"), session, names=("none.db",))
    check(not os.path.exists(desk.path("none.db")), "a missing database was made")
    refused(desk, "unknown session", "replay", desk.path("good.db"), "019a9f3c-6a00-7c41-9b1e-000000000000")
    with open(desk.path("text.db"), "w", encoding="utf-8") as f:
        f.write("this is no database\n" * 1000)
    refused(desk, "no database", "history", desk.path("text.db"), "list", names=("text.db",))
    shutil.copy(desk.path("good.db"), desk.path("newer.db"))
    with contextlib.closing(sqlite3.connect(desk.path("newer.db"))) as db:
        db.execute("PRAGMA user_version = 999")
    with open(desk.path("newer.db"), "rb") as f:
        before = f.read()
    refused(desk, "newer database", "history", desk.path("newer.db"), "list", names=("newer.db",))
    refused(desk, "play into a newer database", "play", scenario, "--script", script, "--db", desk.path("newer.db"), "--out",
            desk.path("o"))
    with open(desk.path("newer.db"), "rb") as f:
        check(f.read() == before, "a newer database was touched")
    refused(desk, "unknown account", "history", desk.path("good.db"), "list", "--as", "nobody", CUSP_PASSWORD="wrong-password")
    for rubric in (desk.path("text.db"), "/dev/zero"):
        refused(desk, f"{rubric} as a rubric", "grade", desk.path("good.db"), session, "--rubric", rubric, names=(rubric,))
    with open(desk.path("free.json"), "w", encoding="utf-8") as f:
        f.write('{"pass": 0, "criteria": [], "critical": []}')
    refused(desk, "rubric that validate refuses", "grade", desk.path("good.db"), session, "--rubric", desk.path("free.json"), names=("/rubric",))
    check(desk.run("specimen", "block", "--voxel-mm", "0.5", "-o", desk.path("coarse.nrrd"))[0] == 0, "a coarse block is grown")
    refused(desk, "volume of other voxels", "grade", scenario, "--volume", desk.path("coarse.nrrd"), names=("0.500", "0.250"))
    check(desk.run("specimen", "paper-block", "-o", desk.path("paper.nrrd"))[0] == 0, "the paper's block is made")
    refused(desk, "volume of finer voxels", "grade", "channel-1", "--volume", desk.path("paper.nrrd"), names=("paper.nrrd",))
    refused(desk, "no volume", "grade", scenario, "--volume", desk.path("text.db"))
    refused(desk, "missing prepared volume", "grade", scenario, "--volume", desk.path("none.nrrd"), names=("none.nrrd",))
    def too_narrow(s):
        s["target"] = {"kind": "box", "from_mm": [0, 0, -1], "size_mm": [3, 0.4, 4]}
        s["format"] = 2
    narrow = desk.small_exercise("narrow.json", too_narrow)
    refused(desk, "target that no bur fits", "grade", narrow, "--operator", "reference")
    refused(desk, "fault that a block cannot have", "grade", scenario, "--operator", "exposed_pulp:small", names=("exposed_pulp:small",))
    refused(desk, "pulp that a block has not", "grade", scenario, "--operator", "pulp", names=("pulp",))
    refused(desk, "target that no bur fits, played", "play", narrow, "--script", "expert", "--out", desk.path("o"))
    for what, arguments, names in (("unknown template", ("class-9", "--tooth", "36"), ("class-9",)),
                                   ("incisor", ("class-1-adhesive", "--tooth", "11"), ("11",)),
                                   ("unknown parameter", ("class-1-adhesive", "--tooth", "36", "--set", "dept=2"), ("dept",)),
                                   ("parameter out of range", ("class-1-adhesive", "--tooth", "36", "--set", "depth=9"), ("depth", "2.6")),
                                   ("class II without a box", ("class-2-adhesive", "--tooth", "36", "--set", "mesial=0"), ("mesial box",))):
        refused(desk, what, "template", "fit", *arguments, "--out", desk.path("fitted"), names=names)
    check(not os.path.exists(desk.path("fitted", "scenario.json")), "a refused template was written")
    for what, arguments, names in (("a volume that is none", ("class-1-adhesive", "--tooth", "36", "--volume", desk.path("text.db")), ("text.db",)),
                                   ("a missing volume", ("class-1-adhesive", "--tooth", "36", "--volume", desk.path("none.nrrd")), ("none.nrrd",)),
                                   ("a block for a tooth", ("class-1-adhesive", "--tooth", "36", "--volume", desk.path("paper.nrrd")), ("mesial_axis",)),
                                   ("a volume for no tooth", ("class-1-adhesive", "--tooth", "99", "--volume", desk.path("paper.nrrd")), ("99",))):
        refused(desk, what, "template", "fit", *arguments, "--out", desk.path("fitted"), names=names)
    check(not os.path.exists(desk.path("fitted", "tooth.nrrd")), "a refused template left a volume")
    os.makedirs(desk.path("half", "tooth.nrrd"))
    check(desk.run("specimen", "tooth", "--voxel-mm", "0.4", "-o", desk.path("own.nrrd"))[0] == 0, "a tooth is grown")
    refused(desk, "a tooth that cannot be written", "template", "fit", "class-1-adhesive", "--tooth", "36", "--volume", desk.path("own.nrrd"),
            "--out", desk.path("half"))
    check(not os.path.exists(desk.path("half", "scenario.json")), "an exercise without its tooth")
    refused(desk, "template into a file", "template", "fit", "class-1-adhesive", "--tooth", "36", "--out", desk.path("text.db"))
    refused(desk, "missing exercise", "grade", desk.path("none.json"), "--operator", "reference", names=("none.json",))
    refused(desk, "folder that is a file", "play", scenario, "--script", script, "--out", desk.path("text.db"), names=("text.db",))
    refused(desk, "volume into no folder", "specimen", "block", "--voxel-mm", "0.5", "-o", desk.path("none", "b.nrrd"))
    refused(desk, "missing mesh", "import", desk.path("none.obj"), "--tissue", "a=dentine", "-o", desk.path("v.nrrd"),
            names=("none.obj",))
    check(not os.path.exists(desk.path("v.nrrd")), "a failed import left a volume")


def no_files(desk):
    """A pipe that nobody writes to, a device, a folder and nothing: each verb refuses them at once where it wants a file."""
    scenario, script, database = desk.small_exercise(), desk.small_script(1), desk.path("good.db")
    session = desk.json("history", database, "list")[0]["session"]
    pipe = desk.path("pipe")
    os.mkfifo(pipe)
    for name in (pipe, "/dev/zero", desk.folder, desk.path("nothing")):
        for verb in (("play", name, "--script", script, "--out", desk.path("o")), ("audit", name), ("validate", name), ("import", name, "--list"),
                     ("play", scenario, "--script", name, "--db", desk.path("s.db"), "--out", desk.path("o")),
                     ("grade", name, "--operator", "reference"), ("grade", scenario, "--volume", name), ("grade", database, session, "--rubric", name),
                     ("template", "fit", "class-1-adhesive", "--tooth", "36", "--volume", name, "--out", desk.path("fitted")),
                     ("history", name, "list"), ("replay", name, session), ("grade", name, session), ("export", name), ("erase", name, "17"), ("thin", name),
                     ("retain", name, "--years", "2"), ("appeal", name, session, desk.path("a.cusppack")), ("exchange", "keys", "--db", name),
                     ("backup", name, desk.folder), ("restore", name, desk.path("r.db")), ("verify", name), ("verify", desk.path("a.cusppack"), "--db", name)):
            refused(desk, f"{name} for {verb[0]}", *verb)
    for ending in (".cusp", ".nrrd", ".mha", ".binvox", ".nii", ".dcm", ".stl", ".ply"):
        os.mkfifo(pipe + ending)
        refused(desk, f"a pipe named {ending}", *(("validate", pipe + ending) if ending == ".cusp" else ("import", pipe + ending, "--list")))
    with open("/dev/zero", "rb") as endless:
        done = subprocess.run([desk.cusp, "history", database, "list", "--as", "nobody"], stdin=endless, capture_output=True, text=True, timeout=HUNG_S,
                              env=desk.environment())
    check(done.returncode == 1 and done.stdout == "", f"a password without an end: exit {done.returncode}: {done.stdout}{done.stderr}")
    one_sentence(done.stderr, "a password without an end")


def usage(desk):
    for arguments in (("play",), ("play", "channel-1"), ("replay", "--verify"), ("history", "x.db"), ("nonsense",),
                      ("specimen", "banana", "-o", "x"), ("replay", "x.db", "no-id"), ("audit",), ("audit", "channel-1", "--apply"),
                      ("audit", "channel-1", "-o", "x.json"), ("audit", "channel-1", "--seeds", "0"),
                      ("play", "channel-1", "--out", desk.path("o"), "--seconds", "5"),
                      ("play", "channel-1", "--out", desk.path("o"), "--silence-every", "5"),
                      ("grade", "x.db"), ("grade", "channel-1", "019a9f3c-6a00-7c41-9b1e-000000000000", "--volume", "x.nrrd"),
                      ("grade", "channel-1", "--volume", "x.nrrd", "--as", "demo"), ("grade", "channel-1", "--operator", "nobody"),
                      ("grade", "channel-1", "--operator", "expert"), ("grade", "channel-1", "--operator", "too_deep:huge"), ("grade", "channel-1", "--operator", "reference", "--as", "demo"),
                      ("grade", "channel-1", "--operator", "reference", "--volume", "x.nrrd"), ("template",), ("template", "fit"),
                      ("template", "fit", "class-1-adhesive", "--tooth", "36"), ("template", "fit", "class-1-adhesive", "--out", "x"),
                      ("template", "fit", "class-1-adhesive", "--tooth", "36", "--set", "depth", "--out", "x"),
                      ("template", "fit", "class-1-adhesive", "--tooth", "36", "--set", "depth=1.4", "--set", "depth=2", "--out", "x"),
                      ("template", "fit", "class-1-adhesive", "--tooth", "36", "--seed", "2", "--volume", "x.nrrd", "--out", "x"),
                      ("template", "fit", "class-1-adhesive", "--tooth", "36", "--set", "depth=2mm", "--out", "x"),
                      ("grade", "channel-1", "019a9f3c-6a00-7c41-9b1e-000000000000", "--operator", "reference")):
        status, _, err = desk.run(*arguments)
        check(status == 2, f"{arguments}: exit {status}")
        one_sentence(err, " ".join(arguments))
    check("nonsense" in desk.run("nonsense")[2], "an unknown verb is not named")
    replay, play = ("replay", "x.db", "019a9f3c-6a00-7c41-9b1e-000000000000"), ("play", "channel-1", "--out", desk.path("o"))
    for verb, option, value in ((replay, "--at", "nan"), (replay, "--at", "-1"), (replay, "--at", "inf"), (play, "--seconds", "nan"), (play, "--seconds", "0"),
                                (play, "--seed", "-1"), (play, "--seed", "99999999999999999999"), (play, "--seed", "1.5"),
                                (("export", "x.db", "--exercise", "channel-1"), "--exercise-version", "0")):
        status, _, err = desk.run(*verb, f"{option}={value}")
        check(status == 2 and option in err and value in err and len(err) < 120, f"{verb} {option} {value}: exit {status}: {err}")
        one_sentence(err, option)
    for verb in (("play",), ("replay",), ("grade",), ("validate",), ("import",), ("specimen",), ("audit",), ("history",), ("export",),
                 ("template", "list"), ("template", "fit")):
        status, out, err = desk.run(*verb, "--help")
        check(status == 0 and "--json" in out and not err, f"{verb} --help: {status} {err}")


def window(desk):
    nowhere = dict.fromkeys(("DISPLAY", "WAYLAND_DISPLAY", "WAYLAND_SOCKET", "QT_QPA_PLATFORM"), "")
    for arguments in ((), ("--safe",), (desk.path("some.cusp"),)):
        refused(desk, f"no display: {arguments}", *arguments, names=("no display",), **nowhere)
    refused(desk, "a platform that needs a display", names=("no display",), **(nowhere | {"QT_QPA_PLATFORM": "xcb"}))
    status, _, err = desk.run("--saef", QT_QPA_PLATFORM="offscreen")
    check(status == 2 and "saef" in err, f"an unknown option of the window: exit {status}: {err}")
    for files, name in (((desk.path("a.cusp"), desk.path("b.cusp")), "b.cusp"), ((desk.path("a.cusp"), "export"), "export"),
                        (("--db", desk.path("x.db"), "export"), "export"), (("--safe", desk.path("notes.txt")), "notes.txt")):
        status, out, err = desk.run(*files, QT_QPA_PLATFORM="offscreen")
        check(status == 2 and name in err and out == "", f"{files} for the window: exit {status}: {out}{err}")
    status, _, err = desk.run("-platform", "offscreen", "--saef", **nowhere)
    check(status == 2 and "saef" in err, f"a platform that needs no display: exit {status}: {err}")


def causes(desk):
    """What cannot be written is named with the system's reason, and what was there before stays."""
    nowhere, folder, missing, directory = desk.path("none", "f"), desk.path("a-folder"), "No such file or directory", "Is a directory"
    os.makedirs(folder)
    exercise = desk.small_exercise("caused.json")
    for what, verb in (("a list", ("template", "list", "--json")), ("an audit", ("audit", exercise, "--json")), ("a leaner copy", ("audit", exercise, "--apply", "-o"))):
        refused(desk, f"{what} into a folder that is not there", *verb, nowhere, names=(nowhere, missing))
    refused(desk, "a list in place of a folder", "template", "list", "--json", folder, names=(folder, directory))
    script, report = desk.small_script(1), desk.path("reported", "report.json")
    os.makedirs(report)
    refused(desk, "a report in place of a folder", "play", exercise, "--script", script, "--db", desk.path("reported.db"), "--out", desk.path("reported"),
            names=(report, directory))
    for verb in (("play", exercise, "--script", script, "--db", desk.path("reported.db")), ("grade", exercise, "--operator", "reference"),
                 ("template", "fit", "class-1-adhesive", "--tooth", "36")):
        refused(desk, f"{verb[0]} into a file", *verb, "--out", exercise, names=(exercise, "Not a directory"))
    kept = desk.path("kept.json")
    with open(kept, "w", encoding="utf-8") as f:
        f.write("old")
    done = subprocess.run([desk.cusp, "template", "list", "--json", kept], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=HUNG_S,
                          env=desk.environment(), preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)))
    check(done.returncode == 1 and kept in done.stderr and "File too large" in done.stderr, f"a list that is too large: exit {done.returncode}: {done.stderr}")
    one_sentence(done.stderr, "a list that is too large")
    with open(kept, encoding="utf-8") as f:
        check(f.read() == "old", "a list that is too large replaced what was there")
    check([name for name in os.listdir(desk.folder) if name.startswith("kept.json.")] == [], "a half file is left")


def file_sizes(desk):
    """Where the process may write no larger file, it ends by itself and names the cause."""
    play = ("play", desk.small_exercise(), "--script", desk.small_script(1), "--db", desk.path("large.db"), "--out", desk.path("o"))
    for limit, arguments in ((1000, ("specimen", "tooth", "--voxel-mm", "0.3", "-o", desk.path("large.nrrd"))), (20000, play)):
        done = subprocess.run([desk.cusp, *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=HUNG_S,
                              env=desk.environment(), preexec_fn=lambda size=limit: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
        check(done.returncode == 1, f"{arguments} with at most {limit} bytes: exit {done.returncode}: {done.stderr}")
        one_sentence(done.stderr, f"{arguments} with at most {limit} bytes")


def mounted(folder, options):
    os.makedirs(folder, exist_ok=True)
    return subprocess.run(["mount", "-t", "tmpfs", "-o", options, "tmpfs", folder], capture_output=True).returncode == 0


def disks(desk):
    """A disk that is full and one that is read-only; where nothing can be mounted this part prints that."""
    scenario, script = desk.small_exercise(), desk.small_script(6)
    full = desk.path("full")
    statuses = set()
    # From too small for an empty database to enough: the disk is full at another moment each time.
    for kilobytes in (100, 500, 700, 900, 1100, 4000):
        if not mounted(full, f"size={kilobytes}k"):
            print("no right to mount: full and read-only disks were not tried")
            return
        try:
            database = os.path.join(full, "f.db")
            what = f"disk with {kilobytes} kB left"
            status, out, err = desk.run("play", scenario, "--script", script, "--db", database, "--out", desk.path(f"o{kilobytes}"))
            print(f"{what}: exit {status} {err.strip()}")
            statuses.add(status)
            if status == 0:
                continue
            check(status == 1 and out == "", f"{what}: {out}")
            one_sentence(err, what)
            check(not os.path.exists(desk.path(f"o{kilobytes}", "report.json")), f"{what}: a report of an attempt that was not kept")
            check(subprocess.run(["mount", "-o", "remount,size=20m", full]).returncode == 0, "more space")
            if os.path.exists(database) and os.path.getsize(database) > 0:
                check(integrity(database) == "ok", f"{what}: the database is not sound")
                status, out, err = desk.run("history", database, "list", "--json", "-")
                for row in json.loads(out) if status == 0 else []:
                    check(row["state"] in ("interrupted", "finished"), f"{what}: shows as {row['state']}")
                    desk.json("grade", database, row["session"])
                    check(desk.json("replay", "--verify", database, row["session"])["holds"], f"{what}: no proof")
        finally:
            subprocess.run(["umount", full], check=True)
    check(statuses == {0, 1}, f"the sizes must meet both a full disk and one that is not: {statuses}")
    fixed = desk.path("fixed")
    if mounted(fixed, "size=20m"):
        try:
            status, out, err = desk.run("play", scenario, "--script", script, "--db", os.path.join(fixed, "r.db"), "--out",
                                        desk.path("o3"))
            check(status == 0, f"play: {err}")
            session = out.strip()
            shutil.copy(scenario, os.path.join(fixed, "locked.json"))
            subprocess.run(["mount", "-o", "remount,ro", fixed], check=True)
            refused(desk, "read-only folder", "play", scenario, "--script", script, "--db", os.path.join(fixed, "new.db"),
                    "--out", desk.path("o4"))
            refused(desk, "read-only database", "play", scenario, "--script", script, "--db", os.path.join(fixed, "r.db"),
                    "--out", desk.path("o4"))
            refused(desk, "audit applied to a read-only disk", "audit", os.path.join(fixed, "locked.json"), "--apply",
                    names=("locked.json",))
            refused(desk, "report into a read-only folder", "play", scenario, "--script", script, "--db", desk.path("ok.db"),
                    "--out", os.path.join(fixed, "out"))
            status, out, err = desk.run("replay", "--verify", os.path.join(fixed, "r.db"), session)
            check(status == 0, f"a read-only record is still proved: {err}")
        finally:
            subprocess.run(["umount", fixed], check=True)


with Desk(sys.argv[1]) as the_desk:
    usage(the_desk)
    window(the_desk)
    scenarios(the_desk)
    audits(the_desk)
    audits_of_what_changes(the_desk)
    databases(the_desk)
    no_files(the_desk)
    causes(the_desk)
    file_sizes(the_desk)
    disks(the_desk)
