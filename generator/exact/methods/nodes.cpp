// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/methods/nodes.hpp"

#include <map>

#include "generator/exact/algebra/number_polynomial.hpp"
#include "generator/exact/expressions/evaluate.hpp"
#include "generator/exact/methods/interpolation.hpp"
#include "generator/exact/numbers/rational.hpp"

namespace hvi::gen {

namespace {

RationalPolynomial x() { return RationalPolynomial::variable(); }

/// Returns the polynomial on [-1, 1] whose roots are the nodes of a family.
RationalPolynomial symmetric_polynomial(const std::string& family, unsigned s) {
    const RationalPolynomial one(1);
    if (family == "gauss") return legendre(s);
    if (family == "lobatto") return (x() * x() - one) * legendre(s - 1).derivative();
    if (family == "radau-left") return legendre(s - 1) + legendre(s);
    if (family == "radau-right") return legendre(s - 1) - legendre(s);
    if (family == "chebyshev") return chebyshev_equal_weights(s);
    if (family == "fejer") return chebyshev_t(s);
    HVI_CHECK(family == "clenshaw-curtis");
    return (x() * x() - one) * chebyshev_t(s - 1).derivative();
}

/// Returns a polynomial with the roots first/n, (first + 1)/n, ..., last/n.
RationalPolynomial equally_spaced(long first, long last, long n) {
    RationalPolynomial product(1);
    for (long i = first; i <= last; ++i) {
        product = product * (RationalPolynomial(n) * x() - RationalPolynomial(i));
    }
    return product;
}

Number fraction(long numerator, long denominator) {
    return Number(numerator) / Number(denominator);
}

/// Returns (1 - cos(pi p/q))/2: from the angle on the circle to [0, 1], ascending.
Number projected(long p, long q, const Ground& ground) {
    return (Number(1) - ground.cos(ground.pi() * fraction(p, q))) / Number(2);
}

/// Returns node number i = 0 .. s-1 of the families that have a formula for their nodes.
std::optional<Number> explicit_node(const std::string& family, long s, long i,
                                    const Ground& ground) {
    if (family == "newton-cotes") return fraction(i, s - 1);
    if (family == "newton-cotes-open") return fraction(i + 1, s + 1);
    if (family == "clenshaw-curtis") return projected(i, s - 1, ground);
    if (family == "fejer") return projected(2 * i + 1, 2 * s, ground);
    return std::nullopt;
}

/// Returns tau - node when the node is rational.
std::optional<RationalPolynomial> linear_factor(const Number& node) {
    const auto negative = rational_text(-node);
    if (!negative) return std::nullopt;
    RationalPolynomial factor = x();
    factor.set_coefficient(0, *negative);
    return factor;
}

/// Returns (tau - c_1) (tau - c_2) ..., where it is over Q. NOTE: then so are the sums of the nodes
/// and of their squares. Where they are not, the product may be too long to be written.
std::optional<RationalPolynomial> product_of_factors(const NumberVector& c) {
    Number sum, squares;
    for (const Number& node : c) {
        if (!is_exact(node)) { return std::nullopt; }
        sum = sum + node;
        squares = squares + node * node;
    }
    if (!rational_text(sum) || !rational_text(squares)) { return std::nullopt; }
    NumberPolynomial polynomial{Number(1)};
    for (const Number& node : c) { polynomial = product(polynomial, {-node, Number(1)}); }
    return over_rationals(polynomial);
}

/// Returns the argument of `roots(...)` as a polynomial in tau over Q.
RationalPolynomial root_polynomial(const Expression& argument, const List& list,
                                   const Ground& ground) {
    const Place place = list.place(argument.range);
    const auto polynomial = as_polynomial(evaluate_function(argument, list.source, ground));
    if (!polynomial) {
        throw InputError("roots takes a polynomial in tau with rational coefficients", place);
    }
    if (polynomial->degree() < 1) {
        throw InputError("roots takes a polynomial in tau that is not constant", place);
    }
    if (polynomial->degree() > 64) {
        throw InputError("a polynomial of degree more than 64 is out of range", place);
    }
    return *polynomial;
}

/// Collects nodes, and their polynomial as long as it is known.
class Collector {
public:
    explicit Collector(const Ground& ground) : ground_(ground) {}

    void add(const Number& node) {
        nodes_.c.push_back(node);
        multiply(linear_factor(node));
    }

    /// Adds the nodes of a family. NOTE: nodes with a formula are exact, and not isolated as roots.
    void add_family(const Family& family, const Place& place) {
        if (!explicit_node(family.name, family.size, 0, ground_)) {
            add_roots(family_polynomial(family), place);
            return;
        }
        for (long i = 0; i < family.size; ++i) {
            nodes_.c.push_back(explicit_node(family.name, family.size, i, ground_).value());
        }
        multiply(family_polynomial(family));
    }

    void add_roots(const RationalPolynomial& polynomial, const Place& place) {
        const NumberVector roots = real_roots(polynomial, ground_);
        if (roots.empty()) throw MathError("this polynomial has no real root", place);
        nodes_.c.insert(nodes_.c.end(), roots.begin(), roots.end());
        const bool all_roots = static_cast<long>(roots.size()) == polynomial.degree();
        multiply(all_roots ? std::optional(monic(polynomial)) : std::nullopt);
    }

    [[nodiscard]] Nodes result() const {
        Nodes nodes = nodes_;
        if (!nodes.polynomial) { nodes.polynomial = product_of_factors(nodes.c); }
        return nodes;
    }

private:
    void multiply(const std::optional<RationalPolynomial>& factor) {
        if (!factor || !nodes_.polynomial) {
            nodes_.polynomial.reset();
        } else {
            nodes_.polynomial = *nodes_.polynomial * *factor;
        }
    }

    const Ground& ground_;
    Nodes nodes_{{}, RationalPolynomial(1)};
};

}  // namespace

RationalPolynomial family_polynomial(const Family& family) {
    const long s = family.size;
    if (family.name == "newton-cotes") { return monic(equally_spaced(0, s - 1, s - 1)); }
    if (family.name == "newton-cotes-open") { return monic(equally_spaced(1, s, s + 1)); }
    return monic(symmetric_polynomial(family.name, static_cast<unsigned>(s)).at_affine(2, -1));
}

Nodes quadrature_nodes(const List& list, const Ground& ground) {
    Collector nodes(ground);
    for (const Item& item : list.items) {
        if (const Family* family = std::get_if<Family>(&item.what)) {
            nodes.add_family(*family, list.place(family->range));
            continue;
        }
        const Expression& expression = std::get<Expression>(item.what);
        if (expression.kind == Expression::Kind::call && expression.name == "roots") {
            nodes.add_roots(root_polynomial(expression.arguments.front(), list, ground),
                            list.place(expression.range));
        } else {
            nodes.add(evaluate_number(expression, list.source, ground));
        }
    }
    return nodes.result();
}

}  // namespace hvi::gen
