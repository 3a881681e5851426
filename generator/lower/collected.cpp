// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/collected.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "generator/expr/functions.hpp"
#include "generator/graph/horner.hpp"
#include "generator/graph/polynomial.hpp"
#include "generator/graph/replaced.hpp"
#include "generator/lower/common_products.hpp"
#include "generator/lower/derivative.hpp"
#include "generator/lower/exponentials.hpp"
#include "generator/lower/kernel.hpp"
#include "generator/lower/node_uses.hpp"

namespace hvi::gen {

namespace {

/// Nodes that are variables of polynomials, beside sums of inputs alone.
struct Variables {
    bool shared = false;  ///< sums that more than one node needs, and powers a^(n/2)
    bool shifts = false;  ///< sums of inputs and of what does not vary: r - r0, 1 - y
};

/// Roles that values are computed for again and again, while others stay.
constexpr Roles of_inner_loops =
    static_cast<Roles>(Role::conjugate) | static_cast<Roles>(Role::direction);

double product_with(const SmallFraction& factor) { return factor.size().is_one() ? 0 : 1; }

/// Moves a number from values that are products into a factor that several of them have: 2 x f and
/// 2 y f become x g and y g with g = 2 f.
std::vector<Scaled> with_shared_numbers(Graph& graph, std::vector<Scaled> values) {
    using Part = std::pair<SmallFraction, Node>;
    std::map<Part, std::vector<std::size_t>> users;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const Computation& computation = graph.at(values[k].node);
        const SmallFraction size = values[k].factor.size();
        if (size.is_one() || computation.operation != Operation::product) { continue; }
        for (const Node factor :
             std::set(computation.arguments.begin(), computation.arguments.end())) {
            users[{size, factor}].push_back(k);
        }
    }
    for (const auto& [part, indices] : users) {
        const auto& [number, node] = part;
        if (indices.size() < 2 || graph.at(node).operation == Operation::input) { continue; }
        const Scaled multiple = graph.settled({number, node});
        for (const std::size_t k : indices) {
            Scaled& value = values[k];
            if (value.factor.size().is_one()) { continue; }
            const std::vector<Node>& factors = graph.at(value.node).arguments;
            const Scaled other{{value.factor.above < 0 ? -1 : 1, 1},
                               factors[0] == node ? factors[1] : factors[0]};
            value = graph.product(other, multiple);
        }
    }
    return values;
}

class Collecting {
public:
    Collecting(Graph& graph, std::vector<Scaled> values)
        : graph_(graph), values_(std::move(values)), uses_(graph), size_(graph.size()) {
        for (const Scaled& value : values_) { uses_.take(value.node, {1, 0}); }
        for (Node node = 0; node < size_; ++node) {
            const Computation& computation = graph.at(node);
            const std::size_t uses = uses_.of(node).all;
            is_shared_.push_back(uses > 1);
            const bool is_call = computation.operation == Operation::call;
            chooses_ = chooses_ || (uses > 0 && is_call && is_if(computation.name));
        }
    }

    /// NOTE: users come before what they use, so that a polynomial is collected as a whole, and its
    /// parts only where others need them too.
    [[nodiscard]] std::vector<Scaled> operator()() && {
        for (Scaled& value : values_) {
            if (!value.factor.size().is_one()) { collect(value); }
        }
        for (auto node = static_cast<Node>(size_); node-- > 0;) {
            const UseCount uses = uses_.of(node);
            if (uses.all == 0 || !is_polynomial(node)) { continue; }
            const Scaled best = shortest({{1, 1}, node}, uses, static_cast<double>(uses.all));
            if (best.node == node) { continue; }
            replace(node, best.node, uses);
            forms_[node] = best;
            uses_.ban(node);
        }
        return rewritten(graph_, std::move(values_), forms_);
    }

private:
    [[nodiscard]] bool is_polynomial(Node node) const {
        const Computation& computation = graph_.at(node);
        return varies(computation.roles) && (computation.operation == Operation::sum ||
                                             computation.operation == Operation::product);
    }

    /// Collects a value with its factor.
    void collect(Scaled& value) {
        if (!is_polynomial(value.node)) { return; }
        const Scaled best = shortest(value, {1, 0}, 1);
        replace(value.node, best.node, {1, 0});
        value = best;
    }

    /// NOTE: takes first, so that what both need stays.
    void replace(Node before, Node after, const UseCount& uses) {
        uses_.take(after, uses);
        uses_.drop(before, uses);
    }

    /// Returns the form with the least cost; `products`: how often a factor is multiplied in.
    [[nodiscard]] Scaled shortest(const Scaled& value, const UseCount& uses, double products) {
        Scaled best = value;
        double least = uses_.cost() + products * product_with(value.factor);
        if (least - cost_without(value.node, uses) <= 1) { return value; }
        for (const Scaled& form : forms(value)) {
            replace(value.node, form.node, uses);
            const double cost = uses_.cost() + products * product_with(form.factor);
            if (cost < least && uses_.bans_hold()) {
                best = form;
                least = cost;
            }
            replace(form.node, value.node, uses);
        }
        return best;
    }

    [[nodiscard]] double cost_without(Node node, const UseCount& uses) {
        uses_.drop(node, uses);
        const double result = uses_.cost();
        uses_.take(node, uses);
        return result;
    }

    /// Returns a value in Horner's forms, each once, without the value itself.
    [[nodiscard]] std::vector<Scaled> forms(const Scaled& value) {
        std::set<NodePolynomial> polynomials;
        std::vector<Scaled> result;
        for (const auto& [shared, shifts] :
             {Variables{true, true}, {true, false}, {false, true}, {false, false}}) {
            const auto [found, is_new] =
                polynomials.insert(expansion(value.node, {shared, shifts})(value));
            if (!is_new) { continue; }
            add_forms(*found, Graph::number(1), value.node, result);
            for (const LinearFactor& divisor : linear_factors(graph_, *found)) {
                add_forms(divisor.quotient, divisor.factor, value.node, result);
            }
        }
        return result;
    }

    /// Adds Horner's forms of factor * polynomial that are no form of the node yet.
    void add_forms(const NodePolynomial& polynomial, const Scaled& factor, Node node,
                   std::vector<Scaled>& result) {
        for (const HornerForm& form : forms_of(polynomial)) {
            const Scaled written = graph_.product(factor, horner(graph_, polynomial, form));
            const bool is_known = std::find(result.begin(), result.end(), written) != result.end();
            // NOTE: not 0, which may be a divisor.
            if (written.node != node && !written.is_zero() && !is_known) {
                result.push_back(written);
            }
        }
    }

    /// NOTE: roots only where they are needed anyway, outside of choices: elsewhere 1/a may have a
    /// negative a.
    [[nodiscard]] std::vector<HornerForm> forms_of(const NodePolynomial& polynomial) const {
        bool has_inverses = false, have_roots = !chooses_;
        for (const auto& [powers, coefficient] : polynomial) {
            for (const auto& [node, twice_exponent] : powers) {
                if (twice_exponent > 0) { continue; }
                has_inverses = true;
                have_roots = have_roots && uses_.has_root(node);
            }
        }
        // NOTE: in a single product nothing is taken out first or last.
        const bool is_sum = polynomial.size() > 1;
        std::vector<HornerForm> result{{}};
        const auto add = [&](const HornerForm& form) { result.push_back(form); };
        if (is_sum) { add({.takes_last = true}); }
        if (is_sum) { add({.takes_coefficients = true}); }
        if (!has_inverses) { return result; }
        add({.divides_once = true});
        if (is_sum) { add({.takes_last = true, .divides_once = true}); }
        if (!have_roots) { return result; }
        add({.takes_roots = true});
        if (is_sum) { add({.takes_last = true, .takes_roots = true}); }
        return result;
    }

    [[nodiscard]] Expansion& expansion(Node node, const Variables& variables) {
        const Roles inner = graph_.at(node).roles & of_inner_loops;
        const auto is_whole = [this, inner, variables](Node part) {
            return (inner & ~graph_.at(part).roles) != 0 || is_variable(part, variables);
        };
        return expansions_
            .try_emplace({variables.shared, variables.shifts, inner}, graph_, is_whole)
            .first->second;
    }

    [[nodiscard]] bool is_variable(Node node, const Variables& variables) const {
        const std::vector<Scaled>& terms = graph_.at(node).terms;
        // NOTE: derivatives of a^(n/2) know that it is this power.
        if (variables.shared && graph_.half_power_at(node)) { return true; }
        if (terms.empty()) { return false; }
        if (variables.shared && node < size_ && is_shared_[node]) { return true; }
        return variables.shifts && std::all_of(terms.begin(), terms.end(), [&](const Scaled& term) {
                   const Computation& part = graph_.at(term.node);
                   return part.operation == Operation::input || !varies(part.roles);
               });
    }

    Graph& graph_;
    std::vector<Scaled> values_;
    NodeUses uses_;
    std::size_t size_;  ///< of the graph before
    std::vector<bool> is_shared_;
    bool chooses_ = false;  ///< whether values are chosen, as `if` does
    std::map<Node, Scaled> forms_;
    std::map<std::tuple<bool, bool, Roles>, Expansion> expansions_;
};

}  // namespace

std::vector<Scaled> collected(Graph& graph, const std::vector<Scaled>& values) {
    const auto cost_of = [&](const std::vector<Scaled>& some) {
        return cost(kernel(graph, some).counts);
    };
    std::vector<Scaled> best = with_powers_of_exponentials(graph, values);
    double least = cost_of(best);
    const std::vector<Scaled> derived = best;
    std::set<std::vector<Scaled>> tried;
    // Returns the part of the cost that is saved.
    const auto try_collected = [&](const std::vector<Scaled>& from) {
        if (!tried.insert(from).second) { return 0.0; }
        std::vector<Scaled> form = Collecting(graph, with_shared_numbers(graph, from))();
        const double cost = cost_of(form);
        if (cost >= least) { return 0.0; }
        best = std::move(form);
        return 1 - cost / std::exchange(least, cost);
    };
    try_collected(best);
    // NOTE: Horner's form takes factors out of sums that others have in products.
    try_collected(with_common_products(graph, derived));
    // NOTE: a form has new nodes, which may have shorter forms themselves. What is found again and
    // again in many thousands of operations is not worth the time.
    constexpr double worth = 0.01;
    while (try_collected(with_common_products(graph, best)) > worth) {}
    return best;
}

std::vector<Scaled> short_gradient(Graph& graph, const Scaled& f, const std::vector<Node>& inputs) {
    const std::vector<Scaled> in_terms = gradient(graph, f, inputs, Shares::in_terms);
    const std::vector<Scaled> whole = gradient(graph, f, inputs, Shares::whole);
    std::vector<Scaled> result = collected(graph, in_terms);
    if (whole == in_terms) { return result; }
    std::vector<Scaled> other = collected(graph, whole);
    const double cost_of_other = cost(kernel(graph, other).counts);
    return cost_of_other < cost(kernel(graph, result).counts) ? other : result;
}

}  // namespace hvi::gen
