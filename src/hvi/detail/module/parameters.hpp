// Parameters of a stepper as numbers in a row.
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace hvi::detail {

/// Reader of parameters, one after the other.
class ParameterReader {
public:
    ParameterReader(const double* values, std::size_t count) : values_(values), count_(count) {}

    template <class Scalar>
    void number(Scalar& parameter) {
        double value = 0;
        if (next(value)) { parameter = static_cast<Scalar>(value); }
    }

    /// Reads a positive whole number, which ranges are made of.
    void size(std::ptrdiff_t& parameter) {
        constexpr double most = std::numeric_limits<int>::max();
        double value = 0;
        if (!next(value)) { return; }
        are_right_ = are_right_ && value >= 1 && value <= most && value == std::floor(value);
        if (are_right_) { parameter = static_cast<std::ptrdiff_t>(value); }
    }

    /// Returns whether nothing is left, so that lists stay as they are.
    [[nodiscard]] bool is_at_end() const { return read_ == count_; }

    /// Reads a list of `size` numbers.
    template <class List>
    void list(List& parameter, std::size_t size) {
        if (size > count_ - read_) {
            has_enough_ = false;
            return;
        }
        parameter.resize(size);
        for (auto& each : parameter) { number(each); }
    }

    /// Returns how many of the remaining numbers each of `lists` equally long lists gets.
    [[nodiscard]] std::size_t share(std::size_t lists) {
        has_enough_ = has_enough_ && (count_ - read_) % lists == 0;
        return (count_ - read_) / lists;
    }

    /// Returns whether there were as many numbers as were read.
    [[nodiscard]] bool is_count_right() const { return has_enough_ && read_ == count_; }
    /// Returns whether each number that was read is a valid value.
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
