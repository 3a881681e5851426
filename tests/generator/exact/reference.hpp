// The files of values that another computer algebra system computed.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tests/checkout.hpp"
#include "tests/generator/exact/exact.hpp"

namespace hvi::gen {

using Json = nlohmann::json;

/// A file below tests/generator.
inline Json reference(const std::string& name) {
    std::ifstream file(hvi::test::in_checkout("tests/generator/" + name));
    return Json::parse(file).at("methods");
}

inline Json reference_methods() { return reference("exact/reference.json"); }

inline Method method_of(const Json& entry) {
    if (entry.contains("method")) return method(entry["method"].get<std::string>());
    return method(entry["basis"].get<std::string>(), entry["nodes"].get<std::string>());
}

/// One unit of the last digit of a decimal: 0.3333 has 0.0001, and 1.99e-20 has 0.01e-20.
inline std::string last_unit(std::string decimal) {
    const std::size_t mantissa = std::min(decimal.find('e'), decimal.size());
    for (std::size_t i = 0; i < mantissa; ++i) {
        if (decimal[i] != '.') decimal[i] = i + 1 < mantissa ? '0' : '1';
    }
    return decimal;
}

/// Whether two decimals differ by one unit of the first one's last digit at most.
inline bool close(const std::string& left, const std::string& right) {
    const Ground ground(std::make_shared<Field>(Denominators{}));
    const Number a = read(left, ground);
    const Number b = read(right, ground);
    if (a.is_zero() || b.is_zero()) return a.is_zero() && b.is_zero();
    const Number unit = read(last_unit(left), ground);
    return (unit - (a - b)).sign() >= 0 && (unit + (a - b)).sign() >= 0;
}

}  // namespace hvi::gen
