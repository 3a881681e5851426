// Writes a scene out, without indices.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/written_out_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "generator/read/kinks.hpp"
#include "generator/read/names.hpp"
#include "generator/read/scene_values.hpp"

namespace hvi::gen {

namespace {

class SceneUnrolling {
public:
    explicit SceneUnrolling(const Scene& written) : written_(written), words_(written) {}

    [[nodiscard]] WrittenOutScene operator()();

private:
    [[nodiscard]] VariableNames variable_names() const;
    void set_mechanics(WrittenOutScene& scene, const VariableNames& names);
    void fix_parameters(WrittenOutScene& scene) const;
    [[nodiscard]] std::vector<NamedExpression> invariants();
    [[nodiscard]] SceneSplit split(const IndexedSplit& written);
    [[nodiscard]] std::vector<VectorField> fields();
    [[nodiscard]] VectorField field(const IndexedField& written);
    void check_component(const NamedExpression& component, const Place& place) const;
    [[nodiscard]] SceneEvent event(const IndexedEvent& written);
    [[nodiscard]] std::vector<NamedExpression> jumps(const ValueTable& written);
    [[nodiscard]] std::vector<SceneEvent> kinks(const WrittenOutScene& scene) const;
    [[nodiscard]] SceneScale scale(const IndexedScale& written);

    const Scene& written_;
    SceneWords words_;
    SceneVariables variables_;
};

VariableNames SceneUnrolling::variable_names() const {
    const WholeNumbers& sizes = words_.sizes();
    return {unrolled(written_.coordinates, sizes), unrolled(written_.conjugates, sizes),
            unrolled(written_.rotations, sizes), unrolled(written_.angular_momenta, sizes)};
}

void SceneUnrolling::set_mechanics(WrittenOutScene& scene, const VariableNames& names) {
    const std::shared_ptr<const Source>& source = written_.function.source;
    Expression function =
        words_.expression("", written_.function, rules_of_function(written_.side)).expression;
    if (written_.side == Side::lagrangian) {
        scene.mechanics =
            lagrangian_of(std::move(function), source, names.coordinates, names.conjugates);
    } else {
        scene.mechanics = hamiltonian_of(std::move(function), source, names);
    }
    variables_ = {variables(scene), function_of(scene).rotations};
    function_of(scene).origin = written_.origin;
    function_of(scene).sizes = words_.sizes();
}

/// Gives H or L the values of the parameters in it that a program cannot change.
void SceneUnrolling::fix_parameters(WrittenOutScene& scene) const {
    MechanicalFunction& function = function_of(scene);
    const std::vector<std::string> names = parameter_names(function.expression, variables_.names);
    for (const Parameter& parameter : scene.parameters) {
        if (written_.fixed.count(parameter.name) != 0 && contains(names, parameter.name)) {
            function.parameters.push_back(parameter);
        }
    }
}

std::vector<NamedExpression> SceneUnrolling::invariants() {
    std::vector<NamedExpression> list;
    for (const NamedIndexed& invariant : written_.invariants) {
        list.push_back(words_.expression(invariant.name, invariant.expression, invariant_rules));
    }
    return list;
}

SceneSplit SceneUnrolling::split(const IndexedSplit& written) {
    SceneSplit split{{}, written.place, written.small_steps};
    for (const NamedIndexed& part : written.parts) {
        split.parts.push_back(words_.expression(part.name, part.expression, part_rules));
    }
    return split;
}

/// Throws InputError where a component of a field does not belong to a coordinate, or is not a
/// function of the coordinates.
void SceneUnrolling::check_component(const NamedExpression& component, const Place& place) const {
    const auto coordinates = variables_.names.begin();
    const auto conjugates = coordinates + static_cast<std::ptrdiff_t>(variables_.names.size() / 2);
    const auto is_coordinate = [&](const std::string& name) {
        return std::find(coordinates, conjugates, name) != conjugates;
    };
    if (!is_coordinate(component.name)) {
        throw InputError(fmt::format("`{}` is no coordinate", component.name), place,
                         "a vector field moves the coordinates; what follows them follows");
    }
    walk(component.expression, [&](const Expression& part) {
        const bool is_other =
            part.kind == Expression::Kind::symbol && words_.names().contains(part.name) &&
            std::find(conjugates, variables_.names.end(), part.name) != variables_.names.end();
        if (is_other) {
            throw InputError("a vector field is one of the coordinates alone",
                             Place{component.place.source, part.range});
        }
        return true;
    });
}

VectorField SceneUnrolling::field(const IndexedField& written) {
    VectorField field{written.name, {}, written.place};
    SceneValues given(words_, variables_, field_rules);
    for (const IndexedValue& value : written.components.values) {
        const auto before = given.found();
        given.add(value);
        for (const auto& [name, component] : given.found()) {
            if (before.count(name) == 0) { check_component(component, value.place); }
        }
    }
    for (const std::string& name : variables_.names) {
        const auto component = given.found().find(name);
        if (component != given.found().end()) { field.components.push_back(component->second); }
    }
    return field;
}

std::vector<VectorField> SceneUnrolling::fields() {
    std::vector<VectorField> list;
    for (const IndexedField& written : written_.fields) { list.push_back(field(written)); }
    return list;
}

std::vector<NamedExpression> SceneUnrolling::jumps(const ValueTable& written) {
    SceneValues given(words_, variables_, jump_rules);
    for (const IndexedValue& value : written.values) { given.add(value); }
    std::vector<NamedExpression> list;
    for (const std::string& name : variables_.names) {
        const auto jump = given.found().find(name);
        if (jump != given.found().end()) { list.push_back(jump->second); }
    }
    return list;
}

SceneEvent SceneUnrolling::event(const IndexedEvent& written) {
    SceneEvent event{.name = written.name,
                     .place = written.place,
                     .zero = words_.expression("zero", written.zero, event_rules),
                     .direction = written.direction,
                     .stop = written.stop,
                     .set = {},
                     .canonical = written.canonical};
    if (written.set) { event.set = jumps(*written.set); }
    if (written.cooldown) {
        event.cooldown = words_.expression("cooldown", *written.cooldown, cooldown_rules);
    }
    if (written.period) {
        event.period = words_.expression("period", *written.period, period_rules);
    }
    return event;
}

/// Makes an event for each kink of H.
std::vector<SceneEvent> SceneUnrolling::kinks(const WrittenOutScene& scene) const {
    std::vector<SceneEvent> list;
    if (!written_.kinks) { return list; }
    const MechanicalFunction& function = function_of(scene);
    for (Expression& zero : kinks_of(function.expression)) {
        SceneEvent& kink = list.emplace_back();
        kink.name = "kink " + std::to_string(list.size());
        kink.place = *written_.kinks;
        kink.zero = {"zero", std::move(zero), whole(function.source)};
        kink.is_kink = true;
    }
    return list;
}

SceneScale SceneUnrolling::scale(const IndexedScale& written) {
    SceneScale scale{.kind = written.kind, .expression = {}, .place = written.place};
    if (scale.kind == TimeScale::expression) {
        scale.expression = words_.expression("scale", written.expression, scale_rules);
    }
    return scale;
}

WrittenOutScene SceneUnrolling::operator()() {
    WrittenOutScene scene;
    scene.name = written_.name;
    scene.description = written_.description;
    const VariableNames names = variable_names();
    words_.declare_variables(names);
    scene.parameters = words_.declare_parameters();
    words_.define();
    check_more_names(written_, words_.names());
    set_mechanics(scene, names);
    fix_parameters(scene);
    scene.own = written_.own;
    scene.invariants = invariants();
    scene.approximate = written_.approximate;
    scene.fields = fields();
    for (const IndexedEvent& each : written_.events) { scene.events.push_back(event(each)); }
    for (SceneEvent& each : kinks(scene)) { scene.events.push_back(std::move(each)); }
    if (const auto* parts = std::get_if<IndexedSplit>(&written_.split)) {
        scene.split = split(*parts);
    }
    if (written_.scale) { scene.scale = scale(*written_.scale); }
    if (written_.initial) {
        scene.initial = values(*written_.initial, words_, variables_, initial_rules);
    }
    if (written_.exact) { scene.exact = values(*written_.exact, words_, variables_, exact_rules); }
    return scene;
}

void check_degrees(const Scene& scene, const std::string& why) {
    const std::size_t degrees = degrees_of_freedom(scene);
    if (!scene.place || degrees <= most_degrees_of_freedom) { return; }
    throw InputError(fmt::format("this scene has {} degrees of freedom, and sums of at most {} "
                                 "are written out",
                                 degrees, most_degrees_of_freedom),
                     scene.place, why);
}

}  // namespace

WrittenOutScene unrolled(const Scene& scene, const std::string& why) {
    check_degrees(scene, why);
    return SceneUnrolling(scene)();
}

const MechanicalFunction& function_of(const WrittenOutScene& scene) {
    return std::visit([](const auto& of) -> const MechanicalFunction& { return of; },
                      scene.mechanics);
}

MechanicalFunction& function_of(WrittenOutScene& scene) {
    return std::visit([](auto& of) -> MechanicalFunction& { return of; }, scene.mechanics);
}

std::vector<std::string> variables(const WrittenOutScene& scene) {
    return std::visit([](const auto& of) { return variables(of); }, scene.mechanics);
}

const Hamiltonian& hamiltonian_of(const WrittenOutScene& scene) {
    if (const auto* H = std::get_if<Hamiltonian>(&scene.mechanics)) { return *H; }
    throw MathError("here a Hamiltonian is wanted, and the scene has a Lagrangian",
                    whole(function_of(scene).source), "`hvi-gen scheme` prints its Hamiltonian");
}

}  // namespace hvi::gen
