// Headers of steppers that carry directions along.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/emit/steps/tangent.hpp"

#include "generator/emit/steps/banner.hpp"
#include "generator/emit/text/text.hpp"

namespace hvi::gen {
namespace {

/// Arguments of the template of the stepper, with vectors of any type where it has them.
struct TemplateOfClass {
    std::string head, arguments;
};

TemplateOfClass template_of(const System& system) {
    if (vectors_of(system) != StateVectors::numbers) {
        return {"template <class Number>", "<Number>"};
    }
    return {fmt::format("template <class Number, class Numbers = std::array<Number, {}>>",
                        system.degrees_of_freedom()),
            "<Number, Numbers>"};
}

}  // namespace

std::string emit_with_directions(const StepToEmit& stepper, const StepToEmit& carrier,
                                 PulledBack pulled_back) {
    const std::string name = stepper.options.class_name;
    EmitOptions of_stepper = stepper.options;
    of_stepper.class_name = name + "Steps";
    EmitOptions of_carrier = carrier.options;
    of_carrier.class_name = name + "Directions";
    of_carrier.parameters_of = of_stepper.class_name;
    const TemplateOfClass head = template_of(*stepper.options.system);
    return fill("tangent.hpp.in",
                {{"banner", banner(stepper.method, stepper.step, stepper.options)},
                 {"stepper", emit_class(stepper.method, stepper.step, of_stepper)},
                 {"carrier", emit_class(carrier.method, carrier.step, of_carrier)},
                 {"head", head.head},
                 {"numbers", head.arguments},
                 {"name", name},
                 {"pulls_back", pulled_back == PulledBack::step_back ? "step_back" : "columns"}});
}

}  // namespace hvi::gen
