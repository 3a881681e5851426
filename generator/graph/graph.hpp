// Expressions and their derivatives as a graph in which nothing is computed twice.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "generator/expr/expression.hpp"
#include "generator/graph/small_fraction.hpp"

namespace hvi::gen {

/// A node of a graph, by its number: it needs nodes of smaller numbers only.
using Node = std::uint32_t;

/// factor * node. Zero is 0 * the node of the constant 1.
struct Scaled {
    SmallFraction factor;
    Node node = 0;

    [[nodiscard]] bool is_zero() const { return factor.is_zero(); }
    friend auto operator<=>(const Scaled&, const Scaled&) = default;
};

enum class Operation {
    constant,             ///< an expression without symbols
    input,                ///< a variable or a parameter
    sum,                  ///< of factors times nodes
    product,              ///< of two nodes
    inverse,              ///< 1/a
    square_root,          ///< sqrt(a)
    inverse_square_root,  ///< 1/sqrt(a)
    power,                ///< a^b
    call,                 ///< one of expr/functions.hpp, or of the user's own, by its name
};

/// What an input is, and so what a node depends on.
enum class Role : unsigned {
    parameter = 1,
    coordinate = 2,
    conjugate = 4,  ///< a momentum, of a Lagrangian a velocity
    time = 8,
    direction = 16,
    index = 32  ///< of a loop, as a number, and what has such an index and is no variable
};

/// A set of roles.
using Roles = unsigned;
[[nodiscard]] constexpr bool has(Roles roles, Role role) {
    return (roles & static_cast<unsigned>(role)) != 0;
}

/// Of what changes in a step but the time.
inline constexpr Roles of_state =
    static_cast<Roles>(Role::coordinate) | static_cast<Roles>(Role::conjugate);

/// Roles of inputs that change along a motion.
inline constexpr Roles of_motion = of_state | static_cast<Roles>(Role::time);

/// Whether something depends on variables, so that it is computed at every evaluation.
[[nodiscard]] constexpr bool varies(Roles roles) {
    return (roles & ~static_cast<Roles>(Role::parameter)) != 0;
}

/// What a node computes. A sum has `terms`, ascending by node, at least two, and the first factor
/// is positive; or one with a factor other than 1, for an operation that takes nodes. The other
/// operations have `arguments`.
struct Computation {
    Operation operation = Operation::constant;
    std::vector<Scaled> terms;
    std::vector<Node> arguments;
    std::string name;     ///< input, call; of a constant its text
    Expression constant;  ///< of a constant
    Roles roles = 0;      ///< of the inputs that it depends on
};

/// base^(twice_exponent/2).
struct HalfPower {
    Scaled base;
    long twice_exponent;
};

/// Nodes made by algebra: equal computations are one node, numbers are folded, what is computed
/// from constants is a constant, 0, 1 and like terms vanish, x - y and y - x are one node but for
/// their sign, and powers are products of shared squares. The same calls make the same graph.
class Graph {
public:
    Graph();

    [[nodiscard]] std::size_t size() const { return computations_.size(); }
    [[nodiscard]] const Computation& at(Node node) const { return computations_.at(node); }

    [[nodiscard]] static Scaled number(long integer) { return {{integer, 1}, one}; }
    [[nodiscard]] static Scaled number(const SmallFraction& fraction) { return {fraction, one}; }
    /// Precondition: no symbols but pi and e.
    [[nodiscard]] Scaled constant(const Expression& expression);
    [[nodiscard]] Scaled input(const std::string& name, Role role);
    [[nodiscard]] Scaled input(const std::string& name, Roles roles);

    [[nodiscard]] Scaled sum(std::vector<Scaled> terms);
    [[nodiscard]] Scaled product(const Scaled& a, const Scaled& b);
    [[nodiscard]] Scaled times(const SmallFraction& factor, const Scaled& a);
    [[nodiscard]] Scaled inverse(const Scaled& a);
    /// a^(twice_exponent/2), by products of a, 1/a and sqrt(a).
    [[nodiscard]] Scaled half_power(const Scaled& a, long twice_exponent);
    [[nodiscard]] Scaled power(const Scaled& base, const Scaled& exponent);
    /// Precondition: a function of expr/functions.hpp other than those of lists, or one of the
    /// user's own, and as many arguments as it takes. NOTE: one of the user's own is no constant,
    /// whatever it is called of.
    [[nodiscard]] Scaled call(const std::string& function, const std::vector<Scaled>& arguments);

    /// What half_power() made this node of, for odd exponents.
    [[nodiscard]] std::optional<HalfPower> half_power_at(Node node) const;

    [[nodiscard]] bool is_number(const Scaled& a) const { return a.node == one; }

private:
    static constexpr Node one = 0;

    [[nodiscard]] Node insert(Computation computation);
    /// The constant that it is, if it is computed from constants alone and not too long.
    [[nodiscard]] std::optional<Expression> folded(const Computation& computation) const;
    /// The node of a scaled one, its factor multiplied in.
    [[nodiscard]] Node whole(const Scaled& a);
    [[nodiscard]] Scaled root(const Scaled& a, Operation operation);
    [[nodiscard]] Scaled negative_half_power(const Scaled& a, long twice_exponent);
    Scaled remember_half_power(const Scaled& power, const Scaled& a, long twice_exponent);
    [[nodiscard]] Scaled whole_power(const Scaled& base, long exponent);

    using Key = std::tuple<Operation, std::vector<Scaled>, std::vector<Node>, std::string>;
    std::vector<Computation> computations_;
    std::map<Key, Node> numbers_;
    std::map<Node, HalfPower> half_powers_;
};

/// Whether a value is not smooth in what changes along a motion, as far as the graph shows: a
/// function with a kink or a choice is called of it.
[[nodiscard]] bool has_kinks(const Graph& graph, const std::vector<Scaled>& values);

}  // namespace hvi::gen
