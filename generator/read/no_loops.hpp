// Scenes and steps that loops do not have.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/support/error.hpp"

namespace hvi::gen {

/// What is refused where sums stay loops, and may be had where they are written out.
class NoLoops : public InputError {
public:
    explicit NoLoops(std::string what, std::optional<Place> place = {},
                     std::string help = "write sums out, where there are not many terms: "
                                        "--unroll yes")
        : InputError(std::move(what), std::move(place), std::move(help)) {}
};

}  // namespace hvi::gen
