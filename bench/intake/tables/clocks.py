# SPDX-License-Identifier: GPL-3.0-or-later
"""Cells of clocks, and whether they decide the order of day and month."""
import datetime

MONTHS = {
    "en": "Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec", "de": "Jan Feb Mär Apr Mai Jun Jul Aug Sep Okt Nov Dez",
    "fr": "janv févr mars avr mai juin juil août sept oct nov déc", "es": "ene feb mar abr may jun jul ago sep oct nov dic",
    "pt": "jan fev mar abr mai jun jul ago set out nov dez", "it": "gen feb mar apr mag giu lug ago set ott nov dic",
}
EPOCH = datetime.datetime(1970, 1, 1)
EXCEL = datetime.datetime(1899, 12, 30)
FORMATS = {
    "iso": ["%Y-%m-%d %H:%M:%S"], "iso_and_elapsed": ["%Y-%m-%d %H:%M:%S"], "iso_z": ["%Y-%m-%dT%H:%M:%S%z"],
    "dmy_slash": ["%d/%m/%Y %H:%M:%S", "%d/%m/%Y %H:%M"], "mdy_slash": ["%m/%d/%Y %H:%M:%S", "%m/%d/%Y %H:%M"],
    "dmy_dot": ["%d.%m.%Y %H:%M:%S", "%d.%m.%Y %H:%M", "%d.%m.%y %H:%M:%S"], "dmy_dash": ["%d-%m-%Y %H:%M:%S"],
    "ymd_slash": ["%Y/%m/%d %H:%M:%S"], "mdy_ampm": ["%m/%d/%Y %I:%M:%S %p", "%m/%d/%y %I:%M:%S %p"],
    "midnight_bare": ["%Y-%m-%d %H:%M:%S", "%d.%m.%Y %H:%M:%S", "%d/%m/%Y %H:%M:%S"],
    "month_name": ["%d-%b-%Y %H:%M:%S", "%d %b %Y %H:%M:%S"],
}
DATES = ["%d/%m/%Y", "%m/%d/%Y", "%d.%m.%Y", "%Y-%m-%d", "%Y/%m/%d"]
UNPADDED = ("mdy_slash", "mdy_ampm", "ymd_slash")


def write(t, form, language="en", unpadded=False):
    """t in the given form; month names by language; unpadded: 3/7/2026 in place of 03/07/2026."""
    if "%b" in form:
        form = form.replace("%b", MONTHS.get(language, MONTHS["en"]).split()[t.month - 1])
    if unpadded:
        form = form.replace("%m", str(t.month)).replace("%d", str(t.day)).replace("%I", str(t.hour % 12 or 12))
        form = form.replace("%H", str(t.hour))
    return t.strftime(form.replace("%z", "Z"))


def swapped(form):
    """The form with day and month exchanged, or None if it has only one order."""
    if "%b" in form or "%d" not in form:
        return None
    other = form.replace("%d", "\0").replace("%m", "%d").replace("\0", "%m")
    return None if form.startswith("%Y") else other


def order_is_open(moments, form):
    """True if the cells can be read with day and month exchanged, steadily and without a jump above a day."""
    if swapped(form) is None or any(t.day > 12 for t in moments):
        return False
    other = [t.replace(day=t.month, month=t.day) for t in moments]
    steps = [(b - a).total_seconds() for a, b in zip(other, other[1:])]
    down = moments[-1] < moments[0]
    return all((0 <= -s if down else 0 <= s) and abs(s) <= 86400 for s in steps)


def elapsed(seconds):
    seconds = int(seconds)
    return f"{seconds // 3600}:{seconds // 60 % 60:02d}:{seconds % 60:02d}"


def serial(t):
    return (t - EXCEL).total_seconds() / 86400


def start(random, times, midnight):
    """A start of the test. If midnight: one reading in the middle is at 00:00:00."""
    day = datetime.datetime(2026, random.randint(1, 12), random.randint(1, 28)) + datetime.timedelta(seconds=random.randint(27000, 64800))
    if midnight:
        at = times[random.randint(1, len(times) - 2)]
        return datetime.datetime(day.year, day.month, day.day) - datetime.timedelta(seconds=at)
    return day.replace(second=day.second if random.random() < 0.7 else 0)
