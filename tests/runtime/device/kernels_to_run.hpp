// Kernels whose text for a card a test runs on the host.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <device/gauss_2_double_pendulum.hpp>
#include <device/gauss_4_kepler.hpp>
#include <device/kahan_li_kepler.hpp>
#include <device/verlet_functions.hpp>
#include <hvi/detail/device/row_steps.hpp>
#include <hvi/device.hpp>

namespace made = hvi::generated;

#define HVI_KERNELS_TO_RUN(take)                                                                   \
    take(functions, made::BasicVerletFunctionsThreads<double>)                                     \
        take(functions_in_float, made::BasicVerletFunctionsThreads<float>)                         \
            take(kepler, made::BasicKahanLiKeplerThreads<double>)                                  \
                take(kepler_in_float, made::BasicKahanLiKeplerThreads<float>)                      \
                    take(double_pendulum, made::BasicGauss2DoublePendulumThreads<double>)

/// Kernels of rows, which look at the energy.
#define HVI_ROWS_TO_RUN(take)                                                                      \
    take(rows_of_functions, made::BasicVerletFunctionsThreads<double>)                             \
        take(rows_of_kepler, made::BasicGauss4KeplerThreads<double>)
