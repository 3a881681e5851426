// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "generator/emit/header.hpp"

namespace hvi::gen {
namespace {

void entries(Writer& writer, const std::vector<Constant>& row) {
    std::size_t width = 0;
    for (const Constant& entry : row) { width = std::max(width, literal(entry.value).size()); }
    for (const Constant& entry : row) {
        const std::string number = literal(entry.value) + ",";
        const std::string meaning = entry.name + " = " + entry.exact;
        const std::string line = fmt::format("{:<{}}  // {}", number, width + 1, meaning);
        // NOTE: at most four braces are open around a table.
        if (line.size() <= page_width - 16) {
            writer.line("{}", line);
        } else {
            writer.comment(meaning).line("{}", number);
        }
    }
}

}  // namespace

void table(Writer& writer, std::string_view name, const std::vector<Constant>& row) {
    writer.open("static constexpr double {}[{}] = {{", name, row.size());
    entries(writer, row);
    writer.close("};");
}

void table(Writer& writer, std::string_view name, const std::vector<std::vector<Constant>>& rows) {
    writer.open("static constexpr double {}[{}][{}] = {{", name, rows.size(), rows.front().size());
    for (const auto& row : rows) {
        writer.open("{{");
        entries(writer, row);
        writer.close("},");
    }
    writer.close("};");
}

std::vector<Constant> weights(const std::vector<StageValue>& values) {
    std::vector<Constant> result;
    for (const StageValue& value : values) {
        std::string name;
        for (const std::size_t stage : value.stages) {
            name += fmt::format("{}b_{}", name.empty() ? "" : "+", stage + 1);
        }
        result.push_back({name, value.weight.nearest_double(), exact_text(value.weight)});
    }
    return result;
}

}  // namespace hvi::gen
