# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of the columns: canonical name, factor to s, mm, mm2, mm3, kN, kPa and plain numbers, spellings, decimals."""
from .names import encodable

DIMENSION = {
    "time": "time", "stage_time": "time", "axial_displacement": "length", "specimen_height": "length", "axial_force": "force",
    "back_volume": "volume", "volume_change": "volume", "cell_volume": "volume", "current_area": "area", "axial_strain": "strain",
    "radial_strain": "strain", "volumetric_strain": "strain", "void_ratio": "ratio", "stress_ratio": "ratio",
    "principal_stress_ratio": "ratio", "cycle": "count", "stage": "count", "reading_number": "count", "force_reading": "division",
    "temperature": "temperature",
}

FACTOR = {
    "s": 1.0, "min": 60.0, "h": 3600.0, "mm": 1.0, "cm": 10.0, "in": 25.4, "0.01 mm": 0.01, "kN": 1.0, "N": 0.001,
    "kgf": 0.00980665, "lbf": 0.0044482216152605, "kPa": 1.0, "MPa": 1000.0, "bar": 100.0, "kgf/cm2": 98.0665,
    "psi": 6.894757293168, "mm3": 1.0, "cm3": 1000.0, "ml": 1000.0, "in3": 16387.064, "mm2": 1.0, "cm2": 100.0, "in2": 645.16,
    "%": 0.01, "": 1.0, "per mille": 0.001, "degC": 1.0, "div": 1.0,
}

DECIMALS = {
    "s": (0, 1), "min": (2, 3), "h": (4,), "mm": (3, 4), "cm": (4,), "in": (4, 5), "0.01 mm": (1,), "kN": (4, 5), "N": (1, 2),
    "kgf": (2, 3), "lbf": (2, 3), "kPa": (1, 2), "MPa": (4, 5), "bar": (3, 4), "kgf/cm2": (3, 4), "psi": (2, 3), "mm3": (0, 1),
    "cm3": (2, 3), "ml": (2, 3), "in3": (4,), "mm2": (1, 2), "cm2": (3,), "in2": (3, 4), "%": (2, 3), "": (5,), "per mille": (2,),
    "degC": (1,), "div": (1,),
}

SYSTEMS = {
    "si": {"pressure": ["kPa"], "force": ["kN", "N"], "length": ["mm"], "volume": ["mm3", "cm3", "ml"], "area": ["mm2", "cm2"]},
    "mpa": {"pressure": ["MPa"], "force": ["kN", "N"], "length": ["mm"], "volume": ["cm3", "mm3"], "area": ["mm2", "cm2"]},
    "bar": {"pressure": ["bar"], "force": ["kN", "N"], "length": ["mm"], "volume": ["cm3", "ml"], "area": ["cm2", "mm2"]},
    "kgcm2": {"pressure": ["kgf/cm2"], "force": ["kgf"], "length": ["mm", "cm", "0.01 mm"], "volume": ["cm3", "ml"], "area": ["cm2"]},
    "us": {"pressure": ["psi"], "force": ["lbf"], "length": ["in"], "volume": ["in3", "cm3"], "area": ["in2"]},
}

SPELLINGS = {
    "s": ["s", "sec", "S", "secs", "seconds"], "min": ["min", "mins", "min.", "minutes"], "h": ["h", "hr", "hrs", "hours"],
    "mm": ["mm", "MM"], "cm": ["cm"], "in": ["in", "in.", "inch", "inches"], "0.01 mm": ["0.01mm", "0.01 mm"],
    "kN": ["kN", "KN"], "N": ["N"], "kgf": ["kgf", "kg", "Kg"], "lbf": ["lbf", "lb", "lbs", "LBS"],
    "kPa": ["kPa", "KPa", "kpa", "kN/m2", "kN/m²", "kN/m^2"], "MPa": ["MPa", "N/mm2", "N/mm²", "MPA"], "bar": ["bar", "Bar"],
    "kgf/cm2": ["kg/cm2", "kgf/cm2", "kg/cm²", "kgf/cm²", "Kg/cm2"], "psi": ["psi", "PSI", "psig", "lb/in2", "lbf/in2"],
    "mm3": ["mm3", "mm³", "mm^3"], "cm3": ["cm3", "cm³", "cc", "cm^3"], "ml": ["ml", "mL"], "in3": ["in3", "cu in", "in^3"],
    "mm2": ["mm2", "mm²", "mm^2"], "cm2": ["cm2", "cm²", "cm^2"], "in2": ["in2", "sq in", "in.2"], "%": ["%"], "": ["-"],
    "per mille": ["‰", "mm/m"], "degC": ["°C", "degC", "C"], "div": ["div"],
}
LOCAL = {
    "ru": {"kPa": ["кПа"], "MPa": ["МПа"], "mm": ["мм"], "cm3": ["см3"], "cm2": ["см2"], "mm2": ["мм2"], "mm3": ["мм3"],
           "kN": ["кН"], "N": ["Н"], "min": ["мин"], "s": ["с", "сек"], "h": ["ч"], "kgf": ["кгс"],
           "kgf/cm2": ["кгс/см2"], "": ["д.е."], "cm": ["см"]},
    "zh": {"s": ["s", "秒"], "min": ["min", "分"], "h": ["h", "小时"]},
    "ja": {"kPa": ["kN/m2", "kPa"], "min": ["min", "分"], "s": ["s", "秒"]},
    "de": {"h": ["h", "Std"], "kPa": ["kN/m²", "kN/m2", "kPa"]},
    "es": {"in": ["pulg", "in"], "h": ["h", "hr"]},
}
PLAIN = {"kPa": ["kPa", "kpa", "KPA"], "MPa": ["MPa"], "bar": ["bar"], "kgf/cm2": ["ksc"], "psi": ["psi", "PSI"],
         "mm": ["mm"], "cm": ["cm"], "in": ["in"], "N": ["N"], "kN": ["kN"], "kgf": ["kgf"], "lbf": ["lbf", "lbs"],
         "mm3": ["mm3"], "cm3": ["cm3", "cc"], "ml": ["ml"], "in3": ["in3"], "mm2": ["mm2"], "cm2": ["cm2"], "in2": ["in2"], "s": ["s"],
         "min": ["min"], "h": ["h"], "%": ["pct"], "per mille": ["permille"], "degC": ["degC"], "div": ["div"], "": [""], "0.01 mm": ["mm"]}
STRAIN_SPELLINGS = {"si": ["mm/mm", "-", "m/m"], "mpa": ["mm/mm", "-"], "bar": ["-"], "kgcm2": ["cm/cm", "-"], "us": ["in/in", "-"]}


class Units:
    """Draws the units of one file. A unit has one spelling in a file, except that SI pressures may be mixed."""

    def __init__(self, random, traits, codec):
        self.random, self.traits, self.codec = random, traits, codec
        system = traits["units"]
        self.mixed = system == "mixed"
        self.system = "si" if self.mixed else system
        self.chosen = {k: random.choice(v) for k, v in SYSTEMS[self.system].items()}
        if traits["unit_style"] in ("underscore", "none") and self.chosen["length"] == "0.01 mm":
            self.chosen["length"] = "mm"
        self.chosen["strain"] = {"percent": "%", "plain": "", "per_mille": "per mille"}[traits["strain_unit"]]
        self.chosen.update(ratio="", count="", division="div", temperature="degC")
        self.spelled = {}

    def unit(self, quantity):
        dimension = DIMENSION.get(quantity, "pressure")
        if dimension == "pressure" and self.mixed:
            return "bar" if quantity in ("cell_pressure", "back_pressure", "pore_pressure", "ignored") else "kPa"
        if quantity == "specimen_height" and self.chosen["length"] == "0.01 mm":
            return "mm"
        return self.chosen[dimension]

    def decimals(self, unit, quantity):
        if DIMENSION.get(quantity) == "ratio":
            return 4
        if DIMENSION.get(quantity) == "count":
            return 0
        return self.random.choice(DECIMALS[unit])

    def spelling(self, unit):
        if unit not in self.spelled:
            if self.traits["unit_style"] == "underscore":
                options = PLAIN[unit]
            elif unit == "" and self.traits["language"] != "ru":
                options = STRAIN_SPELLINGS[self.system]
            else:
                options = LOCAL.get(self.traits["language"], {}).get(unit, SPELLINGS[unit])
            blank_allowed = self.traits["separator"] != "space"
            options = [o for o in options if encodable(o, self.codec) and (blank_allowed or " " not in o)]
            self.spelled[unit] = self.random.choice(options or PLAIN[unit])
        return self.spelled[unit]
