"""An administrator imports a list of students, an instructor assigns their cohort an exercise, one of them finds it due, and no
longer once it is withdrawn.

    /usr/bin/python3 tests/outside/desktop/cohort.py build/release/cusp
"""
import os
import re
import sys

import desk
import school

COHORT = "Year 3"
EXERCISE = "Class I, tooth 36"
LIST = "Nachname;Vorname;Matrikelnummer;PIN;Kohorte\nBrandt;Lena;4711;271828;Year 3\nSaid;Omar;4712;;Year 3\nWithout;Number;;;\n"
LENA = ("4711", "271828")


def pick(program, title, path):
    picker = program.find(re.compile("dialog|file chooser"), title)
    program.find("text", re.compile("^File name"), within=picker).type(path)
    program.keys("Return")


def import_list(program, take=school.nothing):
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    program.find("table", "People")  # an administrator's first page
    program.press("Import a list")
    take(program, "import-people")
    path = os.path.join(program.folder, "list.csv")
    with open(path, "w", encoding="cp1252") as f:
        f.write(LIST)
    program.press("Choose a file")
    pick(program, "Choose a list of students", path)
    school.row_of(program, "Lines of the list", "Lena Brandt", "new")
    school.row_of(program, "Lines of the list", "no number")
    take(program, "import-people-lines")
    program.press("Make the accounts")
    slips = os.path.join(program.folder, "slips.pdf")
    pick(program, "Save the PIN slips", slips)
    program.find("label", re.compile("The list is imported"))
    desk.check(os.path.getsize(slips) > 1000, "the PIN slips are empty")
    program.keys("alt+Left")
    school.row_of(program, "People", "Omar Said", "4712")
    school.sign_out(program)


def begin(program, name, *numbers):
    """As an instructor: makes a cohort of these students."""
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Cohorts")
    program.find("text", "Name of a new cohort").type(name)
    program.press("New cohort")
    program.find("text", "Student numbers to add").type(" ".join(numbers))
    program.press("Add students")


def assign(program):
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Cohorts")
    school.row_of(program, "Cohorts", COHORT)[0].click()
    school.row_of(program, "Students of the cohort", "Lena Brandt")
    # Somebody comes later.
    program.find("text", "Student numbers to add").type(school.STUDENT[1])
    program.press("Add students")
    school.row_of(program, "Students of the cohort", school.STUDENT[0])
    program.labelled("combo box", "Exercise").choose(EXERCISE)
    program.press("Assign")
    row = [cell.name for cell in school.row_of(program, "Assigned exercises", EXERCISE)]
    school.sign_out(program)
    return row


def withdraw(program, take=school.nothing):
    school.sign_in_staff(program, *school.INSTRUCTOR[1:])
    school.page(program, "Cohorts")
    school.row_of(program, "Cohorts", COHORT)[0].click()
    school.row_of(program, "Assigned exercises", EXERCISE)[0].click()
    program.press("Withdraw")
    question = program.find("alert")
    take(program, "withdraw")
    program.press("Withdraw", within=question)
    school.row_of(program, "Assigned exercises", EXERCISE, "withdrawn")
    take(program, "withdrawn")
    school.sign_out(program)


def visit(program):
    import_list(program)
    row = assign(program)
    school.sign_in_student(program, *LENA)
    program.find("label", "Due next")
    school.row_of(program, "Your exercises", EXERCISE)
    school.sign_out(program)
    withdraw(program)
    school.sign_in_student(program, *LENA)
    program.find(None, "Next exercise")
    desk.check(program.here("label", "Due next") is None, "what was withdrawn is due")
    school.sign_out(program)
    return row


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        print(visit(program))
        program.close()


if __name__ == "__main__":
    main()
