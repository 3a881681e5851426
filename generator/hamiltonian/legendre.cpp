// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/legendre.hpp"

#include <fmt/format.h>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "generator/hamiltonian/elimination.hpp"
#include "generator/hamiltonian/ginac_functions.hpp"
#include "generator/hamiltonian/vanishing.hpp"
#include "generator/read/names.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;

/// The form w^T M w/2 + a w + rest in momenta or velocities w; M, a and rest do not depend on w.
struct QuadraticInFibre {
    GiNaC::matrix M;
    GiNaC::exvector a;
    ex rest;
};

/// Returns the second half of the variables.
std::vector<GiNaC::symbol> fibre(const Algebra& algebra) {
    const auto& all = algebra.variables();
    return {all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end()};
}

/// Returns the form if the third derivatives vanish. NOTE: only then there surely is a value at w =
/// 0; and an M with kinks may be regular at one point and singular at another.
std::optional<QuadraticInFibre> quadratic_in_fibre(const Algebra& algebra) {
    const std::vector<GiNaC::symbol> w = fibre(algebra);
    const auto n = static_cast<unsigned>(w.size());
    GiNaC::exmap origin;
    for (const GiNaC::symbol& symbol : w) origin[symbol] = 0;
    if (has_kink_in(algebra.function(), w)) return {};
    QuadraticInFibre result{GiNaC::matrix(n, n), {}, {}};
    try {
        for (unsigned i = 0; i < n; ++i) {
            const ex slope = algebra.derivative(algebra.function(), w[i]);
            for (unsigned j = 0; j <= i; ++j) {
                const ex entry = algebra.derivative(slope, w[j]);
                if (has_kink_in(entry, algebra.variables())) return {};
                for (const GiNaC::symbol& symbol : w)
                    if (vanishing(algebra, entry.diff(symbol)) != Vanishing::proved) return {};
                result.M(i, j) = result.M(j, i) = entry.subs(origin);
            }
            result.a.push_back(slope.subs(origin));
        }
        result.rest = algebra.function().subs(origin);
    } catch (const Error&) { throw; } catch (const std::exception&) {
        return {};
    }  // a pole
    return result;
}

/// Returns (w - a)^T M^-1 (w - a)/2 - rest, where w stands for the variables of the other side.
ex transformed(const QuadraticInFibre& given, const GiNaC::matrix& inverse,
               const std::vector<GiNaC::symbol>& w) {
    ex sum = -given.rest;
    for (unsigned i = 0; i < w.size(); ++i) {
        sum += inverse(i, i) * GiNaC::pow(w[i] - given.a[i], 2) / 2;
        for (unsigned j = 0; j < i; ++j)
            sum += inverse(i, j) * (w[i] - given.a[i]) * (w[j] - given.a[j]);
    }
    return sum;
}

std::map<std::string, std::string> renaming(const std::vector<std::string>& from,
                                            const std::vector<std::string>& to) {
    std::map<std::string, std::string> names;
    for (std::size_t i = 0; i < from.size(); ++i) names[from[i]] = to[i];
    return names;
}

std::shared_ptr<const Source> text_of(const Expression& expression, std::string name) {
    return std::make_shared<const Source>(Source{std::move(name), to_text(expression)});
}

[[noreturn]] void refuse_degenerate(const Algebra& algebra, const QuadraticInFibre& given,
                                    std::size_t rank) {
    const std::size_t n = given.a.size();
    if (rank == 0 && vanishing(algebra, given.rest) == Vanishing::proved)
        throw MathError("the associated Lagrangian is identically zero", algebra.place(),
                        "H = p dH/dp, so that L = p q' - H is 0 where q' = dH/dp; leave out "
                        "--lagrangian for the equations (4.18), which need no L");
    throw MathError(
        fmt::format("the Hamiltonian is degenerate: H_pp has the rank {} of {}", rank, n),
        algebra.place(),
        "q' = dH/dp has no solution for the momenta, and no Lagrangian belongs to H; leave out "
        "--lagrangian for the equations (4.18), which need no L");
}

QuadraticInFibre mass_matrix_and_rest(const Algebra& algebra) {
    auto given = quadratic_in_fibre(algebra);
    if (!given)
        throw MathError("the Lagrangian is not seen to be quadratic in the velocities",
                        algebra.place(),
                        "it is v^T M v/2 + a v - U with M, a and U functions of the coordinates "
                        "and the time; anything else is to come");
    return *std::move(given);
}

Elimination regular(const Algebra& algebra, const GiNaC::matrix& mass_matrix) {
    Elimination found = eliminate(algebra, mass_matrix);
    if (!found.inverse)
        throw MathError(fmt::format("the Lagrangian is degenerate: its mass matrix d2L/dv2 has the "
                                    "rank {} of {}",
                                    found.rank, mass_matrix.rows()),
                        algebra.place(),
                        "p = dL/dv has no solution for the velocities, so that there is no motion "
                        "from every q and p");
    return found;
}

}  // namespace

Lagrangian legendre_transform(const Hamiltonian& hamiltonian) {
    const Progress::Stage stage("looking for the Lagrangian");
    const Algebra algebra(hamiltonian);
    const auto given = quadratic_in_fibre(algebra);
    if (!given)
        throw MathError("the Lagrangian has no closed form here: H is not seen to be quadratic in "
                        "the momenta",
                        algebra.place(),
                        "leave out --lagrangian for the equations (4.18), which need no L");
    const Elimination found = eliminate(algebra, given->M);
    if (!found.inverse) refuse_degenerate(algebra, *given, found.rank);
    Lagrangian L;
    L.coordinates = hamiltonian.coordinates;
    L.velocities = velocity_names(hamiltonian);
    L.expression = renamed(algebra.written(transformed(*given, *found.inverse, fibre(algebra))),
                           renaming(hamiltonian.momenta, L.velocities));
    L.source = text_of(L.expression, "the Lagrangian");
    L.parameters = hamiltonian.parameters;
    L.origin = hamiltonian.origin;
    return L;
}

Hamiltonian legendre_transform(const Lagrangian& lagrangian) {
    const Progress::Stage stage("looking for the Hamiltonian");
    const Algebra algebra(lagrangian);
    const QuadraticInFibre given = mass_matrix_and_rest(algebra);
    const Elimination found = regular(algebra, given.M);
    Hamiltonian H;
    H.coordinates = lagrangian.coordinates;
    H.momenta = momentum_names(lagrangian);
    H.expression = renamed(algebra.written(transformed(given, *found.inverse, fibre(algebra))),
                           renaming(lagrangian.velocities, H.momenta));
    H.source = text_of(H.expression, "the Hamiltonian");
    H.parameters = lagrangian.parameters;
    H.origin = lagrangian.origin;
    return H;
}

void check_regular(const Lagrangian& lagrangian) {
    const Progress::Stage stage("looking whether the Lagrangian is regular");
    const Algebra algebra(lagrangian);
    const GiNaC::matrix mass_matrix = mass_matrix_and_rest(algebra).M;
    if (!is_surely_regular(algebra, mass_matrix)) static_cast<void>(regular(algebra, mass_matrix));
}

}  // namespace hvi::gen
