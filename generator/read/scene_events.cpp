// The sections [events] and [time] of a scene file.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include "generator/read/scene_reader.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_events = 64;

}  // namespace

EventDirection SceneReader::direction(const toml::table& event) const {
    const toml::node* node = event.get("direction");
    if (node == nullptr) return EventDirection::both;
    const std::string_view word = node->value_or(std::string_view());
    if (word == "up") return EventDirection::up;
    if (word == "down") return EventDirection::down;
    if (word == "both") return EventDirection::both;
    throw InputError("this is no direction", file_.place(*node),
                     "write \"up\", \"down\" or \"both\"");
}

/// Returns the number of the event that ends the run: `stop = 3`; true is 1, and 0 is none.
long SceneReader::stop(const toml::table& event) const {
    const toml::node* node = event.get("stop");
    if (node == nullptr) return 0;
    if (const auto* flag = node->as_boolean()) return flag->get() ? 1 : 0;
    const auto* number = node->as_integer();
    if (number != nullptr && number->get() >= 1) return static_cast<long>(number->get());
    throw InputError("true, or which of the events ends the run, is wanted here",
                     file_.place(*node), "write stop = true, or stop = 3 for the third");
}

bool SceneReader::claims(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (node == nullptr) return false;
    if (const auto* flag = node->as_boolean()) return flag->get();
    throw InputError("true or false is wanted here", file_.place(*node));
}

IndexedEvent SceneReader::event(const TomlEntry& entry) const {
    const Place place = file_.place(entry.first->source());
    const auto* table = entry.second->as_table();
    if (table == nullptr || table->get("zero") == nullptr)
        throw InputError("this event does not say where it is", place,
                         "write a section [events.NAME] with zero = \"y\"");
    file_.check_keys(*table, "event",
                     {"zero", "direction", "stop", "set", "canonical", "cooldown", "period"});
    IndexedEvent event{.name = std::string(entry.first->str()),
                       .place = place,
                       .zero = expression(*table->get("zero")),
                       .direction = direction(*table),
                       .stop = stop(*table)};
    if (const toml::node* node = table->get("set")) {
        const auto* jumps = node->as_table();
        if (jumps == nullptr || jumps->empty())
            throw InputError("this says nothing of what jumps", file_.place(*node),
                             "write the new values of variables: set = {px = \"-px\"}");
        event.set = values(*jumps);
    }
    if (claims(*table, "canonical")) event.canonical = file_.place(*table->get("canonical"));
    if (const toml::node* node = table->get("cooldown")) event.cooldown = expression(*node);
    if (const toml::node* node = table->get("period")) event.period = expression(*node);
    return event;
}

std::vector<IndexedEvent> SceneReader::events() const {
    std::vector<IndexedEvent> list;
    const toml::table* table = section("events", "crossing = {zero = \"y\"}");
    if (table == nullptr) return list;
    for (const TomlEntry& entry : in_order(*table)) {
        list.push_back(event(entry));
        if (list.size() > most_events)
            throw InputError(fmt::format("there are more than {} events", most_events),
                             list.back().place);
    }
    return list;
}

void SceneReader::read_time(Scene& scene) const {
    const toml::table* table = section("time", "scale = \"x^2 + y^2\"");
    if (table == nullptr) return;
    file_.check_keys(*table, "section [time]", {"scale", "kinks"});
    if (const toml::node* node = table->get("kinks")) {
        if (node->value_or(std::string_view()) != "events")
            throw InputError("kinks are \"events\", or nothing is said of them",
                             file_.place(*node));
        scene.kinks = file_.place(*node);
    }
    if (const toml::node* node = table->get("scale")) scene.scale = scale(*node);
    if (!scene.kinks && !scene.scale)
        throw InputError("there is no scale", file_.place(*table),
                         fmt::format("it is an expression, or one of {}", names_of_scales));
}

IndexedScale SceneReader::scale(const toml::node& node) const {
    IndexedScale scale{.kind = TimeScale::expression, .expression = {}, .place = file_.place(node)};
    const std::string_view word = node.value_or(std::string_view());
    if (word == "logarithmic") scale.kind = TimeScale::logarithmic;
    if (word == "arclength") scale.kind = TimeScale::arclength;
    if (word == "potential") scale.kind = TimeScale::potential;
    if (word == "distance") scale.kind = TimeScale::distance;
    if (scale.kind == TimeScale::expression) scale.expression = expression(node);
    return scale;
}

}  // namespace hvi::gen
