// The coefficients in the headers are, in each scalar, what fifty digits round to.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/coefficients/rounded.hpp>
#include <hvi/generated/chebyshev_3.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/gauss_2_separable.hpp>
#include <hvi/generated/gauss_3.hpp>
#include <hvi/generated/gauss_4.hpp>
#include <hvi/generated/lobatto_3.hpp>
#include <hvi/generated/lobatto_3_separable.hpp>
#include <hvi/generated/lobatto_4.hpp>
#include <hvi/generated/trig3.hpp>

#include "decimals.hpp"
#include "scalars.hpp"
#include "wide.hpp"

using namespace hvi::generated;
using scalars::Wide;

namespace {

/// A solver that solves nothing and keeps the coefficients that the stepper passes to it.
template <class T>
struct Spy {
    static constexpr int most_iterations = 1;
    static constexpr bool takes_starting_values = false;

    static inline std::vector<T> b;
    static inline std::vector<std::vector<T>> m, mt;
    static inline std::vector<T> hb;

    template <class Vector>
    class Iteration {
    public:
        template <class Coupled>
        [[nodiscard]] hvi::Status solve(Coupled coupled) {
            const std::size_t rows = coupled.s.Q.size();
            const std::size_t columns = coupled.s.P.size();
            m.assign(rows, std::vector<T>(columns));
            mt.assign(columns, std::vector<T>(rows));
            b.resize(columns);
            for (std::size_t j = 0; j < columns; ++j) {
                b[j] = Coupled::weight_q(j);
                for (std::size_t i = 0; i < rows; ++i) {
                    m[i][j] = Coupled::coefficient_q(i, j);
                    mt[j][i] = Coupled::coefficient_p(j, i);
                    static_assert(std::is_same_v<decltype(Coupled::coefficient_q(i, j)), T>);
                }
            }
            hb.assign(coupled.s.hb_q.begin(), coupled.s.hb_q.end());
            return hvi::Status(hvi::Status::Code::ok, 1);
        }
    };
};

template <class T>
T ulp(T value) {
    T result = scalars::eps<T>;
    if (value < 0) { value = -value; }
    for (; value >= 2; value /= 2) { result *= 2; }
    for (; value < 1 && value > 0; value *= 2) { result /= 2; }
    return result;
}

/// The uncertainty that fifty digits leave.
const Wide& slack() {
    static const Wide value("0." + std::string(47, '0') + "1");
    return value;
}

template <class T>
bool is_nearest(T value, const std::string& exact) {
    return (Wide::of(value) - Wide(exact)).absolute() <= Wide::of(ulp(value) / 2) + slack();
}

/// |m_ij - a_ij/b_j| is at most half a unit of the lattice. NOTE: times b_j, as nothing divides.
template <class T>
bool is_nearest_on_lattice(T m, const std::string& a, const std::string& b) {
    const T rest = 1 - m;
    const T unit = std::max(ulp(m), ulp(rest));
    const Wide error = (Wide::of(m) * Wide(b) - Wide(a)).absolute();
    return error <= Wide::of(unit / 2) * Wide(b) + slack();
}

template <class T>
void check_coefficients(const scalars::Decimals& exact) {
    using S = Spy<T>;
    REQUIRE(S::b.size() == exact.b.size());
    for (std::size_t i = 0; i < exact.b.size(); ++i) {
        INFO("i = " << i);
        CHECK(is_nearest(S::b[i], exact.b[i]));
        for (std::size_t j = 0; j < exact.b.size(); ++j) {
            INFO("j = " << j);
            CHECK(is_nearest_on_lattice(S::m[i][j], exact.A[i][j], exact.b[j]));
            CHECK((Wide::of(S::m[i][j]) + Wide::of(S::mt[j][i]) - Wide("1.0")).absolute() <=
                  Wide());
        }
    }
}

/// For weights that are no powers of two: they add up to h to the last bit, keep the symmetry, and
/// are h b_i to three units in the last place of h.
template <class T>
void check_weights(T h, const scalars::Decimals& exact) {
    using S = Spy<T>;
    Wide sum;
    for (std::size_t i = 0; i < exact.b.size(); ++i) {
        const T weight = S::hb[i];
        CHECK(weight == S::hb[exact.b.size() - 1 - i]);
        CHECK((Wide::of(weight) - Wide::of(h) * Wide(exact.b[i])).absolute() <=
              Wide::of(3 * ulp(h)));
        sum = sum + Wide::of(weight);
    }
    CHECK((sum - Wide::of(h)).absolute() <= Wide());
}

template <template <class, class> class Stepper, class T>
void check(const scalars::Decimals& exact, bool powers_of_two = false) {
    for (const T h : {scalars::ratio<T>(1, 10), scalars::ratio<T>(-3, 7), T(1)}) {
        Stepper<scalars::Oscillator<T>, Spy<T>> stepper;
        typename decltype(stepper)::State x{{T(1)}, {T(1)}};
        REQUIRE(stepper.step(x, h).ok());
        check_coefficients<T>(exact);
        if (!powers_of_two) { check_weights(h, exact); }
    }
}

}  // namespace

TEMPLATE_TEST_CASE("coefficients are correctly rounded", "", HVI_SCALARS) {
    check<Gauss2, TestType>(scalars::gauss_2, true);
    check<Gauss2Separable, TestType>(scalars::gauss_2, true);
    check<Gauss3, TestType>(scalars::gauss_3);
    check<Gauss4, TestType>(scalars::gauss_4);
    check<Lobatto3, TestType>(scalars::lobatto_3);
    check<Lobatto3Separable, TestType>(scalars::lobatto_3);
    check<Lobatto4, TestType>(scalars::lobatto_4);
    check<Trig3, TestType>(scalars::trig3);
    check<Chebyshev3, TestType>(scalars::chebyshev_3);
}

TEST_CASE("the parts of a number are put together without rounding") {
    // 1/3, of 24, 53, 64 and 113 bits.
    constexpr auto third = [](auto zero) {
        return hvi::detail::rounded<decltype(zero)>(0x1.555556p-2F, 0x1.5555555555555p-2,
                                                    0x1.558p-56, 0x1.5555555555555p-56, 0x1.5p-110);
    };
    CHECK(third(0.0F) == 1.0F / 3);
    CHECK(third(0.0) == 1.0 / 3);
    CHECK(third(0.0L) == 1.0L / 3);
#ifdef __SIZEOF_FLOAT128__
    CHECK(is_nearest(third(scalars::Quad(0)), "0." + std::string(60, '3')));
#endif
}
