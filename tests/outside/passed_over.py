"""Options of every verb but import that would change nothing, and values that are empty: none is passed over. imports.py has import.

  passed_over.py CUSP
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from desk import Desk, check, one_sentence  # noqa: E402

SESSION = "019a9f3c-6a00-7c41-9b1e-000000000000"


def wrong_usage(desk, arguments, *names):
    status, out, err = desk.run(*arguments)
    check(status == 2 and out == "", f"{arguments}: exit {status}: {out}{err}")
    one_sentence(err, str(arguments))
    for name in names:
        check(name in err, f"{arguments}: {name} is not in {err!r}")


def replays(desk):
    """A proof computes the whole attempt: it writes no tooth of a moment."""
    wrong_usage(desk, ("replay", "x.db", SESSION, "--verify", "--volume", desk.path("t.nrrd")), "--verify", "--volume")
    wrong_usage(desk, ("replay", "x.db", SESSION, "--verify", "--at", "1"), "--verify", "--at")


def specimens(desk):
    """A block has no tooth's number and no gums, and that of the paper one size of voxels."""
    made = desk.path("specimen.nrrd")
    for kind, *option in (("block", "--fdi", "16"), ("block", "--seed", "2"), ("layered-block", "--neighbours"), ("paper-block", "--gingiva"),
                          ("block", "--bone"), ("block", "--typodont"), ("layered-block", "--lesion", "fissure:central"), ("paper-block", "--voxel-mm", "0.05")):
        wrong_usage(desk, ("specimen", kind, *option, "-o", made), option[0], kind)
    wrong_usage(desk, ("specimen", "tooth", "--typodont", "--lesion", "fissure:central", "-o", made), "--lesion", "plastic")
    check(not os.path.exists(made), "a refused specimen was written")
    status, _, err = desk.run("specimen", "block", "--voxel-mm", "0.5", "-o", made)
    check(status == 0 and os.path.exists(made), f"a block of coarse voxels: {err}")


def plays(desk):
    """A file of inputs has no tremor, and a person who holds the device no script."""
    play = ("play", desk.small_exercise(), "--db", desk.path("none.db"), "--out", desk.path("o"))
    wrong_usage(desk, (*play, "--script", desk.small_script(1), "--seed", "2"), "--seed", "script.csv")
    wrong_usage(desk, (*play, "--device", "falcon", "--script", "novice"), "--script")
    wrong_usage(desk, (*play, "--device", "falcon:FT1", "--seed", "2"), "--seed")
    wrong_usage(desk, (*play, "--device", "falcon", "--seconds", "5", "--silence-every", "2"), "--silence-every")
    check(not os.path.exists(desk.path("none.db")), "what was refused left a database")


def empty_values(desk):
    """A variable of the shell that is not set names nothing: it is not the same as no option."""
    grade, fit = ("grade", "x.db", SESSION), ("template", "fit", "class-1-adhesive", "--tooth", "36", "--out", desk.path("fitted"))
    play = ("play", desk.small_exercise(), "--script", desk.small_script(1))
    for verb, *options in ((("history", "x.db", "list"), "--as", "--json"), (("erase", "x.db", "17"), "--as"), (grade, "--rubric", "--volume", "--out"),
                           (("replay", "x.db", SESSION), "--volume"), (("export", "x.db"), "--output"), (("verify", "x.cusppack"), "--db"),
                           (("audit", desk.small_exercise(), "--apply"), "--out"), (fit, "--volume"), ((*play, "--out", desk.path("empty")), "--db", "--device"),
                           (play, "--out")):
        for option in options:
            wrong_usage(desk, (*verb, option, ""), option, "empty")
    check(not os.path.exists(desk.path("empty")) and not os.path.exists(desk.path("fitted")), "what was refused was written")


def no_stdout(desk):
    """What never goes to stdout makes no file of the name -."""
    for verb, option in ((("specimen", "block"), "--output"), (("import", desk.small_script(1)), "--output"), (("replay", "x.db", SESSION), "--volume"),
                         (("audit", desk.small_exercise(), "--apply"), "--out")):
        wrong_usage(desk, (*verb, option, "-"), option, "file")
    check(not os.path.exists("-"), "a file of the name - was written")


with Desk(sys.argv[1]) as the_desk:
    replays(the_desk)
    specimens(the_desk)
    plays(the_desk)
    empty_values(the_desk)
    no_stdout(the_desk)
