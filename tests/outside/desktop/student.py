"""A student signs in, drills the class I, finishes, reads the grade off the report and finds it in the history.

    /usr/bin/python3 tests/outside/desktop/student.py build/release/cusp
"""
import os
import re
import subprocess
import sys

import desk
import school

EXERCISE = "Class I, tooth 36"


def save_pdf(program):
    """The report's own "Save as PDF"; the file holds the picture of the tooth that the window shows."""
    path = os.path.join(program.folder, "report.pdf")
    program.press("Save as PDF")
    picker = program.find(re.compile("dialog|file chooser"), "Save the report")
    program.find("text", re.compile("^File name"), within=picker).type(path)
    program.keys("Return")
    program.find("label", re.compile("The report is saved"))
    images = subprocess.run(["pdfimages", "-list", path], capture_output=True, text=True, check=True).stdout.split("\n")[2:]
    desk.check(any("image" in line for line in images), "the PDF has no picture of the tooth")


def visit(program):
    """Returns the points, as the report has them."""
    school.sign_in_student(program)
    program.find(None, "Next exercise")
    school.begin(program, EXERCISE)
    school.drill(program, least_mm3=0.2)
    school.finish(program)
    points, verdict = school.points_on_report(program)
    desk.check(verdict == "Not passed", f"0.2 mm3 of a cavity should not pass, the report shows {verdict}")
    criteria = school.row_of(program, "Criteria", "Target removed")
    desk.check(any("%" in cell.name for cell in criteria), f"the share has no unit: {[c.name for c in criteria]}")
    save_pdf(program)

    school.home(program)
    school.page(program, "My results")
    row = [cell.name for cell in school.row_of(program, "My results", EXERCISE)]
    desk.check(any(name.split(" ")[0] == points for name in row), f"the report shows {points}, the history shows {row}")
    school.sign_out(program)
    return points


def main():
    desk.on_own_bus()
    with desk.Desk(sys.argv[1]) as own:
        program = own.start()
        school.first_start(program)
        print(f"the report and the history show {visit(program)} points")
        program.close()


if __name__ == "__main__":
    main()
