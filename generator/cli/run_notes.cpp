// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_notes.hpp"

#include "generator/read/names.hpp"
#include "generator/support/version.hpp"

namespace hvi::gen {

std::vector<TableNote> notes_on(const Scene& scene, const SceneStepper& stepper,
                                const RunSubject& subject, double step) {
    return {{"scene", subject.scene},
            {"description", subject.description},
            {"scene_text", scene.text},
            {"method", subject.title},
            {"step", step},
            {"command", stepper.command},
            {"source", "hvi-gen " + std::string(version)}};
}

std::map<std::string, std::string, std::less<>> meanings_of(const RunSubject& subject) {
    std::map<std::string, std::string, std::less<>> meanings;
    for (const NameBox& box : subject.coordinates) meanings[box.stem] = "coordinate";
    for (const NameBox& box : subject.momenta) meanings[box.stem] = "momentum";
    for (const std::string& name : subject.conserved)
        if (name != "energy") meanings[std::string(without_index(name))] = "invariant";
    return meanings;
}

}  // namespace hvi::gen
