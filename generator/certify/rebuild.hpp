// Rebuilds the method that a tableau was meant to be, and finds the entries that differ.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/methods/given.hpp"
#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

/// A wrong entry of a tableau.
struct WrongEntry {
    std::string place;  ///< `c[1]`, `b[1]`, `b_tilde[1]`, `A[1][2]`, `A_tilde[1][2]`, from 1
    std::string given;  ///< the text in the file
    Number right;
};

/// The matrix of a method that stands for one of ours.
enum class Matrix { A, A_tilde };

/// A method that has nearly all entries of a tableau.
struct Rebuilt {
    /// Empty where the given A is trusted, and A~ is compared with its symplectic partner.
    std::optional<Tableau> tableau;
    Matrix A = Matrix::A;              ///< the matrix of `tableau` that is our A
    Matrix A_tilde = Matrix::A_tilde;  ///< the matrix of `tableau` that is our A~
    NodesAndMethod right;              ///< right entries, in the order of our stages
    std::vector<WrongEntry> wrong;
    std::size_t compared = 0;  ///< entries of the file that were compared
    std::optional<long>
        places;           ///< all entries agree with `right` up to 10^-places/2; empty: exactly
    bool proved = false;  ///< no entry is wrong, and none is only right within its digits
    /// Whether `right` is exact: it is not when it is computed from rounded nodes or a rounded A.
    bool determined = true;

    [[nodiscard]] bool is_right() const { return wrong.empty(); }
    /// Whether A and A~ have the method's order.
    [[nodiscard]] bool is_method() const {
        return tableau && A == Matrix::A && A_tilde == Matrix::A_tilde;
    }
};

/// Finds the method with the fewest wrong entries, if these are at most a third. It looks among all
/// named methods and families with this number of stages whose nodes, in any order, are those of
/// the file but for at most a third. Then it looks at collocation at the given nodes. It tries each
/// with A for A~ and A~ for A as well. Last comes the symplectic partner of the given A.
/// Collocation at rounded nodes is tried only where no named method is found. An exact entry is
/// wrong when it differs. A decimal is wrong when none of the numbers that round to it is right
/// (see unrounded()), for all nodes that round to the given ones. Returns nothing for a tableau
/// with a free parameter. `ground` is the ground of `given`.
[[nodiscard]] std::optional<Rebuilt> rebuild(const Coefficients& coefficients,
                                             const GivenTableau& given, const Ground& ground);

}  // namespace hvi::gen
