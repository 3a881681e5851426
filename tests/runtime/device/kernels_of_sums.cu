// Kernels of steps without functions, whose text for a device has no fused products.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <device/adjoint_euler_chain.hpp>
#include <device/gauss_3_nonseparable.hpp>
#include <device/gauss_4_kepler.hpp>
#include <device/kahan_li_kepler.hpp>
#include <device/verlet_kepler.hpp>

#include "kernels.hpp"

HVI_KERNEL_OF(BasicVerletKeplerThreads<double>)
HVI_KERNEL_OF(BasicVerletKeplerThreads<float>)
HVI_KERNEL_OF(BasicKahanLiKeplerThreads<double>)
HVI_KERNEL_OF(BasicAdjointEulerChainThreads<double>)
HVI_KERNEL_OF(BasicGauss4KeplerThreads<double>)
HVI_KERNEL_OF(BasicGauss3NonseparableThreads<float>)

HVI_KERNELS_OF_ROWS(BasicVerletKeplerThreads<float>)
HVI_KERNELS_OF_ROWS(BasicGauss4KeplerThreads<double>)
