// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/rotation_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "generator/read/rotations.hpp"

namespace hvi::gen {

namespace {

class RotationReader {
public:
    RotationReader(const TomlFile& file, const OwnArguments& own) : file_(file), own_(own) {}

    [[nodiscard]] std::vector<Expression> entries(const toml::node& node) const;

private:
    [[nodiscard]] std::vector<Expression> turn(const toml::table& table) const;
    [[nodiscard]] std::vector<Expression> parts(const toml::table& table, std::string_view key,
                                                std::size_t count) const;
    [[nodiscard]] Expression part(const toml::node& node, const Place& whole) const;

    const TomlFile& file_;
    const OwnArguments& own_;
};

constexpr const char* forms = "write \"identity\", nine numbers row by row, {axis = [0, 0, 1], "
                              "angle = \"pi/3\"} or {quaternion = [1, 0, 0, 0]}";

std::vector<Expression> RotationReader::entries(const toml::node& node) const {
    if (const auto* table = node.as_table()) return turn(*table);
    if (!node.is_string() || file_.text(node) != "identity")
        throw InputError("this is no rotation", file_.place(node), forms);
    return identity_rotation();
}

std::vector<Expression> RotationReader::turn(const toml::table& table) const {
    file_.check_keys(table, "rotation", {"axis", "angle", "quaternion"});
    if (table.contains("quaternion") == (table.contains("axis") || table.contains("angle")))
        throw InputError("a rotation has an axis and an angle, or a quaternion", file_.place(table),
                         forms);
    if (table.contains("quaternion")) return turn_of_quaternion(parts(table, "quaternion", 4));
    const toml::node* angle = table.get("angle");
    if (angle == nullptr) throw InputError("the angle is missing", file_.place(table), forms);
    return turn_about(parts(table, "axis", 3), part(*angle, file_.place(table)));
}

std::vector<Expression> RotationReader::parts(const toml::table& table, std::string_view key,
                                              std::size_t count) const {
    const toml::node* node = table.get(key);
    const auto* array = node == nullptr ? nullptr : node->as_array();
    if (array == nullptr || array->size() != count)
        throw InputError(fmt::format("`{}` is a list of {} numbers", key, count),
                         file_.place(node == nullptr ? table : *node));
    std::vector<Expression> result;
    for (const toml::node& each : *array) result.push_back(part(each, file_.place(table)));
    const auto is_zero = [](const Expression& x) { return x == Expression::integer(0); };
    if (std::all_of(result.begin(), result.end(), is_zero))
        throw InputError(fmt::format("zeros are no {}", key), file_.place(*node),
                         "its length is free, but not 0");
    return result;
}

/// Reads a piece of a value that has several, and places it at the whole value. NOTE: an expression
/// has one source, and pieces stand in texts of their own.
Expression RotationReader::part(const toml::node& node, const Place& whole) const {
    const auto move = [&](auto& self, Expression& moved) -> void {
        moved.range = whole.range;
        for (Expression& argument : moved.arguments) self(self, argument);
    };
    Expression result =
        parse_indexed_expression(file_.source(node, file_.text(node)), own_).written;
    move(move, result);
    return result;
}

}  // namespace

RotationValue rotation_in(const toml::node& node, const TomlFile& file, const OwnArguments& own) {
    RotationValue value;
    for (Expression& entry : RotationReader(file, own).entries(node))
        value.entries.push_back({std::move(entry), file.place(node).source});
    return value;
}

}  // namespace hvi::gen
