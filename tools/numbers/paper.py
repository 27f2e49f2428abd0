# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of docs/explanation/paper.md (tools/pages): of Table 2 from tools/table2, in half a minute; of 10,000 grains from
docs/data/grains.json, which tools/grains-figures makes; of 500 grains from the program itself, in seconds."""
import json
import os
import pathlib
import re
import runpy
import shutil
import subprocess
import textwrap

results = runpy.run_path(str(pathlib.Path(__file__).resolve().parent.parent / "grains-results"))
kept_results = results["kept_results"]
ROOT = results["ROOT"]
IMAGES = ROOT / "docs/images/grains"


# ---- Table 2

def table2(triax, block: str) -> str:
    """A block that tools/table2 writes. Unless pages are only checked, its figures replace those of the page."""
    folder = triax.folder / "table2"
    if not folder.exists():
        subprocess.run([ROOT / "tools/table2", folder], env={**os.environ, "TRIAX": triax.program}, check=True)
    text = (folder / f"{block}.md").read_text(encoding="utf-8")
    if block == "table2_figures" and not triax.checking:
        for figure in re.findall(r"\(\.\./images/table2/(\w+\.svg)\)", text):
            shutil.copy(folder / "figures" / figure, ROOT / "docs/images/table2" / figure)
    return text


def ten_tests(triax) -> str:
    return table2(triax, "ten_tests")


def statements(triax) -> str:
    return table2(triax, "statements")


def pore_pressure(triax) -> str:
    return table2(triax, "pore_pressure")


def influence_of_q(triax) -> str:
    return table2(triax, "influence_of_q")


def table2_figures(triax) -> str:
    return table2(triax, "table2_figures")


# ---- grains

def stage(run: dict, name: str) -> dict:
    return next(s for s in run["stages"] if s["name"] == name)


def at(rose: dict, degrees: float) -> dict:
    return next(p for p in rose["probes"] if abs(p["alpha_deg"] - degrees) < 1e-3)


def table(heading: str, rows: list[str]) -> str:
    columns = heading.count("|") - 1
    return "\n".join([heading, "|" + "---|" * columns, *rows])


def wrapped(text: str) -> str:
    hang = "  " if text.startswith("- ") else ""
    return textwrap.fill(text, 100, subsequent_indent=hang, break_long_words=False, break_on_hyphens=False)


def comparison(*items: tuple[str, str, str]) -> str:
    """Items of a list: statement of the paper, result of triax, agreement."""
    return "\n".join(wrapped(f"- *{paper}.* {here} **{agreement}.**") for paper, here, agreement in items)


def degrees(ranges: list[dict]) -> str:
    return " and ".join(f"{r['from_deg']:.0f}° to {r['to_deg'] % 360:.0f}°" for r in ranges) or "no direction"


def span(values: list[float], digits: str) -> str:
    least, most = format(min(values), digits), format(max(values), digits)
    return least if least == most else f"{least} to {most}"


def apart(probe: dict) -> float:
    """Micro less macro over macro."""
    return probe["gap"]["micro_less_macro"] / probe["w2"]["lagrangian"]


def reversible(alpha: float) -> bool:
    """Where the paper finds both equal."""
    return alpha < 70.5 or alpha > 229.5


# ---- specimens

def specimens(triax) -> str:
    rows = []
    for name, run in kept_results(triax).items():
        if name in ("loose_study", "loose_probes"):
            continue
        made, state = run["specimen"], run["specimen"]["state"]
        how = f"friction {made['compaction_friction_deg']:.3g}°"
        if made["porosity_wanted"]:
            how = f"porosity {made['porosity_wanted']:g}: {how} in {made['compactions']} trials"
        rows.append(f"| `{name}` | {how} | {state['porosity']:.4f} | {state['coordination']:.2f} | {state['floating_grains']} |")
    outside = sum(s["grains_outside"] for run in kept_results(triax).values() for s in run["stages"])
    return (table("| sample | made with | n at 100 kPa | Z, floating grains included | floating |", rows) +
            f"\n\nNumber of grains outside the box after any stage: {outside}.")


# ---- probes of the dense specimen

def probed_state(triax) -> str:
    run = kept_results(triax)["dense"]
    pressed, sheared, rose = stage(run, "isotropic 200"), stage(run, "to eta 0.77"), stage(run, "probes")
    last = sheared["last"]
    null = rose["null_probe_over_smallest"]
    return wrapped(
        f"The state: isotropic to 200 kPa (n = {pressed['porosity']:.3f}), drained to η = 0.77 (ε₁ = {100 * last['strain']['axial']:.3f} %, "
        f"ε_v = {100 * last['volumetric_strain']:.3f} %), then equilibrium. {len(rose['probes'])} increments of {rose['norm_kPa']:g} kPa follow, and a "
        f"null probe, whose strain is {100 * null:.2f} % of the smallest probe's strain.")


def probes(triax) -> str:
    rose = stage(kept_results(triax)["dense"], "probes")
    by_strain = stage(kept_results(triax)["dense"], "probes by strain")
    all_probes = rose["probes"]
    inside = [p for p in all_probes if not reversible(p["alpha_deg"])]
    outside = [p for p in all_probes if reversible(p["alpha_deg"])]
    slides = [100 * p["sliding_share"] for p in all_probes]
    quiet = [100 * p["sliding_share"] for p in all_probes if not 55 < p["alpha_deg"] < 255]
    moving = max(all_probes, key=lambda p: p["kinetic_energy_most_J"])
    kinetic = [p["kinetic_energy_most_J"] for p in inside]
    rest = sorted(p["kinetic_energy_most_J"] for p in outside)[len(outside) // 2]
    same = ", ".join(f"{100 * apart(at(rose, a)):.1f}" for a in (60, 70, 230, 240, 250))
    euler = max(abs(p["w2"]["eulerian"] / p["w2"]["lagrangian"] - 1) for p in all_probes)
    largest = max(all_probes, key=lambda p: p["w2"]["lagrangian"])
    parts = largest["w2"]
    shares = ", ".join(f"{100 * parts[k] / parts['eulerian']:.1f} %" for k in ("stress_part", "volume_part", "transport_part"))
    boundary = [abs(p["boundary_part_J_per_m3"]) for p in all_probes]
    steady = [abs(p["boundary_part_J_per_m3"]) for p in by_strain["probes"]]
    negative = degrees(rose["negative_w2"])
    return comparison(
        ("Irreversible strain for 50° < α < 260°: many contacts reached Coulomb's criterion (at any step) or were not permanent",
         f"Sliding and non-permanent contacts exceed those of the null probe by {100 * rose['irreversible']['contacts_above_null_probe']:g} % for "
         f"{degrees(rose['irreversible']['ranges'])}: up to {max(slides):.1f} % of the contacts, at most {max(quiet):.1f} % outside 60° to 250°. triax "
         f"checks every 50 steps, and a contact with constant force at its limit does not count.", "Same range"),
        ("Many non-permanent contacts in that range",
         f"At most {100 * max(p['non_permanent_share'] for p in all_probes):.1f} % of the contacts.", "Fewer"),
        ("Kinetic energy not negligible for 70° < α < 230°",
         f"Largest at {moving['alpha_deg']:.0f}°, {moving['kinetic_energy_most_J']:.1g} J. From 80° to 220° it is {min(kinetic) / rest:.1f} to "
         f"{max(kinetic) / rest:.0f} times the median elsewhere.", "Same range, small"),
        ("Macro and micro W₂ are equal for α ≤ 70° and α ≥ 230°, not between",
         f"Difference at most {100 * max(abs(apart(p)) for p in outside):.1f} % for α ≤ 70° and α ≥ 230°, "
         f"{span([100 * apart(p) for p in inside], '.0f')} % from 80° to 220°.", "Same range, smaller difference"),
        ("Equal also in some irreversible directions (60°, 70°, 230°, 240°, 250°)", f"Differences {same} %.", "Same"),
        ("Semi-Lagrangian (7) and Eulerian (10) work are equivalent", f"Relative difference at most {euler:.0e} in all directions.", "Same"),
        ("In Eq. (10) dσ : LΔt is the largest part, div(du) σ : LΔt nearly nil, σLᵗ : LΔt small but not negligible for irreversible strains",
         f"At α = {largest['alpha_deg']:.0f}°: {shares}.", "Same"),
        ("W₂ is largest in the middle of the diagram",
         f"{parts['lagrangian']:.4f} J/m³ at {largest['alpha_deg']:.0f}°, {at(rose, 40)['w2']['lagrangian']:.4f} at 40°, "
         f"{at(rose, 220)['w2']['lagrangian']:.4f} at 220°.", "Same"),
        ("The boundary term of Eq. (22) is negligible: strain probes make it vanish and leave the difference",
         f"Up to {max(boundary):.1f} J/m³ in stress probes, {max(boundary) / parts['lagrangian']:.0f} times the largest W₂. At most "
         f"{max(steady):.0e} J/m³ in strain probes, with the same kind of difference.", "Not small, but no part of the difference"),
    ) + "\n\n" + wrapped(f"W₂ is negative in {negative} of this dense specimen. Its smallest normalised value is {rose['least_w2_normalised']:.2f} at "
                         f"{rose['least_alpha_deg']:.0f}°.")


# ---- what micro and macro differ by

def roses_of(name: str, stages: list[dict]) -> list[tuple[str, dict]]:
    found = []
    for one, words in (("probes", "{norm_kPa:g} kPa"), ("probes by strain", "ε {norm_strain:g}")):
        rose = stage({"stages": stages}, one)
        found.append((f"{name}, {words.format(**rose)}", rose))
    return found


def small_roses(triax) -> list[tuple[str, dict]]:
    """Of 500 grains, dense, at rest and hardly at rest, and loose, computed now."""
    found = []
    for friction, unbalanced in ((5, "1e-5"), (5, "1e-4"), (20, "1e-4")):
        document = json.loads(triax.run("grains", triax.sample("grains/quick.toml"), "--set", f"specimen.compaction_friction_deg={friction}",
                                        "--set", f"stages.3.unbalanced={unbalanced}", "--json"))
        stages = [s | results["rose_of"](s) for s in document["stages"] if "probes" in s]
        found += roses_of(f"n = {stages[0]['before']['porosity']:.3f}, {unbalanced}", stages)
    return found


def large_roses(triax) -> list[tuple[str, dict]]:
    """Of 10,000 grains, as far as their runs are kept."""
    if not results["KEPT"].exists():
        return []
    runs = kept_results(triax)
    return [one for name in ("dense", "loose_probes") if name in runs
            for one in roses_of(f"`{name.removesuffix('_probes')}`", runs[name]["stages"])]


def gaps(triax) -> str:
    large, small = large_roses(triax), small_roses(triax)
    rows = []
    for words, rose in large + small:
        rested = [p for p in rose["probes"] if p["at_rest"]]
        total = sum(abs(p["gap"]["micro_less_macro"]) for p in rested)
        share = {k: 100 * sum(p["gap"][k] for p in rested) / total for k in ("grains_turning", "contacts_turning", "out_of_balance")}
        left = 100 * sum(abs(p["gap"]["left"]) for p in rested) / total
        rows.append(f"| {words} | {len(rested)}/{len(rose['probes'])} | {span([1 + apart(p) for p in rested], '.3f')} | {share['grains_turning']:.1f} % | "
                    f"{share['contacts_turning']:.1f} % | {share['out_of_balance']:.1f} % | {left:.2g} % | "
                    f"{max(abs(p['boundary_part_J_per_m3']) for p in rested):.1g} |")
    return (table("| probes | at rest | micro/macro | grains | contacts | balance | left | boundary |", rows) +
            "\n\nSome directions, J/m³:\n\n" + by_direction([one for one in large if "kPa" in one[0]]))


def by_direction(some: list[tuple[str, dict]]) -> str:
    rows = []
    for words, rose in some:
        for alpha in (0, 90, 120, 180, 210):
            p = at(rose, alpha)
            g = p["gap"]
            if not p["at_rest"]:
                rows.append(f"| {words} | {alpha}° | not at rest | | | | | | |")
                continue
            rows.append(f"| {words} | {alpha}° | {p['w2']['lagrangian']:.5f} | {p['w2']['microscopic']:.5f} | {g['grains_turning']:.2e} | "
                        f"{g['contacts_turning']:.1e} | {g['out_of_balance']:.1e} | {g['left']:.0e} | {p['boundary_part_J_per_m3']:.1g} |")
    pictures = [f"![Probes, {what}](../images/grains/{name}_work.svg)" for name, what in
                (("dense_probes_by_strain", "dense, by strain"), ("loose_probes", "loose"), ("loose_probes_by_strain", "loose, by strain"))
                if (IMAGES / f"{name}_work.svg").exists()]
    return (table("| probes | α | macro | micro | grains | contacts | balance | left | boundary |", rows) +
            "\n\n" + "\n".join(pictures))


def energy(triax) -> str:
    document = json.loads(triax.run("grains", triax.sample("grains/quick.toml"), "--json"))
    quick = [s | results["rose_of"](s) for s in document["stages"] if "probes" in s]
    rows = []
    for words, rose in large_roses(triax) + roses_of("`quick`", quick):
        ledgers = [p["ledger"] for p in rose["probes"]]
        damping = [100 * l["damping_J"] / l["friction_J"] for l in ledgers]
        rows.append(f"| {words} | {min(damping):.2g} to {max(damping):.2g} % | {max(l['error_share'] for l in ledgers):.0e} |")
    worst = max((s for s in document["stages"] if s["ledger"]), key=lambda s: s["ledger"]["error_share"])
    return (table("| probes | damping over friction | largest error |", rows) +
            "\n\n" + wrapped(f"The largest error of the other stages of `quick` is {worst['ledger']['error_share']:.0e} (`{worst['name']}`, "
                             f"strained at 0.5 /s)."))


# ---- strain paths

RATIOS = ("0.7", "0.8", "0.825", "0.85", "0.875", "0.9", "1.0")


def peaks(triax) -> str:
    runs = kept_results(triax)
    rows = []
    for ratio in RATIOS:
        cells = []
        for name in ("medium", "loose"):
            one = stage(runs[name], f"R {ratio}")
            peak, last = one["peak_path_stress"], one["last"]
            end = f"{last['path_stress_kPa']:.1f}"
            if last["strain"]["axial"] < 0.0199:
                end += f" at {100 * last['strain']['axial']:.2f} %"
            cells.append(f"{peak['path_stress_kPa']:.1f} | {100 * peak['axial_strain']:.2f} | {end}")
        rows.append(f"| {ratio} | " + " | ".join(cells) + " |")
    return table("| R | `medium`: peak | at ε₁ | end | `loose`: peak | at ε₁ | end |", rows)


def falls(one: dict) -> bool:
    return one["last"]["path_stress_kPa"] < 0.9 * one["peak_path_stress"]["path_stress_kPa"]


def fallen(run: dict) -> str:
    return ", ".join(r for r in RATIOS if falls(stage(run, f"R {r}"))) or "none"


def crossing(run: dict) -> str:
    """How far from the maximum W₂ turns negative, % of strain."""
    far = []
    for ratio in RATIOS:
        one = stage(run, f"R {ratio}")
        if falls(one) and one["w2_first_negative"]:
            far.append((100 * abs(one["w2_first_negative"]["axial_strain"] - one["peak_path_stress"]["axial_strain"]), ratio))
    worst = max(far)
    others = sorted(far)[:-1]
    return f"within {others[-1][0]:.2f} % ({worst[0]:.2f} % at R = {worst[1]})"


def paths(triax) -> str:
    runs = kept_results(triax)
    loose, medium = runs["loose"], runs["medium"]
    energies = [(stage(run, f"R {r}")["kinetic_energy_most_J"], name, r) for name, run in (("medium", medium), ("loose", loose)) for r in RATIOS]
    energies.sort(reverse=True)
    return comparison(
        ("σ₁ − σ₃/R has a maximum for R below 0.85",
         f"A maximum and then a decrease by more than a tenth: `medium` for R = {fallen(medium)}, `loose` for R = {fallen(loose)}.",
         "`medium` same, `loose` differs"),
        ("W₂ vanishes at the maximum and is negative after it",
         f"W₂ of Eq. (30) over increments of 0.1 % of strain becomes negative close to the maximum, in strain {crossing(loose)} for `loose`, "
         f"{crossing(medium)} for `medium`.", "Same"),
        ("The path at R = 0.825 carries about 25 kPa at ES_a and ES_b, one on each side",
         f"The maximum is {stage(medium, 'R 0.825')['peak_path_stress']['path_stress_kPa']:.1f} kPa (`medium`), "
         f"{stage(loose, 'R 0.825')['peak_path_stress']['path_stress_kPa']:.1f} kPa (`loose`). ES_a and ES_b of `loose` are at "
         f"{stage(loose, 'a at rest')['path_stress_kPa']:.1f} and {stage(loose, 'b at rest')['path_stress_kPa']:.1f} kPa.", "Lower"),
        ("Kinetic energy on the paths at most about 1e-3 J",
         f"At most {energies[0][0]:.0e} J (`{energies[0][1]}`, R = {energies[0][2]}), then {energies[1][0]:.0e} J.", "Same"))


# ---- perturbations

def ended(run: dict, name: str) -> str:
    one = stage(run, name)
    words = {"at rest": "a new equilibrium", "collapsed": "collapses", "undecided": "not at rest at the time limit"}[one["end"]]
    return f"{words}, final χ = {one['chi']:.4g}, at most {one['kinetic_energy_most_J']:.1g} J"


def asked(run: dict, which: str) -> float:
    return stage(run, f"{which} load")["load_step_Pa"] / 1e3 / stage(run, f"{which} at rest")["path_stress_kPa"]


def perturbations(triax) -> str:
    run = kept_results(triax)["loose"]
    a, b = asked(run, "a"), asked(run, "b")
    reached = stage(run, "b load")["chi_most"]
    return comparison(
        ("Without perturbation both states do not change", f"ES_a: {ended(run, 'a left alone')}. ES_b: {ended(run, 'b left alone')}.", "Same"),
        ("ES_a under +2 %: a new equilibrium, a little higher, hardly any kinetic energy",
         f"+{stage(run, 'a load')['load_step_Pa']:g} Pa ({100 * a:.1f} %): {ended(run, 'a load')}.", "Same"),
        ("ES_b under +1 %: does not reach the setpoint, collapses at a growing rate, kinetic energy grows exponentially",
         f"+{stage(run, 'b load')['load_step_Pa']:g} Pa ({100 * b:.1f} %): χ reaches {reached:.3f} of {1 + b:.3f}, then {ended(run, 'b load')}.",
         f"Same at {100 * b:.1f} %"),
        ("ES_a with 1e-4 J given to floating grains: a new equilibrium after a transient",
         f"{stage(run, 'a energy')['kinetic_energy_given_J']:.0e} J: {ended(run, 'a energy')}.", "Same"),
        ("ES_b with 1e-4 J: total collapse", f"{stage(run, 'b energy')['kinetic_energy_given_J']:.0e} J: {ended(run, 'b energy')}.",
         f"Same at {stage(run, 'b energy')['kinetic_energy_given_J']:.0e} J"))


def study(triax) -> str:
    run, loose = kept_results(triax)["loose_study"], kept_results(triax)["loose"]
    at_rates = [(one["R"], one["peak_path_stress"]) for one in (stage(loose, "R 0.825"), stage(run, "slow"))]
    states = ("0.010", "0.015", "0.020", "0.025", "0.030", "0.035")

    def collapsed(push: str) -> int:
        return sum(stage(run, f"{s}, {push}")["end"] == "collapsed" for s in states)

    fast, slow = at_rates[0][1], at_rates[1][1]
    return "\n\n".join(wrapped(text) for text in (
        f"A state beyond the maximum relaxes when its walls stop: from 18.0 to {stage(run, 'relaxed')['path_stress_kPa']:.1f} kPa on a path at 0.1 /s, from "
        f"17.0 to {stage(run, 'slow relaxed')['path_stress_kPa']:.1f} kPa at 0.02 /s. ES_b is such a state, loaded again slowly (0.002 /s). Of "
        f"{len(states)} such states, 0.005 % of strain apart, {collapsed('350 Pa')} collapse under +350 Pa, {collapsed('170 Pa')} under +170 Pa and "
        f"{collapsed('0.1 mJ')} with 0.1 mJ given to floating grains.",
        f"Near the maximum the results depend on the rate. The maximum for R = 0.825 is {fast['path_stress_kPa']:.1f} kPa at "
        f"{100 * fast['axial_strain']:.2f} % of strain at 0.1 /s, and {slow['path_stress_kPa']:.1f} kPa at {100 * slow['axial_strain']:.2f} % at "
        f"0.02 /s. Perturbations run at the specimen's own rate."))
