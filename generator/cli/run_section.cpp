// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_section.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace hvi::gen {

namespace {

/// Columns of a table of events: the name, the number, the time, and the variables.
constexpr std::size_t column_of_time = 3, first_variable = 4;

/// Returns the names in the boxes, one by one.
std::vector<std::string> all_names(const std::vector<NameBox>& boxes) {
    std::vector<std::string> names;
    for (std::string name = name_at(boxes, 0); !name.empty(); name = name_at(boxes, names.size()))
        names.push_back(name);
    return names;
}

}  // namespace

std::optional<SectionAxes> section_axes(const WrittenOutScene& scene, const RunSubject& subject) {
    const std::vector<std::string> coordinates = all_names(subject.coordinates),
                                   momenta = all_names(subject.momenta);
    const auto is_axis = [&](const std::string& name) {
        return std::none_of(scene.events.begin(), scene.events.end(), [&](const SceneEvent& event) {
            return to_text(event.zero.expression) == name;
        });
    };
    if (scene.events.empty() || coordinates.size() != momenta.size()) return {};
    for (std::size_t k = 0; k < coordinates.size(); ++k)
        if (is_axis(coordinates[k]))
            return {{{first_variable + k, coordinates[k]},
                     {first_variable + coordinates.size() + k, momenta[k]}}};
    return {{{column_of_time, "t"}, {first_variable + coordinates.size(), momenta.front()}}};
}

SectionPicture section_of(std::string title, const SectionAxes& axes, const EventWishes& wishes,
                          const Simulation& run) {
    SectionPicture picture{std::move(title), {}, 0, {}, axes.x, axes.y};
    for (std::size_t i = 0; i < run.events.size(); ++i) {
        if (run.events[i] == 0 || wishes.events[i].event.is_kink) continue;
        picture.rows += run.events[i];
        picture.events.push_back(wishes.events[i].name);
    }
    return picture;
}

}  // namespace hvi::gen
