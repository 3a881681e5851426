// What a tableau that someone else made really is.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/certify/certificate.hpp"
#include "generator/certify/rebuild.hpp"

namespace hvi::gen {

struct Audit {
    /// Of the coefficients as they are written, when none of them looks rounded, or when the digits
    /// behind the written ones would change nothing; else within the digits that are given: of the
    /// method that they are found to be, or of all numbers that round to them.
    Certificate certificate;
    std::size_t coefficients = 0;                ///< in the file, nodes included
    std::size_t rounded = 0;                     ///< of these look rounded
    int digits = 0;                              ///< the most significant digits of one of them
    std::optional<Properties> as_written;        ///< where the certificate is of something else
    std::optional<SymplecticDefect> defect;      ///< why it is not symplectic
    std::optional<Rebuilt> rebuilt;              ///< what it is, or was meant to be
    Verdict c_is_sum_of_A, c_is_sum_of_A_tilde;  ///< the rows' sums are the nodes

    /// Whether the coefficients are those of a method, to the last digit: the certificate is its.
    [[nodiscard]] bool is_known() const {
        return rebuilt && rebuilt->tableau && rebuilt->determined && rebuilt->is_right();
    }
};

/// Decides everything exactly as it is written first, then within the digits that are given (see
/// Coefficient::rounded and unrounded()). Preconditions and errors as for orders(), and errors of
/// evaluate_number().
[[nodiscard]] Audit audit(const Coefficients& coefficients, int max_order);

}  // namespace hvi::gen
