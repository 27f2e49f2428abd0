# SPDX-License-Identifier: GPL-3.0-or-later
"""Traits of a file: each has values with weights, which may depend on traits drawn before it."""

SINGLE = ("ICU", "CID", "CSD")
ASIAN = {"zh": "gb18030", "ja": "shift_jis"}
TYPED_CLOCKS = ("iso", "dmy_slash", "mdy_slash", "dmy_dot", "ymd_slash", "midnight_bare")


def kind(_):
    return {"ICU": 30, "CID": 22, "CSD": 7, "UU": 10, "UC": 6, "cyclic": 8, "consolidation": 7, "stages": 10}


def direction(t):
    return {"compression": 92, "extension": 8} if t["kind"] in ("ICU", "CID", "stages") else {"none": 1}


def container(_):
    return {"text": 90, "xlsx": 10}


def language(_):
    return {"en": 34, "de": 12, "fr": 10, "es": 10, "pt": 10, "it": 8, "zh": 9, "ru": 4, "ja": 3}


def headings(t):
    weights = {"1": 62, "2": 24, "3": 9}
    return weights | {"0": 3} if t["container"] == "text" else weights


def view(t):
    return {
        "UU": {"raw": 35, "reduced": 30, "sheet": 25, "principal": 10}, "UC": {"raw": 40, "reduced": 35, "sheet": 25},
        "cyclic": {"raw": 45, "reduced": 35, "path": 20}, "consolidation": {"raw": 60, "reduced": 40},
        "stages": {"raw": 60, "sheet": 30, "reduced": 10},
    }.get(t["kind"], {"raw": 34, "reduced": 24, "path": 14, "principal": 13, "sheet": 15})


def pore(t):
    if t["kind"] in ("UU", "UC"):
        return {"none": 1}
    if t["kind"] in ("CID", "CSD"):
        return {"total": 75, "none": 25} if t["kind"] == "CID" and t["view"] != "raw" else {"total": 1}
    if t["kind"] in ("consolidation", "stages"):
        return {"total": 1}
    return {"total": 60, "excess": 20, "excess_named_pore": 12, "none": 8 if t["view"] in ("reduced", "path") else 0}


def definition(t):
    """q, p' or t, s'; "t_s_named_q_p": the headings q and p' over t and s'."""
    if t["view"] not in ("reduced", "path") or t["kind"] in ("UU", "UC", "consolidation"):
        return {"q_p": 1}
    named = 10 if t["kind"] in SINGLE and t["direction"] != "extension" and t["headings"] != "0" else 0
    if t["pore"] in ("none", "excess_named_pore") and t["kind"] != "CID":
        named = 0
    return {"q_p": 70, "t_s": 18, "t_s_named_q_p": 2 * named}


def stresses(t):
    """Principal stresses: total or effective; bare: without an effective mark, the other columns decide."""
    if t["view"] != "principal":
        return {"none": 1}
    if t["kind"] == "UU":
        return {"total": 1}
    weights = {"total": 25, "effective": 35, "both": 20}
    if t["kind"] == "ICU" and t["pore"] in ("total", "excess") and t["headings"] != "0":
        weights["bare_effective"] = 15
    if t["pore"] == "none":
        weights["total"] = 0
    return weights


def axial_sign(t):
    weights = {"compression": 90}
    if t["view"] in ("raw", "sheet") and t["direction"] != "extension" and t["kind"] not in ("cyclic", "consolidation"):
        weights["displacement_negative"] = 7
    if t["view"] == "principal" and t["stresses"] != "bare_effective" and t["kind"] in SINGLE and t["direction"] != "extension":
        weights["tension_positive"] = 15
    return weights


def volume_sign(t):
    """Of volumes and volumetric strains. "reversed": water out of the specimen and dilation are positive under the usual names."""
    if t["kind"] in ("CID", "CSD", "consolidation", "stages"):
        return {"usual": 70, "reversed": 30} if t["axial_sign"] != "tension_positive" else {"reversed": 1}
    return {"usual": 1}


def cell_source(t):
    """Where the cell pressure is said. "absent": nowhere."""
    if t["kind"] == "UC":
        return {"absent": 1}
    if t["kind"] in ("consolidation", "stages"):
        return {"column": 1}
    if t["headings"] == "0":
        return {"column": 80, "absent": 20}
    return {"column": 70, "label": 20, "absent": 10} if t["view"] == "raw" else {"column": 30, "label": 35, "absent": 35}


def unit_style(t):
    if t["headings"] == "0":
        return {"none": 1}
    if t["headings"] == "3":
        return {"row": 1}
    if t["headings"] == "2":
        return {"row": 70, "round": 20, "square": 10}
    weights = {"round": 52, "square": 14, "underscore": 9, "comma": 6, "slash": 4, "in": 1, "blank": 2}
    if t["view"] in ("reduced", "path", "principal", "sheet") and t["kind"] not in ("cyclic", "consolidation", "stages"):
        weights |= {"none": 6, "partial": 4 if t["view"] != "reduced" else 0}
    return weights


def units(t):
    if t["unit_style"] == "none":
        return {"si": 1}
    weights = {"si": 60, "mpa": 7, "bar": 8, "kgcm2": 9, "us": 10}
    if t["unit_style"] != "partial":
        weights["mixed"] = 6
    return weights


def strain_unit(t):
    plain = 0 if t["unit_style"] == "underscore" and t["kind"] in ("cyclic", "consolidation") else 26
    return {"percent": 70, "plain": plain} | ({"per_mille": 3} if t["unit_style"] not in ("none", "partial") else {})


def decimal(t):
    if t["language"] in ("en", "zh", "ja"):
        return {"point": 97, "comma": 3} if t["language"] == "en" else {"point": 1}
    return {"point": 40, "comma": 60}


def separator(t):
    if t["container"] == "xlsx":
        return {"sheet": 1}
    weights = {"comma": 38, "semicolon": 20, "tab": 24, "wide": 8}
    if t["unit_style"] in ("round", "square", "underscore", "none", "row") and t["headings"] != "3":
        weights["space"] = 7
    if t["decimal"] == "comma":
        weights |= {"comma": 6, "semicolon": 50, "tab": 30}
    if t["headings"] in ("2", "3") and t["unit_style"] != "row":
        weights["wide"] = 0
    if t["headings"] == "3":
        weights["wide"] = 0
    return weights


def quoting(t):
    if t["separator"] in ("sheet", "wide", "space"):
        return {"none": 1}
    if t["separator"] == "comma" and t["decimal"] == "comma":
        return {"needed": 60, "all": 40}
    return {"needed": 75, "text": 12, "all": 13}


def thousands(t):
    if t["container"] == "xlsx" or t["separator"] == "space":
        return {"none": 1}
    if t["decimal"] == "comma":
        return {"none": 90, "point": 6, "nbsp": 3}
    return {"none": 92, "comma": 6, "apostrophe": 2}


def encoding(t):
    if t["container"] == "xlsx":
        return {"xlsx": 1}
    if t["language"] in ASIAN:
        return {ASIAN[t["language"]]: 45, "utf-8": 35, "utf-8-sig": 13, "utf-16": 7}
    if t["language"] == "ru":
        return {"cp1251": 50, "utf-8": 35, "utf-8-sig": 10, "utf-16": 5}
    return {"utf-8": 55, "cp1252": 28, "utf-8-sig": 11, "utf-16": 6}


def newline(t):
    return {"none": 1} if t["container"] == "xlsx" else {"lf": 50, "crlf": 47, "cr": 3}


def heading_style(t):
    if t["headings"] == "0":
        return {"none": 1}
    return {"words": 60, "symbols": 18, "mixed": 12} | ({"short": 22} if t["language"] == "en" else {})


def decoration(t):
    if t["headings"] == "0":
        return {"none": 1}
    weights = {"none": 82, "upper": 4, "lower": 4, "channel": 4}
    if t["language"] == "en":
        weights["statistic"] = 3
    if t["unit_style"] in ("round", "square") and t["separator"] in ("tab", "space"):
        weights["padded"] = 10
    return weights


def accents(t):
    return {"kept": 80, "dropped": 20} if t["language"] in ("de", "fr", "es", "pt", "it") else {"kept": 1}


def preamble(t):
    if t["headings"] == "0":
        return {"none": 1}
    if t["cell_source"] == "label":
        return {"text_labels": 1} if t["separator"] in ("wide", "space") else {"pairs": 50, "many_pairs": 30, "text_labels": 20}
    if t["separator"] in ("wide", "space"):
        return {"none": 50, "text": 20, "text_labels": 30}
    return {"none": 34, "pairs": 26, "many_pairs": 14, "text": 8, "text_labels": 10, "logger": 8}


def cover(t):
    """A first sheet with the labels. "only": they are not above the readings."""
    if t["container"] != "xlsx":
        return {"none": 1}
    return {"none": 50, "copy": 25, "only": 25 if t["preamble"] in ("pairs", "many_pairs", "text_labels") else 0}


def labels(t):
    if t["cell_source"] == "label":
        return {"given": 1}
    return {"given": 75, "absent": 25} if t["preamble"] in ("pairs", "many_pairs", "text_labels") else {"absent": 1}


def comment(t):
    if t["container"] == "xlsx" or t["preamble"] == "none" and t["headings"] == "0":
        return {"none": 1}
    marks = {"hash": 8, "slashes": 2, "semicolon": 1 if t["separator"] != "semicolon" else 0, "exclamation": 1, "stars": 1}
    if t["unit_style"] != "row":
        marks["percent"] = 2
    if t["preamble"] == "none" and t["separator"] not in ("space", "wide", "tab"):
        return {"none": 1}
    return {"none": 88} | marks


def commented(t):
    """Which lines have the mark. In research files the heading has it, too."""
    if t["comment"] == "none":
        return {"none": 1}
    if t["headings"] == "0":
        return {"preamble": 1}
    if t["preamble"] == "none":
        return {"heading": 1}
    return {"preamble": 60, "both": 40}


def trailing(t):
    return {"none": 84, "summary": 8 if t["separator"] != "wide" else 0, "text": 8}


def blocks(t):
    """"below": a second test under its own headings; "restart": the same test goes on below repeated headings."""
    single = t["kind"] not in ("stages", "consolidation", "cyclic") and t["cell_source"] != "label"
    weights = {"one": 88}
    if single and t["direction"] != "extension" and t["headings"] in ("1", "2"):
        weights |= {"beside": 4 if t["separator"] not in ("space", "wide") and t["headings"] == "1" else 0, "below": 3}
    if single and t["direction"] != "extension" and t["trailing"] == "none":
        weights["below_without_headings"] = 3
    if t["headings"] != "0" and t["kind"] not in ("stages",):
        weights["restart"] = 2
    return weights


def extra_cells(t):
    if t["separator"] in ("space", "wide") or t["headings"] == "0" or t["blocks"] == "beside":
        return {"none": 1}
    weights = {"none": 85, "blank_column": 4, "index": 3}
    if t["container"] == "text":
        weights["trailing_separator"] = 6
    if t["unit_style"] == "row" and t["headings"] == "2" and t["blocks"] == "one":
        weights["row_names"] = 12
    return weights


def numbers(t):
    if t["container"] == "xlsx":
        return {"plain": 1}
    minus = 2 if t["encoding"] in ("utf-8", "utf-8-sig", "utf-16") else 0
    return {"plain": 90, "exponent": 4 if t["thousands"] == "none" else 0, "unicode_minus": minus, "no_leading_zero": 3, "explicit_plus": 1}


def clock(t):
    text = t["container"] == "text"
    zero = {"elapsed_s": 30, "elapsed_min": 16, "elapsed_h": 5, "hms": 7}
    if t["kind"] == "consolidation":
        zero["none"] = 0
    elif t["view"] != "raw":
        zero["none"] = 40
    if t["headings"] == "0":
        return {"none": 40, "elapsed_s": 30, "elapsed_min": 10}
    weights = dict(zero)
    if t["separator"] != "space":
        weights |= {"iso": 6, "dmy_slash": 5, "dmy_dot": 4, "dmy_dash": 2, "ymd_slash": 3, "midnight_bare": 3}
        if t["language"] in ("en", "es"):
            weights |= {"mdy_slash": 6, "mdy_ampm": 5}
        if text:
            weights |= {"month_name": 3}
        if t["separator"] != "wide":
            weights["date_on_change"] = 2
    weights |= {"iso_z": 4, "date_and_time": 7, "excel_serial": 2 if text else 0, "unix_ms": 1, "unix_s": 1}
    if t["separator"] not in ("space",):
        weights["iso_and_elapsed"] = 4
    if t["kind"] in ("UU", "UC"):
        weights["time_of_day"] = 4
    if t["kind"] == "stages":
        weights |= {"stage_only": 30, "stage_and_total": 60}
    return weights


def clock_cells(t):
    """In a workbook a clock is a number with a date format, or text."""
    return {"typed": 70, "text": 30} if t["container"] == "xlsx" and t["clock"] in TYPED_CLOCKS else {"text": 1}


def stage_cells(t):
    return {"numbers": 55, "words": 45} if t["kind"] == "stages" else {"none": 1}


def order(t):
    if t["blocks"] != "one" or t["kind"] in ("stages", "cyclic") or t["headings"] == "0" or t["clock"] == "date_on_change":
        return {"ascending": 1}
    return {"ascending": 97, "reversed": 3}


def fill(t):
    weights = {"none": 80, "-999.25": 2, "-9999": 2, "1e30": 2, "9.9E37": 1, "NaN": 2, "OVRFLO": 1, "OVERLOAD": 1, "dash": 1, "n/a": 1}
    if t["separator"] not in ("space",) and t["headings"] != "0":
        weights |= {"blank": 6}
    if t["separator"] in ("comma", "semicolon", "tab", "sheet"):
        weights |= {"#DIV/0!": 1}
    return weights


def noise(_):
    return {"yes": 50, "no": 50}


def length(t):
    return {"short": 25, "medium": 60, "long": 5} if t["kind"] not in ("stages", "cyclic") else {"medium": 90, "long": 10}


def type_said(t):
    return {"yes": 50, "no": 50} if t["preamble"] in ("pairs", "many_pairs", "text", "text_labels") else {"no": 1}


DRAW = [kind, direction, container, language, headings, view, pore, definition, stresses, axial_sign, volume_sign, cell_source, unit_style,
        units, strain_unit, decimal, separator, quoting, thousands, encoding, newline, heading_style, decoration, accents, preamble, cover,
        labels, comment, commented, trailing, blocks, extra_cells, numbers, clock, clock_cells, stage_cells,
        order, fill, noise, length, type_said]
NAMES = [f.__name__ for f in DRAW]


def draw(random, forced):
    """All traits, those of `forced` as given. Raises ValueError if the forced ones exclude each other."""
    for _ in range(3000):
        traits = {}
        for trait in DRAW:
            weights = {k: w for k, w in trait(traits).items() if w > 0}
            name = trait.__name__
            if name in forced:
                if forced[name] not in weights:
                    break
                traits[name] = forced[name]
            else:
                traits[name] = random.choices(list(weights), list(weights.values()))[0]
        else:
            return traits
    raise ValueError("no file has these traits together: " + ", ".join(f"{k}={v}" for k, v in forced.items()))
