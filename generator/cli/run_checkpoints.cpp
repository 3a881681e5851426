// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_checkpoints.hpp"

#include <fmt/format.h>

#include <variant>

#include "generator/module/driven.hpp"
#include "generator/read/file.hpp"
#include "generator/support/digest.hpp"
#include "generator/support/version.hpp"

namespace hvi::gen {

namespace {

constexpr std::size_t most_bytes = std::size_t(1) << 30;

/// Returns the texts of an event's parts.
std::string text_of(const IndexedEvent& event) {
    std::string text = fmt::format("event {} {} {} {}\n", event.name, event.zero.source->text,
                                   static_cast<int>(event.direction), event.stop);
    for (const auto* span : {&event.cooldown, &event.period})
        text += *span ? (*span)->source->text + "\n" : "-\n";
    if (!event.set) return text;
    for (const IndexedValue& value : event.set->values) {
        const auto* written = std::get_if<IndexedExpression>(&value.value);
        text += value.name + " = " + (written == nullptr ? "" : written->source->text) + "\n";
    }
    return text;
}

}  // namespace

std::string text_of(const std::vector<IndexedEvent>& events) {
    std::string text;
    for (const IndexedEvent& event : events) text += text_of(event);
    return text;
}

std::string key_of(const WishedRun& run, const TableWishes& table) {
    std::string text = fmt::format("hvi-gen {}\n{}\nstep {}\nevery {} format {} numbers {}\n",
                                   version, run.stepper.header, run.steps.size, table.every,
                                   static_cast<int>(table.format), static_cast<int>(table.numbers));
    for (const double number : driven_system(run.stepper.system).numbers)
        text += fmt::format("{}\n", number);
    for (const double time : table.times) text += fmt::format("at {}\n", time);
    for_each_column(table.columns, [&](const std::string& name, std::size_t number) {
        text += fmt::format("column {} {}\n", name, number);
    });
    for (const Reduction& each : run.reductions) text += each.name + "\n";
    return digest(text + run.events_text);
}

std::optional<CheckpointWishes> wished_checkpoints(const CheckpointOptions& options,
                                                   const std::string& key) {
    constexpr double usual_minutes = 10;
    if (!options.file) return {};
    CheckpointWishes wishes{.file = options.file->text, .key = key};
    if (options.every) wishes.every = *options.every;
    if (!options.every) wishes.minutes = options.minutes.value_or(usual_minutes);
    return wishes;
}

std::optional<Checkpoint> resumed_checkpoint(const CheckpointOptions& options,
                                             const std::string& key) {
    if (!options.resume) return {};
    const std::filesystem::path file = options.resume->text;
    return last_checkpoint(read_file(file, most_bytes), key, file);
}

}  // namespace hvi::gen
