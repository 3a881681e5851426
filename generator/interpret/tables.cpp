// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/interpret/tables.hpp"

#include <cstddef>
#include <optional>

#include "generator/emit/text/constants.hpp"
#include "generator/ir/equal.hpp"
#include "generator/support/error.hpp"

namespace hvi::gen {

double as_double(const Rounded& value) {
    constexpr std::size_t of_double = 1;
    const std::optional<Dyadic>& rounded = value[of_double];
    HVI_CHECK(rounded.has_value());  // or the header of the stepper could not be written
    return rounded->to_double();
}

Doubles as_doubles(const std::vector<Rounded>& values) {
    Doubles result;
    for (const Rounded& value : values) result.push_back(as_double(value));
    return result;
}

DoubleMatrix as_doubles(const RoundedMatrix& values) {
    DoubleMatrix result;
    for (const std::vector<Rounded>& row : values) result.push_back(as_doubles(row));
    return result;
}

Doubles weights_of(const std::vector<StageValue>& values) {
    Doubles result;
    for (const StageValue& value : values) result.push_back(as_double(nearest(value.weight)));
    return result;
}

Doubles times_of(const Step& step) {
    Doubles result;
    for (const Number& c : step.c) result.push_back(as_double(nearest(c)));
    return result;
}

DoubleMatrix rough_doubles(const NumberMatrix& exact) {
    DoubleMatrix result;
    for (const NumberVector& row : exact) {
        Doubles& doubles = result.emplace_back();
        for (const Number& entry : row) doubles.push_back(as_double(rough_value(entry)));
    }
    return result;
}

WeightedSum::WeightedSum(const NumberVector& exact, const Doubles& values) {
    for (std::size_t k = 0; k < exact.size(); ++k)
        if (!equal(exact[k], 0)) terms_.push_back({k, values[k]});
}

}  // namespace hvi::gen
