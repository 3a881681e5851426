// One trajectory of each kernel.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "kernels_to_run.hpp"

#define HVI_KERNEL_TO_RUN(name, Stepper)                                                           \
    extern "C" HVI_KERNEL void name(Stepper::State* x, const Stepper::Parameters* parameters,      \
                                    Stepper::Steps by, std::int64_t steps) {                       \
        hvi::device::advance_one<Stepper>(*x, *parameters, by, steps);                             \
    }

HVI_KERNELS_TO_RUN(HVI_KERNEL_TO_RUN)

#define HVI_ROW_TO_RUN(name, Stepper)                                                              \
    extern "C" HVI_KERNEL void name(hvi::device::AdvanceRow<Stepper> advance, std::size_t i) {     \
        advance(i);                                                                                \
    }

HVI_ROWS_TO_RUN(HVI_ROW_TO_RUN)
