# Tables, events and curves, beside closed forms.
# SPDX-License-Identifier: MIT
import math
import unittest
import warnings

from common import TestCase, hvi, np, oscillator, verlet_of_oscillator


class Integration(TestCase):
    @classmethod
    def setUpClass(cls):
        cls.verlet = oscillator().stepper("stormer-verlet")
        cls.gauss = oscillator().stepper("gauss:4")

    def test_steps_are_those_of_the_method(self):
        x = self.verlet.initial()
        for _ in range(100):
            self.verlet.step(x, 0.3)
        self.assert_near(x, verlet_of_oscillator(0.3, 100), 1e-13)

    def test_one_step_and_many_round_alike(self):
        for method in ("stormer-verlet", "gauss:2", "gauss:5", "lobatto:3"):
            stepper = hvi.Scene("kepler").stepper(method)
            table = stepper.integrate(t_span=(0, 10), step=0.1, every=1).y
            x = stepper.initial()
            stepper.reset()
            for row in table.T[1:]:
                stepper.step(x, 0.1)
                np.testing.assert_array_equal(x, row)
            coarse = stepper.integrate(t_span=(0, 10), step=0.1, every=10).y
            np.testing.assert_array_equal(coarse, table[:, ::10])

    def test_rows_that_are_far_apart_are_those_of_near_ones(self):
        for steps, every in ((300000, 65000), (26000, 12003), (1003, 1001), (5000, 10000)):
            run = self.verlet.integrate([1, 0], (0, steps / 8), 1 / 8, every=every)
            near = self.verlet.integrate([1, 0], (0, steps / 8), 1 / 8, every=1)
            places = [*range(0, steps, every), steps]
            np.testing.assert_array_equal(run.t, np.array(places) / 8)
            np.testing.assert_array_equal(run.y, near.y[:, places])
            self.assertEqual(run.steps, steps)

    def test_a_table_has_all_steps_and_the_names_of_scipy(self):
        result = self.verlet.integrate([1, 0], (0, 3), 0.3)
        self.assertEqual(result.t.shape, (11,))
        self.assertEqual(result.y.shape, (2, 11))
        self.assertEqual(result.names, ["q", "p"])
        self.assertTrue(result.success)
        self.assertEqual((result.status, result.steps), (0, 10))
        self.assert_near(result.y.T, [verlet_of_oscillator(0.3, n) for n in range(11)], 1e-14)
        self.assert_near(result.energy, result["p"] ** 2 / 2 + result["q"] ** 2 / 2, 1e-15)
        np.testing.assert_array_equal(result.q[0], result["q"])
        np.testing.assert_array_equal(result.p[0], result["p"])
        with self.assertRaises(KeyError):
            result["r"]

    def test_a_long_table_has_about_a_thousand_rows_and_its_end(self):
        result = self.verlet.integrate([1, 0], (0, 1000), 0.01)
        self.assertLess(len(result.t), 1003)
        self.assertEqual(result.t[-1], 1000)
        self.assert_near(result.y[:, -1], verlet_of_oscillator(0.01, 100000), 1e-9)

    def test_the_last_step_is_a_short_one(self):
        result = self.gauss.integrate([1, 0], (0, 1), 0.3)
        self.assert_near(result.t, [0, 0.3, 0.6, 0.9, 1], 1e-15)
        self.assert_near(result.y[:, -1], [math.cos(1), -math.sin(1)], 1e-10)

    def test_no_step_and_steps_backward(self):
        nothing = self.gauss.integrate([1, 0], (2, 2), 0.1)
        self.assertEqual((len(nothing.t), nothing.t[0], nothing.steps), (1, 2, 0))
        back = self.gauss.integrate([math.cos(1), -math.sin(1)], (1, 0), 0.1)
        self.assertEqual(back.t[-1], 0)
        self.assert_near(back.y[:, -1], [1, 0], 1e-13)

    def test_rows_at_given_times_leave_the_trajectory_as_it_is(self):
        times = [0, 0.05, 0.1, 0.77, 5, 9.99, 10]
        free = self.gauss.integrate([1, 0], (0, 10), 0.1)
        given = self.gauss.integrate([1, 0], (0, 10), 0.1, t_eval=times)
        np.testing.assert_array_equal(given.t, times)
        self.assert_near(given.y, [np.cos(times), -np.sin(times)], 1e-13)
        np.testing.assert_array_equal(given.y[:, -1], free.y[:, -1])
        for wrong in ([1, 0.5], [0, 11], [-1, 2]):
            with self.assertRaises(ValueError):
                self.gauss.integrate([1, 0], (0, 10), 0.1, t_eval=wrong)

    def test_a_curve_between_the_rows(self):
        result = self.gauss.integrate([1, 0], (0, 10), 0.1, every=7, dense_output=True)
        times = np.array([0, 0.3, 3.33, 9.999, 10])
        self.assert_near(result.sol(times), [np.cos(times), -np.sin(times)], 1e-13)
        self.assertEqual(result.sol(0.3).shape, (2,))
        with self.assertRaises(ValueError):
            result.sol(10.5)

    def test_what_cannot_be_a_run_is_refused(self):
        for span, step in (((0, math.inf), 0.1), ((0, 1), 0), ((0, 1), math.nan)):
            with self.assertRaises(ValueError):
                self.gauss.integrate([1, 0], span, step)
        with self.assertRaisesRegex(ValueError, "step is missing"):
            self.gauss.integrate([1, 0], (0, 1))
        with self.assertRaisesRegex(ValueError, "t_span is missing"):
            self.gauss.integrate([1, 0], step=0.1)
        for state in ([1], [1, 2, 3], [1, math.nan]):
            with self.assertRaises(ValueError):
                self.gauss.integrate(state, (0, 1), 0.1)
        for state in ([1.0, 0.0], np.zeros(2, dtype=np.float32), np.zeros(3)):
            with self.assertRaises(TypeError):
                self.gauss.step(state, 0.1)

    def test_a_step_that_fails_keeps_the_rows_up_to_there(self):
        # From rest at 0 the way to infinity takes the integral of 1/sqrt(2 (e^q - 1)), pi/sqrt(2).
        fall = hvi.Scene(coordinates=["q"], hamiltonian="p^2/2 - exp(q)",
                         initial={"q": 0, "p": 0}).stepper("gauss:2")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)
            result = fall.integrate(t_span=(0, 4), step=0.01)
        self.assertFalse(result.success)
        self.assertEqual(result.status, -1)
        self.assertTrue(result.message)
        self.assertAlmostEqual(result.t[-1], math.pi / math.sqrt(2), delta=0.05)
        self.assertTrue(np.all(np.isfinite(result.y)))
        x = result.y[:, -1].copy()
        before = x.copy()
        with self.assertRaises(hvi.StepError):
            for _ in range(1000):
                before[:] = x
                fall.step(x, 0.01)
        np.testing.assert_array_equal(x, before)

    def test_a_step_that_is_too_large_is_said(self):
        with self.assertWarnsRegex(RuntimeWarning, "the step is too large"):
            self.verlet.integrate([1, 0], (0, 100), 1.9)
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            self.verlet.integrate([1, 0], (0, 100), 0.5)

    def test_copies_go_on_bit_by_bit(self):
        x = self.gauss.initial()
        for _ in range(10):
            self.gauss.step(x, 0.3)
        other, y = self.gauss.copy(), x.copy()
        for _ in range(10):
            self.gauss.step(x, 0.3)
            other.step(y, 0.3)
        np.testing.assert_array_equal(x, y)


class Events(TestCase):
    @classmethod
    def setUpClass(cls):
        cls.stepper = oscillator(parameters={"level": "1/2"}).stepper("gauss:5")

    def run_with(self, events, until=20, **more):
        return self.stepper.integrate([1, 0], (0, until), 0.1, events=events, **more)

    def test_zeros_of_an_expression(self):
        result = self.run_with("q")
        self.assert_near(result.t_events[0], math.pi / 2 + math.pi * np.arange(6), 1e-13)
        self.assertEqual(result.y_events[0].shape, (6, 2))
        self.assert_near(result.y_events[0][:, 0], np.zeros(6), 1e-14)

    def test_directions(self):
        down, up = self.run_with([hvi.Event("q", "down"), hvi.Event("q", "up")]).t_events
        self.assert_near(down, math.pi / 2 + 2 * math.pi * np.arange(3), 1e-13)
        self.assert_near(up, 3 * math.pi / 2 + 2 * math.pi * np.arange(3), 1e-13)
        with self.assertRaises(ValueError):
            self.run_with(hvi.Event("q", "sideways"))

    def test_functions_with_the_attributes_of_scipy(self):
        def zero(t, y):
            return y[0]
        zero.terminal, zero.direction = 2, -1
        result = self.run_with(zero)
        self.assertEqual(result.status, 1)
        self.assertTrue(result.success)
        self.assertAlmostEqual(result.t[-1], 5 * math.pi / 2, delta=1e-13)
        self.assertEqual(len(result.t_events[0]), 2)

    def test_parameters_and_the_time_in_expressions(self):
        result = self.run_with(["q - level", "t - 7.77"], until=8)
        self.assertAlmostEqual(result.t_events[0][0], math.pi / 3, delta=1e-13)
        self.assert_near(result.t_events[1], [7.77], 1e-14)

    def test_expressions_that_are_none(self):
        for text in ("q +", "r", "__import__('os')", "q.real", "[q]", "lambda: q", "q if q else p"):
            with self.assertRaises(ValueError):
                self.run_with(text)

    def test_a_ball_bounces(self):
        # From height 1 with g = 1: it meets the floor at sqrt(2) (2 k + 1).
        ball = hvi.Scene(coordinates=["z"], momenta=["p"], hamiltonian="p^2/2 + z",
                         initial={"z": 1, "p": 0}).stepper("stormer-verlet")
        bounce = hvi.Event("z", "down", set={"p": "-p"})
        result = ball.integrate(t_span=(0, 20), step=0.1, events=bounce)
        self.assert_near(result.t_events[0], math.sqrt(2) * (2 * np.arange(7) + 1), 1e-12)
        self.assert_near(result.energy, np.ones(len(result.t)), 1e-12)
        with self.assertRaises(ValueError):
            ball.integrate(t_span=(0, 20), step=0.1, events=hvi.Event("z", set={"w": "1"}))
        with self.assertRaises(ValueError):
            ball.integrate(t_span=(0, 20), step=0.1, events=bounce, dense_output=True)

    def test_a_cooldown_and_a_period(self):
        cold = self.run_with(hvi.Event("q", cooldown=4)).t_events[0]
        self.assert_near(cold, math.pi / 2 + 2 * math.pi * np.arange(3), 1e-13)
        turns = hvi.Scene(coordinates=["a"], momenta=["p"], hamiltonian="p^2/2",
                          initial={"a": "1/2", "p": 1}).stepper("midpoint")
        times = turns.integrate(t_span=(0, 20), step=0.1,
                                events=hvi.Event("a", period=2 * math.pi)).t_events[0]
        self.assert_near(times, 2 * math.pi * np.arange(1, 4) - 0.5, 1e-12)

    def test_rows_with_events_are_those_without(self):
        times = np.linspace(0, 20, 33)
        plain = self.run_with(None, t_eval=times)
        watched = self.run_with("q", t_eval=times)
        np.testing.assert_array_equal(plain.y, watched.y)

    def test_invariants_hold_at_events(self):
        result = hvi.Scene("kepler").integrate((0, 200), step=0.05, method="gauss:4",
                                               events="x*px + y*py")
        self.assertGreater(len(result.t_events[0]), 30)
        x, y, px, py = result.y_events[0].T
        momentum = x * py - y * px
        self.assert_near(momentum, np.full(len(x), momentum[0]), 1e-14)


if __name__ == "__main__":
    unittest.main()
