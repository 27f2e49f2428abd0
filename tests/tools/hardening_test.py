# SPDX-License-Identifier: GPL-3.0-or-later
"""The program (TRIAX) and the Python module (TRIAX_MODULE) of a release build have Debian's hardening, by readelf and objdump."""
import os
import platform
import re
import subprocess
import unittest


def read_elf(file, *options):
    return subprocess.run(["readelf", "--wide", *options, file], check=True, capture_output=True, text=True).stdout


class Hardening(unittest.TestCase):
    FILES = [os.environ[name] for name in ("TRIAX", "TRIAX_MODULE")]

    def has_in_all(self, options, pattern):
        for file in self.FILES:
            with self.subTest(file=file):
                self.assertRegex(read_elf(file, *options), pattern)

    def test_program_is_position_independent(self):
        self.assertRegex(read_elf(self.FILES[0], "--dynamic"), r"FLAGS_1.*\bPIE\b")

    def test_relocations_are_resolved_at_start_and_read_only(self):
        self.has_in_all(["--dynamic"], r"BIND_NOW|FLAGS_1.*\bNOW\b")
        self.has_in_all(["--segments"], r"GNU_RELRO")

    def test_stack_is_not_executable(self):
        self.has_in_all(["--segments"], r"GNU_STACK\s+(0x\w+\s+){5}RW\s")

    def test_stack_protector_is_used(self):
        self.has_in_all(["--dyn-syms"], r"__stack_chk_fail\b")

    def test_calls_of_the_c_library_are_fortified(self):
        self.has_in_all(["--dyn-syms"], r"__(mem|str|read|recv|sn?printf|vsn?printf|fprintf)\w*_chk\b")

    @unittest.skipUnless(re.match("x86_64|AMD64", platform.machine()), "only x86-64 has these instructions")
    def test_targets_of_branches_are_marked(self):
        # The start-up code of Debian 12 and 13 is not marked, so that the files as a whole are not: what counts is our own code.
        for file, function in zip(self.FILES, ("main", "PyInit__triax")):
            code = subprocess.run(["objdump", f"--disassemble={function}", file], check=True, capture_output=True, text=True).stdout
            self.assertRegex(code, rf"<{function}>:\n.*\bendbr64\b")


if __name__ == "__main__":
    unittest.main()
