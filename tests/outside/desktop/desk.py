"""A desk for the tests that sit in front of the window: a display of its own and the program on it.

A test presses, types and drags as a user would (AT-SPI to find things, XTest for keys and mouse), and reads names
and values as a screen reader would. Everything waits for what the screen shows, never for a length of time: `LIMIT_S` only
sets when to give up. When a test fails, the screen, what a screen reader would see of it, and the program's own output
go to the folder that CUSP_DESK_PICTURES names (else beside the other temporary files).
"""
import atexit
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import traceback

import words
from screen import LIMIT_S, Atspi_Error, Missing, Screen, reveal, until

SOURCE = os.path.abspath(__file__ + "/../../../..")


def on_own_bus():
    """Starts this script again under a session bus of its own: one run never sees the program of another."""
    if os.environ.get("CUSP_DESK_BUS") != "own":
        # XDG_RUNTIME_DIR would lead to the accessibility bus of whoever is logged in here.
        environment = {k: v for k, v in os.environ.items() if k not in ("DISPLAY", "AT_SPI_BUS_ADDRESS", "XDG_RUNTIME_DIR")}
        # The accessibility bus has its socket in the cache folder, and removes it at its end: runs at one time need one each.
        environment.update(CUSP_DESK_BUS="own", NO_AT_BRIDGE="0", GTK_A11Y="none", XDG_CACHE_HOME=tempfile.mkdtemp(prefix="cusp-bus-"))
        os.execvpe("dbus-run-session", ["dbus-run-session", "--", sys.executable, *sys.argv], environment)
    atexit.register(shutil.rmtree, os.environ["XDG_CACHE_HOME"], ignore_errors=True)
    global Atspi
    import gi
    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi as atspi
    Atspi = atspi


class Widget:
    """One thing on the screen, as a screen reader sees it."""

    def __init__(self, node, program):
        self.node, self.program = node, program

    @property
    def name(self):
        return self.meanings[0]

    @property
    def meanings(self):
        """The name in English: one, or all that the shown text may mean in another language."""
        return self.program.words.meanings(self.shown)

    @property
    def shown(self):
        """The name as the screen has it."""
        return plain(self.node.get_name() or "")

    @property
    def role(self):
        """In Debian 12's words: Debian 13 reports a button, or a push button menu if it has a menu."""
        role = self.node.get_role_name()
        return "push button" if role in ("button", "push button menu") else role

    @property
    def description(self):
        return self.program.words.meanings(plain(self.node.get_description() or ""))[0]

    def has(self, state):
        return self.node.get_state_set().contains(getattr(Atspi.StateType, state))

    @property
    def text(self):
        """What stands in a field."""
        node = self.node
        return plain(Atspi.Text.get_text(node, 0, Atspi.Text.get_character_count(node)))

    @property
    def value(self):
        return Atspi.Value.get_current_value(self.node)

    def extents(self):
        """In Qt's pixels."""
        e = Atspi.Component.get_extents(self.node, Atspi.CoordType.SCREEN)
        return e.x, e.y, e.width, e.height

    def box(self):
        """In pixels of the screen."""
        return tuple(edge * self.program.pixels for edge in self.extents())

    def middle(self):
        x, y, width, height = self.box()
        return x + width // 2, y + height // 2

    def children(self):
        for i in range(self.node.get_child_count()):
            child = self.node.get_child_at_index(i)
            if child is not None:
                yield Widget(child, self.program)

    def walk(self, shown_only=True):
        for child in self.children():
            try:
                if shown_only and not child.has("SHOWING"):
                    continue
                yield child
                yield from child.walk(shown_only)
            except Atspi_Error():
                continue

    def press(self):
        """Presses a button, opens a menu, chooses an item."""
        until(f"{self.name!r} to be enabled", lambda: self.has("ENABLED") or self.has("SENSITIVE"))
        actions = [Atspi.Action.get_action_name(self.node, i) for i in range(Atspi.Action.get_n_actions(self.node))]
        for wanted in ("Press", "Toggle", "ShowMenu"):
            if wanted in actions:
                Atspi.Action.do_action(self.node, actions.index(wanted))
                if wanted != "ShowMenu":  # an open menu holds its button
                    until(f"{self.name!r} to act", self._is_up)
                return self
        raise Missing(f"nothing to press on {self.role} {self.name!r}: {actions}")

    def _is_up(self):
        """Qt holds a button down for 100 ms before it acts: a press that comes earlier may go to a page that it replaces."""
        try:
            return not self.has("PRESSED")
        except Atspi_Error():  # it went with what it did
            return True

    def click(self):
        reveal(self)
        x, y = self.middle()
        self.program.screen.x("mousemove", x, y, "click", 1)
        return self

    def focus(self):
        def focused():
            if self.has("FOCUSED"):
                return True
            Atspi.Component.grab_focus(self.node)
            return self.has("FOCUSED")
        until(f"the focus on {self.name!r}", focused)
        return self

    def type(self, text):
        """Puts `text` in place of what stands in a field, by keys; a built-in exercise's title in the screen's language."""
        text = self.program.words.shown(text)
        self.focus()
        self.program.keys("ctrl+a", "Delete")
        if self.role == "password text":  # nobody may read it, so nobody can look
            self.program.screen.x("type", "--delay", 8, text)
            return self
        until(f"{self.name!r} to be empty", lambda: self.text == "")
        if text.isascii():
            self.program.screen.x("type", "--delay", 8, text)
        else:  # under load a letter without a key of its own is lost
            Atspi.EditableText.set_text_contents(self.node, text)
        until(f"{text!r} to stand in {self.name!r}", lambda: self.text == text)
        return self

    def choose(self, option):
        """Chooses in a list that folds down, wherever the page has scrolled to."""
        if option in self.meanings:
            return self
        self.press()
        self.program.find("list item", option).click()
        until(f"{option!r} to be chosen", lambda: option in self.meanings)
        return self

    def labels(self):
        """The text that labels this, for things whose name is their value."""
        relations = self.node.get_relation_set()
        return [meant for r in relations if r.get_relation_type() == Atspi.RelationType.LABELLED_BY
                for i in range(r.get_n_targets()) for meant in Widget(r.get_target(i), self.program).meanings]

    def __repr__(self):
        return f"{self.role} {self.name!r}"


def plain(text):
    """Without the signs that keep a number and its unit in one direction, and with simple spaces."""
    return re.sub("[\u2066-\u2069\u200e\u200f]", "", text).replace("\u00a0", " ").replace("\u202f", " ")


def fits(wish, text):
    """A wish is a text, a compiled pattern to search for, or None for anything."""
    return wish is None or (wish.search(text) is not None if hasattr(wish, "search") else wish == text)


class Program:
    """The desktop, running on a screen."""

    def __init__(self, binary, screen, folder, database, *arguments, language="en", pixels=1, **environment):
        """`language` of the screen, as the settings have it; `pixels` for one of Qt's, as QT_SCALE_FACTOR has it."""
        self.binary, self.screen, self.folder, self.database = binary, screen, folder, database
        self.words, self.pixels = words.of(language), pixels
        # Whoever runs the test may have set a scale or a style for programs of their own.
        env = {name: value for name, value in os.environ.items() if not name.startswith(("CUSP_", "QT_"))}
        env.update(QT_QPA_PLATFORM="xcb", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", QT_ACCESSIBILITY="1",
                   LIBGL_ALWAYS_SOFTWARE="1", LC_ALL="C.UTF-8", LANGUAGE="en", HOME=folder)
        for name in ("CONFIG", "DATA", "CACHE"):
            env[f"XDG_{name}_HOME"] = os.path.join(folder, name.lower())
        env["XDG_RUNTIME_DIR"] = os.path.join(folder, "runtime")
        os.makedirs(env["XDG_RUNTIME_DIR"], mode=0o700, exist_ok=True)
        env.update({k: str(v) for k, v in environment.items()})
        self.log = open(os.path.join(folder, "program.log"), "a")
        # Now and then the accessibility bus misses a program that starts (seen once): started again.
        for attempt in range(3):
            self.process = subprocess.Popen([binary, "--db", database, *arguments], env=env, stdout=self.log, stderr=self.log,
                                            stdin=subprocess.DEVNULL)
            try:
                self.root = until("the program's window", self._find_root, 20 if attempt < 2 else None)
                break
            except Missing:
                self.process.terminate()  # a kill would be a crash to the next start
                self.process.wait()
                if attempt == 2:
                    raise
        self.find("frame", "Cusp")

    def _find_root(self):
        if self.process.poll() is not None:
            raise SystemExit(f"the program ended at its start, with {self.process.returncode}: {self.output()}")
        desktop = Atspi.get_desktop(0)
        desktop.set_cache_mask(Atspi.Cache.NONE)
        for i in range(desktop.get_child_count()):
            try:
                child = desktop.get_child_at_index(i)
                if child is None or child.get_process_id() != self.process.pid or child.get_child_count() == 0:
                    continue
            except Atspi_Error():  # a killed program that the desktop still lists
                continue
            child.set_cache_mask(Atspi.Cache.NONE)
            return Widget(child, self)
        return None

    def output(self):
        """What the program wrote to its terminal."""
        self.log.flush()
        with open(self.log.name, encoding="utf-8", errors="replace") as f:
            return f.read().strip()

    def alive(self):
        if self.process.poll() is not None:
            raise SystemExit(f"the program ended, with {self.process.returncode}: {self.output()}")

    def all(self, role=None, name=None, within=None):
        """Everything shown of a role, whose name is (str) or matches (compiled pattern)."""
        self.alive()
        for widget in (within or self.root).walk():
            try:
                if fits(role, widget.role) and any(fits(name, meant) for meant in (widget.meanings if name else [None])):
                    yield widget
            except Atspi_Error():
                continue

    def here(self, role=None, name=None, within=None):
        return next(self.all(role, name, within), None)

    def find(self, role=None, name=None, within=None, limit_s=None):
        return until(f"{role or 'anything'} {getattr(name, 'pattern', name)!r}", lambda: self.here(role, name, within), limit_s)

    def labelled(self, role, label):
        """A folding list or a number, by the text over it."""
        return until(f"{role} under {label!r}", lambda: next((w for w in self.all(role) if label in w.labels()), None))

    def gone(self, role, name):
        until(f"{role} {name!r} to go", lambda: self.here(role, name) is None)

    def press(self, name, role="push button", within=None):
        return self.find(role, name, within).press()

    def windows(self):
        """Of the program, with what has popped up."""
        found = subprocess.run(["xdotool", "search", "--onlyvisible", "--pid", str(self.process.pid)], capture_output=True,
                               text=True)
        return len(found.stdout.split())

    def menu(self, button, *keys):
        """Opens a button's menu and walks through it by `keys`: Qt does not show an open menu to a screen reader's search,
        and waits in it for the answer, so that it is opened by the mouse."""
        before = self.windows()
        self.menu_to_dialog(button, *keys)
        until("the menu to close", lambda: self.windows() <= before)

    def menu_to_dialog(self, button, *keys):
        """The same where the chosen item opens a dialog, which the caller waits for."""
        before = self.windows()
        self.find("push button", button).click()
        until(f"the menu of {getattr(button, 'pattern', button)!r}", lambda: self.windows() > before)
        self.keys(*keys)

    def keys(self, *names):
        for name in names:
            self.screen.x("key", "--clearmodifiers", name)

    def texts(self):
        """All text on the screen, in order."""
        return [w.name for w in self.all() if w.name]

    def tree(self):
        lines = []

        def add(widget, depth):
            for child in widget.children():
                try:
                    if not child.has("SHOWING"):
                        continue
                    states = [s for s in ("FOCUSED", "CHECKED", "SELECTED") if child.has(s)]
                    if not child.has("ENABLED"):
                        states.append("disabled")
                    x, y, width, height = child.box()
                    value = ""
                    if "Text" in child.node.get_interfaces() and child.role in ("text", "password text"):
                        value = f" = {child.text!r}"
                    if "Value" in child.node.get_interfaces():
                        value = f" = {child.value:g}"
                    lines.append(f"{'  ' * depth}{child.role} {child.name!r}{value} {' '.join(states)} [{x} {y} {width}x{height}]"
                                 + (f" ({child.description})" if child.description else ""))
                    add(child, depth + 1)
                except Atspi_Error():
                    continue
        add(self.root, 0)
        return "\n".join(lines)

    def active(self):
        """True where the window manager sends keys to the program."""
        found = subprocess.run(["xdotool", "getactivewindow", "getwindowpid"], capture_output=True, text=True)
        return found.stdout.strip() == str(self.process.pid)

    def close(self):
        """Closes the window as its owner does, and waits for the program to end well."""
        until("the window to be the active one", self.active)
        for pressed in range(1, 4):
            self.screen.x("key", "--clearmodifiers", "alt+F4")
            try:
                self.process.wait(LIMIT_S / 3)
                break
            except subprocess.TimeoutExpired:
                print(f"the window is open after its owner closed it {pressed} times: {self.texts()}", flush=True)
        else:
            raise Missing("the program did not end when its window was closed")
        if self.process.returncode != 0:
            raise Missing(f"the program ended with {self.process.returncode}: {self.output()}")

    def kill(self):
        """As a power cut does."""
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGKILL)
        self.process.wait()


class Desk:
    """A folder, a screen, and the programs started on it; everything is removed when it is left."""

    def __init__(self, binary, width=1300, height=840):
        self.binary = os.path.abspath(binary)
        self.folder = tempfile.mkdtemp(prefix="cusp-desk-")
        self.database = os.path.join(self.folder, "records", "cusp.db")
        os.makedirs(os.path.dirname(self.database))
        self.screen = Screen(self.folder, width, height)
        self.program = None
        self.language, self.pixels, self.environment = "en", 1, {}  # of the programs

    def start(self, *arguments, **environment):
        self.program = Program(self.binary, self.screen, self.folder, self.database, *arguments, language=self.language,
                               pixels=self.pixels, **self.environment, **environment)
        return self.program

    def __enter__(self):
        return self

    def __exit__(self, kind, problem, trace):
        if kind is not None:
            self._keep_evidence(problem)
        if self.program:
            self.program.kill()
        self.screen.close()
        shutil.rmtree(self.folder, ignore_errors=True)

    def _keep_evidence(self, problem):
        folder = os.environ.get("CUSP_DESK_PICTURES") or tempfile.gettempdir()
        os.makedirs(folder, exist_ok=True)
        base = os.path.join(folder, f"{os.path.splitext(os.path.basename(sys.argv[0]))[0]}-failed")
        self.screen.picture(base + ".png")
        if self.program:
            with open(base + ".txt", "w", encoding="utf-8") as f:
                f.write("".join(traceback.format_exception(problem)) + "\n" + self.program.output() + "\n\n")
                try:
                    f.write(self.program.tree())
                except Exception as error:  # whatever broke the test may break this too
                    f.write(f"(the screen cannot be read: {error})")
        print(f"FAILED: {problem}\nthe screen is in {base}.png, its text in {base}.txt", file=sys.stderr)


def check(holds, what):
    if not holds:
        raise Missing(what)
