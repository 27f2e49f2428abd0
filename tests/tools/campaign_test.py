# SPDX-License-Identifier: GPL-3.0-or-later
"""tools/campaign against the built program (TRIAX names it): each kind of trial holds for some seconds; against programs that lose a
reading, leave half a file, crash, print no JSON or write where they should read, each notices."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

CAMPAIGN = pathlib.Path(__file__).resolve().parents[2] / "tools" / "campaign"
TRIAX = os.environ["TRIAX"]

# The program, but for one fault; what it does where nobody disturbs it is sound.
FAULTY = """#!{python}
import os, pathlib, signal, sqlite3, subprocess, sys, time
arguments, sound = sys.argv[1:], "undisturbed" in os.getcwd()
done = subprocess.run(["{triax}", *arguments], capture_output=True)
def database():
    return sqlite3.connect("t.db", isolation_level=None, timeout=60)
begin = time.monotonic()
if not sound:
    {fault}
if time.monotonic() - begin > 1:  # the fault itself had to wait for a lock, which is not what is looked for
    done.stderr += b"until the database can be written\\nnothing is lost\\n"
sys.stdout.buffer.write(done.stdout)
sys.stderr.buffer.write(done.stderr)
sys.exit(done.returncode)
"""
LOSES_A_READING = 'database().execute("DELETE FROM scans WHERE id = (SELECT max(id) FROM scans)")'
CHANGES_A_READING = 'database().execute("UPDATE scans SET time_s = time_s + 1e-9 WHERE id = (SELECT max(id) FROM scans)")'
HALF_A_FILE = 'p = pathlib.Path("r.csv"); p.write_bytes(p.read_bytes()[:1000])'
CRASHES = "os.kill(os.getpid(), signal.SIGSEGV)"
PRINTS_NAN = 'done = subprocess.CompletedProcess([], 0, b"{\\"x\\": NaN}", b"")'
SAYS_TOO_MUCH = 'done = subprocess.CompletedProcess([], 2, b"", b"triax: one\\ntriax: two\\n")'
WRITES = 'pathlib.Path("t.db").open("ab").write(b"x")'


# A program of a rig, of which a stop does not stop the work, but for one fault.
FAULTY_ON_A_RIG = """#!{python}
import os, signal, sqlite3, subprocess, sys
if sys.argv[1] == "serve":
    os.execv("{triax}", ["{triax}", *sys.argv[1:]])
work = subprocess.Popen(["{triax}", *sys.argv[1:]])
def go_on(*_):
    {at_going_on}
signal.signal(signal.SIGCONT, go_on)
signal.signal(signal.SIGINT, lambda *_: work.send_signal(signal.SIGINT))
status = work.wait()
{at_its_end}
sys.exit(status)
"""
CRASHES_AFTER_A_STOP = "work.kill(); os.kill(os.getpid(), signal.SIGSEGV)"
LOSES_THE_FIRST = 'sqlite3.connect("t.db", isolation_level=None).execute("DELETE FROM scans WHERE id = (SELECT min(id) FROM scans)")'


class Campaign(unittest.TestCase):
    def campaign(self, program, *arguments):
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            return subprocess.run([sys.executable, CAMPAIGN, "--program", program, "--folder", folder, *arguments], capture_output=True,
                                  text=True, check=False)

    def holds(self, kind, *more):
        done = self.campaign(TRIAX, "--only", kind, "--minutes", "0.06", "--seed", "5", *more)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        total = re.search(r"^all +(\d+) +(\d+) +(\d+)$", done.stdout, re.M)
        self.assertGreater(int(total[1]), 0)
        self.assertEqual((total[1], "0"), (total[2], total[3]))
        return done

    def notices(self, fault, kind, part, words):
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            faulty = pathlib.Path(folder) / "triax"
            faulty.write_text(FAULTY.format(python=sys.executable, triax=TRIAX, fault=fault), encoding="utf-8")
            faulty.chmod(0o755)
            done = self.campaign(str(faulty), "--only", kind, "--of", part, "--trial", "1")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(words, done.stderr)
        self.assertIn(f"again: tools/campaign --only {kind} --of '{part}' --seed 1 --trial 1", done.stderr)
        self.assertRegex(done.stdout, r"(?m)^all +1 +0 +1$")

    def notices_on_a_rig(self, part, hold, words, at_going_on="pass", at_its_end="pass"):
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            faulty = pathlib.Path(folder) / "triax"
            faulty.write_text(FAULTY_ON_A_RIG.format(python=sys.executable, triax=TRIAX, at_going_on=at_going_on, at_its_end=at_its_end),
                              encoding="utf-8")
            faulty.chmod(0o755)
            done = self.campaign(str(faulty), "--only", "stops", "--of", part, "--hold", hold, "--trial", "1")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(words, done.stderr)

    def test_kills(self):
        self.holds("kills")

    def test_mutants(self):
        self.holds("mutants")

    def test_databases(self):
        self.holds("databases")

    def test_locks(self):
        self.holds("locks")

    def test_moves(self):
        self.holds("moves")

    def test_disks(self):
        self.holds("disks")

    def test_signals(self):
        self.holds("signals")

    def test_stops(self):
        done = self.holds("stops", "--hold", "1.2")
        self.assertRegex(done.stdout, r"(?m)^stops: .*[0-9]+ stops of up to 3 s")

    def test_a_crash_after_a_stop_is_noticed(self):
        self.notices_on_a_rig("run", "0.3", "by SIGSEGV", at_going_on=CRASHES_AFTER_A_STOP)

    def test_a_gap_that_is_not_reported_is_noticed(self):
        self.notices_on_a_rig("record", "1.2", "a stop of 1.20 s left no word")

    def test_a_test_that_goes_on_after_a_long_stop_is_noticed(self):
        self.notices_on_a_rig("run", "4.6", "the test went on after a long stop")

    def test_a_reading_lost_on_a_rig_is_noticed(self):
        self.notices_on_a_rig("run", "0.3", "readings were committed, now they differ", at_its_end=LOSES_THE_FIRST)

    def test_a_lost_reading_is_noticed(self):
        self.notices(LOSES_A_READING, "locks", "replay", "scans differs from that of an undisturbed run")

    def test_a_changed_bit_is_noticed(self):
        self.notices(CHANGES_A_READING, "locks", "replay", "scans differs from that of an undisturbed run")

    def test_half_a_file_is_noticed(self):
        self.notices(HALF_A_FILE, "locks", "simulate", "r.csv is not that of an undisturbed run")

    def test_a_crash_is_noticed(self):
        self.notices(CRASHES, "mutants", "record", "ended by SIGSEGV")

    def test_what_is_no_json_is_noticed(self):
        self.notices(PRINTS_NAN, "mutants", "record", "NaN in it")

    def test_a_second_line_is_noticed(self):
        self.notices(SAYS_TOO_MUCH, "mutants", "record", "status 2 with 2 lines")

    def test_a_reader_that_writes_is_noticed(self):
        self.notices(WRITES, "databases", "flip bytes", "changed ['t.db']")

    def test_a_kind_that_is_not_there(self):
        done = self.campaign(TRIAX, "--only", "earthquakes")
        self.assertEqual(done.returncode, 2)
        self.assertIn("no kind earthquakes; there are kills,", done.stderr)


if __name__ == "__main__":
    unittest.main()
