// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/lagrangian.hpp"

#include <utility>

namespace hvi::gen {

Lagrangian lagrangian_of(std::shared_ptr<const Source> expression, const NameList& coordinates,
                         const NameList& velocities) {
    const Vocabulary variables = declared_variables(coordinates, velocities, words_of_velocities);
    Lagrangian L;
    L.source = std::move(expression);
    L.expression = parse_indexed_expression(L.source);
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

bool depends_on_time(const Lagrangian& lagrangian) {
    return depends_on_time(lagrangian.expression);
}

}  // namespace hvi::gen
