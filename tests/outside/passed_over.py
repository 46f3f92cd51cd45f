"""Options of every verb but import that would change nothing: none is passed over. imports.py has those of import.

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


with Desk(sys.argv[1]) as the_desk:
    replays(the_desk)
