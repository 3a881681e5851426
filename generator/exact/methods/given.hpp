// Numbers of a given tableau.
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
    NodesAndMethod written;               ///< every decimal has exactly its written value
    NodesAndMethod enclosed;  ///< decimals that look rounded are unrounded(); else as `written`
    std::size_t rounded = 0;  ///< number of rounded decimals; 0 when there is a free parameter
    int digits = 0;           ///< largest number of significant digits of a rounded decimal
    Precision bits = 0;       ///< tell apart numbers that differ in these digits

    [[nodiscard]] std::size_t stages() const { return written.c.size(); }
    [[nodiscard]] RoundedMethod rounded_method() const {
        return {written.method, enclosed.method, bits};
    }
};

/// Evaluates the coefficients of a file, on the field of `ground`. NOTE: a free parameter has no
/// enclosure, so that beside one every decimal is taken as exact. Throws as evaluate_number() does,
/// InputError for a free parameter beside a number without a closed form, and TooCoarse (see
/// on_new_ground).
[[nodiscard]] GivenTableau given_tableau(const Coefficients& coefficients, Ground ground);

}  // namespace hvi::gen
