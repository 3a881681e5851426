// Kernels of steps with functions, whose text for a device has them all.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <device/gauss_2_double_pendulum.hpp>
#include <device/kahan_li_pushed.hpp>
#include <device/verlet_functions.hpp>

#include "kernels.hpp"

HVI_KERNEL_OF(BasicKahanLiPushedThreads<double>)
HVI_KERNEL_OF(BasicVerletFunctionsThreads<double>)
HVI_KERNEL_OF(BasicVerletFunctionsThreads<float>)
HVI_KERNEL_OF(BasicGauss2DoublePendulumThreads<double>)

HVI_KERNELS_OF_ROWS(BasicVerletFunctionsThreads<double>)
