// Exact integers: GiNaC's as text, and FLINT's with value semantics.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <flint/fmpz.h>
#include <ginac/ginac.h>

#include <sstream>
#include <string>

#include "generator/support/error.hpp"

namespace hvi::gen {

/// An exact rational as `7` or `-2/3`.
[[nodiscard]] inline std::string digits(const GiNaC::numeric& rational) {
    std::ostringstream text;
    text << rational;
    return text.str();
}

/// FLINT's integer.
class Integer {
public:
    Integer() { fmpz_init(value_); }
    explicit Integer(const GiNaC::numeric& integer) : Integer() {
        if (integer.int_length() < 63) {
            fmpz_set_si(value_, integer.to_long());
            return;
        }
        const bool read = fmpz_set_str(value_, digits(integer).c_str(), 10) == 0;
        HVI_CHECK(read);
    }
    Integer(const Integer& other) { fmpz_init_set(value_, other.value_); }
    Integer(Integer&& other) noexcept : Integer() { fmpz_swap(value_, other.value_); }
    Integer& operator=(Integer other) noexcept {
        fmpz_swap(value_, other.value_);
        return *this;
    }
    ~Integer() { fmpz_clear(value_); }

    [[nodiscard]] fmpz* get() { return value_; }
    [[nodiscard]] const fmpz* get() const { return value_; }
    [[nodiscard]] std::string text() const {
        char* const digits = fmpz_get_str(nullptr, 10, value_);
        std::string result(digits);
        flint_free(digits);
        return result;
    }
    [[nodiscard]] GiNaC::numeric value() const {
        if (fmpz_fits_si(value_) != 0) { return fmpz_get_si(value_); }
        return GiNaC::numeric(text().c_str());
    }

private:
    fmpz_t value_;
};

}  // namespace hvi::gen
