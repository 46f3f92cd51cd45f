"""An assessment: assigned with a start code and for certain devices, adjusted for one of two students, sat by both (the device
of one falls silent, the other is killed half-way and continues with the code), marked without names, released, and read.

    /usr/bin/python3 tests/outside/desktop/assessment.py build/release/cusp
"""
import re
import signal
import sys
import time

import cohort
import desk
import school

COHORT = "Examined"
EXERCISE = "Straight channel, level 1"
OTHER = ("Said, Omar", "4799", "141421")
CODE = "amber 17"
SECOND_S = 3  # a second of the attempt lies in the file after two


def assign(program, take):
    cohort.begin(program, COHORT, school.STUDENT[1], OTHER[1])
    school.row_of(program, "Students of the cohort", school.STUDENT[0])
    program.labelled("combo box", "Exercise").choose(EXERCISE)
    program.press("Assessment", school.CHOICE)
    program.find("text", "Start code").type(CODE)
    program.press("Inverse3", school.CHOICE)
    program.press("Emulated Falcon", school.CHOICE)
    program.press("Assign")
    row = school.row_of(program, "Assigned exercises", EXERCISE, "Assessment", "1")
    row[0].click()
    program.find("label", f"only with Falcon, Mouse and keys · Start code {CODE}")
    take(program, "assessment-assigned")
    adjust(program, take)
    school.sign_out(program)


def adjust(program, take):
    """The second student's, whose name the examiner asks for."""
    program.press("Results")
    program.find("table", "Candidates")
    program.press("Show names", school.CHOICE)
    school.row_of(program, "Candidates", OTHER[0])[0].click()
    program.press("Large text", school.CHOICE)
    program.press("Keep the adjustment")
    school.row_of(program, "Candidates", OTHER[0], "large text")
    take(program, "assessment-adjusted")
    program.press("Back")


def begin(program, number, pin, take):
    school.sign_in_student(program, number, pin)
    program.find("push button", "Start assessment")
    take(program, "assessment-due")
    program.press("Start assessment")
    question = program.find("dialog", "Start assessment")
    program.find("text", "Start code, from the invigilator", within=question).type("wrong 1")
    program.press("Begin", within=question)
    program.find("label", re.compile("This is not the start code"), within=question)
    take(program, "assessment-start")
    program.find("text", "Start code, from the invigilator", within=question).type(CODE)
    program.press("Begin", within=question)
    ready(program)
    desk.check(program.here("progress bar", "Target removed") is None, "an assessment shows how much of the target is removed")
    desk.check(program.here("push button", re.compile("^Target")) is None, "an assessment offers the target")


def ready(program):
    desk.until("the tooth to be ready", lambda: program.find("push button", "Finish").has("ENABLED"))


def clock_s(program):
    text = next((w.name for w in program.all("label", re.compile(r"\d+:\d\d$"))), "0:00")
    minutes, seconds = re.search(r"(\d+):(\d\d)$", text).groups()
    return 60 * int(minutes) + int(seconds)


def drill(program, until_s):
    x, y = program.find(None, "Tooth").middle()
    program.screen.x("mousemove", x, y, "mousedown", 1)
    desk.until(f"the clock to show {until_s} s", lambda: (school.resume_if_held(program), clock_s(program) >= until_s)[1])
    program.screen.x("mouseup", 1)


def device_fault(program):
    """The whole program stands for a second: to its loop the device fell silent. The clock stands until somebody resumes."""
    program.process.send_signal(signal.SIGSTOP)
    time.sleep(1)
    program.process.send_signal(signal.SIGCONT)
    program.find("label", re.compile("^The device (answered too late|went quiet)"))
    stood = clock_s(program)
    time.sleep(2.5)
    desk.check(clock_s(program) == stood, f"the clock ran on from {stood} to {clock_s(program)} s while the device was silent")
    program.press("Resume")


def hand_in(program):
    program.press("Finish")
    question = program.find("alert")
    program.press("Hand in", within=question)
    program.find(None, "Handed in")
    desk.until("the keyboard to be on the next act", lambda: program.find("push button", "Next candidate").has("FOCUSED"))
    desk.check(program.here(None, "Report") is None, "the result shows before its release")


def sit(program, take):
    begin(program, *school.STUDENT[1:], take)
    drill(program, SECOND_S)
    device_fault(program)
    drill(program, SECOND_S + 2)
    take(program, "assessment-drilling")
    hand_in(program)
    take(program, "assessment-handed-in")
    handed_in = time.monotonic()
    program.press("Next candidate")
    begin(program, *OTHER[1:], school.nothing)
    between_s = time.monotonic() - handed_in
    take(program, "assessment-large")
    drill(program, SECOND_S)
    return between_s


def continue_after_kill(own, program):
    program.kill()
    own.screen.x("mouseup", 1)
    program = own.start()
    school.after_crash(program, "Start as usual")
    school.sign_in_student(program, *OTHER[1:])
    program.find(None, "Interrupted: continue it below")
    program.press("Continue")
    question = program.find("dialog", "Continue assessment")
    program.find("text", "Start code, from the invigilator", within=question).type("wrong 1")
    program.press("Continue", within=question)
    program.find("label", re.compile("This is not the start code"), within=question)
    program.find("text", "Start code, from the invigilator", within=question).type(CODE)
    begun = time.monotonic()
    program.press("Continue", within=question)
    ready(program)
    back_s = time.monotonic() - begun
    closing_asks(program)
    program.find("label", re.compile("Assessment, candidate .*, continued"))
    hand_in(program)
    program.press("To the start page")
    program.find(None, "Handed in: the result is not released yet")
    school.page(program, "My results")
    school.row_of(program, "My results", EXERCISE, "Not released")
    school.sign_out(program)
    return program, back_s


def closing_asks(program):
    """Closing the window asks for the start code, and ends neither program nor attempt."""
    program.screen.x("key", "--clearmodifiers", "alt+F4")
    question = program.find("alert")
    desk.check(not program.find("push button", "Leave", within=question).has("ENABLED"), "an assessment can be left without its start code")
    program.press("Cancel", within=question)
    desk.until("the question to go", lambda: program.here("alert") is None)


def mark(program, take):
    """Both fail: one is changed and confirmed, the other confirmed. Returns the candidate whose points were changed."""
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Cohorts")
    school.row_of(program, "Cohorts", COHORT)[0].click()
    school.row_of(program, "Assigned exercises", EXERCISE)[0].click()
    program.find("label", re.compile(f"Start code {CODE}$"))
    program.press("Results")
    program.find("table", "Candidates")
    desk.check(not program.here("push button", "Release results").has("ENABLED"), "failed results may be released unconfirmed")
    take(program, "assessment-candidates")
    for row in range(2):
        waiting = school.row_of(program, "Candidates", "to be confirmed")
        if row == 0:
            changed = waiting[0].name
        waiting[0].click()
        program.keys("Return")
        program.find(None, "Marking")
        desk.check(not any(school.STUDENT[0] in w for w in program.texts()), "the name of the candidate shows to who marks")
        if not program.find(school.CHOICE, "Mark this attempt").has("CHECKED"):  # a high window has the card open
            program.press("Mark this attempt", school.CHOICE)
        if row == 0:
            change_points(program)
            take(program, "marking")
        program.press("Confirm the result")
        program.find("label", re.compile("The result is confirmed"))
        program.press("Back")
        program.find("table", "Candidates")
    program.press("Release results")
    program.press("Release", within=program.find("alert"))
    program.find("label", re.compile(r"2 result(s|\(s\)) released"))
    school.row_of(program, "Candidates", "confirmed", "yes")
    program.press("Back")
    school.sign_out(program)
    return changed


def change_points(program):
    said = program.find("text", "Comment or reason")
    said.type("The floor is even where you were.")
    program.press("Add comment")
    program.find("label", re.compile("The comment is kept"))
    said.type("The block was worn here.")
    program.find("spin button", re.compile("^Points of")).type("1")
    program.press("Change points")
    program.find("label", re.compile("The points are changed"))
    program.find("label", re.compile(r"1 instead of 0 point(s|\(s\))"), within=program.find(None, "Remarks"))


def read(program, take):
    """Of the two, one reads the remark."""
    read_by = 0
    for number, pin in (school.STUDENT[1:], OTHER[1:]):
        school.sign_in_student(program, number, pin)
        school.page(program, "My results")
        school.row_of(program, "My results", EXERCISE, "Not passed")[0].click()
        program.keys("Return")
        program.find(None, "Report")
        program.find("table", "Criteria")
        remarks = program.here(None, "Remarks")
        said = remarks and [w.name for w in program.all("label", re.compile("The floor is even"), within=remarks)]
        if said:
            take(program, "marked-report")
        read_by += 1 if said else 0
        desk.check(program.here(None, "Marking") is None, "a student may mark")
        school.home(program)
        school.sign_out(program)
    desk.check(read_by == 1, f"the remark is read by {read_by} of the two candidates")


def visit(own, program, take=school.nothing):
    """The school stands. Returns the program that runs at the end, and what was seen. `take`: a picture by its name."""
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    program.find("table", "People")
    school.add_person(program, *OTHER, "Student", "PIN, six digits")
    school.sign_out(program)
    assign(program, take)
    between_s = sit(program, take)
    program, back_s = continue_after_kill(own, program)
    candidate = mark(program, take)
    read(program, take)
    return program, (f"{between_s:.0f} s from hand-in to the next candidate's tooth, {back_s:.0f} s to continue after a kill, "
                     f"candidate {candidate} changed, confirmed, released and read")


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        program, seen = visit(own, program)
        print(seen)
        program.close()


if __name__ == "__main__":
    main()
