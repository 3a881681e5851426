// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/joint_gradient.hpp"

#include <utility>

namespace hvi::gen {

namespace {

/// In additions, about.
double cost(const OperationCounts& counts) {
    constexpr double division = 8, square_root = 8, call = 24;
    return static_cast<double>(counts.additions + counts.multiplications) +
           division * static_cast<double>(counts.divisions) +
           square_root * static_cast<double>(counts.square_roots) +
           call * static_cast<double>(counts.calls);
}

}  // namespace

GradientKernels gradient_kernels(const System& system) {
    std::vector<Scaled> both = system.by_q;
    both.insert(both.end(), system.by_conjugates.begin(), system.by_conjugates.end());
    return {kernel(system.graph, system.by_q), kernel(system.graph, system.by_conjugates),
            kernel(system.graph, std::move(both))};
}

/// NOTE: iterations of gauss:8 with a joint gradient, and with each slope used at once:
/// nonseparable, h = 0.35, 18.1 and 18.4; point-vortices, h = 0.1, 4.1 and 3.8; double-pendulum,
/// h = 0.1, 12.4 and 8.5. Where slopes are used at once, P moves between dH/dp and dH/dq but Q does
/// not move between dH/dq and the next dH/dp, so that what depends on q alone is shared; and the
/// sums of the stages are waited for twice, not once.
bool joint_gradient_pays(const System& system, const GradientKernels& kernels) {
    constexpr double more_iterations = 1.4, sum = 16;
    const double jointly = cost(kernels.joint.counts) + sum;
    const double in_turn = cost(kernels.by_q.counts) +
                           cost(kernel_of_momenta(system.graph, system.by_conjugates).counts) +
                           2 * sum;
    return more_iterations * jointly < in_turn;
}

}  // namespace hvi::gen
