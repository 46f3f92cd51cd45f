"""An assessment that draws a tooth for each candidate: assigned, sat by two, one killed and continued on the same tooth, and both
teeth named on their reports.

    /usr/bin/python3 tests/outside/desktop/drawn.py build/release/cusp [FOLDER for pictures]
"""
import pathlib
import re
import sys
import time

from PIL import ImageGrab

import assessment
import cohort
import desk
import school

COHORT = "Drawn"
EXERCISE = "Class I, adhesive, tooth 46"
BY_HAND = "Straight channel, level 1"
OTHER = ("Said, Omar", "4799", "141421")
CODE = "amber 17"
CHOICE = "Another tooth for each candidate"


def assign(program, take):
    cohort.begin(program, COHORT, school.STUDENT[1], OTHER[1])
    school.row_of(program, "Students of the cohort", school.STUDENT[0])
    program.press("Assessment", school.CHOICE)
    program.labelled("combo box", "Exercise").choose(BY_HAND)
    desk.check(not program.find("check box", CHOICE).has("ENABLED"), f"a tooth can be drawn for {BY_HAND}")
    program.find("label", re.compile("no template made this exercise"))
    take(program, "drawn-by-hand")
    program.labelled("combo box", "Exercise").choose(EXERCISE)
    program.press(CHOICE, "check box")
    program.find("text", "Start code").type(CODE)
    take(program, "drawn-form")
    program.press("Assign")
    school.row_of(program, "Assigned exercises", EXERCISE, "Assessment")
    school.sign_out(program)


def begin(program, number, pin, take):
    school.sign_in_student(program, number, pin)
    program.find("label", re.compile("another tooth for each candidate"))
    take(program, "drawn-card")
    program.press("Start assessment")
    question = program.find("dialog", "Start assessment")
    program.find("label", re.compile("Your tooth is drawn for you"), within=question)
    program.find("text", "Start code, from the invigilator", within=question).type(CODE)
    take(program, "drawn-start")
    began = time.monotonic()
    program.press("Begin", within=question)
    ready(program)
    return time.monotonic() - began


def ready(program):
    desk.until("the tooth to be ready", lambda: program.find("push button", "Finish").has("ENABLED"))


def hand_in(program):
    program.press("Finish")
    program.press("Hand in", within=program.find("alert"))
    program.find(None, "Handed in")


def teeth(program, take):
    """The seeds on the reports of both candidates, as the examiner sees them."""
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Cohorts")
    school.row_of(program, "Cohorts", COHORT)[0].click()
    school.row_of(program, "Assigned exercises", EXERCISE)[0].click()
    program.press("Results")
    program.find("table", "Candidates")
    program.find("label", re.compile("another tooth for each candidate"))
    seeds = []
    for row in range(2):
        waiting = school.row_of(program, "Candidates", "to be confirmed")
        waiting[0].click()
        program.keys("Return")
        program.find(None, "Report")
        seeds.append(re.search(r"seed (\d+)", program.find("label", re.compile(r"drawn tooth, seed \d+")).name).group(1))
        take(program, f"drawn-report-{row}")
        if not program.find(school.CHOICE, "Mark this attempt").has("CHECKED"):
            program.press("Mark this attempt", school.CHOICE)
        program.press("Confirm the result")
        program.find("label", re.compile("The result is confirmed"))
        program.press("Back")
        program.find("table", "Candidates")
    desk.check(seeds[0] != seeds[1], f"both candidates had the tooth {seeds[0]}")
    return seeds


def main():
    desk.on_own_bus()
    folder = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None

    def take(program, name):
        if folder:
            folder.mkdir(parents=True, exist_ok=True)
            time.sleep(0.5)
            ImageGrab.grab(xdisplay=program.screen.display).save(folder / f"{name}.png")

    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
        program.find("table", "People")
        school.add_person(program, *OTHER, "Student", "PIN, six digits")
        school.sign_out(program)
        assign(program, take)
        first_s = begin(program, *school.STUDENT[1:], take)
        take(program, "drawn-drilling")
        hand_in(program)
        program.press("Next candidate")
        second_s = begin(program, *OTHER[1:], school.nothing)
        assessment.drill(program, assessment.SECOND_S)
        program.kill()
        program = own.start()
        school.after_crash(program, "Start as usual")
        school.sign_in_student(program, *OTHER[1:])
        program.press("Continue")
        question = program.find("dialog", "Continue assessment")
        program.find("text", "Start code, from the invigilator", within=question).type(CODE)
        program.press("Continue", within=question)
        ready(program)
        hand_in(program)
        program.press("To the start page")
        school.sign_out(program)
        seeds = teeth(program, take)
        program.close()
        print(f"{first_s:.1f} and {second_s:.1f} s from the start code to the drawn tooth; seeds {seeds[0]} and {seeds[1]}")


if __name__ == "__main__":
    main()
