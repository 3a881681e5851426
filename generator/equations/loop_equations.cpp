// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/equations/loop_equations.hpp"

#include <algorithm>
#include <set>
#include <utility>
#include <variant>

#include "generator/exact/methods/galerkin.hpp"
#include "generator/exact/numbers/budget.hpp"
#include "generator/expr/functions.hpp"
#include "generator/lower/kernel.hpp"
#include "generator/lower/system.hpp"
#include "generator/read/names.hpp"
#include "generator/read/no_loops.hpp"
#include "generator/read/own_functions.hpp"
#include "generator/read/put_in.hpp"

namespace hvi::gen {

namespace {

IndexedExpression with_definitions(const Scene& scene) {
    Definitions definitions;
    for (const Definition& definition : scene.definitions) { definitions.add(definition); }
    return definitions.put_in(scene.function);
}

/// Returns the words of a derivative and of its indices, and of the totals in it.
std::set<std::string> words_in(const System& system, const ElementSlope& slope) {
    std::set<std::string> words;
    for (const LoopTermOfSlope& term : slope) {
        walk(term.value, [&](const Expression& part) {
            const bool is_named =
                part.kind == Expression::Kind::symbol || part.kind == Expression::Kind::element;
            if (is_named) { words.insert(part.name); }
            return true;
        });
    }
    // NOTE: a total uses only totals before it.
    for (std::size_t k = system.totals.size(); k-- > 0;) {
        const SystemTotal& total = system.totals[k];
        if (words.count(system.graph.at(total.node).name) == 0) { continue; }
        if (has(system.graph.at(total.node).roles, Role::time)) { words.insert("t"); }
        for (const SystemSum& sum : total.sums) {
            for (const std::size_t access : sum.accesses) {
                words.insert(system.family(system.accesses[access]).name);
            }
            const Kernel value = kernel(system.graph, {sum.value});
            for (const SystemTotal& other : system.totals) {
                if (value.uses[other.node] == 0) { continue; }
                words.insert(system.graph.at(other.node).name);
            }
        }
    }
    return words;
}

/// NOTE: derivatives that loops add up have no text in the scene.
void check_totals(const System& system, const Place& place) {
    for (const SystemTotal& total : system.totals) {
        if (system.graph.at(total.node).name.rfind("derivative by ", 0) != 0) { continue; }
        throw NoLoops("equations are not printed where a sum stands in the summands of another",
                      place);
    }
}

/// One element of each family, as a Hamiltonian without loops. Its derivatives are calls with the
/// families that they depend on.
class OfOneElement {
public:
    OfOneElement(const System& system, const LoopGradient& gradient)
        : system_(system), gradient_(gradient) {
        name(system.coordinates, H_.coordinates);
        name(system.conjugates, H_.momenta);
        add(system.coordinates, gradient.by_coordinates, slopes_.by_coordinates);
        add(system.conjugates, gradient.by_momenta, slopes_.by_momenta);
        take_names(system);
    }

    [[nodiscard]] StageEquations equations(const ButcherPair& pair) const {
        StageEquations result = stage_equations(pair, H_, slopes_);
        for (auto* equations : {&result.stages, &result.update}) {
            for (Equation& equation : *equations) { equation.right = of_all(equation.right); }
        }
        return result;
    }

private:
    void name(const std::vector<SystemFamily>& families, std::vector<std::string>& names) {
        for (const SystemFamily& family : families) {
            names.push_back(to_text(element_of(family, gradient_.indices)));
            varying_.emplace_back(family.name, names.back());
        }
    }

    void add(const std::vector<SystemFamily>& families, const std::vector<ElementSlope>& slopes,
             std::vector<Expression>& calls) const {
        for (std::size_t f = 0; f < families.size(); ++f) {
            const std::set<std::string> words = words_in(system_, slopes[f]);
            std::vector<Expression> arguments;
            for (const auto& [family, element] : varying_) {
                if (words.count(family) != 0) { arguments.push_back(Expression::symbol(element)); }
            }
            if (words.count("t") != 0) { arguments.push_back(Expression::symbol("t")); }
            const std::string name = slope_name(families[f], gradient_.indices);
            calls.push_back(slopes[f].empty()   ? Expression::integer(0)
                            : arguments.empty() ? Expression::symbol(name)
                                                : Expression::call(name, std::move(arguments)));
        }
    }

    /// NOTE: stages take no name that occurs in H, with an index or without.
    void take_names(const System& system) {
        std::vector<Expression> words;
        for (const std::string& name : names_in(system)) {
            words.push_back(Expression::symbol(name));
            for (std::size_t d = 1; d <= gradient_.indices.size(); ++d) {
                const SystemFamily family{name, std::vector<LoopRange>(d)};
                words.push_back(Expression::symbol(to_text(element_of(family, gradient_.indices))));
            }
        }
        for (const auto* slopes : {&slopes_.by_coordinates, &slopes_.by_momenta}) {
            words.insert(words.end(), slopes->begin(), slopes->end());
        }
        H_.expression = Expression::sum(std::move(words));
    }

    /// Replaces the arguments of derivatives by whole families.
    [[nodiscard]] static Expression of_all(Expression expression) {
        const bool is_slope =
            expression.kind == Expression::Kind::call && !is_function(expression.name);
        for (Expression& argument : expression.arguments) {
            argument = is_slope ? Expression::symbol(std::string(without_index(argument.name)))
                                : of_all(std::move(argument));
        }
        return expression;
    }

    const System& system_;
    const LoopGradient& gradient_;
    Hamiltonian H_;
    Gradient slopes_;
    std::vector<std::pair<std::string, std::string>> varying_;  ///< families, and elements of them
};

/// Returns the parameters of H, with the ranges of their indices.
std::vector<std::string> parameters_of(const System& system, const Expression& hamiltonian) {
    std::set<std::string> words;
    walk(hamiltonian, [&](const Expression& part) {
        words.insert(part.name);
        return true;
    });
    std::vector<std::string> result;
    for (const SystemParameter& parameter : system.parameters) {
        if (words.count(parameter.name) != 0) { result.push_back(parameter.name); }
    }
    for (const SystemTable& table : system.tables) {
        if (words.count(table.family.name) != 0) { result.push_back(to_text(table.family)); }
    }
    return result;
}

/// Returns the sizes, and the parameters of H that have a value.
std::vector<Parameter> values_of(const System& system, const Expression& hamiltonian,
                                 const std::vector<Parameter>& given) {
    std::vector<Parameter> result;
    for (const SystemSize& size : system.sizes) {
        result.push_back({size.name, Expression::integer(size.value), {}});
    }
    for (const Parameter& parameter : given) {
        const std::string stem(without_index(parameter.name));
        bool is_in = false;
        walk(hamiltonian, [&](const Expression& part) {
            is_in = is_in || part.name == stem;
            return !is_in;
        });
        if (is_in) { assign(result, parameter); }
    }
    return result;
}

void check_names(const Method& method, const System& system) {
    std::vector<std::string> names;
    for (const auto* families : {&system.coordinates, &system.conjugates}) {
        for (const SystemFamily& family : *families) { names.push_back(family.name); }
    }
    for (const SystemTable& table : system.tables) { names.push_back(table.family.name); }
    check_together(method, names, "the scene");
}

}  // namespace

std::string slope_name(const SystemFamily& family, const std::vector<std::string>& indices) {
    return "dH_d" + to_text(element_of(family, indices));
}

LoopEquations loop_equations(const Method& method, Scene scene,
                             const std::vector<Parameter>& values) {
    const IndexedExpression function = with_definitions(scene);
    refuse_own_functions(function.written, function.source, "the exact equations of a step");
    for (const Parameter& parameter : values) { scene.fixed.insert(parameter.name); }
    const Place place{function.source, function.written.range};
    const System system = system_of(scene);
    check_names(method, system);
    check_totals(system, place);
    LoopEquations result;
    result.hamiltonian = system.is_transformed ? with_sums(system, place) : function.written;
    static_cast<StepTitle&>(result) =
        title_of(method, FunctionWords{scene.origin, parameters_of(system, result.hamiltonian),
                                       values_of(system, result.hamiltonian, values)});
    result.coordinates = system.coordinates;
    result.momenta = system.conjugates;
    std::vector<std::string> taken = parameter_names(method);
    for (const Parameter& known : result.values) { taken.push_back(known.name); }
    result.gradient = loop_gradient(system, taken, place);
    result.stages = on_new_ground([&](const Ground& ground) {
        const AnyDerivation found = derive_any_on(ground, method);
        const auto* tableau = std::get_if<Tableau>(&found.method);
        if (tableau == nullptr) {
            throw NoLoops("where sums stay loops, equations are printed for methods with as many "
                          "nodes as functions",
                          method.place);
        }
        return OfOneElement(system, result.gradient).equations(*tableau);
    });
    return result;
}

}  // namespace hvi::gen
