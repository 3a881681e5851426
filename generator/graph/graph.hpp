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

/// Number of a node in a graph. A node needs nodes with smaller numbers only.
using Node = std::uint32_t;

/// A product factor * node. Zero is 0 * the node of the constant 1.
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
    call,                 ///< a function of expr/functions.hpp, or of the user's own, by its name
};

/// Roles of inputs. A node depends on inputs of some roles.
enum class Role : unsigned {
    parameter = 1,
    coordinate = 2,
    conjugate = 4,  ///< a momentum; of a Lagrangian a velocity
    time = 8,
    direction = 16,
    index = 32  ///< an index of a loop, as a number, and elements with such an index that are no
                ///< variables
};

/// A set of roles.
using Roles = unsigned;
[[nodiscard]] constexpr bool has(Roles roles, Role role) {
    return (roles & static_cast<unsigned>(role)) != 0;
}

/// Roles of inputs that change in a step, except the time.
inline constexpr Roles of_state =
    static_cast<Roles>(Role::coordinate) | static_cast<Roles>(Role::conjugate);

/// Roles of inputs that change along a motion.
inline constexpr Roles of_motion = of_state | static_cast<Roles>(Role::time);

/// Returns whether a value depends on variables, so that it is computed at every evaluation.
[[nodiscard]] constexpr bool varies(Roles roles) {
    return (roles & ~static_cast<Roles>(Role::parameter)) != 0;
}

/// The computation of a node. A sum has `terms`, ascending by node, at least two, and the first
/// factor is positive. A sum may have one term with a factor other than 1, for an operation that
/// takes nodes. The other operations have `arguments`.
struct Computation {
    Operation operation = Operation::constant;
    std::vector<Scaled> terms;
    std::vector<Node> arguments;
    std::string name;     ///< of an input or a call; of a constant its text
    Expression constant;  ///< of a constant
    Roles roles = 0;      ///< of the inputs that it depends on
};

/// A power base^(twice_exponent/2).
struct HalfPower {
    Scaled base;
    long twice_exponent;
};

/// Nodes made by algebra. Equal computations are one node, numbers are folded, values computed from
/// constants are constants, and 0, 1 and like terms vanish. x - y and y - x are one node but for
/// their sign, and powers are products of shared squares. The same calls make the same graph.
class Graph {
public:
    Graph();

    [[nodiscard]] std::size_t size() const { return computations_.size(); }
    [[nodiscard]] const Computation& at(Node node) const { return computations_.at(node); }

    [[nodiscard]] static Scaled number(long integer) { return {{integer, 1}, one}; }
    [[nodiscard]] static Scaled number(const SmallFraction& fraction) { return {fraction, one}; }
    /// Returns a constant. Precondition: no symbols but pi and e.
    [[nodiscard]] Scaled constant(const Expression& expression);
    [[nodiscard]] Scaled input(const std::string& name, Role role);
    [[nodiscard]] Scaled input(const std::string& name, Roles roles);

    [[nodiscard]] Scaled sum(std::vector<Scaled> terms);
    [[nodiscard]] Scaled product(const Scaled& a, const Scaled& b);
    [[nodiscard]] Scaled times(const SmallFraction& factor, const Scaled& a);
    [[nodiscard]] Scaled inverse(const Scaled& a);
    /// Returns a^(twice_exponent/2), by products of a, 1/a and sqrt(a).
    [[nodiscard]] Scaled half_power(const Scaled& a, long twice_exponent);
    [[nodiscard]] Scaled power(const Scaled& base, const Scaled& exponent);
    /// Returns a call. Precondition: a function of expr/functions.hpp that takes no list, or one of
    /// the user's own, and as many arguments as it takes. NOTE: a call of the user's own function
    /// is no constant, whatever its arguments are.
    [[nodiscard]] Scaled call(const std::string& function, const std::vector<Scaled>& arguments);

    /// Returns a value with its number multiplied in, except the sign, so that what does not vary
    /// is computed once with it. Numbers stay as they are.
    [[nodiscard]] Scaled settled(const Scaled& a);

    /// Returns the power from which half_power() made this node, for odd exponents.
    [[nodiscard]] std::optional<HalfPower> half_power_at(Node node) const;

    [[nodiscard]] bool is_number(const Scaled& a) const { return a.node == one; }

private:
    static constexpr Node one = 0;

    [[nodiscard]] Node insert(Computation computation);
    /// Returns the computation as a constant, if it takes constants alone and is not too long.
    [[nodiscard]] std::optional<Expression> folded(const Computation& computation) const;
    /// Returns the node of a scaled one, its factor multiplied in.
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

/// Returns whether a value is not smooth in variables of the motion, as far as the graph shows: a
/// function with a kink or a choice is called on them.
[[nodiscard]] bool has_kinks(const Graph& graph, const std::vector<Scaled>& values);

}  // namespace hvi::gen
