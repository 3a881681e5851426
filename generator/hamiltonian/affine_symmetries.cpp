// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/hamiltonian/affine_symmetries.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "generator/hamiltonian/affine_fields.hpp"
#include "generator/hamiltonian/ginac_functions.hpp"
#include "generator/hamiltonian/lie_algebra.hpp"
#include "generator/hamiltonian/normal_form.hpp"
#include "generator/hamiltonian/relations.hpp"
#include "generator/support/progress.hpp"

namespace hvi::gen {

namespace {

using GiNaC::ex;
using GiNaC::numeric;
using GiNaC::symbol;

constexpr std::size_t most_brackets = 24;     ///< symmetries whose brackets are written down
constexpr std::size_t most_translations = 8;  ///< translations that are paired to turn their planes
constexpr std::size_t most_symbolic = 24;     ///< degrees of freedom with parameters as symbols
constexpr std::size_t most_symbols = 12;      ///< symbols among these parameters
constexpr const char* too_long = "the derivatives have too many terms for it to be decided";

/// H or L with its derivatives.
struct FunctionAndSlopes {
    Algebra algebra;
    bool is_lagrangian = false;
    ex value = algebra.function();
    std::vector<symbol> q{algebra.variables().begin(), algebra.variables().begin() + half(algebra)};
    std::vector<symbol> fibre{algebra.variables().begin() + half(algebra),
                              algebra.variables().end()};  ///< p or v
    std::vector<ex> by_q = derivatives(q);
    std::vector<ex> by_fibre = derivatives(fibre);

    [[nodiscard]] std::size_t n() const { return q.size(); }

    /// Returns p, or dL/dv.
    [[nodiscard]] ex momentum(std::size_t i) const {
        return is_lagrangian ? by_fibre[i] : fibre[i];
    }

private:
    static std::ptrdiff_t half(const Algebra& algebra) {
        return static_cast<std::ptrdiff_t>(algebra.variables().size() / 2);
    }
    [[nodiscard]] std::vector<ex> derivatives(const std::vector<symbol>& by) const {
        std::vector<ex> result;
        for (const symbol& variable : by) result.push_back(algebra.derivative(value, variable));
        return result;
    }
};

/// Returns the values of the functions for which relations are sought.
Sampler sampler(const FunctionAndSlopes& function, const AffineUnknowns& unknowns) {
    std::vector<Expression> by_q, by_fibre;
    for (const ex& slope : function.by_q) by_q.push_back(function.algebra.written(slope));
    for (const ex& slope : function.by_fibre) by_fibre.push_back(function.algebra.written(slope));
    return [&function, &unknowns, by_q, by_fibre](const SymbolValues& point) {
        const std::size_t n = function.n();
        std::vector<Ball> q_slopes, fibre_slopes, values(unknowns.count());
        for (const Expression& slope : by_q) q_slopes.push_back(value_at(slope, point, nullptr));
        for (const Expression& slope : by_fibre)
            fibre_slopes.push_back(value_at(slope, point, nullptr));
        const auto of = [&](const symbol& variable) -> const Ball& {
            return point.at(variable.get_name());
        };
        constexpr slong bits = 512;
        for (std::size_t i = 0; i < n; ++i) values[i] = q_slopes[i];
        for (std::size_t number = n; number < values.size(); ++number) {
            const auto [i, j] = unknowns.entry(number);
            arb_ptr sum = values[number].get();
            arb_mul(sum, q_slopes[i].get(), of(function.q[j]).get(), bits);
            if (function.is_lagrangian)
                arb_addmul(sum, fibre_slopes[i].get(), of(function.fibre[j]).get(), bits);
            else
                arb_submul(sum, fibre_slopes[j].get(), of(function.fibre[i]).get(), bits);
        }
        return values;
    };
}

/// Returns the derivatives of a function by each variable; nothing where one is too long.
std::optional<std::vector<MonomialSum>> slopes(Monomials& monomials, const ex& of,
                                               const std::vector<symbol>& by) {
    std::vector<MonomialSum> result;
    for (const symbol& variable : by) {
        auto sum = monomials.sum(monomials.algebra().derivative(of, variable));
        if (!sum) return {};
        result.push_back(*std::move(sum));
    }
    return result;
}

/// Returns the change of F along each field: F_qi q_j - F_pj p_i, or F_qi q_j + F_vi v_j; and F_qi.
std::optional<std::vector<MonomialSum>> changes(Monomials& monomials, const ex& F,
                                                const FunctionAndSlopes& function,
                                                const AffineUnknowns& unknowns) {
    const std::size_t n = function.n();
    const auto by_q = slopes(monomials, F, function.q);
    const auto by_fibre = slopes(monomials, F, function.fibre);
    if (!by_q || !by_fibre) return {};
    std::vector<MonomialSum> result = *by_q;
    for (std::size_t number = n; number < unknowns.count(); ++number) {
        const auto [i, j] = unknowns.entry(number);
        MonomialSum sum = Monomials::times_variable((*by_q)[i], j);
        const bool is_lagrangian = function.is_lagrangian;
        const MonomialSum other = is_lagrangian ? Monomials::times_variable((*by_fibre)[i], n + j)
                                                : Monomials::times_variable((*by_fibre)[j], n + i);
        for (const auto& [monomial, coefficient] : other)
            add(sum, monomial, is_lagrangian ? coefficient : -coefficient);
        result.push_back(std::move(sum));
    }
    return result;
}

/// Returns the functions for which relations are sought. NOTE: derivatives do not see jumps. So the
/// argument of a jump must not change either; its equations are added with a factor of their own.
std::optional<std::vector<MonomialSum>> functions(Monomials& monomials,
                                                  const FunctionAndSlopes& function,
                                                  const AffineUnknowns& unknowns) try {
    auto result = changes(monomials, function.value, function, unknowns);
    if (!result) return {};
    const GiNaC::exvector jumps = where_it_may_jump(function.value);
    for (std::size_t k = 0; k < jumps.size(); ++k) {
        const auto of_jump = changes(monomials, jumps[k], function, unknowns);
        if (!of_jump) return {};
        const MonomialSum factor = monomials.unknown("jump " + std::to_string(k));
        for (std::size_t number = 0; number < result->size(); ++number)
            for (const auto& [monomial, coefficient] :
                 monomials.product((*of_jump)[number], factor))
                add((*result)[number], monomial, coefficient);
    }
    return result;
} catch (const TooManyTerms&) { return {}; }

bool is_negative(const ex& value) { return value.info(GiNaC::info_flags::negative); }

/// A symmetry, and its momentum map.
struct Candidate {
    SparseVector field;
    Expression momentum_map;
    std::size_t words = 0;  ///< words of the momentum map
};

/// The search for symmetries in one algebra.
class Search {
public:
    explicit Search(FunctionAndSlopes function)
        : function_(std::move(function)), unknowns_(function_.n()), monomials_(function_.algebra) {}

    void solve() {
        const auto sums = functions(monomials_, function_, unknowns_);
        if (!sums) {
            relations_.doubt = too_long;
            return;
        }
        relations_ = relations(monomials_, *sums, sampler(function_, unknowns_));
        for (SparseVector& field : relations_.basis) {
            field = without_denominators(function_.algebra, field);
            if (is_translation(unknowns_, field) && is_negative(field.begin()->second))
                for (auto& [number, value] : field) value = -value;
        }
    }

    [[nodiscard]] const Relations& found() const { return relations_; }
    [[nodiscard]] const Algebra& algebra() const { return function_.algebra; }

    /// Returns the symmetries that one would name: translations, then those with the shortest
    /// momentum maps. NOTE: returns all symmetries where their independence is not known.
    [[nodiscard]] std::vector<Candidate> named() const {
        std::vector<Candidate> found;
        for (const SparseVector& field : relations_.basis) found.push_back(candidate(field));
        std::vector<Candidate> candidates = found;
        add_turned_centres(candidates);
        std::stable_sort(candidates.begin(), candidates.end(), [&](const auto& a, const auto& b) {
            const auto rank = [&](const Candidate& of) {
                return is_translation(unknowns_, of.field) ? 0 : of.words;
            };
            return rank(a) < rank(b);
        });
        std::vector<Candidate> result;
        SparseEquations span(function_.algebra);
        try {
            for (Candidate& each : candidates)
                if (span.insert(each.field)) result.push_back(std::move(each));
        } catch (const UndecidedEntry&) { return found; }
        return result;
    }

    /// Returns the components of a field in the order of the coordinates.
    [[nodiscard]] std::vector<Expression> generator(const SparseVector& field) const {
        std::vector<Expression> result;
        for (const ex& component : components(field))
            result.push_back(function_.algebra.written(component));
        return result;
    }

    /// Returns the coefficients of the brackets in the basis; nothing where one is not seen to be
    /// in it.
    [[nodiscard]] std::optional<std::vector<std::vector<std::vector<ex>>>>
    constants(const std::vector<Candidate>& basis) const try {
        const std::size_t m = basis.size(), behind = unknowns_.count();
        SparseEquations span(function_.algebra);
        for (std::size_t i = 0; i < m; ++i) {
            SparseVector tagged = basis[i].field;
            tagged[behind + i] = -1;
            static_cast<void>(span.insert(std::move(tagged)));
        }
        std::vector result(m, std::vector(m, std::vector<ex>(m)));
        for (std::size_t i = 0; i < m; ++i)
            for (std::size_t j = 0; j < i; ++j)
                for (const auto& [number, value] :
                     span.reduced(poisson_bracket(unknowns_, basis[i].field, basis[j].field))) {
                    if (number < behind) return {};
                    result[i][j][number - behind] = value;
                    result[j][i][number - behind] = -value;
                }
        return result;
    } catch (const UndecidedEntry&) { return {}; }

    /// Whether the fields are independent for the given values of the parameters.
    [[nodiscard]] bool stays_independent(const std::vector<Candidate>& basis,
                                         const Algebra& with_values) const {
        try {
            SparseEquations span(with_values);
            for (const Candidate& each : basis) {
                SparseVector field;
                for (const auto& [number, value] : each.field)
                    field[number] = normal_form(at_values(value, with_values));
                if (!span.insert(std::move(field))) return false;
            }
            return true;
        } catch (const std::exception&) {
            return false;  // a denominator vanishes
        } catch (const UndecidedEntry&) { return false; }
    }

    /// Puts values in for parameters. NOTE: the symbols of two algebras differ.
    [[nodiscard]] ex at_values(const ex& expression, const Algebra& with_values) const {
        GiNaC::exmap values;
        for (const symbol& parameter : function_.algebra.parameters()) {
            const auto value = with_values.values().find(parameter.get_name());
            if (value != with_values.values().end()) values[parameter] = value->second;
        }
        return expression.subs(values);
    }

    [[nodiscard]] bool is_turning(const Candidate& only) const {
        return is_rotation(unknowns_, only.field);
    }

private:
    [[nodiscard]] std::vector<ex> components(const SparseVector& field) const {
        std::vector<ex> result(function_.n());
        for (const auto& [number, value] : field) {
            if (number < function_.n()) {
                result[number] += value;
            } else {
                const auto [row, column] = unknowns_.entry(number);
                result[row] += value * function_.q[column];
            }
        }
        return result;
    }

    [[nodiscard]] Expression written(const ex& expression) const {
        return function_.algebra.written(multiplied_out(expression));
    }

    [[nodiscard]] Candidate candidate(const SparseVector& field) const {
        const std::vector<ex> velocity = components(field);
        if (const auto direction = common_direction(field)) {
            const auto& [factor, along] = *direction;
            ex momentum;
            for (const auto& [i, value] : along) momentum += value * function_.momentum(i);
            return with_words(field, Expression::product({written(factor), written(momentum)}));
        }
        ex sum;
        for (std::size_t i = 0; i < velocity.size(); ++i)
            sum += velocity[i] * function_.momentum(i);
        return with_words(field, written(sum));
    }

    /// Returns the speed and the direction of a field that moves all coordinates along one vector
    /// of numbers; nothing for other fields. The momentum map of such a field is a product.
    [[nodiscard]] std::optional<std::pair<ex, SparseVector>>
    common_direction(const SparseVector& field) const {
        if (is_translation(unknowns_, field)) return {};
        std::optional<ex> first;
        SparseVector along;
        const std::vector<ex> velocity = components(field);
        for (std::size_t i = 0; i < velocity.size(); ++i) {
            if (velocity[i].is_zero()) continue;
            if (!first) first = velocity[i].expand();
            const ex ratio = normal_form(velocity[i] / *first);
            if (!GiNaC::is_a<numeric>(ratio)) return {};
            along[i] = ratio;
        }
        if (along.size() < 2) return {};
        return std::pair{*first, std::move(along)};
    }

    static Candidate with_words(SparseVector field, Expression momentum_map) {
        const std::size_t words = word_count(momentum_map);
        return {std::move(field), std::move(momentum_map), words};
    }

    /// Returns the inverse of d2H/dp2, or d2L/dv2, where it is constant and diagonal.
    [[nodiscard]] std::optional<std::vector<ex>> masses() const {
        std::vector<ex> result;
        for (std::size_t i = 0; i < function_.n(); ++i)
            for (std::size_t j = 0; j <= i; ++j) {
                const ex entry = normal_form(function_.by_fibre[i].diff(function_.fibre[j]));
                for (const symbol& variable : function_.algebra.variables())
                    if (entry.has(variable)) return {};
                if ((i == j) == entry.is_zero()) return {};
                if (i == j) result.push_back(function_.is_lagrangian ? entry : 1 / entry);
            }
        return result;
    }

    /// Adds turns of the centre of mass. Where H is p^T K p/2 + U and may be translated along a and
    /// b, the centre of mass, M = K^-1 times a and b, moves as a free particle does, and may be
    /// turned from a to b:
    ///
    ///     q' = b (a M q) - a (b M q),    p q' = (a M q)(b p) - (b M q)(a p).
    void add_turned_centres(std::vector<Candidate>& candidates) const {
        std::vector<SparseVector> along;
        for (const Candidate& each : candidates)
            if (is_translation(unknowns_, each.field)) along.push_back(each.field);
        if (along.size() < 2 || along.size() > most_translations) return;
        const auto mass = masses();
        if (!mass) return;
        for (std::size_t a = 0; a < along.size(); ++a)
            for (std::size_t b = a + 1; b < along.size(); ++b)
                add_turned_centre(candidates, *mass, along[a], along[b]);
    }

    void add_turned_centre(std::vector<Candidate>& candidates, const std::vector<ex>& mass,
                           const SparseVector& a, const SparseVector& b) const {
        SparseVector field;
        const auto add_product = [&](const SparseVector& to, const SparseVector& from, int sign) {
            for (const auto& [i, x] : to)
                for (const auto& [j, y] : from) {
                    ex& entry = field[unknowns_.number(i, j)];
                    entry = normal_form(entry + sign * x * y * mass[j]);
                }
        };
        add_product(b, a, 1);
        add_product(a, b, -1);
        for (auto entry = field.begin(); entry != field.end();)
            entry = entry->second.is_zero() ? field.erase(entry) : std::next(entry);
        const auto momentum = [&](const SparseVector& along) {
            ex sum;
            for (const auto& [i, x] : along) sum += x * function_.momentum(i);
            return written(sum);
        };
        const auto centre = [&](const SparseVector& along) {
            ex sum;
            for (const auto& [i, x] : along) sum += x * mass[i] * function_.q[i];
            return written(sum);
        };
        candidates.push_back(
            with_words(std::move(field),
                       Expression::sum(
                           {Expression::product({centre(a), momentum(b)}),
                            Expression::negation(Expression::product({centre(b), momentum(a)}))})));
    }

    FunctionAndSlopes function_;
    AffineUnknowns unknowns_;
    Monomials monomials_;
    Relations relations_;
};

std::string name_of(const Search& search, const std::vector<Candidate>& basis,
                    const std::vector<std::vector<std::vector<ex>>>& constants,
                    const Algebra& with_values) {
    StructureConstants numbers;
    for (const auto& of_i : constants) {
        auto& rows = numbers.emplace_back();
        for (const auto& bracket : of_i) {
            auto& row = rows.emplace_back();
            for (const ex& value : bracket) {
                const ex number = normal_form(search.at_values(value, with_values));
                if (!number.info(GiNaC::info_flags::rational)) return "";
                row.push_back(GiNaC::ex_to<numeric>(number));
            }
        }
    }
    if (basis.size() == 1 && search.is_turning(basis.front())) return "so(2)";
    return name_of_algebra(numbers);
}

std::optional<SymmetryAlgebra> algebra_of(const Search& search, const std::vector<Candidate>& basis,
                                          const Algebra& with_values) {
    if (basis.empty() || basis.size() > most_brackets) return {};
    const auto constants = search.constants(basis);
    if (!constants) return {};
    SymmetryAlgebra result{"", std::vector<StructureConstant>{}};
    for (std::size_t i = 0; i < basis.size(); ++i)
        for (std::size_t j = i + 1; j < basis.size(); ++j)
            for (std::size_t k = 0; k < basis.size(); ++k) {
                const ex& value = (*constants)[i][j][k];
                if (!value.is_zero())
                    result.constants->push_back({i, j, k, search.algebra().written(value)});
            }
    result.name = name_of(search, basis, *constants, with_values);
    return result;
}

AffineSymmetries result_of(const Search& search, const std::vector<Candidate>& basis,
                           const std::string& doubt, const Algebra& with_values) {
    AffineSymmetries result;
    for (const Candidate& each : basis)
        result.basis.push_back({search.generator(each.field), each.momentum_map});
    result.doubt = doubt;
    result.algebra = algebra_of(search, basis, with_values);
    return result;
}

template <class Mechanics>
FunctionAndSlopes function(const Mechanics& mechanics) {
    return {Algebra(mechanics), std::is_same_v<Mechanics, Lagrangian>};
}

/// Finds the symmetries. Keeps parameters as symbols where this finds as many symmetries as their
/// values do.
template <class Mechanics>
AffineSymmetries found(const Mechanics& mechanics) {
    const Progress::Stage stage("looking for symmetries");
    Search with_values(function(mechanics));
    with_values.solve();
    const Relations& all = with_values.found();
    if (!mechanics.parameters.empty() && mechanics.degrees_of_freedom() <= most_symbolic) {
        Mechanics general = mechanics;
        general.parameters.clear();
        Search with_symbols(function(general));
        const bool is_asked_for = with_symbols.algebra().parameters().size() <= most_symbols;
        if (is_asked_for) with_symbols.solve();
        if (is_asked_for && with_symbols.found().basis.size() == all.basis.size()) {
            const std::vector<Candidate> basis = with_symbols.named();
            if (with_symbols.stays_independent(basis, with_values.algebra()))
                return result_of(with_symbols, basis, all.doubt, with_values.algebra());
        }
    }
    return result_of(with_values, with_values.named(), all.doubt, with_values.algebra());
}

}  // namespace

AffineSymmetries affine_symmetries(const Hamiltonian& hamiltonian) { return found(hamiltonian); }

AffineSymmetries affine_symmetries(const Lagrangian& lagrangian) { return found(lagrangian); }

}  // namespace hvi::gen
