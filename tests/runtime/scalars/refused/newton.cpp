// Must not compile: Eigen does not compute in __float128.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <hvi/generated/gauss_2.hpp>
#include <hvi/newton.hpp>

#include "tests/runtime/scalars/scalars.hpp"

#ifdef __SIZEOF_FLOAT128__
hvi::generated::Gauss2<scalars::Oscillator<scalars::Quad>, hvi::Newton> stepper;
#else
#error "hvi::Newton: Eigen does not compute in these numbers: use hvi::FixedPoint"
#endif
