// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/graph/horner.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace hvi::gen {

namespace {

/// A coefficient times powers of the variables, with exponents of 0 and above.
struct Term {
    Scaled coefficient;
    std::vector<long> exponents;
};
using Terms = std::vector<Term>;

class Horner {
public:
    Horner(Graph& graph, const HornerForm& form) : graph_(graph), form_(form) {}

    [[nodiscard]] Scaled operator()(const NodePolynomial& polynomial) {
        const std::map<Node, std::vector<long>> powers = powers_of(polynomial);
        for (const auto& [node, exponents] : powers) { add_variables(node, exponents); }
        Terms terms;
        for (const auto& [monomial, coefficient] : polynomial) {
            terms.push_back({coefficient, exponents_of(monomial)});
        }
        return sum(std::move(terms));
    }

private:
    /// A node, 1/node or a root of these: the node's power of `halves`/2.
    struct Variable {
        Scaled value;
        Node node;
        long halves;
    };

    [[nodiscard]] static std::map<Node, std::vector<long>>
    powers_of(const NodePolynomial& polynomial) {
        std::map<Node, std::vector<long>> result;
        for (const auto& [monomial, coefficient] : polynomial) {
            for (const auto& [node, twice] : monomial) { result[node].push_back(twice); }
        }
        return result;
    }

    /// Adds variables for the positive powers of a node and for the negative ones.
    void add_variables(Node node, const std::vector<long>& exponents) {
        const auto have = [&](const auto& some) {
            return std::any_of(exponents.begin(), exponents.end(), some);
        };
        const auto is_positive = [](long twice) { return twice > 0; };
        const auto is_negative = [](long twice) { return twice < 0; };
        const bool has_roots = have([](long twice) { return twice > 0 && twice % 2 != 0; });
        const bool has_inverse_roots = have([](long twice) { return twice < 0 && twice % 2 != 0; });
        const long up = has_roots ? 1 : 2;
        const long down = has_inverse_roots || form_.takes_roots ? 1 : 2;
        const Scaled a{{1, 1}, node};
        if (have(is_positive)) { add_variable({graph_.half_power(a, up), node, up}); }
        if (have(is_negative)) { add_variable({graph_.half_power(a, -down), node, -down}); }
    }
    void add_variable(const Variable& variable) {
        places_[{variable.node, variable.halves > 0}] = variables_.size();
        variables_.push_back(variable);
    }

    [[nodiscard]] std::vector<long> exponents_of(const PowerProduct& monomial) const {
        std::vector<long> exponents(variables_.size());
        for (const auto& [node, twice] : monomial) {
            const std::size_t place = places_.at({node, twice > 0});
            exponents[place] = twice / variables_[place].halves;
        }
        return exponents;
    }

    [[nodiscard]] Scaled sum(Terms terms) {
        if (terms.empty()) { return Graph::number(0); }
        if (terms.size() == 1) { return product(terms.front()); }
        if (const auto coefficient = common_coefficient(terms)) {
            return bracket(*coefficient, terms);
        }
        const auto variable = most_common(terms);
        if (!variable) { return sum_by_coefficients(terms); }
        const auto has_it = [&](const Term& term) { return term.exponents[*variable] > 0; };
        if (std::all_of(terms.begin(), terms.end(), has_it)) {
            return taken_out(*variable, std::move(terms));
        }
        Terms inside, rest;
        for (Term& term : terms) { (has_it(term) ? inside : rest).push_back(std::move(term)); }
        const Scaled taken = taken_out(*variable, std::move(inside));
        return graph_.sum({taken, sum(std::move(rest))});
    }

    /// Returns the node that more than one coefficient is a number of times, if it is wanted: that
    /// of the first of such terms.
    [[nodiscard]] std::optional<Node> common_coefficient(const Terms& terms) const {
        if (!form_.takes_coefficients) { return std::nullopt; }
        for (const Term& term : terms) {
            const Node node = term.coefficient.node;
            const auto count = std::count_if(terms.begin(), terms.end(), [&](const Term& other) {
                return other.coefficient.node == node;
            });
            if (count > 1 && !graph_.is_number(term.coefficient)) { return node; }
        }
        return std::nullopt;
    }

    [[nodiscard]] Scaled bracket(Node coefficient, const Terms& terms) {
        Terms inside, rest;
        for (const Term& term : terms) {
            const bool has_it = term.coefficient.node == coefficient;
            (has_it ? inside : rest).push_back(term);
            if (has_it) { inside.back().coefficient = Graph::number(term.coefficient.factor); }
        }
        const Scaled together = graph_.product({{1, 1}, coefficient}, sum(std::move(inside)));
        return rest.empty() ? together : graph_.sum({together, sum(std::move(rest))});
    }

    /// Returns the variable that most terms have; empty where each has its own.
    [[nodiscard]] std::optional<std::size_t> most_common(const Terms& terms) const {
        std::optional<std::size_t> best;
        std::ptrdiff_t most = 1;
        const auto all = static_cast<std::ptrdiff_t>(terms.size());
        for (std::size_t i = 0; i < variables_.size() && most < all; ++i) {
            const std::size_t k = form_.takes_last ? variables_.size() - 1 - i : i;
            const auto count = std::count_if(terms.begin(), terms.end(), [&](const Term& term) {
                return term.exponents[k] > 0;
            });
            if (count <= most) { continue; }
            best = k;
            most = count;
        }
        return best;
    }

    /// Takes the lowest power out, and returns it.
    [[nodiscard]] static long take_lowest(std::size_t variable, Terms& terms) {
        const auto lowest =
            std::min_element(terms.begin(), terms.end(), [&](const Term& a, const Term& b) {
                return a.exponents[variable] < b.exponents[variable];
            });
        const long exponent = lowest->exponents[variable];
        for (Term& term : terms) { term.exponents[variable] -= exponent; }
        return exponent;
    }

    /// Returns terms that have a variable as a product. NOTE: r (1 + r s) is r + r^2 s, which is as
    /// short, waits less, and for small r has the digits of r.
    [[nodiscard]] Scaled taken_out(std::size_t variable, Terms terms) {
        const Scaled first = power(variables_[variable].value, take_lowest(variable, terms));
        const auto one = std::find_if(terms.begin(), terms.end(), [&](const Term& term) {
            return is_constant(term) && graph_.is_number(term.coefficient) &&
                   term.coefficient.factor.size().is_one();
        });
        if (one == terms.end()) { return graph_.product(first, sum(std::move(terms))); }
        const Scaled sign = one->coefficient;
        Terms rest = terms;
        rest.erase(rest.begin() + (one - terms.begin()));
        const bool go_on = std::all_of(rest.begin(), rest.end(), [&](const Term& term) {
            return term.exponents[variable] > 0;
        });
        if (!go_on) { return graph_.product(first, sum(std::move(terms))); }
        const Scaled more = power(variables_[variable].value, take_lowest(variable, rest));
        return graph_.sum({graph_.times(sign.factor, first),
                           graph_.product(graph_.product(first, more), sum(std::move(rest)))});
    }

    [[nodiscard]] static bool is_constant(const Term& term) {
        return std::all_of(term.exponents.begin(), term.exponents.end(),
                           [](long exponent) { return exponent == 0; });
    }

    /// Returns terms without a common variable: those with a common coefficient in brackets.
    [[nodiscard]] Scaled sum_by_coefficients(const Terms& terms) {
        struct Bracket {
            Scaled coefficient;
            std::vector<Scaled> terms;
        };
        std::vector<Bracket> brackets;
        std::vector<Scaled> result;
        for (const Term& term : terms) {
            if (is_constant(term)) {
                result.push_back(graph_.settled(term.coefficient));
                continue;
            }
            const bool is_negative = term.coefficient.factor.above < 0;
            const Scaled size{term.coefficient.factor.size(), term.coefficient.node};
            const Scaled powers = product({Graph::number(is_negative ? -1 : 1), term.exponents});
            const auto found =
                std::find_if(brackets.begin(), brackets.end(),
                             [&](const Bracket& bracket) { return bracket.coefficient == size; });
            if (found == brackets.end()) {
                brackets.push_back({size, {powers}});
            } else {
                found->terms.push_back(powers);
            }
        }
        for (Bracket& bracket : brackets) {
            result.push_back(
                graph_.product(graph_.settled(bracket.coefficient), graph_.sum(bracket.terms)));
        }
        return graph_.sum(std::move(result));
    }

    /// Returns a term. NOTE: factors of equal roles first, the fewer first, so that what depends on
    /// q alone can be computed before p is known.
    [[nodiscard]] Scaled product(const Term& term) {
        std::map<Roles, Scaled> by_roles;
        const auto multiply = [&](const Scaled& factor) {
            const Roles roles = graph_.at(factor.node).roles;
            const auto [found, is_new] = by_roles.emplace(roles, factor);
            if (!is_new) { found->second = graph_.product(found->second, factor); }
        };
        Scaled divisor = Graph::number(1);
        for (std::size_t k = 0; k < term.exponents.size(); ++k) {
            const auto& [value, node, halves] = variables_[k];
            const long exponent = term.exponents[k];
            if (exponent == 0) { continue; }
            if (form_.divides_once && halves < 0) {
                const Scaled a{{1, 1}, node};
                divisor = graph_.product(divisor, graph_.half_power(a, -halves * exponent));
            } else {
                multiply(power(value, exponent));
            }
        }
        if (!graph_.is_number(divisor)) { multiply(graph_.inverse(divisor)); }
        Scaled result = graph_.settled(term.coefficient);
        for (const auto& [roles, factor] : by_roles) { result = graph_.product(result, factor); }
        return result;
    }

    /// Returns a power by squares of lower ones: u^7 shares u^6 = (u^3)^2 with others.
    [[nodiscard]] Scaled power(const Scaled& base, long exponent) {
        if (exponent == 1) { return base; }
        const Scaled lower = power(base, exponent % 2 == 0 ? exponent / 2 : exponent - 1);
        return graph_.product(lower, exponent % 2 == 0 ? lower : base);
    }

    Graph& graph_;
    HornerForm form_;
    std::vector<Variable> variables_;
    std::map<std::pair<Node, bool>, std::size_t>
        places_;  ///< of variables: whether powers are positive
};

}  // namespace

Scaled horner(Graph& graph, const NodePolynomial& polynomial, const HornerForm& form) {
    return Horner(graph, form)(polynomial);
}

}  // namespace hvi::gen
