# SPDX-License-Identifier: GPL-3.0-or-later
"""Ways to spoil a file: bytes, lines, words, numbers, its length, its encoding."""
import random
import re

NUMBER = re.compile(rb"[-+]?\d+\.?\d*(?:[eE][-+]?\d+)?")
NUMBERS = (b"0", b"-0", b"-1", b"1e308", b"-1e308", b"1e-308", b"1e400", b"nan", b"NaN", b"inf", b"-inf", b"99999999999999999999",
           b"-9223372036854775808", b"4294967296", b"0x10", b"1_000", b"", b"1,5", b"1.", b".5", b"+-1", b"1e", b"3" * 400, b"1" + b"0" * 40,
           b"0." + b"0" * 40 + b"1")
ODD = (b"\0", b"\xff", b"\xef\xbb\xbf", b"\r", b"\x1b[31m", b"\xe2\x80\xae", b"\"", b"'", b"\"\"\"", b"[", b"]", b"{", b"}", b"[[", b"=",
       b";", b",", b"\t", b"#", b"\\", b"\\u0000", b"\xc3\xa4", b"\xf0\x9f\x98\x80", b"=1+1", b"/", b"../", b"%s%n")


def place(data: bytes, chance: random.Random) -> int:
    return chance.randrange(len(data) + 1)


def flip(data: bytes, chance: random.Random) -> bytes:
    changed = bytearray(data)
    for _ in range(chance.choice((1, 1, 3, 20)) if data else 0):
        changed[chance.randrange(len(changed))] = chance.randrange(256)
    return bytes(changed)


def insert(data: bytes, chance: random.Random) -> bytes:
    at = place(data, chance)
    what = chance.choice((chance.choice(ODD), chance.choice(ODD) * 2000, chance.randbytes(chance.choice((1, 40, 5000)))))
    return data[:at] + what + data[at:]


def remove(data: bytes, chance: random.Random) -> bytes:
    at = place(data, chance)
    return data[:at] + data[at + chance.choice((1, 1, 4, 30, 400)):]


def cut(data: bytes, chance: random.Random) -> bytes:
    return data[:place(data, chance)]


def lines(data: bytes, chance: random.Random) -> bytes:
    all_of_them = data.split(b"\n")
    a, b = (chance.randrange(len(all_of_them)) for _ in range(2))
    how = chance.randrange(6)
    if how == 0:
        del all_of_them[a]
    elif how == 1:
        all_of_them[a], all_of_them[b] = all_of_them[b], all_of_them[a]
    elif how == 2:
        all_of_them.insert(b, all_of_them[a])
    elif how == 3:
        all_of_them[a:a] = [all_of_them[b]] * chance.choice((2, 50, 3000))
    elif how == 4:
        del all_of_them[min(a, b):max(a, b)]
    else:
        all_of_them[a] = b""
    return b"\n".join(all_of_them)


def words(data: bytes, chance: random.Random) -> bytes:
    pieces = re.split(rb"(\W+)", data)
    a, b = (chance.randrange(len(pieces)) for _ in range(2))
    how = chance.randrange(4)
    if how == 0:
        pieces[a], pieces[b] = pieces[b], pieces[a]
    elif how == 1:
        pieces[a] = pieces[b]
    elif how == 2:
        pieces[a] = b""
    else:
        pieces[a] = chance.choice(ODD)
    return b"".join(pieces)


def numbers(data: bytes, chance: random.Random) -> bytes:
    found = list(NUMBER.finditer(data))
    for one in sorted(chance.sample(found, min(len(found), chance.choice((1, 1, 1, 2, 5)))), key=lambda m: -m.start()):
        text = one.group()
        how = chance.randrange(5)
        if how == 0:
            text = b"-" + text
        elif how == 1:
            text += chance.choice((b"e3", b"e-3", b"e9", b"e30", b"000000", b"9"))
        elif how == 2:
            text = chance.choice(found).group()
        else:
            text = chance.choice(NUMBERS)
        data = data[:one.start()] + text + data[one.end():]
    return data


def encoding(data: bytes, chance: random.Random) -> bytes:
    text = data.decode("utf-8", errors="replace")
    how = chance.randrange(5)
    if how == 0:
        return text.encode("utf-16")
    if how == 1:
        return data.replace(b"\n", b"\r\n")
    if how == 2:
        return data.replace(b"\n", b"\r")
    if how == 3:
        return data.replace(b".", b",")
    return b"\xef\xbb\xbf" + data


MUTATIONS = (flip, insert, remove, cut, lines, lines, words, words, numbers, numbers, numbers, encoding)


def mutant(data: bytes, chance: random.Random) -> bytes:
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        data = chance.choice(MUTATIONS)(data, chance)
    return data
