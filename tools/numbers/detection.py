# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of docs/explanation/detection.md (tools/pages): four simulated tests."""
from math import radians, sin, tan

PROGRAMMES = ("icu_6", "csu_26", "csd_58", "icu_dense")
FRICTION_DEG = 32


def tests(triax) -> dict[str, dict]:
    told = [triax.documents("simulate", triax.sample(f"programmes/{programme}.toml"))[0] for programme in PROGRAMMES]
    return dict(zip(PROGRAMMES, told))


def loose(triax) -> list[dict]:
    return [one for name, one in tests(triax).items() if name != "icu_dense"]


def failure_slope() -> float:
    return 6 * sin(radians(FRICTION_DEG)) / (3 - sin(radians(FRICTION_DEG)))


def result(one: dict) -> str:
    collapse, last = one["collapse"], one["peak"]
    if collapse["kind"] == "none":
        return f"– | – | no collapse (largest q {last['q_kPa']:.0f} kPa at ε₁ = {100 * last['axial_strain']:.0f} %)"
    inside = "inside the limit surface" if collapse["inside_limit_surface"] else "on the limit surface"
    return f"{collapse['eta']:.2f} | {collapse['phi_mob_deg']:.1f}° | {collapse['kind']}, {inside}"


def two_lines(triax) -> str:
    etas = [one["collapse"]["eta"] for one in loose(triax)]
    phis = [one["collapse"]["phi_mob_deg"] for one in loose(triax)]
    mean = sum(etas) / len(etas)
    return f"""\
- **Limit surface** (failure line): friction angle φ′ = {FRICTION_DEG}°, slope M = 6 sin φ′/(3 − sin φ′) = {failure_slope():.3f}.
- **Instability line**: η at the onset, here {min(etas):.2f} to {max(etas):.2f} for loose sand, {100 * mean / failure_slope():.0f} % of M. The mobilised
  friction angle is {min(phis):.1f}° to {max(phis):.1f}°, from sin φ_mob = 3η/(6 + η). Between the two lines a loose specimen is
  stable only while it is not disturbed and water can drain."""


def results(triax) -> str:
    lines = ["| test | p′₀ (kPa) | e₀ | η at onset | φ_mob at onset | result |", "|---|---|---|---|---|---|"]
    for one in tests(triax).values():
        at = one["consolidation"]
        lines.append(f"| {one['test']['name']} | {at['p_eff_kPa']:.0f} | {at['void_ratio']:.3f} | {result(one)} |")
    return "\n".join(lines) + "\n\n" + two_lines(triax)


def example(triax) -> str:
    told = tests(triax)
    phi = told["csu_26"]["collapse"]["phi_mob_deg"]
    icu = told["icu_6"]
    peak, p0 = icu["peak"]["q_kPa"], icu["consolidation"]["p_eff_kPa"]
    q = triax.query("SELECT q_kPa FROM states WHERE test = 'ICU 6' ORDER BY reading DESC LIMIT 1")
    return f"""\
A dry long slope of {phi:.1f}° (φ_mob of CSU 26) has a factor of safety of tan {FRICTION_DEG}°/tan {phi:.1f}° = {tan(radians(FRICTION_DEG)) / tan(radians(phi)):.1f} on the failure
line, but is on the instability line. In ICU 6 q fell from {peak:.1f} (q/2 = {peak / 2 / p0:.2f} p′₀) to {q[0]['q_kPa']:.1f} kPa."""


def second_order_work(triax) -> str:
    told = tests(triax)
    icu, csd = told["icu_6"]["collapse"], told["csd_58"]["collapse"]
    early = [(told[name]["collapse"]["time_s"] - told[name]["peak"]["time_s"]) / 60 for name in ("csu_26", "csd_58")]
    return f"""\
The report prints normalised W2, from −1 to 1, with its standard error: {icu['second_order_work_normalised']:.3f} ± {icu['second_order_work_error']:.3f} for ICU 6
where it is first significant. The sign matters. The size does not rank tests. CSD 58 has no peak of q:
W2 gives the onset, at {csd['time_s'] / 60:.0f} min and ε₁ = {100 * csd['axial_strain']:.1f} %. In tests at held q the reported peak of q is only noise,
here {min(early):.0f} to {max(early):.0f} minutes before the onset."""


def slow_logger(triax) -> str:
    off = []
    for seed in (1, 2, 3):
        told = triax.documents("simulate", triax.sample("programmes/icu_load.toml"), "--seed", str(seed), "--set", "test.scan_interval_s=7.5")[0]
        off.append(told["collapse"]["eta"] - told["collapse"]["truth"]["eta"])
    return (f"With 7.5 s between readings the error of η of ICU 6 under a growing load is {max(map(abs, off)):.3f} (largest of three\n"
            "seeds), because p′ continues to change after the last reading.")
