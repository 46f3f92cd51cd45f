"""./run beside stand-ins for dpkg, apt, cmake and the program: what it installs, when it asks for root, and where the program runs.

    python3 tests/clean_root/set_up.py
"""
import os
import shutil
import subprocess
import tempfile

SOURCE = os.path.abspath(__file__ + "/../../..")
STAND_INS = {
    "id": "echo 1000",
    "dirname": 'exec /usr/bin/dirname "$@"',
    "dpkg-query": 'grep -qx "${@: -1}" "$STATE/installed" && printf "%s" "${HELD:-ii }"',
    "apt-cache": 'grep -qx "${@: -1}" "$STATE/offered" && echo "  Candidate: 1.0" || echo "  Candidate: (none)"',
    "sudo": 'echo "sudo $*" >>"$STATE/log"',
    "cmake": "exit 0",
}


def write(path, text):
    with open(path, "w", encoding="utf-8") as f:
        f.write(text)


def run(folder, *arguments, sudo, **environment):
    tools = os.path.join(folder, "tools")
    os.makedirs(tools, exist_ok=True)
    for name, what in STAND_INS.items():
        write(os.path.join(tools, name), f"#!/bin/bash\n{what}\n")
        os.chmod(os.path.join(tools, name), 0o755)
    for name in ("bash", "env", "grep", "cat", "mkdir", "touch"):
        if not os.path.exists(os.path.join(tools, name)):
            os.symlink(shutil.which(name), os.path.join(tools, name))
    if not sudo:
        os.remove(os.path.join(tools, "sudo"))
    write(os.path.join(folder, "log"), "")
    done = subprocess.run([os.path.join(folder, "a tree", "run"), *arguments], cwd=folder, capture_output=True, text=True,
                          env=dict(PATH=tools, STATE=folder, **environment))
    with open(os.path.join(folder, "log"), encoding="utf-8") as f:
        return done.returncode, done.stdout + done.stderr, f.read()


def check(holds, what):
    if not holds:
        raise SystemExit(f"FAILED: {what}")


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
    status, said, log = run(state, "validate", "mine.cusp", sudo=True)
    check(status == 0 and f"in {state}: validate mine.cusp" in said, f"a path is one of where ./run was called: {said}")
    for environment, window in ((dict(DISPLAY=":7"), True), (dict(WAYLAND_DISPLAY="wayland-0"), True), (dict(QT_QPA_PLATFORM="vnc:port=5901"), True),
                                (dict(QT_QPA_PLATFORM="offscreen"), False), (dict(QT_QPA_PLATFORM="xcb"), False), (dict(), False)):
        status, said, log = run(state, sudo=True, HOME=state, **environment)
        check(status == 0 and ("No display" not in said) == window, f"{environment}: {said}")
