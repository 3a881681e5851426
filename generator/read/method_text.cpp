// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/method.hpp"

namespace hvi::gen {
namespace {

std::string text(const Item& item) {
    if (const auto* family = std::get_if<Family>(&item.what)) {
        return family->name + ":" + std::to_string(family->size);
    }
    return to_text(std::get<Expression>(item.what));
}

std::string lines(const std::string& name, const List& list) {
    std::string result;
    for (const Item& item : list.items) { result += name + ": " + text(item) + "\n"; }
    return result;
}

}  // namespace

std::string dump(const Method& method) {
    std::string result = "method: " + (method.name.empty() ? method.origin : method.name) + "\n";
    result += lines("basis", method.basis) + lines("node", method.nodes);
    if (method.weights) { result += lines("weight", *method.weights); }
    for (const Parameter& parameter : method.parameters) {
        result += "parameter " + parameter.name + ": " + to_text(parameter.value) + "\n";
    }
    return result;
}

}  // namespace hvi::gen
