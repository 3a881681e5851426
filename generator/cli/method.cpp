// Reading METHOD and its parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/method.hpp"

#include <set>
#include <utility>

#include "generator/exact/galerkin.hpp"
#include "generator/read/method.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

namespace {

std::shared_ptr<const Source> source(const std::string& option, const std::string& value) {
    return std::make_shared<const Source>(Source{option, value});
}

Method read_method(const MethodOptions& options) {
    if (options.name) return named_method(source("--method", *options.name));
    if (options.file) return method_from_file(*options.file);
    const auto weights = options.weights ? source("--weights", *options.weights) : nullptr;
    return method_from_text(source("--basis", *options.basis), source("--nodes", *options.nodes),
                            weights);
}

/// Without the values of parameters.
Hamiltonian read_hamiltonian(const SchemeOptions& options) {
    const auto names = [](const std::string& option, const std::optional<std::string>& value) {
        return value ? source(option, *value) : nullptr;
    };
    return hamiltonian_from_text(source("--hamiltonian", *options.hamiltonian),
                                 names("--coordinates", options.coordinates),
                                 names("--momenta", options.momenta));
}

/// Calls `set` for what each `--param` says.
template <class Set>
void set_parameters(const std::vector<std::string>& assignments, Set set) {
    std::set<std::string> names;
    for (const std::string& assignment : assignments) {
        Parameter parameter = parse_parameter(source("--param", assignment));
        if (!names.insert(parameter.name).second)
            throw InputError("`" + parameter.name + "` is given a value twice", parameter.place);
        set(std::move(parameter));
    }
}

}  // namespace

Method method_of(const MethodOptions& options) {
    Method method = read_method(options);
    set_parameters(options.parameters,
                   [&](Parameter parameter) { set_parameter(method, std::move(parameter)); });
    return method;
}

Tableau tableau_of(const MethodOptions& options) { return derive(method_of(options)); }

Coefficients coefficients_of(const std::filesystem::path& file, const MethodOptions& options) {
    Coefficients coefficients = coefficients_from_file(file);
    set_parameters(options.parameters,
                   [&](Parameter parameter) { set_parameter(coefficients, std::move(parameter)); });
    return coefficients;
}

System read_system(const SchemeOptions& options) {
    Method method = read_method(options.method);
    if (!options.scene) {
        Hamiltonian hamiltonian = read_hamiltonian(options);
        check_together(method, hamiltonian);
        set_parameters(options.method.parameters, [&](Parameter parameter) {
            set_parameter(method, hamiltonian, std::move(parameter));
        });
        return {std::move(method), std::move(hamiltonian)};
    }
    Scene scene =
        find_scene(*options.scene, {source("SCENE", *options.scene), {0, options.scene->size()}});
    check_together(method, scene.hamiltonian);
    set_parameters(options.method.parameters, [&](Parameter parameter) {
        set_parameter(method, scene, std::move(parameter));
    });
    return {std::move(method), std::move(scene.hamiltonian)};
}

}  // namespace hvi::gen
