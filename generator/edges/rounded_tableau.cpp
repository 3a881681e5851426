// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/rounded_tableau.hpp"

#include "generator/exact/numbers/exact_number.hpp"

namespace hvi::gen {

RoundedTableau rounded_entries(const ButcherPair& pair) {
    const std::size_t s = pair.stages();
    RoundedTableau result{{static_cast<double>(s)}, true};
    const auto rounded = [&](const Number& entry) {
        result.words.push_back(entry.nearest_double());
        return exact_number(result.words.back());
    };
    NumberMatrix A(s), A_tilde(s);
    NumberVector b;
    for (std::size_t i = 0; i < s; ++i)
        for (const Number& entry : pair.A[i]) A[i].push_back(rounded(entry));
    for (std::size_t i = 0; i < s; ++i)
        for (const Number& entry : pair.A_tilde[i]) A_tilde[i].push_back(rounded(entry));
    for (const Number& entry : pair.b) b.push_back(rounded(entry));
    for (std::size_t i = 0; i < s; ++i)
        for (std::size_t j = 0; j < s; ++j)
            if ((b[i] * A_tilde[i][j] + b[j] * A[j][i] - b[i] * b[j]).sign() != 0)
                result.is_symplectic = false;
    return result;
}

}  // namespace hvi::gen
