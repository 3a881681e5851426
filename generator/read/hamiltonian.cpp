// Hamiltonians by text.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/hamiltonian.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_parameters = 64;
constexpr const char* how_to_name =
    "name the variables: --coordinates \"x, y\" --momenta \"px, py\"";

Place whole(const std::shared_ptr<const Source>& source) {
    return {source, {0, source->text.size()}};
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// What CONTRACT.md announces for many bodies, which the grammar does not have: `x[1..6]`.
void refuse_indices(const std::shared_ptr<const Source>& source) {
    const std::size_t bracket = source->text.find('[');
    if (bracket == std::string::npos) return;
    throw InputError("indexed variables, and sums over them, are announced, but not built yet",
                     Place{source, {bracket, bracket + 1}}, "write them out: x1, x2, x3");
}

std::vector<std::string> names_in(const std::shared_ptr<const Source>& source,
                                  std::string_view subject) {
    refuse_indices(source);
    std::vector<std::string> names;
    const List list = parse_list(source);
    for (const Item& item : list.items) {
        const Place place = list.place(item.range);
        const auto* expression = std::get_if<Expression>(&item.what);
        if (expression == nullptr || expression->kind != Expression::Kind::symbol)
            throw InputError(fmt::format("this is no name of {}", subject), place,
                             "a name is a letter followed by letters, digits and `_`");
        check_parameter_name(expression->name, place, subject);
        if (contains(names, expression->name))
            throw InputError(fmt::format("`{}` is named twice", expression->name), place);
        names.push_back(expression->name);
        if (names.size() > most_degrees_of_freedom)
            throw InputError(
                fmt::format("there are more than {} degrees of freedom", most_degrees_of_freedom),
                place);
    }
    return names;
}

/// The variables that `--coordinates` and `--momenta` name.
void name_variables(Hamiltonian& H, const std::shared_ptr<const Source>& coordinates,
                    const std::shared_ptr<const Source>& momenta) {
    H.coordinates = names_in(coordinates, "a coordinate");
    H.momenta = names_in(momenta, "a momentum");
    for (const Item& item : parse_list(momenta).items) {
        const std::string& name = std::get<Expression>(item.what).name;
        if (contains(H.coordinates, name))
            throw InputError(fmt::format("`{}` is a coordinate already", name),
                             Place{momenta, item.range});
    }
    if (H.momenta.size() != H.coordinates.size())
        throw InputError(fmt::format("{} coordinate{} and {} moment{}", H.coordinates.size(),
                                     H.coordinates.size() == 1 ? "" : "s", H.momenta.size(),
                                     H.momenta.size() == 1 ? "um" : "a"),
                         whole(momenta), "each coordinate has a momentum of its own");
}

/// The k of `qk` and `pk`, as digits; empty for q and p themselves, nothing for other names.
/// NOTE: q0 is none of q1, q2, ...: it often is a parameter, a position at rest.
std::optional<std::string> index_of(const std::string& name) {
    if (name.empty() || (name.front() != 'q' && name.front() != 'p')) return {};
    const std::string digits = name.substr(1);
    const bool counts = std::all_of(digits.begin(), digits.end(), is_digit) &&
                        (digits.empty() || digits.front() != '0');
    return counts ? std::optional(digits) : std::nullopt;
}

/// The variables q, p or q1, q2, ..., p1, p2, ... as they occur: a pair for each index that one of
/// the two has. NOTE: an index that is left out is no variable; a pair that does not occur in H is
/// constant in time, and would only stand beside the others.
void find_variables(Hamiltonian& H) {
    const auto shorter_first = [](const std::string& left, const std::string& right) {
        return std::pair(left.size(), left) < std::pair(right.size(), right);
    };
    std::set<std::string, decltype(shorter_first)> indices(shorter_first);
    Range last;
    walk(H.expression, [&](const Expression& part) {
        if (part.kind != Expression::Kind::symbol) return true;
        if (const auto index = index_of(part.name)) {
            indices.insert(*index);
            last = part.range;
        }
        if (indices.size() > 1 && indices.begin()->empty())
            throw InputError("some variables have an index, and some have none",
                             Place{H.source, last}, how_to_name);
        return true;
    });
    if (indices.empty())
        throw InputError("neither q and p nor q1, p1, ... occur in the Hamiltonian",
                         whole(H.source), how_to_name);
    if (indices.size() > most_degrees_of_freedom)
        throw InputError(
            fmt::format("there are more than {} degrees of freedom", most_degrees_of_freedom),
            whole(H.source));
    for (const std::string& index : indices) {
        H.coordinates.push_back("q" + index);
        H.momenta.push_back("p" + index);
    }
}

void check_symbol(const std::string& name, const Place& place) {
    if (is_constant(name)) return;
    if (name == "t")
        throw InputError("a Hamiltonian that depends on the time `t` is announced, but not built "
                         "yet",
                         place);
    check_parameter_name(name, place);
}

/// Whether what stands in H can stand there.
void check_words(const Hamiltonian& H) {
    walk(H.expression, [&](const Expression& part) {
        const Place place{H.source, part.range};
        if (part.kind == Expression::Kind::symbol) check_symbol(part.name, place);
        if (part.kind == Expression::Kind::call && (part.name == "roots" || part.name == "bspline"))
            throw InputError(fmt::format("`{}` cannot stand in a Hamiltonian", part.name), place);
        return true;
    });
}

/// Where a symbol stands in a list.
std::optional<Place> find_symbol(const List& list, const std::vector<std::string>& names) {
    std::optional<Place> place;
    for (const Item& item : list.items) {
        const auto* expression = std::get_if<Expression>(&item.what);
        if (expression == nullptr) continue;
        walk(*expression, [&](const Expression& part) {
            const bool found =
                part.kind == Expression::Kind::symbol && contains(names, part.name) && !place;
            if (found) place = list.place(part.range);
            return !place;
        });
    }
    return place;
}

[[noreturn]] void refuse_unknown(const Method& method, const Hamiltonian& H,
                                 const Parameter& parameter) {
    if (contains(variables(H), parameter.name))
        throw InputError(
            fmt::format("`{}` is a variable of the Hamiltonian, and no parameter", parameter.name),
            parameter.place);
    std::vector<std::string> names = parameter_names(H);
    for (const std::string& name : parameter_names(method)) names.push_back(name);
    const std::string otherwise =
        names.empty() ? "there are no parameters"
                      : fmt::format("the parameters are {}", fmt::join(names, ", "));
    throw InputError(
        fmt::format("neither the Hamiltonian nor the method has a parameter `{}`", parameter.name),
        parameter.place, did_you_mean(parameter.name, {names.begin(), names.end()}, otherwise));
}

}  // namespace

Hamiltonian hamiltonian_from_text(std::shared_ptr<const Source> expression,
                                  const std::shared_ptr<const Source>& coordinates,
                                  const std::shared_ptr<const Source>& momenta) {
    HVI_CHECK((coordinates == nullptr) == (momenta == nullptr));
    refuse_indices(expression);
    Hamiltonian H;
    H.source = std::move(expression);
    H.expression = parse_expression(H.source);
    check_words(H);
    H.origin = fmt::format("--hamiltonian \"{}\"", to_text(H.expression));
    if (coordinates != nullptr) {
        name_variables(H, coordinates, momenta);
        H.origin += fmt::format(" --coordinates \"{}\" --momenta \"{}\"",
                                fmt::join(H.coordinates, ", "), fmt::join(H.momenta, ", "));
    } else {
        find_variables(H);
    }
    if (parameter_names(H).size() > most_parameters)
        throw InputError(fmt::format("there are more than {} parameters", most_parameters),
                         whole(H.source));
    return H;
}

std::vector<std::string> variables(const Hamiltonian& hamiltonian) {
    std::vector<std::string> names = hamiltonian.coordinates;
    names.insert(names.end(), hamiltonian.momenta.begin(), hamiltonian.momenta.end());
    return names;
}

std::vector<std::string> parameter_names(const Hamiltonian& hamiltonian) {
    const std::vector<std::string> all = variables(hamiltonian);
    std::set<std::string> names;
    walk(hamiltonian.expression, [&](const Expression& part) {
        if (part.kind == Expression::Kind::symbol && !is_reserved(part.name) &&
            !contains(all, part.name))
            names.insert(part.name);
        return true;
    });
    return {names.begin(), names.end()};
}

void check_together(const Method& method, const Hamiltonian& hamiltonian) {
    const std::vector<std::string> names = variables(hamiltonian);
    std::vector<const List*> lists{&method.basis, &method.nodes};
    if (method.weights) lists.push_back(&*method.weights);
    for (const List* list : lists)
        if (const auto place = find_symbol(*list, names))
            throw InputError("a parameter of the method is called as a variable of the Hamiltonian",
                             place, "take another name for one of them");
}

void set_parameter(Method& method, Hamiltonian& hamiltonian, Parameter parameter) {
    const bool in_hamiltonian = contains(parameter_names(hamiltonian), parameter.name);
    const bool in_method = contains(parameter_names(method), parameter.name);
    if (!in_hamiltonian && !in_method) refuse_unknown(method, hamiltonian, parameter);
    if (in_hamiltonian) assign(hamiltonian.parameters, parameter);
    if (in_method) set_parameter(method, std::move(parameter));
}

}  // namespace hvi::gen
