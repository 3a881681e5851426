// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/properties.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "generator/exact/algebra/rational_matrix.hpp"
#include "generator/exact/methods/polynomial_stages.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

Verdict vanishes(const RationalPolynomial& function) { return {function.degree() < 0, true}; }

/// Fills a matrix with the results of `column` for k = 0 .. s-1: coefficients of 1 .. x^(s-1).
template <class Column>
void fill(RationalMatrix& matrix, long stages, Column column) {
    for (long k = 0; k < stages; ++k) {
        const RationalPolynomial polynomial = column(k);
        for (long m = 0; m < stages; ++m) {
            fmpq* const entry =
                matrix.entry(static_cast<std::size_t>(m), static_cast<std::size_t>(k));
            fmpq_poly_get_coeff_fmpq(entry, polynomial.get(), m);
        }
    }
}

/// Returns whether, on 1 .. x^(s-1), A~^T G + G A = b b^T with the Gram matrix G of <., .>, and
/// b.x^k for b.
Verdict is_symplectic(const PolynomialStages& stages) {
    const long s = stages.count();
    const auto size = static_cast<std::size_t>(s);
    RationalMatrix A(size, size), A_tilde(size, size), G(size, size), b(size, size),
        sum(size, size);
    const auto moments = [&](long from, long count) {
        RationalPolynomial row;
        for (long m = 0; m < count; ++m) {
            row.set_coefficient(m, stages.moment(from + m).coefficient(0));
        }
        return row;
    };
    fill(A, s, [&](long k) { return stages.apply(Colour::f, stages.power(k), 1); });
    fill(A_tilde, s, [&](long k) { return stages.apply(Colour::g, stages.power(k), 1); });
    fill(G, s, [&](long k) { return moments(k, s); });
    fill(b, s, [&](long k) { return moments(0, s) * stages.moment(k); });
    fmpq_mat_transpose(A_tilde.get(), A_tilde.get());
    fmpq_mat_mul(A_tilde.get(), A_tilde.get(), G.get());
    fmpq_mat_mul(A.get(), G.get(), A.get());
    fmpq_mat_add(sum.get(), A_tilde.get(), A.get());
    return {fmpq_mat_equal(sum.get(), b.get()) != 0, true};
}

/// Returns whether, with R g(x) = g(1 - x), P and its roots are mapped to themselves, and R A R g +
/// A g = b.g.
Verdict is_symmetric(const PolynomialStages& stages, const RationalPolynomial& P) {
    const RationalPolynomial mirrored = P.at_affine(-1, 1);
    if (!(vanishes(mirrored - P).holds || vanishes(mirrored + P).holds)) { return {false, true}; }
    Verdict verdict;
    for (long k = 0; k < stages.count() && verdict.holds; ++k) {
        const RationalPolynomial g = stages.power(k);
        const RationalPolynomial reflected = g.at_affine(-1, 1);
        for (const Colour colour : {Colour::f, Colour::g}) {
            const RationalPolynomial back = stages.apply(colour, reflected, 1).at_affine(-1, 1);
            verdict = verdict && vanishes(back + stages.apply(colour, g, 1) - stages.moment(k));
        }
    }
    return verdict;
}

Verdict is_runge_kutta(const PolynomialStages& stages) {
    Verdict verdict;
    for (long k = 0; k < stages.count() && verdict.holds; ++k) {
        const RationalPolynomial g = stages.power(k);
        verdict = vanishes(stages.apply(Colour::f, g, 1) - stages.apply(Colour::g, g, 1));
    }
    return verdict;
}

/// Decides whether a condition's residual vanishes.
using Decision = std::function<Verdict(const Number&)>;

Decision for_rounded(const RoundedMethod& method) {
    return [bits = method.bits](const Number& residual) { return can_vanish(residual, bits); };
}

Verdict for_exact(const Number& residual) { return vanishes(residual); }

Number weights_residual(const PartitionedMethod& method, std::size_t i) {
    return method.b_tilde[i] - method.b[i];
}

Number symplectic_residual(const PartitionedMethod& method, std::size_t i, std::size_t j) {
    const auto& [b, b_tilde, A, A_tilde] = method;
    return b[i] * A_tilde[i][j] + b_tilde[j] * A[j][i] - b[i] * b_tilde[j];
}

/// Verdict on all conditions up to the first that does not hold, and its residual by the
/// coefficients `written`.
struct Symplecticity {
    Verdict verdict;
    std::optional<SymplecticDefect> defect;
};
Symplecticity symplecticity(const PartitionedMethod& method, const Decision& vanish,
                            const PartitionedMethod& written) {
    Symplecticity result;
    for (std::size_t i = 0; i < method.stages(); ++i) {
        result.verdict = result.verdict && vanish(weights_residual(method, i));
        if (!result.verdict.holds) {
            result.defect = {i, {}, weights_residual(written, i)};
            return result;
        }
    }
    for (std::size_t i = 0; i < method.stages(); ++i) {
        for (std::size_t j = 0; j < method.stages(); ++j) {
            result.verdict = result.verdict && vanish(symplectic_residual(method, i, j));
            if (result.verdict.holds) { continue; }
            result.defect = {i, j, symplectic_residual(written, i, j)};
            return result;
        }
    }
    return result;
}

Symplecticity symplecticity(const PartitionedMethod& method) {
    return symplecticity(method, for_exact, method);
}

Symplecticity symplecticity(const RoundedMethod& method) {
    return symplecticity(method.enclosed, for_rounded(method), method.written);
}

Verdict has_common_weights(const PartitionedMethod& method, const Decision& vanish) {
    Verdict verdict;
    for (std::size_t i = 0; i < method.stages() && verdict.holds; ++i) {
        verdict = verdict && vanish(weights_residual(method, i));
    }
    return verdict;
}

Verdict is_runge_kutta(const PartitionedMethod& method, const Decision& vanish) {
    Verdict verdict = has_common_weights(method, vanish);
    for (std::size_t i = 0; i < method.stages() && verdict.holds; ++i) {
        for (std::size_t j = 0; j < method.stages() && verdict.holds; ++j) {
            verdict = verdict && vanish(method.A_tilde[i][j] - method.A[i][j]);
        }
    }
    return verdict;
}

/// Looks for sigma stage by stage, and takes back choices that lead nowhere.
class Mirror {
public:
    Mirror(const PartitionedMethod& method, Decision vanish)
        : method_(method), vanish_(std::move(vanish)) {}

    Verdict found() { return extend() ? verdicts_.back() : Verdict{false, true}; }

private:
    bool extend() {
        const std::size_t i = sigma_.size();
        if (i == method_.stages()) { return true; }
        for (std::size_t image = 0; image < method_.stages(); ++image) {
            if (std::find(sigma_.begin(), sigma_.end(), image) != sigma_.end()) { continue; }
            sigma_.push_back(image);
            const Verdict fits = verdicts_.back() && last_fits();
            verdicts_.push_back(fits);
            if (fits.holds && extend()) { return true; }
            verdicts_.pop_back();
            sigma_.pop_back();
        }
        return false;
    }

    /// Returns whether the last stage fits all stages up to itself.
    [[nodiscard]] Verdict last_fits() const {
        const std::size_t i = sigma_.size() - 1;
        const auto& [b, b_tilde, A, A_tilde] = method_;
        Verdict verdict = vanish_(b[sigma_[i]] - b[i]);
        verdict = verdict && vanish_(b_tilde[sigma_[i]] - b_tilde[i]);
        for (std::size_t j = 0; j <= i && verdict.holds; ++j) {
            verdict = verdict && entry_fits(A, b, i, j) && entry_fits(A_tilde, b_tilde, i, j);
            verdict = verdict && entry_fits(A, b, j, i) && entry_fits(A_tilde, b_tilde, j, i);
        }
        return verdict;
    }

    [[nodiscard]] Verdict entry_fits(const NumberMatrix& A, const NumberVector& b, std::size_t i,
                                     std::size_t j) const {
        return vanish_(A[sigma_[i]][sigma_[j]] + A[i][j] - b[j]);
    }

    const PartitionedMethod& method_;
    Decision vanish_;
    std::vector<std::size_t> sigma_;
    std::vector<Verdict> verdicts_{Verdict{}};  ///< verdicts on the first 0, 1, ... stages
};

}  // namespace

Verdict is_symplectic(const PartitionedMethod& method) { return symplecticity(method).verdict; }

Verdict is_symplectic(const RoundedMethod& method) { return symplecticity(method).verdict; }

std::optional<SymplecticDefect> symplectic_defect(const PartitionedMethod& method) {
    return symplecticity(method).defect;
}

std::optional<SymplecticDefect> symplectic_defect(const RoundedMethod& method) {
    return symplecticity(method).defect;
}

Verdict is_symmetric(const PartitionedMethod& method) { return Mirror(method, for_exact).found(); }

Verdict is_symmetric(const RoundedMethod& method) {
    return Mirror(method.enclosed, for_rounded(method)).found();
}

Verdict is_runge_kutta(const PartitionedMethod& method) {
    return is_runge_kutta(method, for_exact);
}

Verdict is_runge_kutta(const RoundedMethod& method) {
    return is_runge_kutta(method.enclosed, for_rounded(method));
}

Verdict has_common_weights(const PartitionedMethod& method) {
    return has_common_weights(method, for_exact);
}

Verdict has_common_weights(const RoundedMethod& method) {
    return has_common_weights(method.enclosed, for_rounded(method));
}

Verdict has_common_weights(const Tableau& tableau) {
    return has_common_weights(partitioned_method(tableau));
}

Verdict is_symplectic(const Tableau& tableau) {
    const Progress::Stage stage("checking symplecticity");
    const RationalPolynomial* const P = tableau.node_polynomial();
    return P != nullptr ? is_symplectic(PolynomialStages(*P))
                        : is_symplectic(partitioned_method(tableau));
}

Verdict is_symmetric(const Tableau& tableau) {
    const Progress::Stage stage("checking symmetry");
    const RationalPolynomial* const P = tableau.node_polynomial();
    return P != nullptr ? is_symmetric(PolynomialStages(*P), *P)
                        : is_symmetric(partitioned_method(tableau));
}

Verdict is_runge_kutta(const Tableau& tableau) {
    const RationalPolynomial* const P = tableau.node_polynomial();
    return P != nullptr ? is_runge_kutta(PolynomialStages(*P))
                        : is_runge_kutta(partitioned_method(tableau));
}

}  // namespace hvi::gen
