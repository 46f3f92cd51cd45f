"""An administrator sees the student's result among everybody's, exports it as CSV, and gives it out to other stations.

    /usr/bin/python3 tests/outside/desktop/administrator.py build/release/cusp
"""
import csv
import os
import sys

import cohort
import desk
import school
import student


def shown(score):
    """As the screen rounds: to a tenth, and up to no whole number that is not reached (shown_score() of grading)."""
    whole, tenth = round(score), round(score, 1)
    return whole - 0.1 if score > 0 and tenth == whole and score < whole - 1e-6 else tenth


def visit(program, points):
    school.sign_in_staff(program, *school.ADMINISTRATOR[1:])
    school.page(program, "Performance")
    name, number, _ = school.STUDENT
    row = [cell.name for cell in school.row_of(program, "Attempts", name, student.EXERCISE)]
    desk.check(any(cell.split(" ")[0] == points for cell in row), f"the student's report shows {points}, this page {row}")

    program.press("Export CSV")
    path = os.path.join(program.folder, "results.csv")
    cohort.pick(program, "Export CSV", path)
    program.find("label", desk.re.compile("exported"))
    with open(path, encoding="utf-8-sig", newline="") as f:
        text = f.read()
    rows = list(csv.DictReader(text.splitlines(), delimiter=csv.Sniffer().sniff(text.splitlines()[0]).delimiter))
    desk.check(len(rows) == 1, f"one attempt was finished, the file has {len(rows)}")
    desk.check(rows[0]["student_number"] == number, f"not {number} stands in {rows[0]}")
    desk.check(abs(shown(float(rows[0]["score"])) - float(points)) < 1e-9, f"not {points} points stand in {rows[0]}")
    give_out(program)
    school.sign_out(program)
    return rows[0]


def give_out(program):
    """The attempt goes out as a file for the office; this station refuses it as its own."""
    school.page(program, "Other stations")
    program.find("label", "No other station is known yet")
    path = os.path.join(program.folder, "results.cuspexchange")
    program.press("Results for the office")
    cohort.pick(program, "Give out results", path)
    program.find("label", desk.re.compile("File 1 of this station is written: 1 attempt"))
    desk.check(os.path.getsize(path) > 0, f"{path} is empty")
    program.press("Read a file in")
    cohort.pick(program, "Choose a file of another station", path)
    program.find("label", desk.re.compile("This is this station.s own"))


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        print(visit(program, student.visit(program)))
        program.close()


if __name__ == "__main__":
    main()
