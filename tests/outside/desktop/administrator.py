"""An administrator sees the student's result among everybody's, and exports it as CSV.

    /usr/bin/python3 tests/outside/desktop/administrator.py build/release/cusp
"""
import csv
import os
import sys

import desk
import school
import student


def visit(program, points):
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    school.page(program, "Performance")
    name, number, _ = school.STUDENT
    row = [cell.name for cell in school.row_of(program, "Attempts", name, student.EXERCISE)]
    desk.check(any(cell.split(" ")[0] == points for cell in row), f"the student's report shows {points}, this page {row}")

    program.press("Export CSV")
    path = os.path.join(program.folder, "results.csv")
    picker = program.find(desk.re.compile("dialog|file chooser"), "Export CSV")
    program.find("text", desk.re.compile("^File name"), within=picker).type(path)
    program.keys("Return")
    program.find("label", desk.re.compile("exported"))
    with open(path, encoding="utf-8-sig", newline="") as f:
        text = f.read()
    rows = list(csv.DictReader(text.splitlines(), delimiter=csv.Sniffer().sniff(text.splitlines()[0]).delimiter))
    desk.check(len(rows) == 1, f"one attempt was finished, the file has {len(rows)}")
    desk.check(rows[0]["student_number"] == number, f"not {number} stands in {rows[0]}")
    # The screen rounds to a tenth.
    desk.check(abs(float(rows[0]["score"]) - float(points)) <= 0.05, f"not {points} points stand in {rows[0]}")
    school.sign_out(program)
    return rows[0]


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        print(visit(program, student.visit(program)))
        program.close()


if __name__ == "__main__":
    main()
