# Scenes: how they are made, what they say, and what is refused.
# SPDX-License-Identifier: MIT
import json
import math
import os
import pickle
import signal
import subprocess
import sys
import time
import unittest
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import sympy
from common import TestCase, hvi, np, oscillator


def ten_steps(stepper):
    x = stepper.initial()
    for _ in range(10):
        stepper.step(x, 0.1)
    return x.tolist()


class Scenes(TestCase):
    def test_a_scene_by_name_and_by_file(self):
        kepler = hvi.Scene("kepler")
        self.assertIn("hamiltonian", kepler.text)
        path = self.folder() / "mine.toml"
        path.write_text(kepler.text)
        first, second = (scene.integrate((0, 1), step=0.01, method="gauss:3")
                         for scene in (kepler, hvi.Scene(path)))
        np.testing.assert_array_equal(first.y, second.y)

    def test_expressions_of_sympy(self):
        q, p, k = sympy.symbols("q p k")
        H = p**2 / 2 + k * q**2 / 2 + sympy.Rational(1, 3) * sympy.Abs(q)**3 * sympy.sin(q)
        scene = hvi.Scene(coordinates=["q"], hamiltonian=H, parameters={"k": 2.5},
                          initial={"q": sympy.pi / 4, "p": 0}, step=0.1, until=1)
        result = scene.integrate(method="gauss:2")
        value = H.subs({q: result.q[0, -1], p: result.p[0, -1], k: sympy.Rational(5, 2)})
        self.assertAlmostEqual(float(value), result.energy[-1], delta=1e-14)
        self.assertEqual(result.q[0, 0], math.pi / 4)
        with self.assertRaises(ValueError):
            hvi.Scene(coordinates=["q"], hamiltonian=q * sympy.I, initial={"q": 1, "p": 0}).text

    def test_names_of_momenta(self):
        for coordinates, momenta in ((["x", "y"], ["px", "py"]), (["x", "y"], ["p_x", "p_y"]),
                                     (["q1", "q2"], ["p1", "p2"]), (["q"], ["p"])):
            H = " + ".join(f"{p}^2/2" for p in momenta)
            scene = hvi.Scene(coordinates=coordinates, hamiltonian=H)
            self.assertIn(f"momenta = {json.dumps(momenta)}", scene.text)

    def test_a_lagrangian(self):
        scene = hvi.Scene(coordinates=["q"], lagrangian="v^2/2 - q^2/2", velocities=["v"],
                          initial={"q": 1, "v": 0})
        result = scene.integrate((0, math.pi), step=0.1, method="gauss:5")
        self.assert_near(result.y[:, -1], [-1, 0], 1e-12)

    def test_without_a_method_it_is_gauss_4(self):
        self.assertIn("gauss:4", oscillator().integrate((0, 1), step=0.1).method)
        self.assertIn("midpoint", oscillator(method="midpoint").integrate((0, 1), step=0.1).method)

    def test_parameters_of_the_scene_need_no_second_library(self):
        kepler = hvi.Scene("kepler")
        first = kepler.integrate((0, 1), step=0.1, method="gauss:2", parameters={"mu": 2})
        self.assertNotEqual(first.y[0, -1],
                            kepler.integrate((0, 1), step=0.1, method="gauss:2").y[0, -1])
        with self.assertRaisesRegex(TypeError, "no parameter 'nu'"):
            kepler.integrate((0, 1), step=0.1, method="gauss:2", parameters={"nu": 2})

    def test_parameters_that_are_computed_from_others(self):
        folder = self.folder()
        (folder / "chain.toml").write_text(hvi.Scene("fpu-chain").text)  # amplitude = (N+1)/32
        chain = hvi.Scene(folder / "chain.toml")
        self.assertEqual(chain.stepper(N=31).parameters["amplitude"], 1)
        self.assertAlmostEqual(chain.stepper(N=31).initial()[15], 1, delta=1e-15)
        self.assertEqual(chain.stepper(N=31, amplitude=3).parameters["amplitude"], 3)
        self.assertAlmostEqual(chain.stepper(N=31, amplitude=3).initial()[15], 3, delta=1e-15)

    def test_errors_have_the_caret(self):
        with self.assertRaises(hvi.InputError) as caught:
            hvi.Scene(coordinates=["q"], hamiltonian="p^2/2 + quartic(q)",
                      initial={"q": 1, "p": 0}).integrate((0, 1), step=0.1)
        self.assertIn("^", str(caught.exception))
        self.assertIsInstance(caught.exception, ValueError)
        with self.assertRaisesRegex(hvi.InputError, "kepler"):
            hvi.Scene("keplar").integrate((0, 1), step=0.1)
        with self.assertRaises(hvi.MathError):
            hvi.tableau({"basis": "1, tau", "nodes": "1/2, 1/2"})

    def test_words_that_scenes_do_not_take(self):
        for wrong in (lambda: hvi.Scene(), lambda: hvi.Scene("kepler", hamiltonian="p"),
                      lambda: hvi.Scene(coordinates=["q"]), lambda: hvi.Scene("kepler", step=1),
                      lambda: oscillator().integrate((0, 1), step=0.1, accuracy=1e-3),
                      lambda: oscillator().integrate((0, 1), step=0.1, initial="q")):
            with self.assertRaises((TypeError, ValueError)):
                wrong()
        with self.assertRaisesRegex(TypeError, "accuracy"):
            oscillator().integrate((0, 1), step=0.1, rtol=1e-6)

    def test_initial_by_name(self):
        result = oscillator().integrate((0, math.pi), step=0.1, initial={"p": 2})
        self.assert_near(result.y[:, -1], [-1, -2], 1e-9)
        with self.assertRaises(ValueError):
            oscillator().integrate((0, 1), step=0.1, initial={"r": 1})

    def test_accuracy_is_of_the_end(self):
        result = oscillator().integrate((0, 10), accuracy=1e-6)
        self.assert_near(result.y[:, -1], [math.cos(10), -math.sin(10)], 1e-6)
        self.assertTrue(result.method)

    def test_the_derivative_of_the_flow(self):
        result = oscillator().integrate((0, 1), step=0.1, method="gauss:4", tangent=True)
        c, s = math.cos(1), math.sin(1)
        self.assert_near(result.tangent, [[c, s], [-s, c]], 1e-11)

    def test_events_and_the_scale_of_a_scene(self):
        ball = hvi.Scene("bouncing-ball").integrate()
        self.assertTrue(ball.success)
        self.assertGreater(len(ball.t_events[0]), 1)
        ellipse = hvi.Scene("eccentric-kepler").integrate()
        self.assertTrue(ellipse.success)
        self.assertEqual(ellipse.y.shape[0], 4)

    def test_lyapunov_exponents_of_a_saddle(self):
        saddle = hvi.Scene(coordinates=["q"], hamiltonian="p^2/2 - q^2/2",
                           initial={"q": 0, "p": 0})
        found = saddle.lyapunov((0, 20), step=0.05, method="gauss:4", spectrum=True)
        self.assert_near(found["lyapunov"], [1, -1], 1e-1)

    def test_symmetries_and_certificates(self):
        self.assertIn("x*py", str(hvi.Scene("kepler").symmetries()).replace("py*x", "x*py"))
        self.assertEqual(oscillator().check("gauss:3")["order"], 6)
        self.assertEqual(hvi.check("stormer-verlet")["order"], 2)

    def test_a_poincare_section(self):
        points = oscillator().section("q", (0, 20), step=0.1, direction="down")
        self.assert_near(points, np.tile([0, -1], (3, 1)), 1e-9)

    def test_pickles_in_another_process(self):
        stepper = oscillator().stepper("gauss:2")
        with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
            there = pool.submit(ten_steps, stepper).result(timeout=120)
        self.assertEqual(there, ten_steps(stepper))
        scene = pickle.loads(pickle.dumps(oscillator()))
        self.assertEqual(scene.text, oscillator().text)

    def test_interrupts_are_heard(self):
        program = ("import hvi\ns = hvi.Scene('kepler').stepper('gauss:4')\n"
                   "print('begun', flush=True)\ns.integrate(t_span=(0, 1e12), step=0.01)\n")
        environment = {**os.environ, "PYTHONPATH": os.environ["HVI_PYTHON_PACKAGE"]}
        with subprocess.Popen([sys.executable, "-c", program], env=environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as run:
            self.assertEqual(run.stdout.readline(), "begun\n")
            time.sleep(0.5)
            run.send_signal(signal.SIGINT)
            _, messages = run.communicate(timeout=20)
        self.assertIn("KeyboardInterrupt", messages)

    def test_no_hvi_gen(self):
        program = "import hvi\ntry: hvi.check('gauss:2')\nexcept hvi.OutsideError as e: print(e)\n"
        environment = {"PYTHONPATH": os.environ["HVI_PYTHON_PACKAGE"], "PATH": "/nowhere"}
        done = subprocess.run([sys.executable, "-c", program], env=environment, text=True,
                              capture_output=True, check=True)
        self.assertIn("hvi-gen is not on PATH", done.stdout)


class Ensembles(TestCase):
    def test_each_row_is_a_run_of_its_own(self):
        scene = hvi.Scene("henon-heiles")
        name = scene.stepper("gauss:3").coordinates[0]
        starts = {name: np.linspace(0, 0.3, 7)}
        one, three = (scene.ensemble(starts, t_span=(0, 10), step=0.1, method="gauss:3",
                                     threads=threads) for threads in (1, 3))
        np.testing.assert_array_equal(one.y, three.y)
        alone = scene.integrate((0, 10), step=0.1, method="gauss:3", initial={name: 0.15})
        np.testing.assert_array_equal(one.y[3], alone.y[:, -1])
        self.assertEqual(one.energy_error[3], alone.energy[-1] - alone.energy[0])

    def test_parameters_of_each(self):
        scene = hvi.Scene(coordinates=["q"], hamiltonian="p^2/2 + k*q^2/2", parameters={"k": 1},
                          initial={"q": 1, "p": 0})
        k = np.array([1, 4, 9])
        found = scene.ensemble(parameters={"k": k}, t_span=(0, 1), step=0.05)
        self.assert_near(found.y[:, 0], np.cos(np.sqrt(k)), 1e-9)
        self.assertTrue(np.all(found.success))

    def test_a_row_that_fails_ends_no_other(self):
        # From q it reaches infinity at t = exp(-q/2) pi/sqrt(2).
        scene = hvi.Scene(coordinates=["q"], hamiltonian="p^2/2 - exp(q)",
                          initial={"q": 1, "p": 0})
        found = scene.ensemble({"q": [0, -5, math.nan]}, t_span=(0, 4), step=0.01,
                               method="gauss:2")
        self.assertEqual(found.status.tolist(), [-1, 0, -1])
        self.assertIn("finite", found.message[2])

    def test_columns_that_do_not_fit(self):
        for initial, parameters in ((None, None), ({"q": [1, 2], "p": [1]}, None), ({"r": [1]}, None),
                                    (np.zeros((2, 3)), None)):
            with self.assertRaises(ValueError):
                oscillator().ensemble(initial, parameters, t_span=(0, 1), step=0.1)


class TwinOfScipy(TestCase):
    def test_expressions_and_functions(self):
        span = (0, math.pi)
        for H in ("(p^2 + q^2)/2", lambda t, y: (y[1]**2 + y[0]**2) / 2):
            result = hvi.solve_ivp(H, span, [1, 0], step=0.1)
            self.assert_near(result.y[:, -1], [-1, 0], 1e-9)
        with self.assertRaisesRegex(TypeError, "sympy"):
            hvi.solve_ivp(lambda t, y: np.sin(y[0]), span, [1, 0], step=0.1)
        with self.assertRaisesRegex(TypeError, "rtol"):
            hvi.solve_ivp("p^2/2", span, [1, 0], rtol=1e-6)
        with self.assertRaises(ValueError):
            hvi.solve_ivp("p^2/2", span, [1], step=0.1)

    def test_more_degrees_of_freedom(self):
        result = hvi.solve_ivp("(p1^2 + p2^2 + q1^2 + 4*q2^2)/2", (0, 1), [1, 1, 0, 0], step=0.05)
        self.assert_near(result.y[:2, -1], [math.cos(1), math.cos(2)], 1e-9)


class Tableaux(TestCase):
    def test_gauss_2_as_in_textbooks(self):
        found, root = hvi.tableau("gauss:2"), sympy.sqrt(3)
        self.assertEqual(found.A, sympy.Matrix([[sympy.Rational(1, 4), sympy.Rational(1, 4) - root / 6],
                                                [sympy.Rational(1, 4) + root / 6, sympy.Rational(1, 4)]]))
        self.assertEqual(list(found.b), [sympy.Rational(1, 2)] * 2)
        self.assertEqual([sympy.simplify(c) for c in found.c],
                         [sympy.Rational(1, 2) - root / 6, sympy.Rational(1, 2) + root / 6])

    def test_a_method_of_lists(self):
        found = hvi.tableau({"basis": ["1", "cos(pi*tau)"], "nodes": [0, 1]})
        self.assertEqual(list(found.b), [sympy.Rational(1, 2)] * 2)
        with self.assertRaises(TypeError):
            hvi.tableau({"bases": "1"})


if __name__ == "__main__":
    unittest.main()
