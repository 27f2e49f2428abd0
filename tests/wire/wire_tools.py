# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts of this folder share: our served instruments, tools of others, and what is expected of them."""
import shutil
import subprocess
import sys

SKIPPED = 77


def skip_without(*tools):
    """CTest says "Skipped", and the output which tool is missing."""
    for tool in tools:
        if shutil.which(tool) is None:
            print(f"skipped: {tool} is not installed (tools/packages-test.txt)")
            sys.exit(SKIPPED)


class Served:
    """Our instruments at free ports: `ports["34401A"]`. They end with this script at the latest."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([sys.argv[1], *arguments], stdout=subprocess.PIPE, text=True)
        self.ports = {}
        for line in self.process.stdout:
            if line == "ready\n":
                return
            name, address = line.split()
            self.ports[name] = address.rsplit(":", 1)[1]
        raise SystemExit("the instruments did not begin")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()


def run(*command, **more):
    """The output of a command that must end well."""
    done = subprocess.run(command, capture_output=True, text=True, timeout=30, **more)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def expect(found, wanted, what):
    if found != wanted:
        raise SystemExit(f"{what}: {found!r} instead of {wanted!r}")
    print(f"ok: {what}")
