"""Devices to plug into the running program: cusp_plugs (tests/ui/device/plugs.cpp) holds a Falcon, a foot pedal and a
SpaceMouse on a mock of the kernel's files, which the program sees as its own."""
import subprocess

from desk import Missing


class Plugs:
    def __init__(self, binary):
        self.child = subprocess.Popen(["umockdev-wrapper", binary], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.folder = self.child.stdout.readline().strip()
        if not self.folder:
            raise Missing("the devices did not start")
        # As umockdev-wrapper does it.
        self.environment = {"UMOCKDEV_DIR": self.folder, "LD_PRELOAD": "libumockdev-preload.so.0"}

    def __call__(self, *order):
        """Leads a device: plugs("falcon", "plug")."""
        self.child.stdin.write(" ".join(str(w) for w in order) + "\n")
        self.child.stdin.flush()
        answer = self.child.stdout.readline().strip()
        if answer in ("", "?"):
            raise Missing(f"the devices do not know {order}")
        return answer

    def __enter__(self):
        return self

    def __exit__(self, kind, problem, trace):
        self.child.stdin.close()
        self.child.wait()
