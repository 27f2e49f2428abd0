# SPDX-License-Identifier: GPL-3.0-or-later
"""The stages of a test: B check, consolidation, and shear by one of the controls, with rests, loops and changes of rate."""
import dataclasses
import math

from .draws import log_uniform, rounded

MAX_READINGS = 3000  # of shear


@dataclasses.dataclass
class Test:
    """What the stages need to know. Pressures and stresses in kPa, dimensions in mm."""
    random: object
    p0: float
    start: float
    back: float
    height: float
    diameter: float
    ratio: float = 0.0      # q/p' of consolidation
    extension: bool = False
    consolidated: bool = True  # by stages; else the specimen starts at p0
    b_check: str = "before"    # consolidation, "after" it, or "none"
    features: list = dataclasses.field(default_factory=list)
    shear_minutes: float = 0.0

    @property
    def newton_per_kpa(self):
        return math.pi / 4 * self.diameter ** 2 * 1e-3

    @property
    def max_q(self):
        return 3.0 * self.p0 + 100

    @property
    def sense(self):
        return -1 if self.extension else 1

    def strain(self, percent):
        key = "below" if self.extension else "above"
        return {"quantity": "axial_strain_pct", key: rounded(self.sense * percent, 3)}

    def q(self, value, rising=True):
        """Reached by loading, or by unloading if not rising."""
        key = "above" if rising != self.extension else "below"
        return {"quantity": "q_kPa", key: rounded(self.sense * value)}


def stage(name, role, drainage, axial, end, limit=None, **keys):
    out = {"name": name, "role": role, "drainage": drainage, "axial": axial} | keys
    if limit is not None:
        out["time_limit_min"] = rounded(min(limit, 1e5), 3)
    return out | {"end": end}


def ramp(test, name, role, drainage, target, rate, axial="free", **keys):
    """Cell pressure to `target`."""
    return stage(name, role, drainage, axial, [{"quantity": "cell_pressure_kPa", "above" if rate > 0 else "below": target}],
                 cell_rate_kPa_per_min=rounded(rate, 3), cell_target_kPa=target, **keys)


def b_check(test, cell, back=False):
    """The cell pressure goes back if it would be beyond that of consolidation otherwise."""
    step = rounded(test.random.uniform(20, 70), 2)
    rate = log_uniform(test.random, 10, 60)
    out = [ramp(test, "B check", "b_check", "closed", rounded(cell + step), rate)]
    if back or test.random.random() < 0.6:
        out.append(ramp(test, "back after B check", "saturation", "closed", cell, -rate))
    return out


def consolidation(test):
    random = test.random
    cell = rounded(test.back + test.p0)
    axial = {"axial": "stress_ratio", "held_stress_ratio": test.ratio} if test.ratio else {"axial": "free"}
    minutes = log_uniform(random, 10, 120)
    out = []
    targets = [cell]
    if random.random() < 0.2 and test.p0 > 4 * test.start:
        targets.insert(0, rounded(test.back + test.p0 * random.uniform(0.4, 0.7)))
        test.features.append("consolidated in steps")
    if test.ratio:  # q at once would be a blow
        q = test.ratio * test.start
        out.append(stage("load to the stress ratio", "consolidation", "open", "load", [{"quantity": "q_kPa", "above": rounded(q)}], 60,
                         load_rate_N_per_min=rounded(q * test.newton_per_kpa / random.uniform(5, 20))))
    for target in targets:
        out.append(ramp(test, "consolidation", "consolidation", "open", target, test.p0 / minutes, **axial))
        if random.random() < 0.8:
            end = {"quantity": "time_min", "above": rounded(log_uniform(random, 5, 120), 2)}
            if random.random() < 0.3:
                end = {"quantity": "volume_rate_mm3_per_min", "below": 20.0}
            out.append(stage("rest", "consolidation", "open", axial["axial"], [end], 240,
                             **{k: v for k, v in axial.items() if k != "axial"}))
    return out


def preparation(test):
    """All that comes before shear."""
    if not test.consolidated:
        return []
    cell = rounded(test.back + test.start)
    consolidated = consolidation(test)
    if test.b_check == "before":
        return b_check(test, cell, next(s["cell_target_kPa"] for s in consolidated if "cell_target_kPa" in s) < cell + 75) + consolidated
    test.features.append("no B check" if test.b_check == "none" else "B check after consolidation")
    return consolidated + (b_check(test, rounded(test.back + test.p0)) if test.b_check == "after" else [])


def split(test, low, high, count):
    """`count` values in order between low and high."""
    return sorted(test.random.uniform(low, high) for _ in range(count))


def by_displacement(test, drainage, end_strain, minutes, extra_ends=(), **keys):
    """Shear at a rate, with what the operator does in between."""
    random = test.random
    rate = max(2e-5, test.height * end_strain / 100 / minutes)
    test.shear_minutes += minutes
    ends = [test.q(test.max_q), *extra_ends]
    out = []
    action = random.random()
    inside = split(test, 0.02, 0.4, random.choice((1, 2))) if action < 0.4 else []

    def go(name, end, factor=1.0):
        speed = min(5.9, rate * factor)
        out.append(stage(name, "shear", drainage, "displacement", end, 4 * minutes / factor + 30,
                         axial_rate_mm_per_min=rounded(test.sense * speed), **keys))
    for share in inside:
        go("shear", [test.strain(end_strain * share ** 2), *ends])
        if action < 0.13:
            test.features.append("loop")
            speed = -test.sense * min(5.9, rate)
            out.append(stage("unloading", "shear", drainage, "displacement", [test.q(0.08 * test.p0 + test.ratio * test.p0 * 0.3, False)],
                             minutes, axial_rate_mm_per_min=rounded(speed), **keys))
        elif action < 0.26:
            test.features.append("rest")
            minutes_of_rest = rounded(log_uniform(random, 1, 60), 2)
            out.append(stage("rest of the drive", random.choice(("shear", "hold")), drainage, "hold",
                             [{"quantity": "time_min", "above": minutes_of_rest}]))
        else:
            test.features.append("rate change")
            rate *= log_uniform(random, 0.25, 4)
    go("shear to the end", [test.strain(end_strain), *ends])
    return out


def load_minutes(test):
    return log_uniform(test.random, 20, 500)


def by_load(test, drainage, minutes, axial_strain=15, q_end=None):
    """Load that grows by p0 in `minutes`."""
    random = test.random
    rate = test.p0 * test.newton_per_kpa / minutes
    q_end = q_end or test.p0 * random.uniform(0.9, 2.0)
    test.shear_minutes += minutes
    out = []
    end = [test.strain(axial_strain), test.q(q_end), {"quantity": "axial_strain_pct", "above" if test.extension else "below":
                                                      -test.sense * axial_strain}]

    def go(name, ends, speed, role="shear"):
        out.append(stage(name, role, drainage, "load", ends, 3 * minutes, load_rate_N_per_min=rounded(test.sense * speed)))
    action = random.random()
    if action < 0.3:
        q = test.p0 * random.uniform(0.1, 0.4) + test.ratio * test.p0
        go("load", [test.q(q), *end[:1]], rate)
        if action < 0.1:
            test.features.append("loop")
            go("unloading", [test.q(0.5 * q, False)], -rate)
        elif action < 0.2:
            test.features.append("rest")
            out.append(stage("load rests", "shear", drainage, "dead_load", [{"quantity": "time_min",
                                                                             "above": rounded(log_uniform(random, 1, 30), 2)}, *end[:1]]))
        else:
            test.features.append("rate change")
            rate *= log_uniform(random, 0.3, 3)
    go("load to the end", end, rate)
    return out


def displacement(test):
    return by_displacement(test, "closed", test.random.uniform(3, 15), log_uniform(test.random, 15, 600))


def load(test):
    return by_load(test, "closed", load_minutes(test))


def drained(test):
    if test.random.random() < 0.7:
        return by_displacement(test, "open", test.random.uniform(5, 15), log_uniform(test.random, 100, 1500))
    test.features.append("by load")
    return by_load(test, "open", log_uniform(test.random, 100, 1000))


def spring(test):
    random = test.random
    minutes = log_uniform(random, 60, 600)
    stiffness = test.p0 * test.newton_per_kpa / (0.01 * test.height) * log_uniform(random, 0.05, 3)
    test.shear_minutes += minutes
    travel = 1.5 * test.p0 * test.newton_per_kpa / stiffness + 0.1 * test.height
    return [stage("spring", "shear", "closed", "spring", [test.strain(10), test.q(test.max_q)], 2 * minutes,
                  axial_rate_mm_per_min=rounded(test.sense * max(2e-5, min(5.9, travel / minutes))),
                  spring_stiffness_N_per_mm=rounded(stiffness, 3))]


def dead_load(test):
    """Masses, one after the other."""
    random = test.random
    count = random.randint(5, 14)
    step = test.p0 * random.uniform(0.6, 1.4) / count * test.newton_per_kpa
    minutes = log_uniform(random, 2, 20)
    test.shear_minutes += count * minutes
    drainage = "open" if random.random() < 0.2 else "closed"
    end = [{"quantity": "time_min", "above": rounded(minutes, 2)}, test.strain(12)]
    return [stage(f"mass {i + 1}", "shear", drainage, "dead_load", end, load_step_N=rounded(test.sense * step, 3)) for i in range(count)]


def to_constant_q(test, ratio):
    """Drained shear to q, by displacement or load, and sometimes with the pressure that moves already."""
    random = test.random
    q = test.p0 * ratio
    minutes = log_uniform(random, 60, 800)
    ends = [test.q(q), test.strain(12)]
    if random.random() < 0.3:
        return [stage("drained load", "shear", "open", "load", ends, 3 * minutes,
                      load_rate_N_per_min=rounded(test.sense * q * test.newton_per_kpa / minutes))]
    rate = test.height * random.uniform(0.003, 0.02) / minutes
    return [stage("drained shear", "shear", "open", "displacement", ends, 8 * minutes, axial_rate_mm_per_min=rounded(test.sense * max(2e-5, rate)))]


def constant_q(test, drainage, by):
    """q held while p' falls: by the back pressure, or by the cell pressure."""
    random = test.random
    ratio = max(test.ratio + 0.05, random.uniform(0.15, 0.8) * (0.6 if test.extension else 1))
    out = to_constant_q(test, ratio)
    minutes = log_uniform(random, 60, 600)
    rate = test.p0 / minutes
    moving = {"back_rate_kPa_per_min": rounded(rate, 3)} if by == "back" else {"cell_rate_kPa_per_min": rounded(-rate, 3)}
    if random.random() < 0.5 and out[-1]["axial"] == "displacement":
        last = out[-1]
        end = [test.q(1.1 * ratio * test.p0), last["end"][1], {"quantity": "time_min", "above": rounded(0.15 * minutes, 3)}]
        out.append(last | {"name": "drained shear, the pressure begins to move", "end": end} | moving)
    ends = [{"quantity": "axial_strain_pct", "above": 15.0}, {"quantity": "axial_strain_pct", "below": -15.0},
            {"quantity": "p_eff_kPa", "below": rounded(max(2.0, 0.02 * test.p0), 2)}]
    if drainage == "closed":
        ends.append({"quantity": "pore_pressure_kPa", "below": 20.0})
    if by == "cell":
        ends.append({"quantity": "cell_pressure_kPa", "below": 25.0})
    if random.random() < 0.25 and not test.extension:
        test.features.append("ends early")
        ends.append({"quantity": "stress_ratio", "above": rounded(min(1.1, ratio * random.uniform(1.1, 1.8)), 3)})
    test.shear_minutes += minutes
    return out + [stage("constant q", "shear", drainage, "constant_q", ends, 2 * minutes, **moving)]


def csd(test):
    by = test.random.choice(("back", "cell"))
    test.features.append(f"p' falls by the {by} pressure")
    return constant_q(test, "open", by)


def csu(test):
    return constant_q(test, "closed", "cell")


def strain_path(test):
    ratio = rounded(log_uniform(test.random, 0.35, 2.0), 3)
    test.features.append("dilates" if ratio < 1 else "contracts")
    end = [test.strain(test.random.uniform(3, 8)), {"quantity": "p_eff_kPa", "below": 2.0}, test.q(test.max_q)]
    minutes = log_uniform(test.random, 60, 600)
    test.shear_minutes += minutes
    return [stage("strain path", "shear", "open", "displacement", end, 2 * minutes,
                  axial_rate_mm_per_min=rounded(max(2e-5, test.height * 0.05 / minutes)), strain_path_R=ratio)]


def cyclic(test):
    """Cycles of load about a bias, and sometimes monotonic shear after them."""
    random = test.random
    amplitude = test.p0 * random.uniform(0.06, 0.4)
    bias = test.ratio * test.p0 + (amplitude * random.uniform(0.2, 1.3) if random.random() < 0.5 else 0.0)
    test.features.append("bias" if bias else "symmetric")
    count = random.randint(4, 20)
    minutes = log_uniform(random, 1, 12)  # of a quarter cycle
    rate = amplitude * test.newton_per_kpa / minutes
    strains = [{"quantity": "axial_strain_pct", "above": 12.0}, {"quantity": "axial_strain_pct", "below": -12.0}]
    drainage = "open" if random.random() < 0.1 else "closed"
    out = []
    for i in range(count):
        for name, target, sign in ((f"up {i + 1}", bias + amplitude, 1), (f"down {i + 1}", bias - amplitude, -1)):
            end = {"quantity": "q_kPa", "above" if sign > 0 else "below": rounded(target)}
            out.append(stage(name, "shear", drainage, "load", [end, *strains], 6 * minutes, load_rate_N_per_min=rounded(sign * rate)))
    test.shear_minutes += 4 * count * minutes
    if random.random() < 0.25:
        test.features.append("monotonic after cycles")
        out += by_displacement(test, drainage, 10, log_uniform(random, 30, 300), [strains[0]])
    return out


def mixed(test):
    """One control after the other."""
    random = test.random
    first = random.choice(("drained", "displacement", "load"))
    q = test.p0 * random.uniform(0.15, 0.45) + test.ratio * test.p0
    minutes = log_uniform(random, 60, 400)
    test.features.append(f"{first} first")
    drainage = "open" if first == "drained" else "closed"
    if first == "load":
        out = [stage("load", "shear", "closed", "load", [test.q(q), test.strain(5)], 2 * minutes,
                     load_rate_N_per_min=rounded(q * test.newton_per_kpa / minutes))]
        return out + by_displacement(test, "closed", 10, 2 * minutes)
    out = [stage("shear by displacement", "shear", drainage, "displacement", [test.q(q), test.strain(2)], 4 * minutes,
                 axial_rate_mm_per_min=rounded(max(2e-5, test.height * 0.01 / minutes)))]
    test.shear_minutes += minutes
    return out + by_load(test, "closed", minutes)


SHEAR = {"displacement": displacement, "load": load, "spring": spring, "drained": drained, "dead_load": dead_load, "csd": csd, "csu": csu,
         "strain_path": strain_path, "cyclic": cyclic, "mixed": mixed}


def set_scans(test, stages):
    """An interval for preparation and one for shear, within what costs no more than MAX_READINGS; some average their samples."""
    random = test.random
    shear = log_uniform(random, max(0.2, test.shear_minutes * 60 / MAX_READINGS), min(120.0, max(1.0, test.shear_minutes * 60 / 80)))
    shear = rounded(max(0.25, shear), 2)
    average = rounded(shear * random.uniform(0.2, 1), 2) if shear > 1 and random.random() < 0.4 else 0
    for one in stages:
        if one["role"] == "shear":
            one["scan_interval_s"] = shear
            if average:
                one["averaging_s"] = average
    return stages
