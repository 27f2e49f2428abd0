# SPDX-License-Identifier: GPL-3.0-or-later
"""Readings of a triaxial test in closed form: hyperbolic strength, Skempton's pore pressure or dilatancy, corrected area.

simulate() returns every quantity as a list in canonical units (s, mm, mm2, mm3, kN, kPa, plain strains; compression, contraction and
pressure positive; back_volume is water into the specimen). Every derived quantity is computed from the same strain, q, cell pressure and
pore pressure, so that all identities between columns hold exactly before the cells are rounded.
"""
import math
from dataclasses import dataclass, field

SIZES = [(38.0, 76.0), (50.0, 100.0), (70.0, 140.0), (100.0, 200.0), (35.0, 70.0), (39.1, 80.0), (71.12, 142.24), (35.56, 71.12)]
TOTAL_STRESS = ("UU", "UC")
DRAINED = ("CID", "CSD")
UNDRAINED = ("ICU", "cyclic")


@dataclass
class Test:
    kind: str
    diameter: float
    height: float
    void_ratio: float
    cell: float      # total radial stress in shear
    back: float      # pore pressure at the start of shear
    drained: bool    # in shear
    series: dict = field(default_factory=dict)
    stages: list = field(default_factory=list)  # 0 saturation, 1 consolidation, 2 shear

    @property
    def area(self):
        return math.pi / 4 * self.diameter**2

    @property
    def volume(self):
        return self.area * self.height

    @property
    def consolidation_stress(self):
        return self.cell - self.back


def steps(rows, duration, step, power):
    """Strictly increasing times from 0, multiples of `step`; the readings are closer at the start if power > 1."""
    duration = max(duration, 1.5 * rows * step)
    times = [0]
    for i in range(1, rows):
        times.append(max(times[-1] + step, round(duration * (i / (rows - 1)) ** power / step) * step))
    return times


def hyperbola(x, ultimate, half):
    return ultimate * x / (x + half)


def undrained_shear(random, test, times, extension):
    """q hyperbolic in the axial strain, excess pore pressure A q with A from A0 to Af; the final stress ratio is eta."""
    p0 = test.consolidation_stress
    eta = random.uniform(-0.75, -0.5) if extension else random.uniform(0.9, 1.4)
    a_f = random.uniform(-0.1, 0.5) if extension else random.uniform(-0.15, 1.0)
    ultimate = eta * p0 / (1 - eta * (1 / 3 - a_f))
    end = (-1 if extension else 1) * random.uniform(0.06, 0.2)
    half = abs(end) * random.uniform(0.02, 0.12)
    strain = [end * t / times[-1] for t in times]
    q = [hyperbola(abs(e), ultimate, half) for e in strain]
    excess = [v * (1 / 3 + (a_f - 1 / 3) * abs(e) / (abs(e) + 2 * half)) for e, v in zip(strain, q)]
    return strain, [0.0] * len(times), q, [test.back + d for d in excess]


def contraction(strain, depth, length, dilatancy):
    """Volumetric strain: contraction first, dilation later. Its slope at the start is depth/length - dilatancy > 0."""
    return depth * (1 - math.exp(-strain / length)) - dilatancy * strain


def drained_shear(random, test, times, extension):
    p0 = test.consolidation_stress
    eta = random.uniform(-0.75, -0.5) if extension else random.uniform(0.9, 1.4)
    ultimate = eta * p0 / (1 - eta / 3)
    end = (-1 if extension else 1) * random.uniform(0.06, 0.2)
    half = abs(end) * random.uniform(0.03, 0.15)
    strain = [end * t / times[-1] for t in times]
    depth, length, dilatancy = random.uniform(0.006, 0.02), random.uniform(0.012, 0.03), random.uniform(-0.02, 0.2)
    early = max(0.01, abs(strain[2]))  # the readings show the contraction, however few they are
    dilatancy = min(dilatancy, 0.5 * depth * (1 - math.exp(-early / length)) / early)
    return (strain, [contraction(abs(e), depth, length, dilatancy) for e in strain],
            [hyperbola(abs(e), ultimate, half) for e in strain], [test.back] * len(times))


def constant_shear(random, test, times, _extension):
    """Drained shear to a stress ratio below failure, then q is constant and the back pressure rises."""
    p0 = test.consolidation_stress
    eta, eta_end = random.uniform(0.5, 0.8), random.uniform(1.15, 1.35)
    q_held = eta * p0 / (1 - eta / 3)
    rise = p0 + q_held / 3 - q_held / eta_end
    half, first, second = random.uniform(0.003, 0.008), random.uniform(0.02, 0.035), random.uniform(0.035, 0.08)
    depth, length, dilatancy = random.uniform(0.006, 0.015), random.uniform(0.01, 0.02), random.uniform(0.05, 0.2)
    knee = 0.4 * times[-1]
    strain, volumetric, q, pore = [], [], [], []
    for t in times:
        x = max(0.0, (t - knee) / (times[-1] - knee))
        e = first * min(1.0, t / knee) + second * x**2
        strain.append(e)
        volumetric.append(contraction(min(e, first), depth, length, 0.0) - dilatancy * max(0.0, e - first))
        q.append(hyperbola(min(e, first), q_held * (1 + half / first), half))
        pore.append(test.back + rise * x)
    return strain, volumetric, q, pore


def total_stress(random, test, times, _extension):
    strength = random.uniform(40, 400)
    end = random.uniform(0.06, 0.2)
    peak = end * random.uniform(0.6, 0.95)
    strain = [end * t / times[-1] for t in times]
    return strain, [0.0] * len(times), [strength * (2 - e / peak) * e / peak for e in strain], [0.0] * len(times)


def cyclic(random, test, times, _extension):
    p0 = test.consolidation_stress
    cycles = test.series["cycles"]
    r_u, strain_amplitude = random.uniform(0.3, 0.7), random.uniform(0.005, 0.03)
    amplitude = p0 * random.uniform(0.1, 0.75 * (1 - r_u))
    strain, q, pore = [], [], []
    for t in times:
        n = cycles * t / times[-1]
        wave = math.sin(2 * math.pi * n)
        growth = (n / cycles) ** 0.7
        q.append(amplitude * wave)
        strain.append(strain_amplitude * wave * (0.1 + 0.9 * growth))
        pore.append(test.back + p0 * r_u * growth + 0.2 * amplitude * wave * growth)
    return strain, [0.0] * len(times), q, pore


def consolidation(random, test, times, _extension):
    """Isotropic: the excess pore pressure of the last load dissipates, the specimen contracts."""
    load = test.consolidation_stress * random.uniform(0.4, 0.7)
    tau, final = times[-1] / random.uniform(4, 8), random.uniform(0.01, 0.05)
    share = [math.exp(-t / tau) for t in times]
    volumetric = [final * (1 - s) for s in share]
    return [v / 3 for v in volumetric], volumetric, [0.0] * len(times), [test.back + load * s for s in share]


SHEAR = {"ICU": undrained_shear, "CID": drained_shear, "CSD": constant_shear, "UU": total_stress, "UC": total_stress,
         "cyclic": cyclic, "consolidation": consolidation}
HOURS = {"ICU": (2, 30), "CID": (8, 80), "CSD": (8, 60), "UU": (0.2, 0.5), "UC": (0.1, 0.3), "consolidation": (6, 30)}


def times_of(random, kind, rows, step, cycles):
    if kind == "cyclic":
        period = max(step, math.ceil(cycles * random.randint(60, 600) / (rows - 1) / step) * step)
        return [i * period for i in range(rows)]
    if kind == "consolidation":  # square root of time in equal steps: 0, 0.25, 1, 2.25 ... min
        unit = max(step, 15)
        return [unit * i * i for i in range(rows)]
    low, high = HOURS[kind]
    return steps(rows, 3600 * random.uniform(low, high), step, random.choice([1.0, 1.0, 1.5, 2.0]))


def join_stages(random, test, rows, step, extension):
    """Saturation, isotropic consolidation and shear in one table; strains are counted from the start of the table."""
    before, middle = max(4, rows // 6), max(6, rows // 4)
    saturation = steps(before, 3600 * random.uniform(3, 10), step, 1.0)
    settled = times_of(random, "consolidation", middle, step, 0)
    sheared = times_of(random, "CID" if test.drained else "ICU", rows - before - middle, step, 0)
    pressure = random.choice([10.0, 15.0, 20.0])  # cell above back pressure during saturation
    parts = []
    x = [t / saturation[-1] for t in saturation]
    parts.append(([0.0] * before, [0.0] * before, [0.0] * before, [0.3 * test.back * (1 - s) + test.back * s for s in x]))
    cell = [parts[0][3][i] + pressure for i in range(before)]
    parts.append(consolidation(random, test, settled, False))
    cell += [test.cell] * (rows - before)
    parts.append((drained_shear if test.drained else undrained_shear)(random, test, sheared, extension))
    strain, volumetric, q, pore = ([], [], [], [])
    for part in parts:
        e0, v0 = (strain[-1], volumetric[-1]) if strain else (0.0, 0.0)
        strain += [e0 + e for e in part[0]]
        volumetric += [v0 + v for v in part[1]]
        q += part[2]
        pore += part[3]
    times, stage_times, start = [], [], 0
    for part in (saturation, settled, sheared):
        times += [start + t for t in part]
        stage_times += part
        start = times[-1] + max(step, random.choice([60, 300]))
    test.stages = [0] * before + [1] * middle + [2] * (rows - before - middle)
    test.series["stage_time"] = stage_times
    return times, strain, volumetric, q, cell, pore


def derive(test, times, strain, volumetric, q, cell, pore):
    """All quantities that a laboratory may write, from the five that were measured."""
    s = test.series
    zero = pore[test.stages.index(2)] if test.stages else pore[0]
    s["time"], s["axial_strain"], s["volumetric_strain"], s["deviator_stress"] = times, strain, volumetric, q
    s["cell_pressure"] = s["radial_stress"] = cell
    s["pore_pressure"] = pore
    s["excess_pore_pressure"] = [u - zero for u in pore]
    s["axial_displacement"] = [test.height * e for e in strain]
    s["specimen_height"] = [test.height * (1 - e) for e in strain]
    s["current_area"] = [test.area * (1 - v) / (1 - e) for e, v in zip(strain, volumetric)]
    s["axial_force"] = [x * a * 1e-6 for x, a in zip(q, s["current_area"])]
    s["radial_strain"] = [(v - e) / 2 for e, v in zip(strain, volumetric)]
    s["void_ratio"] = [test.void_ratio - (1 + test.void_ratio) * v for v in volumetric]
    s["volume_change"] = [test.volume * v for v in volumetric]
    s["back_volume"] = [s["counter"] - d for d in s["volume_change"]]
    s["axial_stress"] = [c + x for c, x in zip(cell, q)]
    s["effective_radial_stress"] = [c - u for c, u in zip(cell, pore)]
    s["effective_axial_stress"] = [r + x for r, x in zip(s["effective_radial_stress"], q)]
    s["mean_stress"] = [c + x / 3 for c, x in zip(cell, q)]
    s["mean_effective_stress"] = [r + x / 3 for r, x in zip(s["effective_radial_stress"], q)]
    s["half_deviator_stress"] = [x / 2 for x in q]
    s["mean_effective_stress_2d"] = [r + x / 2 for r, x in zip(s["effective_radial_stress"], q)]
    if test.kind not in TOTAL_STRESS:
        s["stress_ratio"] = [x / p for x, p in zip(q, s["mean_effective_stress"])]
        s["principal_stress_ratio"] = [a / r for a, r in zip(s["effective_axial_stress"], s["effective_radial_stress"])]


def simulate(random, kind, rows, *, extension=False, noise=False, step=1, size=None):
    diameter, height = size or random.choice(SIZES)
    back = 0.0 if kind in TOTAL_STRESS else random.choice([100.0, 150.0, 200.0, 300.0, 400.0])
    consolidated = random.choice([50.0, 75.0, 100.0, 150.0, 200.0, 300.0, 400.0])
    cell = 0.0 if kind == "UC" else back + consolidated
    drained = kind in DRAINED or kind == "stages" and random.random() < 0.4
    test = Test(kind, diameter, height, random.uniform(0.5, 1.1), cell, back, drained)
    test.series["counter"] = random.choice([0.0, 0.0, -1250.0, 12345.0, 40210.0])
    cycles = test.series["cycles"] = random.randint(4, 8)
    if kind == "stages":
        times, strain, volumetric, q, cells, pore = join_stages(random, test, rows, step, extension)
    else:
        times = times_of(random, kind, rows, step, cycles)
        strain, volumetric, q, pore = SHEAR[kind](random, test, times, extension)
        cells = [test.cell] * rows
    if kind == "cyclic":
        test.series["cycle"] = [int(cycles * t / times[-1] - 1e-9) + 1 for t in times]
    if noise:
        def shaken(values, size):
            return [v + random.uniform(-size, size) for v in values]
        q = shaken(q, 0.2) if kind != "consolidation" else q
        cells = shaken(cells, 0.2) if kind != "UC" else cells
        pore = shaken(pore, 0.15) if kind not in TOTAL_STRESS else pore
    derive(test, times, strain, volumetric, q, cells, pore)
    return test
