// Kernels by the name of their class.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <hvi/detail/device/row_steps.hpp>
#include <hvi/device.hpp>

namespace made = hvi::generated;

#define HVI_KERNEL_OF(Stepper)                                                                     \
    template HVI_KERNEL void hvi::device::advance_kernel<made::Stepper>(                           \
        made::Stepper::State*, const made::Stepper::Parameters*, std::size_t,                      \
        made::Stepper::Steps, std::int64_t);                                                       \
    template HVI_KERNEL void hvi::device::advance_listed_kernel<made::Stepper>(                    \
        made::Stepper::State*, const made::Stepper::Parameters*, const std::uint32_t*,             \
        std::size_t, made::Stepper::Steps, std::int64_t);                                          \
    template HVI_KERNEL void hvi::device::list_going_kernel<made::Stepper::State>(                 \
        const made::Stepper::State*, std::size_t, std::uint32_t*, std::uint32_t*);

/// Kernels of rows, which look at the energy.
#define HVI_KERNELS_OF_ROWS(Stepper)                                                               \
    template HVI_KERNEL void hvi::device::body_kernel(std::size_t,                                 \
                                                      hvi::device::BeginRow<made::Stepper>);       \
    template HVI_KERNEL void hvi::device::body_kernel(std::size_t,                                 \
                                                      hvi::device::ListRow<made::Stepper>);        \
    template HVI_KERNEL void hvi::device::body_kernel(std::size_t,                                 \
                                                      hvi::device::AdvanceRow<made::Stepper>);
