// Hamiltonians from text.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/hamiltonian.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "generator/expr/functions.hpp"
#include "generator/read/names.hpp"
#include "generator/read/nearest.hpp"
#include "generator/read/sizes.hpp"
#include "generator/read/token.hpp"

namespace hvi::gen {

namespace {

constexpr const char* how_to_name =
    "name the variables: --coordinates \"x, y\" --momenta \"px, py\"";

/// Declares the names of one kind of variable.
void declare(Vocabulary& vocabulary, const NameList& list, std::string_view subject) {
    for (std::size_t k = 0; k < list.names.size(); ++k) {
        vocabulary.declare(list.names[k], subject);
        if (k == most_degrees_of_freedom)
            throw InputError(
                fmt::format("there are more than {} degrees of freedom", most_degrees_of_freedom),
                list.names[k].place);
    }
}

/// Places each name at the whole text, as if all of it declared the name.
NameList placed(const std::vector<std::string>& names,
                const std::shared_ptr<const Source>& source) {
    NameList list{{}, whole(source)};
    for (const std::string& name : names) list.names.push_back({name, list.place});
    return list;
}

/// Returns the k of `qk` and `pk` as digits: empty for q and p themselves, nothing for other names.
/// NOTE: q0 is none of q1, q2, ...: it often is a parameter, a position at rest.
std::optional<std::string> number_of(const std::string& name) {
    if (name.empty() || (name.front() != 'q' && name.front() != 'p')) return {};
    const std::string digits = name.substr(1);
    const bool counts = std::all_of(digits.begin(), digits.end(), is_digit) &&
                        (digits.empty() || digits.front() != '0');
    return counts ? std::optional(digits) : std::nullopt;
}

/// Finds the variables q, p or q1, q2, ..., p1, p2, ...: a pair for each index that occurs in one
/// of the two. NOTE: a gap in the indices adds no variable; a pair that does not occur in H would
/// be constant in time.
void find_variables(Hamiltonian& H) {
    const auto shorter_first = [](const std::string& left, const std::string& right) {
        return std::pair(left.size(), left) < std::pair(right.size(), right);
    };
    std::set<std::string, decltype(shorter_first)> indices(shorter_first);
    Range last;
    walk(H.expression, [&](const Expression& part) {
        if (part.kind != Expression::Kind::symbol) return true;
        if (const auto index = number_of(part.name)) {
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

/// Refuses sizes that have the name of a variable: one name would have two meanings.
void refuse_sizes(const NameList& variables, const WholeNumbers& sizes) {
    for (const DeclaredName& variable : variables.names)
        if (sizes.count(variable.name) != 0)
            throw InputError(
                fmt::format("`{}` is a variable, and stands in an index too", variable.name),
                variable.place, "take another name for one of them");
}

/// Returns the place of the first of these symbols in a list.
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

}  // namespace

Vocabulary declared_variables(const NameList& coordinates, const NameList& conjugate,
                              const ConjugateWords& words) {
    Vocabulary vocabulary;
    declare(vocabulary, coordinates, "a coordinate");
    declare(vocabulary, conjugate, words.subject);
    const std::size_t n = coordinates.names.size(), m = conjugate.names.size();
    if (m != n)
        throw InputError(fmt::format("{} coordinate{} and {} {}", n, n == 1 ? "" : "s", m,
                                     m == 1 ? words.singular : words.plural),
                         conjugate.place,
                         fmt::format("each coordinate has {} of its own", words.subject));
    return vocabulary;
}

namespace {

void declare_rotations(Vocabulary& vocabulary, const VariableNames& names) {
    const NameList &R = names.rotations, &L = names.angular_momenta;
    if (R.names.size() != L.names.size())
        throw InputError(fmt::format("{} rotation{} and {} angular moment{}", R.names.size(),
                                     R.names.size() == 1 ? "" : "s", L.names.size(),
                                     L.names.size() == 1 ? "um" : "a"),
                         L.names.empty() ? R.place : L.place,
                         "each rotation has an angular momentum of its own");
    const auto declare = [&](const NameList& list, std::string_view subject, auto parts) {
        for (const DeclaredName& name : list.names)
            for (const std::string& part : parts(name.name))
                vocabulary.declare({part, name.place}, subject);
    };
    declare(R, "a rotation", entries_of);
    declare(L, "an angular momentum", components_of);
}

}  // namespace

Vocabulary declared_variables(const VariableNames& names) {
    Vocabulary vocabulary = declared_variables(names.coordinates, names.conjugates);
    declare_rotations(vocabulary, names);
    if (names.coordinates.names.size() + rotations_of_space.tangent * names.rotations.names.size() >
        most_degrees_of_freedom)
        throw InputError(fmt::format("there are more than {} degrees of freedom, of which a "
                                     "rotation has three",
                                     most_degrees_of_freedom),
                         names.rotations.place);
    return vocabulary;
}

std::vector<std::string> texts(const NameList& list) {
    std::vector<std::string> names;
    for (const DeclaredName& declared : list.names) names.push_back(declared.name);
    return names;
}

void check_words_of(const Expression& function, const std::shared_ptr<const Source>& source,
                    const Vocabulary& variables, std::string_view subject) {
    check_functions(function, source, subject);
    std::set<std::string> parameters;
    walk(function, [&](const Expression& part) {
        if (part.kind != Expression::Kind::symbol) return true;
        if (is_constant(part.name) || part.name == "t") return true;
        const Place place{source, part.range};
        check_symbol_name(part.name, place);
        variables.check_index(part.name, place);
        if (!variables.contains(part.name))
            parameters.insert(std::string(without_index(part.name)));
        return true;
    });
    if (parameters.size() > most_parameters)
        throw InputError(fmt::format("there are more than {} parameters", most_parameters),
                         whole(source));
}

void check_functions(const Expression& expression, const std::shared_ptr<const Source>& source,
                     std::string_view subject) {
    walk(expression, [&](const Expression& part) {
        if (part.kind == Expression::Kind::call && is_of_lists(part.name))
            throw InputError(fmt::format("`{}` cannot stand in {}", part.name, subject),
                             Place{source, part.range});
        return true;
    });
}

Hamiltonian hamiltonian_of(Expression expression, std::shared_ptr<const Source> source,
                           const VariableNames& names) {
    const Vocabulary variables = declared_variables(names);
    Hamiltonian H;
    H.source = std::move(source);
    H.expression = std::move(expression);
    H.coordinates = texts(names.coordinates);
    H.momenta = texts(names.conjugates);
    for (std::size_t k = 0; k < names.rotations.names.size(); ++k) {
        H.rotations.push_back({names.rotations.names[k].name, names.angular_momenta.names[k].name});
        for (const std::string& name : entries_of(H.rotations.back().rotation))
            H.coordinates.push_back(name);
        for (const std::string& name : components_of(H.rotations.back().momentum))
            H.momenta.push_back(name);
    }
    check_words_of(H.expression, H.source, variables, "a Hamiltonian");
    return H;
}

Hamiltonian hamiltonian_from_text(std::shared_ptr<const Source> expression,
                                  const std::shared_ptr<const Source>& coordinates,
                                  const std::shared_ptr<const Source>& momenta,
                                  const std::vector<Parameter>& values) {
    HVI_CHECK((coordinates == nullptr) == (momenta == nullptr));
    const IndexedExpression written = parse_indexed_expression(std::move(expression));
    std::string origin = fmt::format("--hamiltonian \"{}\"", to_text(written.written));
    Hamiltonian H;
    if (coordinates != nullptr) {
        const NameTexts of_q = name_texts(coordinates), of_p = name_texts(momenta);
        WholeNumbers known = sizes(written, {of_q, of_p}, values);
        const NameList coordinates_of_H = unrolled(of_q, known);
        refuse_sizes(coordinates_of_H, known);
        const NameList momenta_of_H = unrolled(of_p, known);
        refuse_sizes(momenta_of_H, known);
        H = hamiltonian_of(unrolled(written, known), written.source,
                           {coordinates_of_H, momenta_of_H});
        H.sizes = std::move(known);
        origin += fmt::format(" --coordinates \"{}\" --momenta \"{}\"",
                              fmt::join(H.coordinates, ", "), fmt::join(H.momenta, ", "));
    } else {
        H.source = written.source;
        H.sizes = sizes(written, {}, values);
        H.expression = unrolled(written, H.sizes);
        find_variables(H);
        const Vocabulary found =
            declared_variables(placed(H.coordinates, H.source), placed(H.momenta, H.source));
        check_words_of(H.expression, H.source, found, "a Hamiltonian");
    }
    H.origin = std::move(origin);
    return H;
}

std::vector<std::string> variables(const Hamiltonian& hamiltonian) {
    std::vector<std::string> names = hamiltonian.coordinates;
    names.insert(names.end(), hamiltonian.momenta.begin(), hamiltonian.momenta.end());
    return names;
}

std::vector<std::string> parameter_names(const Hamiltonian& hamiltonian) {
    return parameter_names(hamiltonian.expression, variables(hamiltonian));
}

std::vector<std::string> parameter_names(const Expression& function,
                                         const std::vector<std::string>& variables) {
    std::set<std::string> names;
    insert_parameters(function, names);
    for (const std::string& variable : variables) names.erase(variable);
    return {names.begin(), names.end()};
}

bool depends_on_time(const Hamiltonian& hamiltonian) {
    return depends_on_time(hamiltonian.expression) && !contains(hamiltonian.coordinates, "t");
}

bool depends_on_time(const Expression& function) {
    bool found = false;
    walk(function, [&](const Expression& part) {
        found = found || (part.kind == Expression::Kind::symbol && part.name == "t");
        return !found;
    });
    return found;
}

void check_together(const Method& method, const Hamiltonian& hamiltonian) {
    check_together(method, variables(hamiltonian), "the Hamiltonian");
}

void check_together(const Method& method, const std::vector<std::string>& variables,
                    std::string_view owner) {
    std::vector<const List*> lists{&method.basis, &method.nodes};
    if (method.weights) lists.push_back(&*method.weights);
    for (const List* list : lists)
        if (const auto place = find_symbol(*list, variables))
            throw InputError(
                fmt::format("a parameter of the method has the name of a variable of {}", owner),
                place, "take another name for one of them");
}

void set_parameter(Method& method, Hamiltonian& hamiltonian, Parameter parameter) {
    const bool in_hamiltonian = contains(parameter_names(hamiltonian), parameter.name);
    const bool in_method = contains(parameter_names(method), parameter.name);
    const bool is_size = hamiltonian.sizes.count(parameter.name) != 0;
    if (!in_hamiltonian && !in_method && !is_size) {
        std::vector<std::string> names = parameter_names(hamiltonian);
        for (const std::string& name : parameter_names(method)) names.push_back(name);
        refuse_parameter(parameter, variables(hamiltonian), "the Hamiltonian", names);
    }
    if (in_hamiltonian) assign(hamiltonian.parameters, parameter);
    if (in_method) set_parameter(method, std::move(parameter));
}

void refuse_parameter(const Parameter& parameter, const std::vector<std::string>& variables,
                      std::string_view owner, const std::vector<std::string>& names) {
    if (contains(variables, parameter.name))
        throw InputError(
            fmt::format("`{}` is a variable of {}, and no parameter", parameter.name, owner),
            parameter.place);
    const std::string otherwise = names.empty()
                                      ? "there are no parameters"
                                      : fmt::format("the parameters are {}", listed(names));
    throw InputError(
        fmt::format("neither {} nor the method has a parameter `{}`", owner, parameter.name),
        parameter.place, did_you_mean(parameter.name, {names.begin(), names.end()}, otherwise));
}

}  // namespace hvi::gen
