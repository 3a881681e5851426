// Parameters of a stepper as numbers in a row.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace hvi::detail {

/// Gives parameters their values, one after the other.
class ParameterReader {
public:
    ParameterReader(const double* values, std::size_t count) : values_(values), count_(count) {}

    template <class Scalar>
    void number(Scalar& parameter) {
        double value = 0;
        if (next(value)) { parameter = static_cast<Scalar>(value); }
    }

    /// A positive whole number, which ranges are made of.
    void size(std::ptrdiff_t& parameter) {
        constexpr double most = std::numeric_limits<int>::max();
        double value = 0;
        if (!next(value)) { return; }
        are_right_ = are_right_ && value >= 1 && value <= most && value == std::floor(value);
        if (are_right_) { parameter = static_cast<std::ptrdiff_t>(value); }
    }

    /// Whether nothing is left, so that lists stay as they are.
    [[nodiscard]] bool is_at_end() const { return read_ == count_; }

    /// A list of so many numbers.
    template <class List>
    void list(List& parameter, std::size_t size) {
        if (size > count_ - read_) {
            has_enough_ = false;
            return;
        }
        parameter.resize(size);
        for (auto& each : parameter) { number(each); }
    }

    /// How many each of these lists has that are equally long, where nothing else follows.
    [[nodiscard]] std::size_t share(std::size_t lists) {
        has_enough_ = has_enough_ && (count_ - read_) % lists == 0;
        return (count_ - read_) / lists;
    }

    /// Whether there were as many as were read.
    [[nodiscard]] bool is_count_right() const { return has_enough_ && read_ == count_; }
    /// Whether each of those is a number that it may be.
    [[nodiscard]] bool are_right() const { return are_right_; }

private:
    bool next(double& value) {
        if (read_ == count_) {
            has_enough_ = false;
            return false;
        }
        value = values_[read_++];
        are_right_ = are_right_ && std::isfinite(value);
        return true;
    }

    const double* values_;
    std::size_t count_, read_ = 0;
    bool has_enough_ = true, are_right_ = true;
};

}  // namespace hvi::detail
