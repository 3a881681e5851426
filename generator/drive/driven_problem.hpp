// Steppers of numbers as a Problem of src/driver/departure.hpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/drive/driven_stepper.hpp"

namespace hvi::gen {

/// The steppers that this process is started for. NOTE: drivers call a type, not an object.
struct DrivenProblem {
    using Stepper = DrivenStepper;

    static Stepper stepper() { return Stepper(make); }
    static Stepper::State initial() { return stepper().initial(); }
    static const std::vector<std::string>& invariants() {
        static const std::vector<std::string> names = stepper().conserved();
        return names;
    }
    static void values(const Stepper& stepper, const Stepper::State& x, double* out) {
        stepper.values(x, out);
    }

    static inline MakeStepper make;
};

}  // namespace hvi::gen
