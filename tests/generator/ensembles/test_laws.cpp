// Values at random.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/ensembles/laws.hpp"
#include "tests/generator/ensembles/scene_of_options.hpp"
#include "tests/generator/read/refusal.hpp"

using namespace hvi::gen;

namespace {

using Words = std::array<std::uint32_t, 4>;

/// Philox4x32-10 as the paper of Salmon et al. (2011), Section 3.3, defines it.
Words philox(Words counter, std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t first = std::uint64_t{0xD2511F53} * counter[0];
        const std::uint64_t second = std::uint64_t{0xCD9E8D57} * counter[2];
        counter = {static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0],
                   static_cast<std::uint32_t>(second),
                   static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1],
                   static_cast<std::uint32_t>(first)};
        key = {key[0] + 0x9E3779B9, key[1] + 0xBB67AE85};
    }
    return counter;
}

Law read_law(const std::string& text) { return law(given("--random", text), scene_of_options()); }

Refusal law_refused(const std::string& text) {
    return refusal([&] { return read_law(text); });
}

constexpr int sample_size = 100'000;

std::vector<double> samples(const Law& law, std::uint64_t seed, std::uint32_t number) {
    std::vector<double> values;
    for (std::int64_t row = 0; row < sample_size; ++row)
        values.push_back(sample(law, seed, row, number));
    return values;
}

/// The largest distance between the distribution of the values and its function, times the root
/// of their number: Kolmogorov's statistic.
template <class Function>
double kolmogorov(std::vector<double> values, Function&& below) {
    std::sort(values.begin(), values.end());
    const auto count = static_cast<double>(values.size());
    double most = 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double expected = below(values[k]), before = static_cast<double>(k) / count;
        most = std::max({most, expected - before, before + 1 / count - expected});
    }
    return most * std::sqrt(count);
}

double mean_of_products(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
    return sum / static_cast<double>(a.size());
}

// Beyond this a right sample goes once in a thousand seeds: 2*exp(-2*x^2) = 1/1000.
constexpr double most_kolmogorov = 1.95;
const double four_errors = 4 / std::sqrt(double{sample_size});

}  // namespace

// From the file kat_vectors of Random123.
TEST_CASE("the counter function of the tests has the known answers of Random123") {
    CHECK(philox({0, 0, 0, 0}, {0, 0}) == Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
    CHECK(philox({~0U, ~0U, ~0U, ~0U}, {~0U, ~0U}) ==
          Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
    CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
          Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("numbers at random are those of Philox, with row and number as counter") {
    CHECK(uniform_number(0, 0, 0) == (double{0xe169c58d6627eULL} + 0.5) / double{1ULL << 52});
    for (const std::uint64_t seed : {0ULL, 1ULL, 0x299f31d0a4093822ULL})
        for (const std::int64_t row : {0LL, 1LL, 0x85a308d3243f6a8LL, -1LL})
            for (const std::uint32_t number : {0U, 1U, 0x13198a2eU}) {
                const auto wide = static_cast<std::uint64_t>(row);
                const Words words = philox(
                    {static_cast<std::uint32_t>(wide), static_cast<std::uint32_t>(wide >> 32),
                     number, 0},
                    {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
                const std::uint64_t bits = words[1] * (1ULL << 32) + words[0];
                CHECK(uniform_number(seed, row, number) == between_0_and_1(bits));
            }
}

TEST_CASE("a number at random is never 0 or 1") {
    CHECK(between_0_and_1(0) == std::ldexp(1.0, -53));
    CHECK(between_0_and_1(~0ULL) == 1 - std::ldexp(1.0, -53));
    CHECK(between_0_and_1(1ULL << 63) == 0.5 + std::ldexp(1.0, -53));
    for (const double part : {between_0_and_1(0), between_0_and_1(~0ULL)}) {
        const double value = quantile({"x", Normal{}, {}}, part);
        CHECK(std::abs(value) == Approx(8.209536151601387).epsilon(1e-14));
        CHECK(std::erfc(std::abs(value) / std::sqrt(2.0)) / 2 ==
              Approx(std::ldexp(1.0, -53)).epsilon(1e-12));
        const double within = quantile({"x", Uniform{-1e308, 1e308}, {}}, part);
        CHECK(std::abs(within) <= 1e308);
    }
}

TEST_CASE("quantiles of laws are known") {
    const Law normal{"x", Normal{10, 2}, {}};
    CHECK(quantile(normal, 0.5) == 10);
    // Abramowitz and Stegun, Table 26.5: 1.95996 for a quarter of a tenth above.
    CHECK(quantile(normal, 0.975) == Approx(10 + 2 * 1.959963984540054).epsilon(1e-15));
    CHECK(quantile(normal, 0.025) == Approx(10 - 2 * 1.959963984540054).epsilon(1e-15));
    CHECK(quantile({"x", Normal{3, 0}, {}}, 0.1) == 3);
    CHECK(quantile({"x", Uniform{1, 5}, {}}, 0.25) == 2);
    CHECK(quantile({"x", Uniform{0.1, 0.1}, {}}, 0.7) == 0.1);
}

TEST_CASE("a value does not depend on those of other rows") {
    const Law law{"x", Normal{}, {}};
    const std::vector<double> forward = samples(law, 7, 3);
    for (const std::int64_t row : {99'999LL, 5LL, 50'000LL})
        CHECK(sample(law, 7, row, 3) == forward[static_cast<std::size_t>(row)]);
    CHECK(sample(law, 7, 0, 3) != sample(law, 8, 0, 3));
    CHECK(sample(law, 7, 0, 3) != sample(law, 7, 0, 4));
}

TEST_CASE("values by a uniform law are spread evenly") {
    const std::vector<double> values = samples({"x", Uniform{-1, 3}, {}}, 2024, 0);
    CHECK(kolmogorov(values, [](double x) { return (x + 1) / 4; }) < most_kolmogorov);
    const std::vector<double> ones(values.size(), 1);
    // The variance of the values is 16/12, their fourth central moment 256/80.
    CHECK(std::abs(mean_of_products(values, ones) - 1) < std::sqrt(16.0 / 12) * four_errors);
    const double variance =
        mean_of_products(values, values) - std::pow(mean_of_products(values, ones), 2);
    CHECK(std::abs(variance - 16.0 / 12) < std::sqrt(256.0 / 80 - 256.0 / 144) * four_errors);
    CHECK(*std::min_element(values.begin(), values.end()) > -1);
    CHECK(*std::max_element(values.begin(), values.end()) < 3);
}

TEST_CASE("values by a normal law have its moments, and are independent") {
    const std::vector<double> values = samples({"x", Normal{}, {}}, 99, 1);
    CHECK(kolmogorov(values, [](double x) { return std::erfc(-x / std::sqrt(2.0)) / 2; }) <
          most_kolmogorov);
    const std::vector<double> ones(values.size(), 1);
    CHECK(std::abs(mean_of_products(values, ones)) < four_errors);
    CHECK(std::abs(mean_of_products(values, values) - 1) < std::sqrt(2.0) * four_errors);
    std::vector<double> squares;
    for (const double x : values) squares.push_back(x * x);
    // The moments of orders 3, 4 and 8 are 0, 3 and 105.
    CHECK(std::abs(mean_of_products(squares, values)) < std::sqrt(15.0) * four_errors);
    CHECK(std::abs(mean_of_products(squares, squares) - 3) < std::sqrt(96.0) * four_errors);
    // With another number, another seed and the row before.
    const std::vector<double> shifted(values.begin() + 1, values.end());
    CHECK(std::abs(mean_of_products(shifted, values)) < four_errors);
    for (const auto& others :
         {samples({"y", Normal{}, {}}, 99, 2), samples({"y", Normal{}, {}}, 100, 1)})
        CHECK(std::abs(mean_of_products(values, others)) < four_errors);
}

TEST_CASE("a law is a name and two numbers of parameters") {
    const Law normal = read_law("x=normal(0, 1e-3)");
    CHECK(normal.name == "x");
    CHECK(std::get<Normal>(normal.kind).mean == 0);
    CHECK(std::get<Normal>(normal.kind).deviation == 1e-3);
    CHECK(normal.place.range.end == 1);
    const Law uniform = read_law(" u[1,2] = uniform ( -m[2]*(w + 1) , max(1, w) ) ");
    CHECK(uniform.name == "u[1,2]");
    CHECK(std::get<Uniform>(uniform.kind).from == static_cast<double>(-std::sqrt(2.0L) * 4 / 3));
    CHECK(std::get<Uniform>(uniform.kind).to == 1);
    CHECK(std::get<Normal>(read_law("x=normal(w,0)").kind).deviation == 0);
}

TEST_CASE("what is wrong with a law is said where it is") {
    CHECK(law_refused("normal(0, 1)").what == "NAME=LAW is wanted here");
    CHECK(law_refused("normal(0, 1)").helps("--random \"x=normal(0, 1e-3)\""));
    for (const std::string text : {"0", "normal", "normal(0, 1", "(0, 1)x", ""}) {
        const Refusal form = law_refused("x=" + text);
        CHECK(form.status == 2);
        CHECK(form.marked == "x=[" + text + "]");
    }
    const Refusal word = law_refused("x=nromal(0, 1)");
    CHECK(word.what == "there is no law `nromal`");
    CHECK(word.marked == "x=[nromal](0, 1)");
    CHECK(word.helps("did you mean `normal`?"));
    CHECK(law_refused("x=poisson(0, 1)").helps("uniform(FROM, TO)"));
    CHECK(law_refused("x=normal(0)").what == "`normal` has two numbers");
    CHECK(law_refused("x=normal(0)").marked == "x=normal([0])");
    CHECK(law_refused("x=uniform(0, 1, 2)").marked == "x=uniform([0, 1, 2])");
    CHECK(law_refused("x=normal(0, -w)").what == "a standard deviation is not negative");
    CHECK(law_refused("x=normal(0, -w)").marked == "x=normal(0, [-w])");
    CHECK(law_refused("x=uniform(1, w)").what == "the second number is below the first one");
    CHECK(law_refused("x=uniform(1, w)").marked == "x=uniform(1, [w])");
    CHECK(law_refused("x=normal(v, 1)").marked == "x=normal([v], 1)");
    CHECK(law_refused("x=normal(, 1)").status == 2);
    CHECK(law_refused("x=normal(0, 10^400)").what == "this number is beyond the range of doubles");
}
