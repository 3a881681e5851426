// What a tableau was meant to be: methods that have its nodes, and the entries that differ.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/exact/methods/given.hpp"
#include "generator/exact/methods/tableau.hpp"

namespace hvi::gen {

/// An entry that is not what it should be.
struct WrongEntry {
    std::string place;  ///< `c[1]`, `b[1]`, `b_tilde[1]`, `A[1][2]`, `A_tilde[1][2]`, from 1
    std::string given;  ///< as it is written
    Number right;
};

/// Which matrix of a method stands for one of ours.
enum class Matrix { A, A_tilde };

/// A method that a tableau has nearly all entries of.
struct Rebuilt {
    /// Empty where the given A is trusted, and A~ is compared with its symplectic partner.
    std::optional<Tableau> tableau;
    Matrix A = Matrix::A;              ///< ours is this matrix of `tableau`
    Matrix A_tilde = Matrix::A_tilde;  ///< the same
    NodesAndMethod right;              ///< what the entries should be, in the order of our stages
    std::vector<WrongEntry> wrong;
    std::size_t compared = 0;  ///< entries of the file that say something of their own
    std::optional<long>
        places;           ///< all entries agree with `right` up to 10^-places/2; empty: exactly
    bool proved = false;  ///< no entry is wrong, and none is only right within its digits
    /// Whether `right` is exact: it is not when it is computed from rounded nodes or a rounded A.
    bool determined = true;

    [[nodiscard]] bool is_right() const { return wrong.empty(); }
    /// Whether A and A~ stand where the method has them.
    [[nodiscard]] bool is_method() const {
        return tableau && A == Matrix::A && A_tilde == Matrix::A_tilde;
    }
};

/// Looks among all named methods and families of that many stages whose nodes are those of the file
/// but for at most a third, in any order; then at collocation at the given nodes; each with A for
/// A~ and A~ for A as well; and at last at the symplectic partner of the given A. It is the one
/// with the fewest wrong entries, if these are a third of all at most; but collocation at rounded
/// nodes is looked at only where there is no such method with a name. Exact entries are wrong when
/// they differ, decimals when none of the numbers that round to them is right (see unrounded()),
/// for all nodes that round to the given ones. Empty for a tableau with a free parameter. `ground`
/// is the one of `given`.
[[nodiscard]] std::optional<Rebuilt> rebuild(const Coefficients& coefficients,
                                             const GivenTableau& given, const Ground& ground);

}  // namespace hvi::gen
