// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/lower.hpp"

#include <algorithm>
#include <charconv>
#include <functional>

#include "generator/expr/own_functions.hpp"

namespace hvi::gen {

namespace {

using Kind = Expression::Kind;

/// Returns an integer of a few digits.
std::optional<long> small_integer(const std::string& digits) {
    long value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool fits = error == std::errc{} && value <= SmallFraction::largest;
    return fits ? std::optional(value) : std::nullopt;
}

bool contains(const Expression& expression, const std::function<bool(const Expression&)>& is_one) {
    return is_one(expression) ||
           std::any_of(expression.arguments.begin(), expression.arguments.end(),
                       [&](const Expression& argument) { return contains(argument, is_one); });
}

bool is_variable(const Expression& expression) {
    return expression.kind == Kind::symbol && expression.name != "pi" && expression.name != "e";
}

/// Returns whether an expression is a number with more to it than sums, products and powers of
/// numbers. Such a number is rounded once, as a whole.
bool is_irrational_constant(const Expression& expression) {
    if (own_call_in(expression) != nullptr) { return false; }
    return !contains(expression, is_variable) && contains(expression, [](const Expression& part) {
        return part.kind == Kind::call || part.kind == Kind::symbol;
    });
}

class Lowering {
public:
    Lowering(Graph& graph, const Symbols& symbols, const std::shared_ptr<const Source>& source)
        : graph_(graph), symbols_(symbols), source_(source) {}

    Scaled operator()(const Expression& expression) {
        if (is_irrational_constant(expression)) { return graph_.constant(expression); }
        switch (expression.kind) {
        case Kind::number: return number(expression);
        case Kind::symbol: return symbol(expression);
        case Kind::sum: return sum(expression);
        case Kind::product:
        case Kind::reciprocal: return product(expression);
        case Kind::negation: return graph_.times({-1, 1}, (*this)(expression.arguments.front()));
        case Kind::power: return power(expression);
        case Kind::call: return call(expression);
        case Kind::element:
        case Kind::sum_over: break;
        }
        HVI_CHECK(false && "indices are unrolled");
        return {};
    }

private:
    Scaled call(const Expression& expression) {
        std::vector<Scaled> arguments;
        for (const Expression& argument : expression.arguments) {
            arguments.push_back((*this)(argument));
        }
        return graph_.call(expression.name, arguments);
    }

    Scaled number(const Expression& expression) {
        const auto above = small_integer(expression.numerator);
        const auto below = small_integer(expression.denominator);
        if (above && below) { return Graph::number(SmallFraction::of(*above, *below).value()); }
        return graph_.constant(expression);
    }

    Scaled symbol(const Expression& expression) {
        const auto known = symbols_.find(expression.name);
        if (known != symbols_.end()) { return known->second; }
        HVI_CHECK(expression.name == "pi" || expression.name == "e");
        return graph_.constant(expression);
    }

    Scaled sum(const Expression& expression) {
        std::vector<Scaled> fixed, varying;
        for (const Expression& argument : expression.arguments) {
            const Scaled term = (*this)(argument);
            (varies(roles(term)) ? varying : fixed).push_back(term);
        }
        varying.push_back(graph_.sum(std::move(fixed)));
        return graph_.sum(std::move(varying));
    }

    Scaled product(const Expression& expression) {
        std::vector<Scaled> above, below;
        collect(expression, false, above, below);
        std::vector<Scaled> fixed_below, varying_below;
        for (const Scaled& factor : below) {
            (varies(roles(factor)) ? varying_below : fixed_below).push_back(factor);
        }
        for (std::vector<Scaled>* factors : {&fixed_below, &varying_below}) {
            if (!factors->empty()) { above.push_back(graph_.inverse(multiplied(*factors))); }
        }
        return multiplied(std::move(above));
    }

    /// Collects the factors of a product above and below the bar.
    void collect(const Expression& expression, bool is_below, std::vector<Scaled>& above,
                 std::vector<Scaled>& below) {
        if (expression.kind == Kind::product) {
            for (const Expression& factor : expression.arguments) {
                collect(factor, is_below, above, below);
            }
        } else if (expression.kind == Kind::reciprocal) {
            collect(expression.arguments.front(), !is_below, above, below);
        } else {
            const Scaled factor = (*this)(expression);
            if (is_below) { refuse_zero(factor, expression); }
            (is_below ? below : above).push_back(factor);
        }
    }

    void refuse_zero(const Scaled& divisor, const Expression& expression) const {
        if (!divisor.is_zero()) { return; }
        throw InputError("a division by zero", Place{source_, expression.range});
    }

    /// Returns the product: factors of equal roles first, the fewer first.
    Scaled multiplied(std::vector<Scaled> factors) {
        std::stable_sort(factors.begin(), factors.end(),
                         [&](const Scaled& a, const Scaled& b) { return roles(a) < roles(b); });
        Scaled result = Graph::number(1);
        for (auto begin = factors.begin(); begin != factors.end();) {
            Scaled group = Graph::number(1);
            const Roles here = roles(*begin);
            for (; begin != factors.end() && roles(*begin) == here; ++begin) {
                group = graph_.product(group, *begin);
            }
            result = graph_.product(result, group);
        }
        return result;
    }

    Scaled power(const Expression& expression) {
        constexpr long most = 1000;
        const Expression& written_base = expression.arguments.front();
        const Scaled exponent = (*this)(expression.arguments.back());
        if (written_base.kind == Kind::symbol && written_base.name == "e") {
            return graph_.call("exp", {exponent});
        }
        const Scaled base = (*this)(written_base);
        const SmallFraction value = exponent.factor;
        if (graph_.is_number(exponent) && value.above < 0) { refuse_zero(base, written_base); }
        const bool is_half =
            graph_.is_number(exponent) && value.below <= 2 && value.size().above <= most;
        return is_half ? graph_.half_power(base, 2 * value.above / value.below)
                       : graph_.power(base, exponent);
    }

    [[nodiscard]] Roles roles(const Scaled& a) const { return graph_.at(a.node).roles; }

    Graph& graph_;
    const Symbols& symbols_;
    const std::shared_ptr<const Source>& source_;
};

}  // namespace

Scaled lower(Graph& graph, const Expression& expression, const Symbols& symbols,
             const std::shared_ptr<const Source>& source) {
    return Lowering(graph, symbols, source)(expression);
}

}  // namespace hvi::gen
