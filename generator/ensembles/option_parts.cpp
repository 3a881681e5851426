// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/option_parts.hpp"

#include <fmt/format.h>

#include "generator/read/token.hpp"
#include "generator/scene/step_count.hpp"

namespace hvi::gen {

NamedPart named_part(const Given& text, const std::string& form, const std::string& example) {
    const std::string& all = text->text;
    const std::size_t end = std::min(all.find('='), all.size());
    const Range name = trimmed(all, {0, end});
    if (end == all.size() || name.begin == name.end)
        throw InputError(fmt::format("{} is wanted here", form), whole(text),
                         "for example " + example);
    return {
        all.substr(name.begin, name.end - name.begin), Place{text, name}, {end + 1, all.size()}};
}

double value_of_part(const Given& text, Range part, const SceneTimes& scene) {
    const Range within = trimmed(text->text, part);
    return nearest_value(scene, expression_of_parameters(scene, text->name, Place{text, within}));
}

}  // namespace hvi::gen
