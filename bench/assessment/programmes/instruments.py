# SPDX-License-Identifier: GPL-3.0-or-later
"""Instruments, drawn continuously from good (quality 0) to terrible (quality 1)."""
from .draws import between, log_uniform, rounded

TERRIBLE_PRESSURE_NOISE_KPA = 1.5
RANGES_KPA = (500.0, 1000.0, 2000.0, 3500.0)


def near(random, quality):
    """The quality of one device: a laboratory does not buy all of them at the same price."""
    return min(1.0, max(0.0, quality + random.gauss(0, 0.15)))


def bits(quality):
    return round(24 - 13 * quality)


def range_above(random, need, ranges):
    """One of the ranges that suffice, the smaller the likelier."""
    fitting = [r for r in ranges if r >= need] or [rounded(need * 1.2, 2)]
    return fitting[min(int(random.expovariate(1.2)), len(fitting) - 1)]


def errors(random, quality, unit, full_scale, noise):
    """The keys that all transducers with a converter have. noise: good and terrible, in the unit."""
    q = near(random, quality)
    out = {f"range_{unit}": full_scale, "bits": bits(near(random, quality)), f"noise_{unit}": rounded(between(*noise, q), 3)}
    if random.random() < 0.5:
        out["nonlinearity_pct_of_range"] = rounded(random.choice((-1, 1)) * between(0.01, 0.4, near(random, quality)), 2)
    if random.random() < 0.3:
        out["hysteresis_pct_of_range"] = rounded(between(0.01, 0.3, near(random, quality)), 2)
    if random.random() < 0.5:
        out["time_constant_s"] = rounded(between(0.02, 3.0, near(random, quality)), 2)
    return out


def transducers(random, quality, size, largest):
    """Tables by channel. size: height and diameter in mm; largest: what the test reaches in mm, N and kPa."""
    pressures = range_above(random, largest["pressure"], RANGES_KPA)
    force = largest["force"] * log_uniform(random, 1.1, 4)
    out = {
        "axial_displacement": errors(random, quality, "mm", range_above(random, 0.35 * size[0], (10.0, 25.0, 50.0, 100.0)), (1e-4, 0.02)),
        "axial_force": errors(random, quality, "N", rounded(force, 2), (1e-5 * force, 1.5e-3 * force)),
        "cell_pressure": errors(random, quality, "kPa", pressures, (0.005, TERRIBLE_PRESSURE_NOISE_KPA)),
        "pore_pressure": errors(random, quality, "kPa", pressures, (0.005, TERRIBLE_PRESSURE_NOISE_KPA)),
        "back_pressure": errors(random, quality, "kPa", pressures, (0.005, TERRIBLE_PRESSURE_NOISE_KPA)),
    }
    if random.random() < 0.15:
        out["pore_pressure"]["time_constant_s"] = rounded(log_uniform(random, 3, 30), 2)
    if random.random() < 0.3:
        out["pore_pressure"]["drift_kPa_per_h"] = rounded(between(0.005, 0.3, near(random, quality)), 2)
    for channel in ("back_volume", "cell_volume"):
        out[channel] = {"resolution_mm3": rounded(between(0.1, 20, near(random, quality)), 2),
                        "noise_mm3": rounded(between(0.05, 10, near(random, quality)), 2)}
    return out


def rig(random, quality, back_pressure, compliance, drained):
    """compliance: of lines and transducer, mm3/kPa, or None for a law with its own pore fluid, which takes the volume as constant."""
    out = {"back_pressure_kPa": back_pressure}
    if compliance is not None:
        out |= {"water_bulk_modulus_GPa": 2.2, "system_compliance_mm3_per_kPa": compliance}
    out["drainage_resistance_kPa_s_per_mm3"] = rounded(log_uniform(random, 0.05, 1.0 if drained else 5.0), 2)
    frame = {"servo_filter_s": rounded(random.uniform(0, 15), 2)}
    if random.random() < 0.5:
        frame["bandwidth_Hz"] = rounded(between(10.0, 0.5, near(random, quality)), 2)
    if random.random() < 0.4:
        frame["velocity_step_mm_per_min"] = rounded(between(1e-5, 1e-3, near(random, quality)), 1)
    if random.random() < 0.4:
        frame["stiffness_kN_per_mm"] = rounded(log_uniform(random, 10, 200), 2)
    controller = {}
    if random.random() < 0.6:
        controller["pressure_resolution_kPa"] = rounded(between(0.02, 1.0, near(random, quality)), 1)
    if random.random() < 0.4:
        controller["time_constant_s"] = rounded(between(0.05, 3.0, near(random, quality)), 2)
    return out, frame, controller
