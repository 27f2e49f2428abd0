# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of docs/explanation/stability.md (tools/pages)."""
import textwrap

LOOSE = ("--void-ratio", "1.086", "--p-kPa", "70", "--step", "1")
DENSE = ("--void-ratio", "0.75", "--p-kPa", "100", "--step", "1")
DOMAIN = ("--void-ratio", "1.086", "--p-kPa", "10:300/100", "--q-kPa", "-250:390/100")


def degrees(cone: dict) -> str:
    return f"{cone['from_deg']:.1f}° – {cone['to_deg']:.1f}°"


def cones(triax) -> str:
    ratios = ("0.55", "0.60", "0.70")
    rows = [("INL2, p′ = 70 kPa, e = 1.086", "inl2", LOOSE), ("octolinear, the same", "octolinear", LOOSE),
            ("INL2, p′ = 100 kPa, e = 0.75 (dense)", "inl2", DENSE)]
    lines = ["| law, state | " + " | ".join(f"η = {r}" for r in ratios) + " |", "|---|" + "---|" * len(ratios)]
    for words, law, state in rows:
        told = triax.documents("probe", "--material", f"{law}/S28-general", *state, "--eta", ",".join(ratios))
        cells = [" and ".join(map(degrees, one["cones"])) or "none" for one in told]
        lines.append(f"| {words} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def collapses(triax, material: str) -> list[dict]:
    """The two tests of the page, probed with a law at the state where each collapsed."""
    for test in ("csu_27", "csd_58"):
        triax.run("simulate", triax.sample(f"programmes/{test}.toml"))
    return triax.documents("probe", "--test", "CSU 27", "--test", "CSD 58", "--at", "collapse", "--material", material)


def where(own: dict) -> str:
    if own["cone"] is None:
        return "no cone"
    if not own["certain"]:
        return "on the edge, within its error"
    return f"{own['nearest_edge_deg']:.1f}° {'inside' if own['in_cone'] else 'outside'}"


def own_increments(triax) -> str:
    lines = ["| law | test | increment | cone | position of the increment |", "|---|---|---|---|---|"]
    for law, words in (("inl2", "INL2, as the specimen"), ("sanisand", "SANISAND")):
        for one in collapses(triax, f"{law}/S28-general"):
            own = one["own_increment"]
            cone = degrees(one["cones"][own["cone"]]) if own["cone"] is not None else "none"
            lines.append(f"| {words} | {one['state']['test']['name']} | {own['alpha_deg']:.1f}° ± {own['alpha_error_deg']:.1f}° | "
                         f"{cone} | {where(own)} |")
    return "\n".join(lines)


def void_ratios(triax) -> str:
    at = [f"{one['state']['void_ratio']:.3f}" for one in collapses(triax, "inl2/S28-general")]
    return f"The void ratios of the tests ({at[0]} and {at[1]} at collapse) differ from the 1.1 of the cones."


def spans(one: dict, sense: str) -> str:
    lost = [s for s in one["control"]["lost"] if s["sense"] == sense]
    return ", ".join(f"R from {s['from_R']:.2f} to {s['to_R']:.2f}" for s in lost) or "–"


def control(triax) -> str:
    told = triax.documents("probe", "--material", "inl2/S28-general", *LOOSE, "--eta", "0.5,0.6,0.7")
    lines = ["| η | σ₁ − σ₃/R cannot grow in compression | cannot fall in extension |", "|---|---|---|"]
    for one in told:
        lines.append(f"| {one['state']['eta']:.1f} | {spans(one, 'loading')} | {spans(one, 'unloading')} |")
    return "\n".join(lines)


def limit_of_peaks(triax, material: str, with_peak: float, without: float) -> float:
    """R, to 0.005, between a strain path with a peak and one without."""
    while abs(with_peak - without) > 0.005:
        middle = round((with_peak + without) / 2, 4)
        path = triax.documents("probe", "--material", material, "--void-ratio", "1.086", "--p-kPa", "100",
                               "--strain-paths", str(middle))[0]["strain_paths"][0]
        if path["peak"]:
            with_peak = middle
        else:
            without = middle
    return with_peak


def strain_paths(triax) -> str:
    lines = ["| law | peak for R from | to |", "|---|---|---|"]
    for words, material in (("INL2", "inl2/S28-general"), ("octolinear", "octolinear/S28-general"),
                            ("SANISAND", "sanisand/S28-general"), ("hypoplasticity", "hypoplastic/S28-MT")):
        lines.append(f"| {words} | {limit_of_peaks(triax, material, 1, 0.1):.2f} | {limit_of_peaks(triax, material, 1, 3):.2f} |")
    return "\n".join(lines)


def boundary(document: dict, p_kPa: float) -> dict:
    near = [b for b in document["boundaries"] if b["side"] == "compression"]
    return min(near, key=lambda b: abs(b["p_eff_kPa"] - p_kPa))


def domain(triax) -> str:
    one = boundary(triax.documents("domain", "--material", "inl2/S28-general", *DOMAIN)[0], 74)
    return textwrap.fill(
        f"At p′ = {one['p_eff_kPa']:.0f} kPa the first unstable direction is at η = {one['first_unstable']['eta']:.3f}. ICU and CSD tests collapse "
        f"inside the domain, on the line of isotropic unloading, at {one['isotropic_unloading']['eta']:.3f}. The plastic limit is far above "
        f"({one['limit']['eta']:.2f}).", 100)


def plane_strain(triax) -> str:
    one = boundary(triax.documents("domain", "--material", "octolinear/S28-general", "--void-ratio", "1.086", "--plane", "plane-strain",
                                   "--localisation", "--p-kPa", "10:300/20", "--q-kPa", "0:390/100")[0], 74)
    return textwrap.fill(
        f"At {one['p_eff_kPa']:.0f} kPa diffuse failure is first (η = {one['first_unstable']['eta']:.2f}), then localisation "
        f"({one['localisation']['eta']:.2f}), then the plastic limit ({one['limit']['eta']:.2f}).", 100)
