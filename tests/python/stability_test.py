#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""probe and domain give what the program gives, as arrays too."""
import unittest

import numpy as np
import triax
from program import SAMPLES, InAFolder, refusal, triax_json

LOOSE = "inl2/S28-general"


class Probes(InAFolder):
    def test_states_are_those_of_the_program(self):
        run = triax.probe(LOOSE, p_kPa=70, eta=[0.5, 0.6], void_ratio=1.086)
        theirs = triax_json("probe", "--material", LOOSE, "--p-kPa", 70, "--eta", "0.5,0.6", "--void-ratio", 1.086, "--json")
        self.assertEqual(run.report, theirs)
        stable, unstable = run.states
        self.assertFalse(stable.unstable)
        self.assertEqual(stable.cones_deg, [])
        (cone,), = [unstable.cones_deg]
        said = theirs["states"][1]["cones"][0]
        np.testing.assert_allclose(cone, (said["from_deg"], said["to_deg"]), rtol=1e-14)
        self.assertTrue(cone[0] < 215.2644 < cone[1])  # isotropic unloading
        probes = unstable.probes
        inside = (probes.alpha_deg > cone[0] + 1e-6) & (probes.alpha_deg < cone[1] - 1e-6)
        np.testing.assert_array_equal(probes.w2_normalised < 0, inside)
        work = probes.axial_stress_kPa * probes.axial_strain + 2 * probes.radial_stress_kPa * probes.radial_strain
        np.testing.assert_allclose(1e3 * work, probes.w2_Pa, rtol=1e-9, atol=1e-9)

    def test_states_of_a_test_and_of_a_path(self):
        triax.replay(SAMPLES / "records/icu_6.csv", self.db)
        (state,) = triax.probe(LOOSE, tests=["ICU 6"], db=self.db).states
        self.assertAlmostEqual(state.eta, 0.598, places=2)
        along = triax.probe(path=SAMPLES / "paths/icu_100.toml", every=50)
        self.assertGreater(len(along.states), 3)
        self.assertIsNotNone(along.report["first_unstable_state"])

    def test_plane_strain_and_strain_probes(self):
        run = triax.probe("sanisand/S28-general", p_kPa=70, q_kPa=20, void_ratio=0.9, plane="plane-strain", kind="strain", directions=12)
        probes = run.states[0].probes
        np.testing.assert_allclose(np.hypot(probes.axial_strain, probes.radial_strain), 1e-5, rtol=1e-9)

    def test_what_is_no_state(self):
        for given, words in ((dict(), "give one of p_kPa"), (dict(p_kPa=70), "p_kPa needs either q_kPa or eta"),
                             (dict(p_kPa=70, eta=0.5), "missing void_ratio"),
                             (dict(p_kPa=70, eta=9, void_ratio=1), "eta 9: out of range; expected a number from -3 to 3"),
                             (dict(p_kPa=70, eta=0.5, void_ratio=1, kind="heat"), "kind 'heat' is not valid")):
            with self.subTest(given=given), self.assertRaisesRegex(triax.BadInput, words):
                triax.probe(LOOSE, **given)
        status, line = refusal("probe", "--material", LOOSE, "--p-kPa", 70, "--eta", 2, "--void-ratio", 1.086)
        with self.assertRaises(triax.BadInput) as raised:
            triax.probe(LOOSE, p_kPa=70, eta=2, void_ratio=1.086)
        self.assertEqual((status, line), (2, str(raised.exception)))


class Domains(unittest.TestCase):
    def test_a_domain_is_that_of_the_program(self):
        mine = triax.domain(LOOSE, 1.086, p_kPa=(50, 300, 6), q_kPa=(0, 300, 10), directions=36)
        theirs = triax_json("domain", "--material", LOOSE, "--void-ratio", 1.086, "--p-kPa", "50:300/6", "--q-kPa", "0:300/10",
                            "--directions", 36, "--json")
        self.assertEqual(mine.report, theirs)
        np.testing.assert_allclose(mine.p_kPa, np.linspace(50, 300, 6))
        np.testing.assert_allclose(mine.q_kPa, np.linspace(0, 300, 10))
        self.assertEqual(mine.kind.shape, (6, 10))
        unstable = triax.DOMAIN_KINDS.index("unstable")
        first = mine.boundary().q_kPa
        for i, q in enumerate(first):
            self.assertTrue((mine.q_kPa[mine.kind[i] == unstable] >= q - 1e-9).all())
        self.assertTrue(np.isnan(mine.boundary(extension=True).q_kPa).all())
        self.assertTrue((mine.least_work[mine.kind == unstable] < 0).all())

    def test_what_is_no_domain(self):
        for call, words in ((lambda: triax.domain(LOOSE, 1.0, p_kPa=(300, 50, 6)), "the grid: p' from 300 to 50 kPa"),
                            (lambda: triax.domain(LOOSE, 1.0, plane="3d"), "plane '3d' is not valid"),
                            (lambda: triax.domain(LOOSE, 1.0, p_kPa=(50, 60, 2), q_kPa=(0, 1, 2), criteria=["x"]), "criterion 'x' is not valid"),
                            (lambda: triax.domain("norsand/S28-MT", 0.9, criteria=["localisation"]),
                             "criterion localisation needs the full tensor, and norsand/S28-MT is not formulated for it"),
                            (lambda: triax.domain("norsand/S28-MT", 0.9, plane="plane-strain"),
                             "plane plane-strain: norsand/S28-MT is not formulated for it: ")):
            with self.assertRaisesRegex(triax.BadInput, words):
                call()
        small = triax.domain(LOOSE, 1.0, p_kPa=(50, 60, 2), q_kPa=(0, 1, 2), directions=8)
        with self.assertRaisesRegex(triax.BadInput, "criterion 'x' is not valid; must be one of: first_unstable, isotropic_unloading"):
            small.boundary("x")


if __name__ == "__main__":
    unittest.main()
