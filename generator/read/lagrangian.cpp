// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/lagrangian.hpp"

#include <fmt/format.h>

#include <set>
#include <utility>

#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

/// Makes new names for the coordinates: `before`, the name, `after`, then the index of the name.
/// Adds `_` to all of them until none is taken.
std::vector<std::string> new_names(const MechanicalFunction& function,
                                   const std::vector<std::string>& variables,
                                   std::string_view before, std::string_view after) {
    std::set<std::string> taken(variables.begin(), variables.end());
    for (const std::string& name : parameter_names(function.expression, variables)) {
        taken.insert(name);
    }
    std::set<std::string, std::less<>> stems;
    for (const std::string& name : taken) { stems.emplace(without_index(name)); }
    for (std::string tail;; tail += '_') {
        std::vector<std::string> names;
        bool is_free = true;
        for (const std::string& coordinate : function.coordinates) {
            const std::string stem(without_index(coordinate));
            const std::string name = fmt::format("{}{}{}{}", before, stem, after, tail);
            is_free = is_free && stems.count(name) == 0 && !is_reserved(name);
            names.push_back(name + coordinate.substr(stem.size()));
        }
        if (is_free) { return names; }
    }
}

}  // namespace

Lagrangian lagrangian_of(Expression expression, std::shared_ptr<const Source> source,
                         const NameList& coordinates, const NameList& velocities) {
    const Vocabulary variables = declared_variables(coordinates, velocities, words_of_velocities);
    Lagrangian L;
    L.source = std::move(source);
    L.expression = std::move(expression);
    L.coordinates = texts(coordinates);
    L.velocities = texts(velocities);
    check_words_of(L.expression, L.source, variables, "a Lagrangian");
    return L;
}

std::vector<std::string> variables(const Lagrangian& lagrangian) {
    std::vector<std::string> names = lagrangian.coordinates;
    names.insert(names.end(), lagrangian.velocities.begin(), lagrangian.velocities.end());
    return names;
}

std::vector<std::string> parameter_names(const Lagrangian& lagrangian) {
    return parameter_names(lagrangian.expression, variables(lagrangian));
}

std::vector<std::string> momentum_names(const Lagrangian& lagrangian) {
    return new_names(lagrangian, variables(lagrangian), "p_", "");
}

std::vector<std::string> velocity_names(const Hamiltonian& hamiltonian) {
    return new_names(hamiltonian, variables(hamiltonian), "", "_dot");
}

bool depends_on_time(const Lagrangian& lagrangian) {
    return depends_on_time(lagrangian.expression);
}

}  // namespace hvi::gen
