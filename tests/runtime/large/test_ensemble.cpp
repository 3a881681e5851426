// Ensembles of scenes of any size: one trajectory a thread.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/ensemble.hpp>
#include <large/chain.hpp>
#include <large/chain_gauss.hpp>
#include <large/masses.hpp>
#include <large/membrane.hpp>
#include <large/toda.hpp>

namespace {

using Vector = std::vector<double>;
using State = hvi::State<Vector>;
using Code = hvi::Status::Code;
namespace generated = hvi::generated;

constexpr double h = 0.02;

bool same_bits(const Vector& a, const Vector& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

bool same_bits(const State& a, const State& b) {
    return same_bits(a.q, b.q) && same_bits(a.p, b.p);
}

/// The start of the scene, with momenta that differ.
template <class Stepper>
std::vector<State> starts(const typename Stepper::Parameters& parameters, std::size_t count) {
    std::vector<State> result(count, Stepper::initial(parameters));
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < result[i].p.size(); ++k) {
            result[i].p[k] += 0.1 * std::sin(static_cast<double>(3 * i + k));
        }
    }
    return result;
}

/// Checks that each trajectory equals that of a fresh stepper in each call, on any number of
/// threads.
template <class Stepper>
void check_trajectories(const typename Stepper::Parameters& parameters) {
    std::vector<State> begin = starts<Stepper>(parameters, 7);
    // One begins where the one before it ends, of which nothing is to be remembered.
    begin[1] = begin[0];
    Stepper first(parameters);
    for (int step = 0; step < 5; ++step) { REQUIRE(first.step(begin[1], h).ok()); }
    std::vector<State> alone = begin;
    for (State& x : alone) {
        for (const int steps : {5, 8}) {
            Stepper stepper(parameters);
            for (int step = 0; step < steps; ++step) { REQUIRE(stepper.step(x, h).ok()); }
        }
    }
    for (const unsigned threads : {1U, 2U, 5U, 0U}) {
        CAPTURE(threads);
        hvi::Ensemble<Stepper> ensemble(begin, parameters);
        ensemble.advance(h, 5, threads);
        ensemble.advance(h, 8, threads);
        CHECK(ensemble.ok());
        for (std::size_t i = 0; i < begin.size(); ++i) {
            CHECK(same_bits(ensemble.state(i), alone[i]));
            CHECK(ensemble.steps(i) == 13);
        }
    }
}

}  // namespace

TEST_CASE("an ensemble of a large scene has the bits of its trajectories alone") {
    generated::Chain::Parameters chain;
    chain.N = 300;
    check_trajectories<generated::Chain>(chain);
    generated::Toda::Parameters toda;
    toda.N = 90;
    check_trajectories<generated::Toda>(toda);
    generated::ChainGauss::Parameters of_gauss;
    of_gauss.N = 90;
    check_trajectories<generated::Masses>({});
    check_trajectories<generated::ChainGauss>(of_gauss);
    check_trajectories<generated::Membrane>({});
}

TEST_CASE("trajectories of a large scene have parameters of their own, and sizes") {
    std::vector<generated::Chain::Parameters> own(5);
    std::vector<State> begin;
    for (std::size_t i = 0; i < own.size(); ++i) {
        own[i].N = 40 + 10 * static_cast<std::ptrdiff_t>(i);
        begin.push_back(starts<generated::Chain>(own[i], 1).front());
    }
    hvi::Ensemble<generated::Chain> ensemble(begin, own);
    ensemble.advance(h, 12, 2);
    REQUIRE(ensemble.ok());
    for (std::size_t i = 0; i < own.size(); ++i) {
        generated::Chain stepper(own[i]);
        for (int step = 0; step < 12; ++step) { REQUIRE(stepper.step(begin[i], h).ok()); }
        CHECK(same_bits(ensemble.state(i), begin[i]));
    }
}

TEST_CASE("a trajectory of a large scene that stops keeps its state, and others go on") {
    generated::Chain::Parameters parameters;
    parameters.N = 100;
    std::vector<State> begin = starts<generated::Chain>(parameters, 4);
    begin[1].q[50] = std::nan("");
    begin[2].q.pop_back();
    hvi::Ensemble<generated::Chain> ensemble(begin, parameters);
    for (int call = 0; call < 2; ++call) { ensemble.advance(h, 10, 2); }
    CHECK(!ensemble.ok());
    CHECK(ensemble.status(1).code() == Code::not_finite);
    CHECK(ensemble.status(2).code() == Code::dimension_mismatch);
    CHECK(same_bits(ensemble.state(1), begin[1]));
    CHECK(same_bits(ensemble.state(2), begin[2]));
    for (const std::size_t i : {0U, 3U}) {
        CHECK(ensemble.steps(i) == 20);
        CHECK(ensemble.status(i).ok());
    }
    CHECK(ensemble.steps(1) == 0);
}

TEST_CASE("an ensemble of no trajectories, and one of no steps") {
    hvi::Ensemble<generated::Toda> none({});
    none.advance(h, 3);
    CHECK(none.ok());
    CHECK(none.size() == 0);
    const State x = generated::Toda::initial();
    hvi::Ensemble<generated::Toda> one({x});
    one.advance(h, 0);
    CHECK(one.steps(0) == 0);
    CHECK(same_bits(one.state(0), x));
}
