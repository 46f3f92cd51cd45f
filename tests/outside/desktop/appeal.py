"""An appeal: the administrator saves an assessed attempt as one file, another school opens and verifies it, and a student is erased.

    /usr/bin/python3 tests/outside/desktop/appeal.py build/release/cusp
"""
import os
import re
import sys

import assessment
import desk
import school

PICKER = re.compile("dialog|file chooser")


def choose_file(program, title, path):
    picker = program.find(PICKER, title)
    program.find("text", re.compile("^File name"), within=picker).type(path)
    program.keys("Return")


def begin_pack(program, path):
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    school.page(program, "Performance")
    school.row_of(program, "Attempts", school.STUDENT[0], assessment.EXERCISE)[0].click()
    program.keys("Return")
    program.find(None, "Report")
    program.press("Appeal pack")
    choose_file(program, "Save the appeal pack", path)


def save(program, take):
    path = os.path.join(program.folder, "case.cusppack")
    begin_pack(program, path)
    program.find("label", re.compile("The appeal pack is saved"))
    take(program, "appeal-saved")
    school.home(program)
    school.sign_out(program)
    return path


def save_and_close(program):
    """The window is closed while the pack is made: it is made all the same."""
    path = os.path.join(program.folder, "closed.cusppack")
    begin_pack(program, path)
    program.find("label", re.compile("The appeal pack is (being made|saved)"))
    program.close()
    desk.check(os.path.exists(path), "the pack is not made")


def open_elsewhere(own, path, take):
    """Another file of records, which knows neither the attempt nor the key."""
    other = desk.Program(own.binary, own.screen, own.folder, os.path.join(own.folder, "other.db"))
    own.program = other
    school.first_start(other)
    school.sign_in_staff(other, *school.ADMINISTRATOR[1:])
    school.page(other, "Performance")
    other.press("Open an appeal pack")
    choose_file(other, "Open an appeal pack", path)
    other.find(None, "Report")
    other.find("label", re.compile("Nothing was changed.*do not know"))
    desk.check(any("Candidate " in text for text in other.texts()), "the pack does not name the candidate")
    desk.check(not any(school.STUDENT[0] in text for text in other.texts()), "the pack holds the student's name")
    other.press("Compute the attempt anew")
    other.find("label", re.compile("bit for bit"))
    take(other, "appeal-opened")
    other.close()


def erase(program, take):
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    school.row_of(program, "People", assessment.OTHER[0])[0].click()
    program.press("Erase the person")
    question = program.find("alert")
    take(program, "erase-person")
    program.press("Erase", within=question)
    program.find("label", re.compile("The person is erased"))
    desk.check(not any(assessment.OTHER[0] in text for text in program.texts()), "the name still shows")
    school.page(program, "Station")
    program.press("Verify now")
    return program.find("label", re.compile("are whole")).name


def visit(own, program, take=school.nothing):
    """After assessment.visit(). Returns the program that runs at the end, and what was seen."""
    path = save(program, take)
    save_and_close(program)
    open_elsewhere(own, path, take)
    program = own.start()
    whole = erase(program, take)
    school.sign_out(program)
    return program, f"a pack of {os.path.getsize(path) / 1e6:.1f} MB opened elsewhere, a student erased; {whole}"


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        program, seen = assessment.visit(own, program)
        print(seen)
        program, seen = visit(own, program)
        print(seen)
        program.close()


if __name__ == "__main__":
    main()
