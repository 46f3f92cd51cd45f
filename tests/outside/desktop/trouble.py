"""What goes wrong at a desk: records that cannot be kept, a wrong password, and the power going while somebody drills.

    /usr/bin/python3 tests/outside/desktop/trouble.py build/release/cusp
"""
import json
import re
import subprocess
import sys

import desk
import school

EXERCISE = "Straight channel, level 1"


def no_place_for_records(own):
    """In /sys not even root may make a file."""
    kept, own.database = own.database, "/sys/cusp.db"
    program = own.start()
    program.find("push button", "Try again")
    shown = [w for w in program.texts() if "/sys" in w or "cusp.db" in w]
    desk.check(shown, f"nothing names the place: {program.texts()}")
    program.close()
    own.database = kept
    return " / ".join(shown)


def wrong_secrets(program):
    school.sign_in_student(program, pin="999999")
    program.find("label", re.compile("^Number and PIN do not match"))
    school.sign_in_staff(program, school.INSTRUCTOR[1], "tin lamp 123")
    shown = program.find("label", re.compile("(?i)password.*(match|wrong|not|fit)")).name
    desk.check(program.here(None, "Pages") is None, "a wrong password led inside")
    return shown


def broken_off(own, program):
    """Killed while drilling; after the next start the start page shows it, it can be graded, and the card is gone."""
    school.sign_in_student(program)
    school.begin(program, EXERCISE)
    x, y = program.find(None, "Tooth").middle()
    program.screen.x("mousemove", x, y, "mousedown", 1)
    # A second of the attempt lies in the file: what is killed now was being kept.
    desk.until("something to be drilled away", lambda: (school.resume_if_held(program), school.removed_mm3(program) >= 0.05)[1])
    desk.until("the clock to pass two seconds", lambda: (school.resume_if_held(program), clock_s(program) >= 2)[1])
    program.kill()
    own.screen.x("mouseup", 1)

    program = own.start()
    school.after_crash(program, "Start without 3D pictures")
    school.sign_in_student(program)
    program.find("label", "Interrupted attempt")
    program.find("push button", "Continue")
    program.find("label", re.compile("^3D pictures are off"))
    desk.check(not program.find("push button", "Start").has("ENABLED"), "without pictures an exercise can be started")
    school.page(program, "My results")
    row = [cell.name for cell in school.row_of(program, "My results", EXERCISE)]
    desk.check(any("nterrupted" in name for name in row), f"an attempt that broke off is shown as {row}")
    school.page(program, "Start")
    program.press("Grade as it stands")
    program.press("Grade", within=program.find("alert"))
    school.points_on_report(program)
    school.home(program)
    program.find(None, "Next exercise")
    desk.check(program.here("label", "Interrupted attempt") is None, "the card stays though the attempt is graded")
    school.sign_out(program)
    report_without_pictures(program)
    program.close()
    own.start().find("label", "Sign in")  # a normal end came before: nothing is asked
    own.program.process.terminate()
    desk.check(own.program.process.wait(desk.LIMIT_S) == 0, "SIGTERM did not end the program well")
    own.start().find("label", "Sign in")
    own.program.close()

    def verb(*arguments):
        done = subprocess.run([own.binary, *arguments], capture_output=True, text=True, timeout=desk.LIMIT_S,
                              input=school.INSTRUCTOR[2] + "\n")
        desk.check(done.returncode == 0, f"{arguments}: {done.stderr}")
        return json.loads(done.stdout)
    attempts = verb("history", own.database, "list", "--as", school.INSTRUCTOR[1], "--json", "-")
    rows = attempts if isinstance(attempts, list) else next(v for v in attempts.values() if isinstance(v, list))
    session = rows[0].get("session", rows[0].get("id"))
    graded = verb("grade", own.database, session, "--as", school.INSTRUCTOR[1], "--json", "-")
    verb("replay", "--verify", own.database, session, "--as", school.INSTRUCTOR[1], "--json", "-")
    return f"shown as {row}, graded with {graded.get('score')} points"


def report_without_pictures(program):
    """An instructor opens the report of the attempt that the crash broke off."""
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Performance")
    school.row_of(program, "Attempts", school.STUDENT[0], EXERCISE)[0].click()
    program.keys("Return")
    school.points_on_report(program)
    program.find("label", re.compile("^3D pictures are off"), within=program.find(None, "Report"))
    school.home(program)
    school.sign_out(program)


def clock_s(program):
    """The clock of the drilling screen."""
    text = next((w.name for w in program.all("label", re.compile(r"\d+:\d\d$"))), "0:00")
    minutes, seconds = re.search(r"(\d+):(\d\d)$", text).groups()
    return 60 * int(minutes) + int(seconds)


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        print("no place for records:", no_place_for_records(own), flush=True)
        program = own.start()
        school.first_start(program)
        print("a wrong password:", wrong_secrets(program), flush=True)
        print("killed while drilling:", broken_off(own, program), flush=True)


if __name__ == "__main__":
    main()
