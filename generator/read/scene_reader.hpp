// Reading a scene file: its sections and keys.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generator/read/column_file.hpp"
#include "generator/read/scene.hpp"
#include "generator/read/toml_file.hpp"

namespace hvi::gen {

/// Reads one file; its events and [time] are in scene_events.cpp, small steps of
/// [split] in small_steps.cpp, and the rest in scene_file.cpp.
class SceneReader {
public:
    explicit SceneReader(const Source& source) : source_(source), file_(source) {}

    [[nodiscard]] Scene read();

private:
    [[nodiscard]] const toml::node& required(std::string_view key, std::string_view example) const;
    [[nodiscard]] const toml::table* section(std::string_view key, std::string_view example) const;
    [[nodiscard]] std::string description() const;
    [[nodiscard]] NameTexts names(std::string_view key, std::string_view example) const;
    [[nodiscard]] IndexedExpression expression(const toml::node& node) const;
    [[nodiscard]] NamedIndexed named(std::string name, const toml::node& node) const;
    void refuse_to_come() const;
    void check_absent(std::string_view key, std::string_view other, std::string_view fault,
                      std::string_view help) const;
    void check_mechanics() const;
    void read_mechanics(Scene& scene);
    void read_variables(Scene& scene) const;
    [[nodiscard]] bool is_of_rotation(std::string_view name) const;
    [[nodiscard]] IndexedValue value(const TomlEntry& entry) const;
    [[nodiscard]] RuleName rule_name(const toml::key& key) const;
    [[nodiscard]] std::filesystem::path directory() const {
        return std::filesystem::path(source_.name).parent_path();
    }
    [[nodiscard]] ColumnFile column_file(const toml::table& table) const;
    [[nodiscard]] ValueList list(const toml::array& array) const;
    void append(ValueList& list, const toml::array& array, std::size_t depth) const;
    [[nodiscard]] std::vector<IndexedValue> parameters() const;
    [[nodiscard]] OwnFunctions own_functions() const;
    [[nodiscard]] OwnFunction own_function(const TomlEntry& entry) const;
    void check_apart(const Scene& scene) const;
    [[nodiscard]] std::vector<Definition> definitions() const;
    void read_invariants(Scene& scene) const;
    void add_invariant(Scene& scene, const TomlEntry& entry) const;
    [[nodiscard]] const toml::node& value_of_invariant(const toml::table& table) const;
    [[nodiscard]] SplitOfScene split() const;
    [[nodiscard]] SplitChoice orbit_coordinates(const toml::table& split) const;
    void read_small_steps(const toml::node& node, IndexedSplit& split) const;
    [[nodiscard]] std::set<std::string> fast_parts(const toml::node& node,
                                                   const IndexedSplit& split) const;
    [[nodiscard]] std::vector<IndexedField> fields() const;
    [[nodiscard]] ValueTable values(const toml::table& table) const;
    [[nodiscard]] std::vector<IndexedEvent> events() const;
    [[nodiscard]] IndexedEvent event(const TomlEntry& entry) const;
    [[nodiscard]] EventDirection direction(const toml::table& event) const;
    [[nodiscard]] long stop(const toml::table& event) const;
    [[nodiscard]] bool claims(const toml::table& table, std::string_view key) const;
    void read_time(Scene& scene) const;
    [[nodiscard]] IndexedScale scale(const toml::node& node) const;
    [[nodiscard]] IndexedRun run() const;

    const Source& source_;
    TomlFile file_;
    OwnArguments own_;
    std::vector<std::string> rotations_;  ///< their names without indices
};

}  // namespace hvi::gen
