// The analysis of frequencies, of functions that are known.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <functional>
#include <tuple>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/drive/frequencies.hpp"

using namespace hvi::gen;

namespace {

Samples sampled(std::size_t count, double first, double step,
                const std::function<double(double)>& f) {
    Samples samples{first, step, {}};
    for (std::size_t k = 0; k < count; ++k)
        samples.values.push_back(f(first + static_cast<double>(k) * step));
    return samples;
}

/// Three terms of frequencies with no common measure, and a mean.
double three_terms(double t) {
    return -7 + std::cos(t + 0.5) + 0.3 * std::cos(std::sqrt(2.0) * t - 2) +
           1e-6 * std::cos(3.3 * t + 1);
}

}  // namespace

TEST_CASE("a sum of three terms is found to round-off") {
    // An even count and an odd one, and time that goes back.
    for (const auto& [count, first, step] :
         {std::tuple(10'000U, 3.0, 0.1), std::tuple(1001U, 3.0, 0.1),
          std::tuple(4001U, -2.0, -0.2)}) {
        const std::vector<FrequencyTerm> terms =
            frequencies(sampled(count, first, step, three_terms), 10);
        CAPTURE(count);
        REQUIRE(terms.size() >= 4);
        CHECK(terms[0].frequency == 0);
        CHECK(terms[0].amplitude == Approx(7).epsilon(1e-13));
        CHECK(std::cos(terms[0].phase) == -1);
        CHECK(std::abs(terms[1].frequency - 1) < 1e-14);
        CHECK(std::abs(terms[1].amplitude - 1) < 1e-12);
        CHECK(std::abs(terms[1].phase - 0.5) < 1e-11);
        CHECK(std::abs(terms[2].frequency - std::sqrt(2.0)) < 1e-14);
        CHECK(std::abs(terms[2].phase + 2) < 1e-11);
        CHECK(std::abs(terms[3].frequency - 3.3) < 1e-10);
        CHECK(std::abs(terms[3].amplitude - 1e-6) < 1e-14);
        for (std::size_t k : {1U, 2U, 3U}) {
            const double exact[] = {0, 1, std::sqrt(2.0), 3.3};
            CHECK(std::abs(terms[k].frequency - exact[k]) <= terms[k].uncertainty);
            CHECK(terms[k].uncertainty < 1e-9);
        }
    }
}

TEST_CASE("terms come by their amplitudes, at most as many as are wished for") {
    const Samples samples = sampled(5000, 0, 0.1, [](double t) {
        double sum = 0;
        for (int k = 1; k <= 6; ++k) sum += k * std::cos(k * std::sqrt(2.0) * t / 2);
        return sum;
    });
    const std::vector<FrequencyTerm> terms = frequencies(samples, 4);
    REQUIRE(terms.size() == 5);
    for (std::size_t k = 1; k <= 4; ++k) {
        const auto number = static_cast<double>(7 - k);
        CHECK(terms[k].frequency == Approx(number * std::sqrt(2.0) / 2).margin(1e-5));
        CHECK(terms[k].amplitude == Approx(number).epsilon(1e-3));
    }
}

TEST_CASE("a series without an end is found to what is beyond the terms") {
    // 1/(1 - cos(t)/2) = sum of (2/sqrt(3)) (2 - sqrt(3))^|k| cos(k t), which ten terms do not end.
    const Samples samples =
        sampled(1 << 14, 0, 0.05, [](double t) { return 1 / (1 - std::cos(t) / 2); });
    const std::vector<FrequencyTerm> terms = frequencies(samples, 10);
    REQUIRE(terms.size() == 11);
    for (std::size_t k = 1; k <= 10; ++k) {
        const auto number = static_cast<double>(k);
        CAPTURE(k);
        CHECK(std::abs(terms[k].frequency - number) < terms[k].uncertainty);
        CHECK(std::abs(terms[k].frequency - number) < 1e-8);
        const double ratio = std::pow(2 - std::sqrt(3.0), number);
        CHECK(terms[k].amplitude == Approx(4 / std::sqrt(3.0) * ratio).epsilon(1e-5));
    }
}

TEST_CASE("the uncertainty shows a frequency that changes") {
    const Samples samples =
        sampled(20'000, 0, 0.05, [](double t) { return std::cos(t + 1e-6 * t * t); });
    const std::vector<FrequencyTerm> terms = frequencies(samples, 3);
    // 1 + 2e-6 t, whose mean is 1.001, and 1.0005 and 1.0015 in the halves.
    CHECK(terms[1].frequency == Approx(1.001).margin(1e-4));
    CHECK(terms[1].uncertainty == Approx(5e-4).epsilon(0.2));
}

TEST_CASE("numbers may be as large and as small as doubles are") {
    for (const double size : {1e300, 1e-300}) {
        const std::vector<FrequencyTerm> terms =
            frequencies(sampled(1001, 0, 0.1, [&](double t) { return size * std::cos(t); }), 3);
        REQUIRE(terms.size() >= 2);
        CHECK(std::abs(terms[1].frequency - 1) < 1e-14);
        CHECK(terms[1].amplitude == Approx(size));
    }
}

TEST_CASE("a constant has a mean alone, and so has what rounding makes of it") {
    CHECK(frequencies(sampled(1000, 0, 1, [](double) { return 0.1; }), 10).size() == 1);
    CHECK(frequencies(sampled(1000, 0, 1, [](double) { return 0.0; }), 10).size() == 1);
    const auto noisy = [](double t) { return 0.1 + 1e-17 * std::cos(t * t); };
    const std::vector<FrequencyTerm> terms = frequencies(sampled(1000, 0, 1, noisy), 10);
    REQUIRE(terms.size() == 1);
    CHECK(terms[0].amplitude == Approx(0.1).epsilon(1e-14));
}
