#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws one increment at a time on arrays: closed forms, the path of triax element, shared memory, refusals."""
import unittest

import numpy as np
import triax
from program import SAMPLES

ROOT2 = np.sqrt(2)
UNDRAINED = (np.zeros((2, 2)), [[1, 0], [1, 2]])  # dε1 and dεv


def sheared(material, p_kPa, void_ratio, increments, strain, tolerance=1e-10):
    points = triax.Points(material, [[p_kPa, p_kPa]], void_ratio)
    for _ in range(increments):
        assert points.advance(control=UNDRAINED, increment=[strain / increments, 0], tolerance=tolerance).accepted
    return points


class ClosedForms(unittest.TestCase):
    def setUp(self):
        self.elastic = triax.Material("elastic/linear")
        e = self.elastic.parameters
        self.e_kPa, self.nu = e["young_modulus_kPa"], e["poisson_ratio"]

    def test_hooke_in_axisymmetry(self):
        points = triax.Points(self.elastic, np.full((3, 2), 100.0), 0.8)
        step = points.advance(stress_kPa=[[10, 0], [0, 10], [10, 10]])
        expected = np.array([[10, -self.nu * 10], [-2 * self.nu * 10, (1 - self.nu) * 10], [(1 - 2 * self.nu) * 10] * 2])
        np.testing.assert_allclose(step.strain, expected / self.e_kPa, rtol=1e-9)
        np.testing.assert_allclose(step.work_kPa, (step.stress_kPa * step.strain) @ [1, 2], rtol=1e-12)
        np.testing.assert_allclose(points.stress_kPa, [[110, 100], [100, 110], [110, 110]], rtol=1e-12)
        np.testing.assert_allclose(points.void_ratio, 0.8 - 1.8 * step.strain @ [1, 2], rtol=1e-6)
        np.testing.assert_allclose(points.q_kPa, [10, -10, 0], atol=1e-9)

    def test_shear_of_a_tensor_has_the_components_of_the_tensor(self):
        points = triax.Points(self.elastic, [[100, 100, 100, 0, 0, 0]], 0.8)
        step = points.advance(strain=[0, 0, 0, 1e-4, 0, 0])
        shear = self.e_kPa / (1 + self.nu) * 1e-4  # 2G ε12
        np.testing.assert_allclose(step.stress_kPa, [[0, 0, 0, shear, 0, 0]], rtol=1e-9, atol=1e-9)
        np.testing.assert_allclose(step.work_kPa, 2 * shear * 1e-4, rtol=1e-9)
        np.testing.assert_allclose(points.q_kPa, np.sqrt(3) * shear, rtol=1e-9)
        np.testing.assert_allclose(points.p_kPa, 100, rtol=1e-12)


class Paths(unittest.TestCase):
    def test_increments_follow_the_path_of_element(self):
        run = triax.element(SAMPLES / "paths/icu_100.toml", sets={"material": "sanisand/S28-general", "void_ratio": 0.9})
        end = np.searchsorted(run.rows.axial_strain, 0.02)
        points = sheared(triax.Material("sanisand/S28-general"), run.rows.p_eff_kPa[0], 0.9, 200,
                         run.rows.axial_strain[end])
        np.testing.assert_allclose(points.q_kPa, run.rows.q_kPa[end], rtol=1e-6)
        np.testing.assert_allclose(points.p_kPa, run.rows.p_eff_kPa[end], rtol=1e-6)
        self.assertEqual([f"memory.{n}" for n in points.memory_names], [n for n in run.rows if n.startswith("memory.")])

    def test_a_tensor_goes_where_axisymmetry_goes(self):
        for name, e in (("sanisand/S28-general", 0.8), ("hypoplastic/S28-MT", 0.95), ("cam_clay/Hostun-like", 0.85)):
            material = triax.Material(name)
            flat = triax.Points(material, [[100, 100]], e)
            full = triax.Points(material, [[100, 100, 100, 0, 0, 0]], e)
            for _ in range(20):
                flat.advance([2e-4, -1e-4])
                full.advance([2e-4, -1e-4, -1e-4, 0, 0, 0])
            np.testing.assert_allclose(full.stress_kPa[:, :2], flat.stress_kPa, rtol=1e-8, err_msg=name)

    def test_a_point_does_not_depend_on_the_others(self):
        material = triax.Material("inl2/S28-general")
        e = np.linspace(0.9, 1.1, 7)
        together = triax.Points(material, np.full((7, 2), 80.0), e)
        strain = np.outer(np.linspace(-1, 1, 7), [1e-4, -0.5e-4])
        together.advance(strain)
        for i in range(7):
            alone = triax.Points(material, [[80.0, 80.0]], e[i])
            alone.advance(strain[i])
            np.testing.assert_array_equal(alone.stress_kPa[0], together.stress_kPa[i])


class Memory(unittest.TestCase):
    def test_arrays_show_the_states_themselves(self):
        points = triax.Points(triax.Material("elastic/linear"), np.full((4, 2), 100.0), 0.8)
        stress, again = points.stress_kPa, points.stress_kPa
        self.assertTrue(np.shares_memory(stress, again))
        self.assertIs(stress.base, points)
        points.advance(stress_kPa=[5, 5])
        np.testing.assert_allclose(stress, 105, rtol=1e-12)  # moved by the increment
        stress[0] = 50  # where the next one starts
        points.advance(stress_kPa=[5, 5])
        np.testing.assert_allclose(points.stress_kPa, [[55, 55], [110, 110], [110, 110], [110, 110]], rtol=1e-12)

    def test_a_copy_has_memory_of_its_own(self):
        points = triax.Points(triax.Material("elastic/linear"), np.full((2, 2), 100.0), 0.8)
        other = points.copy()
        other.stress_kPa[:] = 1
        np.testing.assert_array_equal(points.stress_kPa, 100)
        self.assertFalse(np.shares_memory(points.void_ratio, other.void_ratio))

    def test_arrays_outlive_points(self):
        stress = triax.Points(triax.Material("elastic/linear"), np.full((1000, 2), 7.0), 0.8).stress_kPa
        [np.empty(10_000) for _ in range(20)]
        np.testing.assert_array_equal(stress, 7)


class Refusals(unittest.TestCase):
    def setUp(self):
        self.points = triax.Points(triax.Material("sanisand/S28-general"), np.full((3, 2), 100.0), 0.8)

    def test_a_load_that_cannot_be_carried_is_told(self):
        step = self.points.advance(stress_kPa=[[1, 0], [500, 0], [1, 0]], tolerance=1e-6)
        self.assertEqual([triax.OUTCOMES[o] for o in step.outcome], ["accepted", "lost_control", "accepted"])
        self.assertEqual(list(step.messages), [1])
        self.assertFalse(step.accepted)
        self.assertTrue(0 < step.done[1] < 1 == step.done[0])

    def test_a_state_without_a_law_is_refused_where_it_is(self):
        self.points.stress_kPa[2] = -5
        step = self.points.advance([1e-5, 0])
        self.assertEqual(triax.OUTCOMES[step.outcome[2]], "failed")
        self.assertIn("p'", step.messages[2])
        np.testing.assert_array_equal(self.points.stress_kPa[2], -5)

    def test_what_is_no_increment(self):
        for given, words in (
                (dict(), "give one of strain, stress_kPa and control"),
                (dict(strain=[1, 0], stress_kPa=[1, 0]), "give one of"),
                (dict(strain=[1, 0, 0]), "strain has another shape than the points; expected 2 numbers or 3 rows"),
                (dict(strain=np.zeros((2, 2))), "another shape"),
                (dict(control=UNDRAINED), "control needs increment"),
                (dict(control=(np.zeros((3, 3)), np.eye(2)), increment=[0, 0]), "S of control: not valid; expected a matrix of 2 x 2"),
                (dict(strain=[0, 0], tolerance=0), "tolerance 0: out of range")):
            with self.subTest(given=given), self.assertRaisesRegex(triax.BadInput, words):
                self.points.advance(**given)

    def test_what_are_no_points(self):
        material = triax.Material("sanisand/S28-general")
        with self.assertRaisesRegex(triax.BadInput, "expected a row a point"):
            triax.Points(material, [100, 100], 0.8)
        with self.assertRaisesRegex(triax.BadInput, "void_ratio has another shape"):
            triax.Points(material, [[100, 100]], [0.8, 0.9])
        with self.assertRaises(ValueError):
            triax.Material("elastic/linear", sets={"poisson_ratio": 0.6})


if __name__ == "__main__":
    unittest.main()
