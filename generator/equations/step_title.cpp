// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/step_title.hpp"

#include <algorithm>
#include <set>

#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

/// METHOD has the values of its own parameters.
template <class Function>
std::string origin_of(const Method& method, const Function& function) {
    std::string text = method.origin + " " + function.origin;
    const std::vector<std::string> known = parameter_names(method);
    for (const Parameter& parameter : function.parameters)
        if (!contains(known, parameter.name))
            text += " --param \"" + parameter.name + "=" + to_text(parameter.value) + "\"";
    return text;
}

template <class Function>
StepTitle title(const Method& method, const Function& function) {
    StepTitle title{method.name, origin_of(method, function), {}, function.parameters, {}};
    for (const Parameter& parameter : method.parameters) assign(title.values, parameter);
    std::sort(title.values.begin(), title.values.end(),
              [](const Parameter& a, const Parameter& b) { return a.name < b.name; });
    std::set<std::string> names;
    for (const auto& list : {parameter_names(method), parameter_names(function)})
        names.insert(list.begin(), list.end());
    for (const Parameter& known : title.values) names.erase(known.name);
    title.parameters.assign(names.begin(), names.end());
    return title;
}

}  // namespace

StepTitle title_of(const Method& method, const Hamiltonian& hamiltonian) {
    return title(method, hamiltonian);
}

StepTitle title_of(const Method& method, const Lagrangian& lagrangian) {
    return title(method, lagrangian);
}

}  // namespace hvi::gen
