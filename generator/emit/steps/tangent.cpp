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

/// `carrier`: the text of the class of the motion together with a direction, or nothing; `carries`:
/// the class that carries directions.
std::string with_directions(const StepToEmit& stepper, const std::string& carrier,
                            const std::string& carries, PulledBack pulled_back) {
    EmitOptions of_steps = stepper.options;
    of_steps.class_name += "Steps";
    const TemplateOfClass head = template_of(*stepper.options.system);
    return fill("tangent.hpp.in",
                {{"banner", banner(stepper.method, stepper.step, stepper.options)},
                 {"stepper", emit_class(stepper.method, stepper.step, of_steps)},
                 {"carrier", carrier},
                 {"carries", carries},
                 {"head", head.head},
                 {"numbers", head.arguments},
                 {"name", stepper.options.class_name},
                 {"pulls_back", pulled_back == PulledBack::step_back ? "step_back" : "columns"}});
}

}  // namespace

std::string emit_with_directions(const StepToEmit& stepper, PulledBack pulled_back) {
    return with_directions(stepper, "",
                           fmt::format("Basic{}Steps{}", stepper.options.class_name,
                                       template_of(*stepper.options.system).arguments),
                           pulled_back);
}

std::string emit_with_directions_apart(const StepToEmit& stepper, const StepToEmit& carrier,
                                       PulledBack pulled_back) {
    EmitOptions of_carrier = carrier.options;
    of_carrier.class_name = stepper.options.class_name + "Directions";
    of_carrier.parameters_of = stepper.options.class_name + "Steps";
    return with_directions(stepper, emit_class(carrier.method, carrier.step, of_carrier),
                           fmt::format("Basic{}<Number>", of_carrier.class_name), pulled_back);
}

}  // namespace hvi::gen
