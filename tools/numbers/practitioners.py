# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of docs/explanation/practitioners.md (tools/pages): four simulated tests."""
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
        return f"– | – | none found; the largest q, {last['q_kPa']:.0f} kPa, at ε₁ = {100 * last['axial_strain']:.0f} %"
    inside = "inside the limit surface" if collapse["inside_limit_surface"] else "on the limit surface"
    return f"{collapse['eta']:.2f} | {collapse['phi_mob_deg']:.1f}° | {collapse['kind']}, {inside}"


def results(triax) -> str:
    lines = ["| test | p′₀ (kPa) | e₀ | η at collapse | φ_mob at collapse | result |", "|---|---|---|---|---|---|"]
    for one in tests(triax).values():
        at = one["consolidation"]
        lines.append(f"| {one['test']['name']} | {at['p_eff_kPa']:.0f} | {at['void_ratio']:.3f} | {result(one)} |")
    return "\n".join(lines)


def lines(triax) -> str:
    etas = [one["collapse"]["eta"] for one in loose(triax)]
    phis = [one["collapse"]["phi_mob_deg"] for one in loose(triax)]
    mean = sum(etas) / len(etas)
    return f"""\
**Failure line.** The strength that a stability calculation uses: friction angle φ′ = {FRICTION_DEG}°, in the q-p′ plane the slope
M = 6 sin φ′ / (3 − sin φ′) = {failure_slope():.3f}. The report calls it the *limit surface*.

**Instability line.** The stress ratio η = q/p′ at which the specimen became unstable: {min(etas):.2f} to {max(etas):.2f} in these tests of loose
sand, {100 * mean / failure_slope():.0f} % of M. It is reached with a mobilised friction angle of {min(phis):.1f}° to {max(phis):.1f}°, from
sin φ_mob = 3η/(6 + η). Between the two lines a loose specimen stands only as long as nothing disturbs it and water can leave."""


def example(triax) -> str:
    told = tests(triax)
    phi = told["csu_26"]["collapse"]["phi_mob_deg"]
    icu = told["icu_6"]
    peak, p0 = icu["peak"]["q_kPa"], icu["consolidation"]["p_eff_kPa"]
    q = triax.query("SELECT q_kPa FROM states WHERE test = 'ICU 6' ORDER BY reading DESC LIMIT 1")
    return f"""\
In this sand a dry long slope of {phi:.1f}° (φ_mob of CSU 26) has a factor of safety tan {FRICTION_DEG}° / tan {phi:.1f}° =
{tan(radians(FRICTION_DEG)) / tan(radians(phi)):.1f} by the failure line, and stands at the instability line. In ICU 6 q fell from {peak:.1f} kPa
(q/2 = {peak / 2 / p0:.2f} p′₀) to {q[0]['q_kPa']:.1f} kPa."""


def second_order_work(triax) -> str:
    told = tests(triax)
    icu, csd = told["icu_6"]["collapse"], told["csd_58"]["collapse"]
    early = [(told[name]["collapse"]["time_s"] - told[name]["peak"]["time_s"]) / 60 for name in ("csu_26", "csd_58")]
    return f"""\
The report gives W2 normalised, from −1 to 1, with its standard error: ICU 6 has {icu['second_order_work_normalised']:.3f} ±
{icu['second_order_work_error']:.3f} where it is first significant. Its sign matters, its size does not rank tests. In an undrained test it
changes sign at the peak of q; at constant q where the volume starts to contract while p′ falls. For CSD 58 there is no peak of q to see: W2
shows the onset, at {csd['time_s'] / 60:.0f} min and {100 * csd['axial_strain']:.1f} % of axial strain. q is held constant in CSU 26 and CSD 58, and
its "peak" is noise, {min(early):.0f} to {max(early):.0f} minutes before the onset."""


def trust(triax) -> str:
    told = tests(triax)
    b = {name: told[name]["consolidation"]["b_value"] for name in ("icu_6", "csu_26")}
    lost = [one["specimen"]["void_ratio"] - one["consolidation"]["void_ratio"] for one in loose(triax)]
    falls = [r["end_s"] - r["start_s"] for one in told.values() for r in one["collapse"]["truth"]["run_aways"]]
    return f"""\
In the tests of this page B is {b['icu_6']:.3f} (ICU 6) and {b['csu_26']:.3f} (CSU 26), the loose specimens lost {min(lost):.3f} to
{max(lost):.3f} of e before shear, and the runaways of CSU 26 and CSD 58 lasted {min(falls):.2f} to {max(falls):.2f} s."""
