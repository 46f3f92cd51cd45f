"""./run beside stand-ins for dpkg, apt, cmake and the program: what it installs, when it asks for root, what it waits for, and where the
program runs.

    python3 tests/clean_root/set_up.py
"""
import fcntl
import os
import shutil
import subprocess
import tempfile

SOURCE = os.path.abspath(__file__ + "/../../..")
STAND_INS = {
    "id": 'echo "${WHO:-1000}"',
    "dirname": 'exec /usr/bin/dirname "$@"',
    "dpkg-query": 'grep -qx "${@: -1}" "$STATE/installed" && printf "%s" "${HELD:-ii }"',
    "apt-cache": 'grep -qx "${@: -1}" "$STATE/offered" && echo "  Candidate: 1.0" || echo "  Candidate: (none)"',
    "sudo": """echo "sudo $*" >>"$STATE/log"
if [[ "$*" == *"apt-get update"* && -s "$STATE/busy" ]]; then
  : >"$STATE/busy"
  echo "E: Could not get lock /var/lib/apt/lists/lock. It is held by process 7 (apt-get)" >&2
  exit 100
fi
if [[ "$*" == *"apt-get update"* && -s "$STATE/unsigned" ]]; then
  : >"$STATE/unsigned"
  echo "E: The repository 'https://archive.example' is not signed." >&2
  exit 100
fi
if [[ "$*" == *" true" && -s "$STATE/refused" ]]; then
  : >"$STATE/refused"
  echo "mira is not in the sudoers file." >&2
  exit 1
fi
if [[ "$*" == *"apt-get install"* && -s "$STATE/lacking" ]]; then
  : >"$STATE/lacking"
  echo "E: Unable to locate package older-name" >&2
  exit 100
fi""",
    "apt-get": 'echo "apt-get $*" >>"$STATE/log"',
    "dpkg": 'echo "dpkg $*" >>"$STATE/log"; exit 2',
    "chown": 'echo "chown $*" >>"$STATE/log"',
    "sleep": 'echo "sleep $*" >>"$STATE/log"',
    "cmake": 'if [ "$1" = --version ]; then echo "cmake version ${CMAKE:-3.25.1}"; else echo "cmake $*"; echo "cmake $*" >>"$STATE/log"; echo "${CCACHE_DIR:-}" >"$STATE/ccache"; fi',
}


def write(path, text):
    with open(path, "w", encoding="utf-8") as f:
        f.write(text)


def tools_in(folder, sudo):
    """A PATH with the stand-ins and little else."""
    tools = os.path.join(folder, "tools")
    os.makedirs(tools, exist_ok=True)
    for name, what in STAND_INS.items():
        write(os.path.join(tools, name), f"#!/bin/bash\n{what}\n")
        os.chmod(os.path.join(tools, name), 0o755)
    for name in ("bash", "env", "flock", "grep", "cat", "mkdir", "sed", "touch"):
        if not os.path.exists(os.path.join(tools, name)):
            os.symlink(shutil.which(name), os.path.join(tools, name))
    if not sudo:
        os.remove(os.path.join(tools, "sudo"))
    return tools


def run(folder, *arguments, sudo, **environment):
    tools = tools_in(folder, sudo)
    write(os.path.join(folder, "log"), "")
    done = subprocess.run([os.path.join(folder, "a tree", "run"), *arguments], cwd=folder, capture_output=True, text=True,
                          env=dict(PATH=tools, STATE=folder, **environment))
    with open(os.path.join(folder, "log"), encoding="utf-8") as f:
        return done.returncode, done.stdout + done.stderr, f.read()


def check(holds, what):
    if not holds:
        raise SystemExit(f"FAILED: {what}")


def package_lists(state, tree):
    """Lists that another program updates are waited for. Where apt does not know a package, the releases are named that have it."""
    os.remove(os.path.join(tree, "build/.packages"))
    write(os.path.join(state, "busy"), "yes")
    status, said, log = run(state, "--set-up", sudo=True)
    check(status == 0 and log.count("apt-get update") == 2 and "sleep" in log and "apt-get install" in log, f"beside another update: {said}{log}")
    os.remove(os.path.join(tree, "build/.packages"))
    write(os.path.join(state, "lacking"), "yes")
    status, said, log = run(state, "--set-up", sudo=True)
    check(status == 1 and "locate package older-name" in said and "Ubuntu 24.04" in said, f"a release without a package: {said}{log}")
    write(os.path.join(state, "unsigned"), "yes")
    status, said, log = run(state, "--set-up", sudo=True)
    check(status == 0 and "is not signed" in said and log.strip().endswith("older-name"),
          f"after an installation that failed, beside an archive that cannot be read: {said}{log}")
    os.remove(os.path.join(tree, "build/.packages"))
    write(os.path.join(state, "refused"), "yes")
    status, said, log = run(state, "--set-up", sudo=True)
    check(status == 1 and "once as root" in said and "apt-get" not in log, f"somebody whom sudo refuses: {said}{log}")
    write(os.path.join(tree, "build/.packages"), "")


def as_root(state, tree):
    """Without sudo. The folder build belongs to whoever owns the tree."""
    os.remove(os.path.join(tree, "build/.packages"))
    status, said, log = run(state, "--set-up", sudo=False, WHO="0")
    check(status == 0 and log.index("dpkg --configure -a") < log.index("apt-get install") and "older-name" in log and "chown --reference=. build build/.packages" in log, f"as root: {said}{log}")


def configuring(state, tree):
    """A folder begins anew where another compiler or another place has configured it. An old cmake is called by its name."""
    cache = os.path.join(tree, "build/release/CMakeCache.txt")
    here = f"CMAKE_CXX_COMPILER:STRING=/usr/bin/clang++-19\nCMAKE_HOME_DIRECTORY:INTERNAL={tree}\n"
    for text, fresh in ((None, True), (here, False), (here.replace("clang++-19", "g++"), True), (here.replace(tree, state), True)):
        if text:
            write(cache, text)
        status, said, log = run(state, "validate", sudo=True)
        check(status == 0 and ("cmake --fresh --preset release" in log) == fresh, f"configured before as {text}: {said}{log}")
        check("cmake --build --preset release --target cusp --" in log, f"what is built: {log}")
    status, said, log = run(state, "--build", "asan", sudo=True)
    check(status == 0 and log.splitlines()[-1] == "cmake --build --preset asan -- --quiet", f"a preset of ./check: {said}{log}")
    for version, fits in (("3.22.1", False), ("3.25.1", True), ("4.0.2", True)):
        status, said, log = run(state, "validate", sudo=True, CMAKE=version)
        check((status == 0) == fits == ("older than CMake 3.25" not in said), f"cmake {version}: {said}{log}")


def without_a_home(state, tree):
    """ccache finds a folder where the home folder cannot be written."""
    for home, folder in ((state, ""), (os.path.join(state, "none"), os.path.join(tree, "build/ccache"))):
        run(state, "--build", "release", sudo=True, HOME=home)
        with open(os.path.join(state, "ccache"), encoding="utf-8") as f:
            check(f.read() == folder + "\n", f"the folder of ccache, with {home} as home")


with tempfile.TemporaryDirectory(prefix="cusp-set-up-") as state:
    tree = os.path.join(state, "a tree")
    os.makedirs(os.path.join(tree, "build/release"))
    shutil.copy(os.path.join(SOURCE, "run"), tree)
    write(os.path.join(tree, "packages.txt"), "# a comment\nhere\nhere-too\nolder-name ?\n")
    write(os.path.join(tree, "build/release/cusp"), '#!/bin/bash\necho "in $PWD: $*"\n')
    os.chmod(os.path.join(tree, "build/release/cusp"), 0o755)
    write(os.path.join(state, "installed"), "here\nhere-too\n")
    write(os.path.join(state, "offered"), "here\nhere-too\n")
    status, said, log = run(state, "--set-up", sudo=False)
    check(status == 0 and log == "", f"all is installed that this release has, and ./run asks for root: {said}{log}")
    os.remove(os.path.join(tree, "build/.packages"))
    status, said, log = run(state, "--set-up", sudo=True, HELD="hi ")
    check(status == 0 and log == "", f"a held package is installed: {said}{log}")
    write(os.path.join(state, "offered"), "here\nhere-too\nolder-name\n")
    os.remove(os.path.join(tree, "build/.packages"))
    status, said, log = run(state, "--set-up", sudo=False)
    check(status == 1 and "older-name" in said and "here" not in said.replace("here-too", ""), f"what is missing is named alone: {said}")
    status, said, log = run(state, "--set-up", sudo=True, http_proxy="http://proxy:3128")
    check(status == 0 and "--preserve-env=http_proxy" in log and log.strip().endswith("older-name"), f"older-name is installed: {log}")
    package_lists(state, tree)
    configuring(state, tree)
    without_a_home(state, tree)
    as_root(state, tree)
    status, said, log = run(state, "validate", "mine.cusp", sudo=True)
    check(status == 0 and f"in {state}: validate mine.cusp" in said, f"a path is one of where ./run was called: {said}")
    for environment, window in ((dict(DISPLAY=":7"), True), (dict(WAYLAND_DISPLAY="wayland-0"), True), (dict(QT_QPA_PLATFORM="vnc:port=5901"), True),
                                (dict(QT_QPA_PLATFORM="offscreen"), False), (dict(QT_QPA_PLATFORM="xcb"), False), (dict(), False)):
        status, said, log = run(state, sudo=True, HOME=state, **environment)
        check(status == 0 and ("No display" not in said) == window, f"{environment}: {said}")
    for environment in (dict(), dict(HOME="/proc/none")):  # where nobody may make a folder
        status, said, log = run(state, sudo=True, **environment)
        check(status == 0 and f"lies in {tree}/build/cusp/demonstration:" in said, f"without a home, {environment}: {said}")

    os.makedirs(os.path.join(state, "elsewhere", "a tree"))
    done = subprocess.run(["a tree/run", "validate"], cwd=state, capture_output=True, text=True,
                          env=dict(PATH=tools_in(state, True), STATE=state, CDPATH=os.path.join(state, "elsewhere")))
    check(done.returncode == 0 and done.stdout == f"in {state}: validate\n", f"with CDPATH, and nothing but the program's own: {done.stdout}{done.stderr}")

    with open(os.path.join(tree, "build/.lock"), "w", encoding="utf-8") as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        second = subprocess.Popen([os.path.join(tree, "run"), "validate"], cwd=state, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                  env=dict(PATH=tools_in(state, True), STATE=state))
        said = second.stderr.readline()
    out, err = second.communicate()
    check("Waiting" in said and second.returncode == 0 and f"in {state}: validate" in out, f"beside another build: {said}{out}{err}")
