# Tables that leave Python, a package without hvi-gen, and the examples in docstrings.
# SPDX-License-Identifier: MIT
import contextlib
import doctest
import importlib
import io
import os
import pkgutil
import re
import subprocess
import sys
import unittest
from pathlib import Path

from common import TestCase, hvi, np, oscillator


class Files(TestCase):
    def setUp(self):
        self.result = oscillator(invariants={"twice": "p^2 + q^2"}).integrate((0, 1), step=0.1)

    def test_csv_and_npz_have_all_digits(self):
        folder = self.folder()
        self.result.save(folder / "a.csv")
        self.result.save(folder / "a.npz")
        table = np.genfromtxt(folder / "a.csv", delimiter=",", names=True)
        columns = np.load(folder / "a.npz")
        for name in ("t", "q", "p", "energy", "twice"):
            np.testing.assert_array_equal(table[name], self.result[name])
            np.testing.assert_array_equal(columns[name], self.result[name])
        with self.assertRaises(ValueError):
            self.result.save(folder / "a.txt")
        self.assertEqual(sorted(os.listdir(folder)), ["a.csv", "a.npz"])

    def test_a_dataset(self):
        try:
            import xarray  # noqa: F401
        except ImportError:
            self.skipTest("xarray is not installed")
        data = self.result.to_xarray()
        self.assertEqual(float(data["q"].sel(t=0)), 1)
        self.assertEqual(set(data), {"q", "p", "energy", "twice"})

    def test_a_picture(self):
        try:
            import matplotlib
        except ImportError:
            self.skipTest("matplotlib is not installed")
        matplotlib.use("Agg")
        axes = self.result.plot()
        self.assertEqual([line.get_label() for line in axes.lines], ["q"])
        np.testing.assert_array_equal(axes.lines[0].get_ydata(), self.result["q"])
        with self.assertRaises(KeyError):
            self.result.plot("r")


class Package(TestCase):
    """`hvi-gen module --language python`."""

    def test_it_needs_no_hvi_gen(self):
        folder = self.folder()
        subprocess.run([os.environ["HVI_GEN"], "module", "--method", "gauss:4", "--language",
                        "python", "-o", folder, "kepler"], check=True, capture_output=True)
        self.assertIn("py.typed", os.listdir(folder / "kepler"))
        program = """
import kepler
s = kepler.Stepper(ecc=0.3)
x = s.initial()
s.step(x, 0.01)
r = s.integrate(x, t_span=(0, 10), step=0.01, t_eval=[1, 2, 10], events=["y"])
assert r.success and r.t.tolist() == [1, 2, 10] and len(r.t_events[0]) == 3, r
assert abs(r.energy - r.energy[0]).max() < 1e-13
e = kepler.Event("x", stop=2)
assert s.integrate(t_span=(0, 100), step=0.01, events=e).status == 1
assert kepler.description.scene == "kepler" and "gauss:4" in kepler.description.method
try:
    kepler.Stepper(nonsense=1)
except TypeError as error:
    assert "nonsense" in str(error)
else:
    raise AssertionError
print("done")
"""
        done = subprocess.run([sys.executable, "-c", program], text=True, capture_output=True,
                              env={"PYTHONPATH": str(folder), "PATH": "/nowhere"}, check=False)
        self.assertEqual((done.stdout, done.stderr), ("done\n", ""))

    def test_a_list_of_values_and_the_time(self):
        text = """
name = "springs"
coordinates = ["q[1..N]"]
momenta = ["p[1..N]"]
hamiltonian = "sum(i=1..N, p[i]^2/2 + k[i]*q[i]^2/2) + 0*t"
[parameters]
N = 2
k = [1, 4]
[initial]
"q[i]" = "1"
"p[i]" = "0"
"""
        folder = self.folder()
        (folder / "springs.toml").write_text(text)
        scene = hvi.Scene(folder / "springs.toml")
        stepper = scene.stepper("gauss:4", k=[9, 16])
        result = stepper.integrate(t_span=(0, 1), step=0.02)
        np.testing.assert_allclose(result.q[:, -1], np.cos([3, 4]), atol=1e-9)
        with self.assertRaisesRegex(ValueError, "k has 2 values"):
            scene.stepper("gauss:4", k=[1, 2, 3])


class Examples(TestCase):
    def test_blocks_of_the_manual(self):
        page = Path(os.environ["HVI_PYTHON_PACKAGE"]).parent / "docs/python.md"
        blocks = re.findall(r"```python\n(?!# \w+[.]py\n)(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)
        self.assertGreater(len(blocks), 4)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as out:
            for block in blocks:
                exec(compile(block, "docs/python.md", "exec"), names)
        self.assertTrue(out.getvalue().startswith("True True\n"))

    def test_examples_in_docstrings(self):
        names = ["hvi", *(f"hvi.{module.name}" for module in pkgutil.iter_modules(hvi.__path__))]
        tried = 0
        for name in names:
            found = doctest.testmod(importlib.import_module(name))
            self.assertEqual(found.failed, 0, name)
            tried += found.attempted
        self.assertGreater(tried, 10)

    def test_all_names_are_there_and_said(self):
        for name in hvi.__all__:
            self.assertTrue(getattr(hvi, name).__doc__, name)
        with self.assertRaises(AttributeError):
            hvi.nothing


if __name__ == "__main__":
    unittest.main()
