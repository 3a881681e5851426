// Reading METHOD and its parameters.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/method.hpp"

#include <set>
#include <utility>

#include "generator/exact/galerkin.hpp"
#include "generator/read/method.hpp"

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

/// `Target` is Method or Coefficients.
template <class Target>
void set_parameters(Target& target, const std::vector<std::string>& assignments) {
    std::set<std::string> names;
    for (const std::string& assignment : assignments) {
        Parameter parameter = parse_parameter(source("--param", assignment));
        if (!names.insert(parameter.name).second)
            throw InputError("`" + parameter.name + "` is given a value twice", parameter.place);
        set_parameter(target, std::move(parameter));
    }
}

}  // namespace

Tableau tableau_of(const MethodOptions& options) {
    Method method = read_method(options);
    set_parameters(method, options.parameters);
    return derive(method);
}

Coefficients coefficients_of(const std::filesystem::path& file, const MethodOptions& options) {
    Coefficients coefficients = coefficients_from_file(file);
    set_parameters(coefficients, options.parameters);
    return coefficients;
}

}  // namespace hvi::gen
