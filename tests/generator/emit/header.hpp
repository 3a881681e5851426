// The header of a tableau.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <utility>

#include "generator/emit/steps/emit.hpp"
#include "generator/plan/plan.hpp"

namespace hvi::gen {

inline std::string header(const Tableau& tableau, bool separable = false,
                          std::string name = "Method") {
    return emit({tableau}, plan({tableau}, {.is_separable = separable}),
                {std::move(name), "hvi-gen stepper --method by-hand"});
}

}  // namespace hvi::gen
