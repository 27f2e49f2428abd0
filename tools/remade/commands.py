# SPDX-License-Identifier: GPL-3.0-or-later
"""Commands that a page shows without running them: triax knows them and their options."""
import re
import subprocess

SHOWN = re.compile(r"`triax ([^`]+)`|^ {4}(?:\$ )?(?:build/release/)?triax (.+(?:\\\n.+)*)", re.M)


def unknown(page: str, text: str, triax) -> bool:
    """Whether there are such; they are printed."""
    helps: dict[str, str] = {}
    found = False
    for match in SHOWN.finditer(text):
        line = re.sub(r"\s#\s.*", "", match[1] or match[2])
        command = line.split()[0]
        if not re.fullmatch(r"[a-z]+", command):  # options of the program itself, or PROGRAMME.toml for any command
            command = ""
        if command not in helps:
            done = subprocess.run([triax.program, *command.split(), "--help"], capture_output=True, text=True, check=False)
            helps[command] = done.stdout if done.returncode == 0 else ""
        for option in re.findall(r"(?<!\S)\[?(--[a-z][\w-]*)", line):
            if not re.search(rf"(?<![\w-]){option}(?![\w-])", helps[command]):
                print(f"{page}: `triax {line.strip()}`: {option} is no option of triax {command}")
                found = True
        if not helps[command]:
            print(f"{page}: `triax {line.strip()}`: triax {command} --help fails")
            found = True
    return found
