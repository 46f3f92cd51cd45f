"""The school of these tests: who is there, and how they come to the window and leave it."""
import re

from desk import check, until

ADMINISTRATOR = ("Ada Lindqvist", "ada", "quartz lamp 9")
INSTRUCTOR = ("Jonas Weber", "weber", "copper lamp 7")
STUDENT = ("Mira Okafor", "20267314", "314159")

ACCOUNT = re.compile("^Account of ")
CHOICE = re.compile("^(check box|radio button)$")  # a button that stays down


def nothing(program, name):
    """Takes no picture."""


def first_start(program, take=nothing):
    """The first start makes the administrator, who leaves the quick start, adds an instructor and a student, and signs out."""
    name, number, password = ADMINISTRATOR
    program.find("label", "First start")
    program.find("text", "Your name").type(name)
    program.find("text", "User name").type(number)
    program.find("password text", re.compile("^Password, at least")).type(password)
    program.find("password text", "Password again").type(password)
    program.press("Make the administrator")
    program.find("label", "Five steps to the first report")
    take(program, "quick-start")
    program.press("To the program")
    program.find("table", "People")
    add_person(program, *STUDENT, "Student", "PIN, six digits")
    add_person(program, *INSTRUCTOR, "Instructor", "Password, at least 8 characters")
    sign_out(program)


def add_person(program, name, number, secret, role, secret_label):
    program.press("Add a person")
    program.labelled("combo box", "Role").choose(role)
    program.find("text", "Name").type(name)
    program.find("text", "Number or user name").type(number)
    program.find("password text", secret_label).type(secret)
    program.press("Add")
    program.find("label", f"{name} is added.")
    program.find("table cell", name, within=program.find("table", "People"))


def after_crash(program, answer):
    """Reads the offer that follows a crash and gives the answer: "Start without 3D pictures", or "Start as usual"."""
    question = program.find("alert")
    program.find("label", re.compile("Cusp ended unexpectedly last time"), within=question)
    program.press(answer, within=question)
    program.find("label", "Sign in")


def sign_in_student(program, number=STUDENT[1], pin=STUDENT[2]):
    program.press("Student", "page tab")
    program.find("text", "Student number").type(number)
    program.find("password text", "PIN, six digits").focus()
    program.screen.x("type", "--delay", 8, pin)
    program.press("Sign in")


def sign_in_staff(program, number, password):
    program.press("Staff", "page tab")
    program.find("text", "User name").type(number)
    program.find("password text", "Password").type(password)
    program.press("Sign in")


def sign_out(program):
    program.menu(ACCOUNT, "Up", "Return")  # the last of the account's menu
    program.find("label", "Sign in")


def page(program, name):
    """Goes to a page by the bar at the side."""
    program.press(name, CHOICE, within=program.find(None, "Pages"))


def home(program):
    """Back from the report, and from the briefing behind it, to the pages."""
    def back():
        if program.here(None, "Pages"):
            return True
        way = program.here("push button", "Back")
        if way:  # not while one page follows another
            way.click()
        return False
    until("the pages", back)


def row_of(program, table, *parts):
    """The cells of the first row that shows all `parts`."""
    def look():
        found = program.here("table", table)
        if found is None:
            return None
        cells = {}
        for cell in program.all("table cell", within=found):
            cells.setdefault(cell.box()[1], []).append(cell)
        for row in cells.values():
            names = [cell.name for cell in row]
            if all(any(part in name for name in names) for part in parts):
                return row
        return None
    return until(f"a row with {', '.join(parts)} in {table!r}", look)


def in_library(program, exercise, *parts):
    """The row of an exercise in the library, wherever it stands there."""
    program.find("text", "Find an exercise").type(exercise)
    return row_of(program, "Exercises", exercise, *parts)


def brief(program, exercise):
    """The briefing of the first exercise with this name, found by its text."""
    if program.here("text", "Find an exercise") is None:
        page(program, "Exercises")
    program.find("text", "Find an exercise").type(exercise)
    program.find("list item", exercise)
    program.keys("Return")


def begin(program, exercise):
    """From the exercises over the briefing to the drilling screen, ready to drill."""
    brief(program, exercise)
    program.press("Start")
    until("the tooth to be ready", lambda: program.find("push button", "Finish").has("ENABLED"))


def removed_mm3(program):
    """What is gone so far, as the panel shows it."""
    tissues = ("Enamel", "Dentine", "Plastic", "Cementum", "Pulp", "Bone")
    return sum(bar.value for bar in program.all("progress bar") if bar.name in tissues)


def resume_if_held(program):
    """To the loop a stall of a busy machine is a device that answered too late. Resumes, and presses the mouse anew."""
    button = program.here("push button", "Resume")
    if button is None:
        return
    button.press()
    until("the attempt to go on", lambda: program.here("push button", "Resume") is None)
    program.screen.x("mouseup", 1, "mousedown", 1)


def drill(program, least_mm3):
    """Holds the left button on the middle of the target and moves about until the panel shows that `least_mm3` are gone."""
    x, y = program.find(None, "Tooth").middle()
    program.screen.x("mousemove", x, y, "mousedown", 1)
    sway = [0, 6, 12, 18, 24, 18, 12, 6, 0, -6, -12, -18, -24, -18, -12, -6]
    step = iter(range(1 << 30))

    def enough():
        resume_if_held(program)
        program.screen.x("mousemove", x + sway[next(step) % len(sway)], y)
        return removed_mm3(program) >= least_mm3
    until(f"{least_mm3} mm3 to be drilled away", enough)
    program.screen.x("mouseup", 1)


def finish(program):
    """Finishes the attempt and confirms."""
    program.press("Finish")
    question = program.find("alert")
    program.find("label", "Finish and see the result?", within=question)
    program.press("Finish", within=question)
    program.find(None, "Report")


def points_on_report(program):
    """The large number, and whether the attempt is passed."""
    line = program.find("label", re.compile("^of 100 points"), within=program.find(None, "Report"))
    number = program.here("label", re.compile(r"^\d+(\.\d)?$"), within=program.find(None, "Report"))
    check(number, f"no points stand before {line.name!r}")
    chip = program.find(None, re.compile("^(Passed|Not passed)$"), within=program.find(None, "Report"))
    return number.name, chip.name
