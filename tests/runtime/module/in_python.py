# A program in Python, by ctypes: half an orbit of a planet, and arguments that cannot be.
# SPDX-License-Identifier: GPL-2.0-or-later
import ctypes
import math
import sys
from ctypes import POINTER, byref, c_char_p, c_double, c_int, c_size_t, c_void_p

numbers = POINTER(c_double)
module = ctypes.CDLL(sys.argv[1])
module.kepler_create.argtypes = [numbers, c_size_t, POINTER(c_void_p)]
module.kepler_destroy.argtypes = [c_void_p]
module.kepler_copy.argtypes = [c_void_p, POINTER(c_void_p)]
module.kepler_dof.argtypes = [c_void_p]
module.kepler_dof.restype = c_size_t
module.kepler_initial.argtypes = [c_void_p, numbers]
module.kepler_step.argtypes = [c_void_p, numbers, c_double]
module.kepler_integrate.argtypes = [
    c_void_p, numbers, c_double, c_double, c_size_t, c_size_t, c_char_p, numbers, c_size_t,
    POINTER(c_size_t)]
module.kepler_energy.argtypes = [c_void_p, numbers, numbers]
module.kepler_name.argtypes = [c_int, c_size_t]
module.kepler_name.restype = c_char_p
module.kepler_status_text.argtypes = [c_int]
module.kepler_status_text.restype = c_char_p


def check(status):
    assert status == 0, module.kepler_status_text(status).decode()


def refused(status, words):
    assert words in module.kepler_status_text(status).decode(), status


ecc, steps, rows = 0.5, 400, 4
planet, copy = c_void_p(), c_void_p()
check(module.kepler_create((c_double * 2)(1, ecc), 2, byref(planet)))
assert module.kepler_dof(planet) == 2
assert [module.kepler_name(1, k) for k in range(3)] == [b"x", b"y", None]
x = (c_double * 4)()
check(module.kepler_initial(planet, x))
table, written = (c_double * (3 * rows))(), c_size_t()
check(module.kepler_integrate(
    planet, x, 0, math.pi / steps, steps, steps // rows, b"t, x, energy", table, rows,
    byref(written)))
assert written.value == rows
assert abs(x[0] + 1 + ecc) < 1e-12 and table[3 * rows - 2] == x[0]
check(module.kepler_copy(planet, byref(copy)))
y = (c_double * 4)(*x)
check(module.kepler_step(planet, x, 0.01))
check(module.kepler_step(copy, y, 0.01))
assert list(x) == list(y)

refused(module.kepler_create((c_double * 1)(1), 1, byref(c_void_p())), "as many parameters")
refused(module.kepler_create((c_double * 2)(1, math.nan), 2, byref(c_void_p())), "finite")
refused(module.kepler_step(planet, None, 0.01), "null pointer")
refused(module.kepler_step(planet, x, math.inf), "infinite")
refused(module.kepler_integrate(
    planet, x, 0, 0.01, rows, 1, b"t, z", table, rows, byref(written)), "no such column")
refused(module.kepler_integrate(
    planet, x, 0, 0.01, 10, 1, b"t", table, rows, byref(written)), "fewer rows")
for handle in (None, 1, 2**40 + 1, ctypes.addressof(x)):
    refused(module.kepler_step(handle, x, 0.01), "handle")
    refused(module.kepler_destroy(handle), "handle")
check(module.kepler_destroy(planet))
refused(module.kepler_destroy(planet), "handle")
check(module.kepler_destroy(copy))
