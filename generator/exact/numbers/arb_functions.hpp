// Functions of functions.def that Arb does not have, or has under other names.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <acb.h>
#include <acb_hypgeom.h>
#include <arb.h>
#include <arb_hypgeom.h>

#include <initializer_list>

namespace hvi::gen {

inline void arb_log10(arb_t y, const arb_t x, slong bits) { arb_log_base_ui(y, x, 10, bits); }

/// Computes the real cube root. NOTE: cbrt(-x) is -cbrt(x); a ball that contains 0 is enclosed by
/// the cube roots of its ends.
inline void arb_cbrt(arb_t y, const arb_t x, slong bits) {
    if (arb_is_nonnegative(x)) {
        arb_root_ui(y, x, 3, bits);
        return;
    }
    arb_t low, high;
    arb_init(low);
    arb_init(high);
    arb_get_lbound_arf(arb_midref(low), x, bits);
    arb_get_ubound_arf(arb_midref(high), x, bits);
    for (const arb_ptr end : {low, high}) {
        const bool negative = arb_is_negative(end) != 0;
        arb_abs(end, end);
        arb_root_ui(end, end, 3, bits);
        if (negative) { arb_neg(end, end); }
    }
    arb_union(y, low, high, bits);
    arb_clear(low);
    arb_clear(high);
}

inline void arb_erf(arb_t y, const arb_t x, slong bits) { arb_hypgeom_erf(y, x, bits); }
inline void arb_erfc(arb_t y, const arb_t x, slong bits) { arb_hypgeom_erfc(y, x, bits); }

inline void acb_log10(acb_t y, const acb_t x, slong bits) {
    arb_t ten;
    arb_init(ten);
    arb_const_log10(ten, bits);
    acb_log(y, x, bits);
    acb_div_arb(y, y, ten, bits);
    arb_clear(ten);
}

/// Computes the principal cube root. NOTE: that of a basis is of an argument that is not negative.
inline void acb_cbrt(acb_t y, const acb_t x, slong bits) { acb_root_ui(y, x, 3, bits); }

inline void acb_erf(acb_t y, const acb_t x, slong bits) { acb_hypgeom_erf(y, x, bits); }
inline void acb_erfc(acb_t y, const acb_t x, slong bits) { acb_hypgeom_erfc(y, x, bits); }

}  // namespace hvi::gen
