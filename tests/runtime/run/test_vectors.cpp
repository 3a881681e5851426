// Vectors of all kinds, and no allocation in a step.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <memory>
#include <type_traits>
#include <vector>

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <hvi/generated/gauss_2.hpp>
#include <hvi/generated/lobatto_3_separable.hpp>
#include <hvi/generated/stormer_verlet_separable.hpp>
#include <hvi/newton.hpp>

#include "systems.hpp"

namespace {

long allocations = 0;

template <class T>
struct Counting : std::allocator<T> {
    using value_type = T;
    template <class Other>
    struct rebind {
        using other = Counting<Other>;
    };
    T* allocate(std::size_t n) {
        ++allocations;
        return std::allocator<T>::allocate(n);
    }
};
using CountingVector = std::vector<double, Counting<double>>;

/// A chain of pendula, in any vector.
template <class AnyVector>
struct Chain {
    using Vector = AnyVector;
    void dHdq(const Vector& q, Vector& out) const {
        const auto n = q.size();
        for (auto i = n - n; i < n; ++i) {
            out[i] = std::sin(q[i]);
            if (i > 0) { out[i] += q[i] - q[i - 1]; }
            if (i + 1 < n) { out[i] += q[i] - q[i + 1]; }
        }
    }
    void dHdp(const Vector& p, Vector& out) const { out = p; }
    void d2Hdq2(const Vector& q, const Vector&, Eigen::MatrixXd& out) const {
        for (Eigen::Index i = 0; i < out.rows(); ++i) {
            out(i, i) = std::cos(q[static_cast<decltype(q.size())>(i)]);
            if (i > 0) {
                out(i, i) += 1.0;
                out(i, i - 1) = -1.0;
            }
            if (i + 1 < out.rows()) {
                out(i, i) += 1.0;
                out(i, i + 1) = -1.0;
            }
        }
    }
    void d2Hdqdp(const Vector&, const Vector&, Eigen::MatrixXd&) const {}
    void d2Hdp2(const Vector&, const Vector&, Eigen::MatrixXd& out) const { out.setIdentity(); }
    void dHdq(const Vector& q, const Vector&, Vector& out) const { dHdq(q, out); }
    void dHdp(const Vector&, const Vector& p, Vector& out) const { dHdp(p, out); }
};

template <class Stepper>
hvi::State<systems::Two> run(Stepper stepper) {
    typename Stepper::Vector q, p;
    if constexpr (std::is_same_v<typename Stepper::Vector, Eigen::VectorXd>) {
        q.resize(2);
        p.resize(2);
    }
    q[0] = 0.3;
    q[1] = -0.8;
    p[0] = 0.1;
    p[1] = 1.2;
    typename Stepper::State x{q, p};
    for (int i = 0; i < 20; ++i) { REQUIRE(stepper.step(x, 0.1).ok()); }
    return {{x.q[0], x.q[1]}, {x.p[0], x.p[1]}};
}

}  // namespace

using namespace hvi::generated;

TEST_CASE("all kinds of vectors give the same bits") {
    const auto gauss = run(Gauss2<Chain<systems::Two>>{});
    CHECK(systems::same_bits(gauss, run(Gauss2<Chain<Eigen::Vector2d>>{})));
    CHECK(systems::same_bits(gauss, run(Gauss2<Chain<Eigen::VectorXd>>{})));
    const auto lobatto = run(Lobatto3Separable<Chain<systems::Two>>{});
    CHECK(systems::same_bits(lobatto, run(Lobatto3Separable<Chain<Eigen::Vector2d>>{})));
    CHECK(systems::same_bits(lobatto, run(Lobatto3Separable<Chain<Eigen::VectorXd>>{})));
    const auto verlet = run(StormerVerletSeparable<Chain<systems::Two>>{});
    CHECK(systems::same_bits(verlet, run(StormerVerletSeparable<Chain<Eigen::Vector2d>>{})));
    CHECK(systems::same_bits(verlet, run(StormerVerletSeparable<Chain<Eigen::VectorXd>>{})));
    const auto newton = run(Gauss2<Chain<systems::Two>, hvi::Newton>{});
    CHECK(systems::same_bits(newton, run(Gauss2<Chain<Eigen::VectorXd>, hvi::Newton>{})));
}

TEST_CASE("dimensions that differ are a status, and a new dimension is a new start") {
    Gauss2<Chain<Eigen::VectorXd>> gauss;
    StormerVerletSeparable<Chain<Eigen::VectorXd>> verlet;
    hvi::State<Eigen::VectorXd> x{Eigen::VectorXd::Ones(3), Eigen::VectorXd::Zero(2)};
    CHECK(gauss.step(x, 0.1).code() == hvi::Status::Code::dimension_mismatch);
    CHECK(verlet.step(x, 0.1).code() == hvi::Status::Code::dimension_mismatch);
    for (const int n : {2, 5, 3}) {
        x.q = Eigen::VectorXd::Ones(n);
        x.p = Eigen::VectorXd::Zero(n);
        CHECK(gauss.step(x, 0.1).ok());
        CHECK(verlet.step(x, 0.1).ok());
        CHECK(x.q.size() == n);
    }
}

TEST_CASE("no allocation in a step once the dimension is known") {
    Gauss2<Chain<CountingVector>> gauss;
    Lobatto3Separable<Chain<CountingVector>> lobatto;
    StormerVerletSeparable<Chain<CountingVector>> verlet;
    hvi::State<CountingVector> x{CountingVector(3, 1.0), CountingVector(3, 0.0)};
    bool all_ok = gauss.step(x, 0.1).ok();
    all_ok = lobatto.step(x, 0.1).ok() && all_ok;
    all_ok = verlet.step(x, 0.1).ok() && all_ok;
    const long before = allocations;
    REQUIRE(before > 0);
    for (int i = 0; i < 10; ++i) {
        all_ok = gauss.step(x, 0.1).ok() && all_ok;
        all_ok = gauss.step(x, 0.2).ok() && all_ok;
        all_ok = lobatto.step(x, 0.1).ok() && all_ok;
        all_ok = verlet.step(x, 0.1).ok() && all_ok;
    }
    CHECK(allocations == before);
    CHECK(all_ok);
}
