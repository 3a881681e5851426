// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline/stage.hpp"

#include "generator/support/error.hpp"

namespace hvi::gen {

std::string dump(const Method& method, const SceneStepper& stepper, const Wish<Stage>& stage) {
    switch (stage.choice) {
    case Stage::method: return dump(method);
    case Stage::tableau: return dump(stepper.method);
    case Stage::system: return dump(stepper.system);
    case Stage::step: return dump(stepper.step);
    }
    HVI_CHECK(false);
    return {};
}

std::string dump(const Method& method, const MethodStepper& stepper, const Wish<Stage>& stage) {
    switch (stage.choice) {
    case Stage::method: return dump(method);
    case Stage::tableau: return dump(stepper.method);
    case Stage::system: break;
    case Stage::step: return dump(stepper.step);
    }
    throw InputError("without a scene there is no system to print", stage.place,
                     "give a scene, or --hamiltonian");
}

}  // namespace hvi::gen
