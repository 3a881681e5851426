// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/step_title.hpp"

#include <algorithm>
#include <set>

#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

/// Returns the words of H or L without parameters of the method, whose values METHOD has.
template <class Function>
FunctionWords words_of(const Method& method, const Function& function) {
    FunctionWords words{function.origin, parameter_names(function), function.parameters};
    const std::vector<std::string> known = parameter_names(method);
    for (const Parameter& parameter : function.parameters)
        if (!contains(known, parameter.name)) words.origin += parameter_option(parameter);
    return words;
}

}  // namespace

StepTitle title_of(const Method& method, const FunctionWords& function) {
    StepTitle title{method.name, method.origin + " " + function.origin, {}, function.values, {}};
    for (const Parameter& parameter : method.parameters) assign(title.values, parameter);
    std::sort(title.values.begin(), title.values.end(),
              [](const Parameter& a, const Parameter& b) { return a.name < b.name; });
    std::set<std::string> names;
    for (const auto& list : {parameter_names(method), function.parameters})
        names.insert(list.begin(), list.end());
    for (const Parameter& known : title.values) names.erase(known.name);
    title.parameters.assign(names.begin(), names.end());
    return title;
}

StepTitle title_of(const Method& method, const Hamiltonian& hamiltonian) {
    return title_of(method, words_of(method, hamiltonian));
}

StepTitle title_of(const Method& method, const Lagrangian& lagrangian) {
    return title_of(method, words_of(method, lagrangian));
}

}  // namespace hvi::gen
