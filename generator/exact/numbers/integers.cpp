// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/exact/numbers/integers.hpp"

#include "generator/support/error.hpp"

namespace hvi::gen {

std::string Integer::text() const {
    char* const digits = fmpz_get_str(nullptr, 10, value_);
    std::string result(digits);
    flint_free(digits);
    return result;
}

long Integer::to_long() const {
    HVI_CHECK(fmpz_fits_si(value_) != 0);
    return fmpz_get_si(value_);
}

}  // namespace hvi::gen
