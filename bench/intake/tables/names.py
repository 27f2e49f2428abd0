# SPDX-License-Identifier: GPL-3.0-or-later
"""Names of columns and labels from headings.toml."""
import pathlib
import tomllib
import unicodedata

TABLE = tomllib.loads((pathlib.Path(__file__).parent / "headings.toml").read_text(encoding="utf-8"))
LANGUAGES = ["en", "de", "fr", "es", "pt", "it", "zh", "ru", "ja"]
FIRST_PUBLISHED_SEED = 1000
# Names that say nothing.
INVENTED = ["Kanal {}", "Ch{}", "Wert_{}", "Grandeur {}", "Sensor {}", "Valor {}", "X{}", "MW{}", "Parametro {}", "gemessen {}",
            "Value {}"]
UMLAUTS = str.maketrans({"ä": "ae", "ö": "oe", "ü": "ue", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "ß": "ss"})


def encodable(text, codec):
    try:
        text.encode(codec)
        return True
    except UnicodeEncodeError:
        return False


def without_accents(text, language):
    """As typed on a keyboard without accents: Saettigungsdruck, Presion de poros. Greek and Cyrillic letters stay."""
    if language == "de":
        return text.translate(UMLAUTS)
    return "".join(unicodedata.normalize("NFD", c)[0] if "À" <= c <= "ſ" else c for c in text)


def replace_names(path):
    """Takes the names of columns from lines of quantity, language and name, for the languages and quantities that are in the file."""
    given = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        quantity, language, name = line.split("\t")
        if quantity in TABLE["columns"]:
            given.setdefault((quantity, language), []).append(name)
    for (quantity, language), names in given.items():
        TABLE["columns"][quantity][language] = names


class Names:
    """Draws names for one file: one language, one code page, no name twice."""

    def __init__(self, random, traits, held_back, invented=0.0):
        """`invented`: the share of columns whose name says nothing."""
        self.random, self.traits, self.held_back, self.invented = random, traits, held_back, invented
        self.language = traits["language"]
        self.codec = {"utf-8-sig": "utf-8", "xlsx": "utf-8"}.get(traits["encoding"], traits["encoding"])
        self.used = set()
        self.held_back_count = 0

    def choose(self, names, with_unit=True):
        """One of the names that this file can hold, or None."""
        kept = []
        for name in names:
            held = name.startswith("~")
            name = name.lstrip("~")
            if held and not self.held_back or name.startswith("!") and not with_unit:
                continue
            name = name.lstrip("!")
            if self.traits["accents"] == "dropped":
                name = without_accents(name, self.language)
            if name not in self.used and encodable(name, self.codec):
                kept.append((name, held))
        if not kept:
            return None
        name, held = self.random.choice(kept)
        self.held_back_count += held
        return name

    def column(self, key, with_unit=True, only_symbol=False):
        if self.invented and self.random.random() < self.invented:
            return self.random.choice(INVENTED).format(len(self.used) + self.random.randrange(2, 90))
        entry = TABLE["columns"][key]
        style = self.traits["heading_style"]
        order = [self.language, "en", "short", "symbols"]
        if only_symbol or style == "symbols":
            order = ["symbols"] + order
        elif style == "short" and self.language == "en":
            order = ["short"] + order
        elif style == "mixed" and self.random.random() < 0.5:
            order = ["symbols"] + order
        for source in order:
            name = self.choose(entry.get(source, []), with_unit)
            if name:
                self.used.add(name)
                return name
        name = key.replace("_", " ")
        self.used.add(name)
        return name

    def label(self, key):
        return self.choose(TABLE["labels"][key][self.language]) or self.choose(TABLE["labels"][key]["en"])

    def words(self, key):
        listed = TABLE["words"][key][self.language]
        if self.traits["accents"] == "dropped":
            listed = [without_accents(w, self.language) for w in listed]
        return listed if all(encodable(w, self.codec) for w in listed) else TABLE["words"][key]["en"]
