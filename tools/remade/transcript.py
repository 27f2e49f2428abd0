# SPDX-License-Identifier: GPL-3.0-or-later
"""What a shell says to the commands that a page shows.

Lines that begin with $ are the commands, run one after the other. A command below which nothing stands is run and its output not shown.
Where "..." ends what stands below it, as many lines are shown as stand there; where "..." begins it, they begin with the line that
stands next. Else all are shown. A command that is to fail has a remark which says "exit status N".
"""
import re
import sys


def commands_of(body: str) -> list[tuple[str, list[str]]]:
    shown: list[tuple[str, list[str]]] = []
    for line in body.rstrip("\n").split("\n"):
        if line.startswith("    $ "):
            shown.append((line, []))
        elif shown and shown[-1][0].endswith("\\") and not shown[-1][1]:
            shown[-1] = (f"{shown[-1][0]}\n{line}", [])
        elif shown:
            shown[-1][1].append(line)
        else:
            sys.exit(f"a transcript begins with a command, not with: {line}")
    return shown


def as_much_as(before: list[str], told: list[str]) -> list[str]:
    head = ["    ..."] if len(before) > 1 and before[0] == "    ..." and before[1] in told else []
    if head:
        before, told = before[1:], told[told.index(before[1]):]
    if before[-1] != "    ...":
        return head + told
    shown = "\n".join(told[:len(before) - 1]).rstrip("\n").split("\n")
    return head + shown + ["    ..."]


def expected_status(command: str) -> int:
    remark = re.search(r"# .*exit status (\d)", command)
    return int(remark[1]) if remark else 0


def made_anew(body: str, triax) -> str:
    lines = []
    for command, before in commands_of(body):
        done = triax.shell(command.lstrip().removeprefix("$ "))
        if done.returncode != expected_status(command):
            sys.exit(f"{command}\nstatus {done.returncode}\n{done.stdout}")
        after = [f"    {line}".rstrip() for line in done.stdout.rstrip("\n").split("\n")]
        lines += [command, *(as_much_as(before, after) if before else [])]
    return "\n".join(lines)
