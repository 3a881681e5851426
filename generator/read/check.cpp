// Checks that the words of a method stand where they may.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/check.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <vector>

#include "generator/read/catalogue.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"

namespace hvi::gen {

namespace {

/// Rules for an expression at its place in a method.
struct ItemRules {
    std::string_view subject;  ///< the name in messages: `a node`
    bool tau = false;
    bool bspline = false;
    bool parameters = true;
};

constexpr ItemRules basis_rules{"a basis function", true, true, true};
constexpr ItemRules node_rules{"a node", false, false, true};
constexpr ItemRules polynomial_rules{"the polynomial of `roots`", true, false, true};
constexpr ItemRules weight_rules{"a weight", false, false, true};
constexpr ItemRules coefficient_rules{"a coefficient", false, false, true};
constexpr ItemRules value_rules{"the value of a parameter", false, false, false};

void check_symbol(const std::string& name, const Place& place, const ItemRules& rules) {
    if (is_constant(name)) return;
    if (name == "tau") {
        if (rules.tau) return;
        throw InputError(fmt::format("{} cannot depend on `tau`", rules.subject), place,
                         "`tau` is the variable of basis functions, and of the polynomial in "
                         "`roots(...)`");
    }
    if (!rules.parameters)
        throw InputError(fmt::format("{} is a number, and `{}` is none", rules.subject, name),
                         place);
    if (name == "t" && rules.tau)
        throw InputError("`t` is reserved: it is the time", place, "the variable here is `tau`");
    check_parameter_name(name, place);
}

void check_call(const std::string& function, const Place& place, const ItemRules& rules) {
    if (function == "roots")
        throw InputError("`roots` gives a list of nodes, and stands alone among the nodes", place,
                         "write for example --nodes \"0, roots(2*tau-1), 1\"");
    if (function == "bspline" && !rules.bspline)
        throw InputError(fmt::format("`bspline` cannot stand in {}", rules.subject), place,
                         "it is a basis function");
}

/// Checks that the degree and the index of a B-spline are small whole numbers, written out.
void check_spline(const Expression& call, const std::shared_ptr<const Source>& source) {
    const auto check = [&](const Expression& argument, std::string_view meaning) {
        const bool whole = argument.kind == Expression::Kind::number && argument.denominator == "1";
        if (whole && argument.numerator.size() <= 2 && std::stol(argument.numerator) < largest_size)
            return;
        throw InputError(fmt::format("{} of a B-spline is a whole number from 0 to {}", meaning,
                                     largest_size - 1),
                         Place{source, argument.range}, "write for example `bspline(1,0)`");
    };
    check(call.arguments[0], "the degree k");
    check(call.arguments[1], "the index i");
}

void check_expression(const Expression& expression, const std::shared_ptr<const Source>& source,
                      const ItemRules& rules) {
    walk(expression, [&](const Expression& part) {
        const Place place{source, part.range};
        if (part.kind == Expression::Kind::symbol) check_symbol(part.name, place, rules);
        if (part.kind == Expression::Kind::call) check_call(part.name, place, rules);
        if (part.kind == Expression::Kind::call && part.name == "bspline")
            check_spline(part, source);
        return true;
    });
}

bool is_roots(const Expression& expression) {
    return expression.kind == Expression::Kind::call && expression.name == "roots";
}

/// Checks a family in a list of `subject`: "functions" or "nodes". `other` are the families of the
/// other list.
void check_family(const Family& family, const Place& place, std::string_view subject,
                  std::span<const FamilyEntry> families, std::span<const FamilyEntry> other) {
    const FamilyEntry* entry = find_family(families, family.name);
    if (entry == nullptr && find_family(other, family.name) != nullptr)
        throw InputError(fmt::format("`{}` is no family of {}", family.name, subject), place,
                         "functions stand in --basis, nodes in --nodes");
    if (entry == nullptr) {
        std::vector<std::string_view> names;
        for (const FamilyEntry& known : families) names.push_back(known.name);
        throw InputError(
            fmt::format("there is no family of {} `{}`", subject, family.name), place,
            did_you_mean(family.name, names, fmt::format("the families are {}", listed(names))));
    }
    if (family.size < entry->smallest || family.size > largest_size)
        throw InputError("S is out of range", place,
                         fmt::format("`{}:S` exists for S = {}", entry->name, entry->sizes));
}

/// Refuses Chebyshev nodes that are not real. By Bernstein's theorem equal weights have real nodes
/// for 1 to 7 and for 9 points only.
void check_chebyshev(const Family& family, const Place& place) {
    if (family.name != "chebyshev" || family.size <= 7 || family.size == 9) return;
    throw MathError(fmt::format("the nodes of `chebyshev:{}` are not all real", family.size), place,
                    "Chebyshev's quadrature has real nodes for 1 to 7 and 9 points only");
}

void check_count(const List& list, std::string_view subject) {
    long count = 0;
    for (const Item& item : list.items) {
        const auto* family = std::get_if<Family>(&item.what);
        count += family != nullptr ? family->size : 1;
        if (count > largest_size)
            throw InputError(fmt::format("there are more than {} {}", largest_size, subject),
                             list.place(item.range));
    }
}

}  // namespace

void check_basis(const List& basis) {
    for (const Item& item : basis.items) {
        if (const auto* family = std::get_if<Family>(&item.what))
            check_family(*family, basis.place(family->range), "functions", basis_families(),
                         node_families());
        else
            check_expression(std::get<Expression>(item.what), basis.source, basis_rules);
    }
    check_count(basis, "basis functions");
}

void check_nodes(const List& nodes) {
    for (const Item& item : nodes.items) {
        if (const auto* family = std::get_if<Family>(&item.what)) {
            const Place place = nodes.place(family->range);
            check_family(*family, place, "nodes", node_families(), basis_families());
            check_chebyshev(*family, place);
            continue;
        }
        const Expression& expression = std::get<Expression>(item.what);
        if (is_roots(expression))
            check_expression(expression.arguments[0], nodes.source, polynomial_rules);
        else
            check_expression(expression, nodes.source, node_rules);
    }
    check_count(nodes, "nodes");
}

void check_weights(const List& weights) {
    for (const Item& item : weights.items) {
        if (const auto* family = std::get_if<Family>(&item.what))
            throw InputError(fmt::format("`{}` is a family, and weights are numbers", family->name),
                             weights.place(family->range));
        check_expression(std::get<Expression>(item.what), weights.source, weight_rules);
    }
    check_count(weights, "weights");
}

void check_coefficient(const Expression& value, const std::shared_ptr<const Source>& source) {
    check_expression(value, source, coefficient_rules);
}

void check_parameter_value(const Expression& value, const Place& place) {
    check_expression(value, place.source, value_rules);
}

}  // namespace hvi::gen
