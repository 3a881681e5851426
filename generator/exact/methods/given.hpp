// The numbers of a tableau that someone else made.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/exact/methods/number_stages.hpp"
#include "generator/exact/numbers/ground.hpp"
#include "generator/read/coefficients.hpp"

namespace hvi::gen {

/// Nodes and coefficients.
struct NodesAndMethod {
    NumberVector c;
    PartitionedMethod method;
};

/// A tableau in its two readings.
struct GivenTableau {
    std::vector<std::string> parameters;  ///< free symbols, sorted
    NodesAndMethod written;               ///< every decimal means exactly what is written
    NodesAndMethod enclosed;  ///< decimals that look rounded are unrounded(); else the same numbers
    std::size_t rounded = 0;  ///< how many these are; none when there is a free parameter
    int digits = 0;           ///< the most significant digits of one of them
    Precision bits = 0;       ///< what tells numbers apart that differ in these digits

    [[nodiscard]] std::size_t stages() const { return written.c.size(); }
    [[nodiscard]] RoundedMethod rounded_method() const {
        return {written.method, enclosed.method, bits};
    }
};

/// Computes with what a file says, on the field of `ground`. NOTE: a free parameter has no
/// enclosure, so that beside one every decimal is taken as exact. Throws as evaluate_number() does,
/// InputError for a free parameter beside a number without a closed form, and TooCoarse (see
/// on_new_ground).
[[nodiscard]] GivenTableau given_tableau(const Coefficients& coefficients, Ground ground);

}  // namespace hvi::gen
