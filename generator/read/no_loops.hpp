// The error for scenes and steps that are not supported with loops.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/support/error.hpp"

namespace hvi::gen {

/// A refusal of something that is supported where sums are written out, but not with loops.
class NoLoops : public InputError {
public:
    explicit NoLoops(std::string what, std::optional<Place> place = {},
                     std::string help = "write sums out, where there are not many terms: "
                                        "--unroll yes")
        : InputError(std::move(what), std::move(place), std::move(help)) {}
};

}  // namespace hvi::gen
