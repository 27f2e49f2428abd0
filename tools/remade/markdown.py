# SPDX-License-Identifier: GPL-3.0-or-later
"""Markdown without its code, for the checks of pages. What is removed becomes spaces, so that line numbers stay."""
import re


def blank(match: re.Match) -> str:
    return re.sub(r"[^\n]", " ", match.group())


def without_code_blocks(text: str) -> str:
    """Without fenced code, and without code that is indented after an empty line."""
    text = re.sub(r"^( *)```.*?^\1```", blank, text, flags=re.S | re.M)
    return re.sub(r"(?:\A|(?<=\n\n))(?:(?: {4}|\t).*(?:\n|\Z)|\n(?= {4}))+", blank, text)


def without_code(text: str) -> str:
    """Also without code in backticks."""
    return re.sub(r"`[^`\n]+`", blank, without_code_blocks(text))
