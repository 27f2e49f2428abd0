# SPDX-License-Identifier: GPL-3.0-or-later
"""Random numbers of a programme, and how they are written as TOML."""
import math


def log_uniform(random, low, high):
    return math.exp(random.uniform(math.log(low), math.log(high)))


def between(good, terrible, quality):
    """From `good` at quality 0 to `terrible` at 1, on a logarithmic scale."""
    return good * (terrible / good) ** quality


def rounded(value, digits=4):
    """To significant digits, so that the text of a programme is short."""
    return float(f"{value:.{digits}g}")


def weighted(random, weights):
    return random.choices(list(weights), list(weights.values()))[0]


def cell(value):
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, dict):
        return "{" + ", ".join(f"{k} = {cell(v)}" for k, v in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(cell(v) for v in value) + "]"
    return repr(value)


def table(heading, values):
    return "\n".join([heading] + [f"{key} = {cell(value)}" for key, value in values.items()]) + "\n\n"
