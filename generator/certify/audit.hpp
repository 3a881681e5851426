// The audit of a tableau from another source.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>

#include "generator/certify/certificate.hpp"
#include "generator/certify/rebuild.hpp"

namespace hvi::gen {

struct Audit {
    /// The certificate. It is of the coefficients as they are written, if none of them looks
    /// rounded or if more digits would change nothing. Otherwise it is within the given digits: of
    /// the method that was found for them, or of all numbers that round to them.
    Certificate certificate;
    std::size_t coefficients = 0;            ///< coefficients in the file, nodes included
    std::size_t rounded = 0;                 ///< coefficients that look rounded
    int digits = 0;                          ///< the most significant digits of a coefficient
    std::optional<Properties> as_written;    ///< present where the certificate is of other numbers
    std::optional<SymplecticDefect> defect;  ///< why the tableau is not symplectic
    std::optional<Rebuilt> rebuilt;          ///< the method that it is, or was meant to be
    Verdict c_is_sum_of_A, c_is_sum_of_A_tilde;  ///< the rows' sums are the nodes

    /// Whether the coefficients are those of a method, to the last digit. The certificate is then
    /// the method's.
    [[nodiscard]] bool is_known() const {
        return rebuilt && rebuilt->tableau && rebuilt->determined && rebuilt->is_right();
    }
};

/// Decides everything exactly for the coefficients as they are written, then within their digits
/// (see Coefficient::rounded and unrounded()). Preconditions and errors are those of orders(), and
/// errors of evaluate_number().
[[nodiscard]] Audit audit(const Coefficients& coefficients, int max_order);

}  // namespace hvi::gen
