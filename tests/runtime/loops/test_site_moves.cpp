// Explicit methods on lattices, against loops of another kind.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <hvi/detail/loops/site_moves.hpp>

namespace {

using hvi::Run;
using hvi::detail::CompensatedSums;
using hvi::detail::Move;
using hvi::detail::Place;
using hvi::detail::PlainSums;
using hvi::detail::Site;
using hvi::detail::SiteMoves;
using hvi::detail::Sites;
using hvi::detail::Stretch;

using Vector = std::vector<double>;
using State = hvi::State<Vector>;
using Moves = std::vector<Move<double>>;

// ---- as hvi-gen writes them ----

/// V'(r) of a spring of V = r^2/2 + r^4/8.
template <class V>
V spring(const V& r) {
    return r + V(0.5) * (r * (r * r));
}

/// H = sum p_k^2/2 + sum V(q_{k+1} - q_k), with walls q_0 = q_{n+1} = 0 or a ring.
template <bool is_ring>
class Chain {
public:
    using Scalar = double;
    static constexpr std::size_t dimension = 1;
    static constexpr std::size_t components = 1;
    static constexpr Site<1> reach = {1};

    explicit Chain(Place n) : n_(n) {}

    [[nodiscard]] Sites<1> sites() const { return {{{1}, {n_ + 1}}, {{2}, {n_}}}; }

    template <class V>
    void force(const double* q, Place e, const Site<1>&, V (&out)[1]) const {
        const V x = Stretch<V>::load(q + e);
        out[0] =
            spring<V>(x - Stretch<V>::load(q + e - 1)) - spring<V>(Stretch<V>::load(q + e + 1) - x);
    }

    void force_at_edge(const double* q, Place e, const Site<1>& k, double (&out)[1]) const {
        out[0] = spring(q[e] - at(q, k[0] - 1)) - spring(at(q, k[0] + 1) - q[e]);
    }

    template <class V>
    void velocity(const V (&p)[1], Place, const Site<1>&, V (&out)[1]) const {
        out[0] = p[0];
    }

private:
    [[nodiscard]] double at(const double* q, Place k) const {
        if (is_ring) { return q[(k + n_ - 1) % n_]; }
        return k == 0 || k == n_ + 1 ? 0 : q[k - 1];
    }

    Place n_;
};

/// Two components on a torus: U = sum over bonds of V(u - u') + sum w^2 (1 + u)^2/2, and masses 2
/// of u, 1 + (i + j)/8 of w.
class Torus {
public:
    using Scalar = double;
    static constexpr std::size_t dimension = 2;
    static constexpr std::size_t components = 2;
    static constexpr Site<2> reach = {1, 1};

    Torus(Place rows, Place columns) : n_(rows), m_(columns) {}

    [[nodiscard]] Sites<2> sites() const {
        return {{{0, 0}, {n_, m_}}, {{1, 1}, {n_ - 1, m_ - 1}}};
    }

    template <class V>
    void force(const double* q, Place e, const Site<2>&, V (&out)[2]) const {
        using S = Stretch<V>;
        write<V>({S::load(q + e), S::load(q + e - m_), S::load(q + e + m_), S::load(q + e - 1),
                  S::load(q + e + 1)},
                 S::load(q + n_ * m_ + e), out);
    }

    void force_at_edge(const double* q, Place e, const Site<2>& k, double (&out)[2]) const {
        const auto u = [&](Place i, Place j) { return q[(i + n_) % n_ * m_ + (j + m_) % m_]; };
        write<double>(
            {q[e], u(k[0] - 1, k[1]), u(k[0] + 1, k[1]), u(k[0], k[1] - 1), u(k[0], k[1] + 1)},
            q[n_ * m_ + e], out);
    }

    template <class V>
    void velocity(const V (&p)[2], Place, const Site<2>& k, V (&out)[2]) const {
        out[0] = V(0.5) * p[0];
        out[1] = p[1] / (V(1.0) + V(0.125) * Stretch<V>::indices(k[0] + k[1]));
    }

private:
    template <class V>
    struct Cross {
        V here, above, below, left, right;
    };

    template <class V>
    static void write(const Cross<V>& u, const V& w, V (&out)[2]) {
        const V bonds = (spring<V>(u.here - u.above) - spring<V>(u.below - u.here)) +
                        (spring<V>(u.here - u.left) - spring<V>(u.right - u.here));
        out[0] = bonds + (V(1.0) + u.here) * (w * w);
        out[1] = (V(1.0) + u.here) * ((V(1.0) + u.here) * w);
    }

    Place n_, m_;
};

/// Three indices, a reach of two in the first and the last of them, and no edges on the second.
class Block {
public:
    using Scalar = double;
    static constexpr std::size_t dimension = 3;
    static constexpr std::size_t components = 1;
    static constexpr Site<3> reach = {2, 0, 2};

    explicit Block(const Site<3>& n) : n_(n) {}

    [[nodiscard]] Sites<3> sites() const {
        return {{{0, 0, 0}, n_}, {{2, 0, 2}, {n_[0] - 2, n_[1], n_[2] - 2}}};
    }

    template <class V>
    void force(const double* q, Place e, const Site<3>&, V (&out)[1]) const {
        const Place plane = 2 * n_[1] * n_[2];
        const V x = Stretch<V>::load(q + e);
        out[0] = (spring<V>(x - Stretch<V>::load(q + e - plane)) -
                  spring<V>(Stretch<V>::load(q + e + plane) - x)) +
                 (spring<V>(x - Stretch<V>::load(q + e - 2)) -
                  spring<V>(Stretch<V>::load(q + e + 2) - x));
    }

    void force_at_edge(const double* q, Place e, const Site<3>& k, double (&out)[1]) const {
        const Place row = n_[2];
        const Place plane = n_[1] * row;
        const auto bond = [&](bool is_there, double r) { return is_there ? spring(r) : 0.0; };
        double f = 0;
        f += bond(k[0] >= 2, k[0] >= 2 ? q[e] - q[e - 2 * plane] : 0);
        f -= bond(k[0] + 2 < n_[0], k[0] + 2 < n_[0] ? q[e + 2 * plane] - q[e] : 0);
        double g = 0;
        g += bond(k[2] >= 2, k[2] >= 2 ? q[e] - q[e - 2] : 0);
        g -= bond(k[2] + 2 < n_[2], k[2] + 2 < n_[2] ? q[e + 2] - q[e] : 0);
        out[0] = f + g;
    }

    template <class V>
    void velocity(const V (&p)[1], Place, const Site<3>&, V (&out)[1]) const {
        out[0] = p[0];
    }

private:
    Site<3> n_;
};

// ---- by hand: bonds are summed one after the other, into a vector of their own ----

/// Adds the forces of a bond of the positions q[i] and q[j] with the energy V(q[j] - q[i]).
void pull(const Vector& q, std::size_t i, std::size_t j, Vector& gradient) {
    const double f = spring(q[j] - q[i]);
    gradient[i] -= f;
    gradient[j] += f;
}

struct ByHand {
    std::function<void(const Vector& q, Vector& gradient)> force;
    std::function<double(std::size_t k)> inverse_mass = [](std::size_t) { return 1; };
};

ByHand chain_by_hand(std::size_t n, bool is_ring) {
    ByHand hand;
    hand.force = [=](const Vector& q, Vector& gradient) {
        for (std::size_t k = 0; k + 1 < n; ++k) { pull(q, k, k + 1, gradient); }
        if (is_ring) {
            pull(q, n - 1, 0, gradient);
        } else {
            gradient[0] += spring(q[0]);
            gradient[n - 1] += spring(q[n - 1]);
        }
    };
    return hand;
}

ByHand torus_by_hand(std::size_t rows, std::size_t columns) {
    const std::size_t size = rows * columns;
    ByHand hand;
    hand.force = [=](const Vector& q, Vector& gradient) {
        for (std::size_t e = 0; e < size; ++e) {
            pull(q, e, (e + columns) % size, gradient);
            pull(q, e, e / columns * columns + (e + 1) % columns, gradient);
            const double u = q[e];
            const double w = q[size + e];
            gradient[e] += w * w * (1 + u);
            gradient[size + e] += w * (1 + u) * (1 + u);
        }
    };
    hand.inverse_mass = [=](std::size_t k) {
        if (k < size) { return 0.5; }
        const std::size_t e = k - size;
        return 1 / (1 + static_cast<double>(e / columns + e % columns) / 8);
    };
    return hand;
}

ByHand block_by_hand(const std::array<std::size_t, 3>& n) {
    const auto number = [=](std::size_t i, std::size_t j, std::size_t k) {
        return (i * n[1] + j) * n[2] + k;
    };
    ByHand hand;
    hand.force = [=](const Vector& q, Vector& gradient) {
        for (std::size_t i = 0; i < n[0]; ++i) {
            for (std::size_t j = 0; j < n[1]; ++j) {
                for (std::size_t k = 0; k < n[2]; ++k) {
                    if (i + 2 < n[0]) { pull(q, number(i, j, k), number(i + 2, j, k), gradient); }
                    if (k + 2 < n[2]) { pull(q, number(i, j, k), number(i, j, k + 2), gradient); }
                }
            }
        }
    };
    return hand;
}

void advance(const ByHand& hand, const Moves& moves, State& x, double h, int steps) {
    for (int step = 0; step < steps; ++step) {
        for (const Move<double>& move : moves) {
            if (move.kind == Move<double>::drift) {
                for (std::size_t k = 0; k < x.q.size(); ++k) {
                    x.q[k] += h * move.weight * hand.inverse_mass(k) * x.p[k];
                }
                continue;
            }
            Vector gradient(x.q.size());
            hand.force(x.q, gradient);
            for (std::size_t k = 0; k < x.q.size(); ++k) {
                x.p[k] -= h * move.weight * gradient[k];
            }
        }
    }
}

// ---- what is tried ----

constexpr auto kick = Move<double>::kick;
constexpr auto drift = Move<double>::drift;

const Moves verlet = {{kick, 0.5}, {drift, 1}, {kick, 0.5}};
const Moves verlet_of_positions = {{drift, 0.5}, {kick, 1}, {drift, 0.5}};
const Moves kick_then_drift = {{kick, 1}, {drift, 1}};
const Moves drift_then_kick = {{drift, 1}, {kick, 1}};

/// Three steps of Verlet in one.
Moves triple_jump() {
    const double outer = 1 / (2 - std::cbrt(2.0));
    Moves moves;
    for (const double part : {outer, 1 - 2 * outer, outer}) {
        for (const Move<double>& move : verlet) {
            moves.push_back({move.kind, part * move.weight});
        }
    }
    return moves;
}

std::vector<Moves> all_methods() {
    return {verlet, verlet_of_positions, kick_then_drift, drift_then_kick, triple_jump()};
}

State start(std::size_t size) {
    State x{Vector(size), Vector(size)};
    for (std::size_t k = 0; k < size; ++k) {
        const auto place = static_cast<double>(k);
        x.q[k] = 0.3 * std::sin(1 + 1.3 * place);
        x.p[k] = 0.2 * std::cos(0.7 * place * place);
    }
    return x;
}

double farthest(const State& x, const State& y) {
    double largest = 0;
    for (std::size_t k = 0; k < x.q.size(); ++k) {
        largest = std::fmax(largest, std::fabs(x.q[k] - y.q[k]));
        largest = std::fmax(largest, std::fabs(x.p[k] - y.p[k]));
    }
    return largest;
}

bool same(const State& x, const State& y) { return x.q == y.q && x.p == y.p; }

/// Checks that all methods, plain and compensated, agree with loops by hand; that the bits do not
/// depend on threads; and that those of plain sums do not depend on the number of calls.
template <class System>
void agree(const System& system, std::size_t size, const ByHand& hand) {
    const int steps = size > 10000 ? 3 : 20;
    const double h = 0.05;
    for (const Moves& moves : all_methods()) {
        const State first = start(size);
        State wanted = first;
        advance(hand, moves, wanted, h, steps);

        State x = first;
        const Run run = SiteMoves<System>(moves).advance(system, x, h, steps);
        CHECK(run.ok());
        CHECK(run.steps == steps);
        CHECK(farthest(x, wanted) < 1e-14 * steps);

        for (const unsigned threads : {2U, 3U}) {
            State y = first;
            CHECK(SiteMoves<System>(moves, threads).advance(system, y, h, steps).ok());
            CHECK(same(x, y));
        }

        State y = first;
        SiteMoves<System> one_by_one(moves);
        for (int step = 0; step < steps; ++step) {
            CHECK(one_by_one.advance(system, y, h, 1).ok());
        }
        CHECK(same(x, y));

        y = first;
        CHECK(SiteMoves<System, CompensatedSums>(moves, 2).advance(system, y, h, steps).ok());
        CHECK(farthest(y, wanted) < 1e-14 * steps);
    }
}

TEST_CASE("chains of any length do as by hand") {
    const auto n = GENERATE(1, 2, 3, 7, 8, 9, 10, 17, 18, 19, 26, 64, 1000, 4097, 4098, 40000);
    INFO(n);
    agree(Chain<false>(n), static_cast<std::size_t>(n),
          chain_by_hand(static_cast<std::size_t>(n), false));
}

TEST_CASE("rings of any length do as by hand") {
    const auto n = GENERATE(3, 7, 8, 9, 17, 64, 1000, 40000);
    INFO(n);
    agree(Chain<true>(n), static_cast<std::size_t>(n),
          chain_by_hand(static_cast<std::size_t>(n), true));
}

TEST_CASE("tori of any size do as by hand") {
    struct Size {
        std::size_t rows, columns;
    };
    const auto size = GENERATE(Size{3, 3}, Size{3, 40}, Size{40, 3}, Size{10, 12}, Size{33, 19},
                               Size{400, 50}, Size{20, 3000});
    INFO(size.rows << " x " << size.columns);
    agree(Torus(static_cast<Place>(size.rows), static_cast<Place>(size.columns)),
          2 * size.rows * size.columns, torus_by_hand(size.rows, size.columns));
}

TEST_CASE("blocks do as by hand") {
    using Size = std::array<std::size_t, 3>;
    const auto n =
        GENERATE(Size{1, 1, 1}, Size{5, 1, 5}, Size{3, 4, 20}, Size{9, 5, 11}, Size{60, 7, 50});
    INFO(n[0] << " x " << n[1] << " x " << n[2]);
    agree(Block({static_cast<Place>(n[0]), static_cast<Place>(n[1]), static_cast<Place>(n[2])}),
          n[0] * n[1] * n[2], block_by_hand(n));
}

TEST_CASE("gradients are those of bonds by hand") {
    const std::size_t rows = 33, columns = 21;
    const Torus torus(33, 21);
    const State x = start(2 * rows * columns);
    Vector out(x.q.size()), wanted(x.q.size());
    const ByHand hand = torus_by_hand(rows, columns);
    hand.force(x.q, wanted);
    hvi::detail::gather(torus, x.q.data(), out.data());
    for (std::size_t k = 0; k < out.size(); ++k) { CHECK(std::fabs(out[k] - wanted[k]) < 1e-14); }
    hvi::detail::velocities(torus, x.p.data(), out.data());
    for (std::size_t k = 0; k < out.size(); ++k) {
        CHECK(std::fabs(out[k] - hand.inverse_mass(k) * x.p[k]) < 1e-15);
    }
}

TEST_CASE("compensated sums lose less") {
    const Place n = 100;
    const int steps = 20000;
    const double h = 1.0 / 1024;
    const Chain<false> chain(n);
    State plain = start(static_cast<std::size_t>(n));
    State compensated = plain;
    hvi::State<std::vector<long double>> exact;
    exact.q.assign(plain.q.begin(), plain.q.end());
    exact.p.assign(plain.p.begin(), plain.p.end());
    std::vector<long double> bonds(static_cast<std::size_t>(n) + 1);
    const auto kick_exactly = [&] {
        for (std::size_t k = 0; k <= static_cast<std::size_t>(n); ++k) {
            const long double left = k == 0 ? 0 : exact.q[k - 1];
            const long double right = k == static_cast<std::size_t>(n) ? 0 : exact.q[k];
            const long double r = right - left;
            bonds[k] = r + r * r * r / 2;
        }
        for (std::size_t k = 0; k < exact.q.size(); ++k) {
            exact.p[k] += static_cast<long double>(h) / 2 * (bonds[k + 1] - bonds[k]);
        }
    };
    for (int step = 0; step < steps; ++step) {
        kick_exactly();
        for (std::size_t k = 0; k < exact.q.size(); ++k) {
            exact.q[k] += static_cast<long double>(h) * exact.p[k];
        }
        kick_exactly();
    }
    CHECK(SiteMoves<Chain<false>>(verlet).advance(chain, plain, h, steps).ok());
    CHECK(SiteMoves<Chain<false>, CompensatedSums>(verlet)
              .advance(chain, compensated, h, steps)
              .ok());
    double error = 0, error_compensated = 0;
    for (std::size_t k = 0; k < exact.q.size(); ++k) {
        const auto wanted = static_cast<double>(exact.q[k]);
        error = std::fmax(error, std::fabs(plain.q[k] - wanted));
        error_compensated = std::fmax(error_compensated, std::fabs(compensated.q[k] - wanted));
    }
    CHECK(error_compensated < error / 10);
    CHECK(error_compensated < 3e-14);
}

// ---- what goes wrong ----

/// A particle that explodes: H = p^2/2 - q^4/4 at each site.
struct Cliff {
    using Scalar = double;
    static constexpr std::size_t dimension = 1;
    static constexpr std::size_t components = 1;
    static constexpr Site<1> reach = {0};

    Place n;

    [[nodiscard]] Sites<1> sites() const { return {{{0}, {n}}, {{0}, {n}}}; }
    template <class V>
    void force(const double* q, Place e, const Site<1>&, V (&out)[1]) const {
        const V x = Stretch<V>::load(q + e);
        out[0] = -(x * (x * x));
    }
    void force_at_edge(const double* q, Place e, const Site<1>& k, double (&out)[1]) const {
        force(q, e, k, out);
    }
    template <class V>
    void velocity(const V (&p)[1], Place, const Site<1>&, V (&out)[1]) const {
        out[0] = p[0];
    }
};

/// Goes to infinity at place k and nowhere else.
template <template <class> class Sums>
void falls(Place n, std::size_t k) {
    State x{Vector(static_cast<std::size_t>(n), 0.0), Vector(static_cast<std::size_t>(n), 1e-3)};
    x.q[k] = 1;
    const State first = x;
    const Run run = SiteMoves<Cliff, Sums>(verlet, 2).advance(Cliff{n}, x, 0.01, 1000);
    CHECK(run.status.code() == hvi::Status::Code::not_finite);
    REQUIRE(run.steps > 10);
    REQUIRE(run.steps < 1000);

    State good = first;
    const Run last = SiteMoves<Cliff, Sums>(verlet).advance(Cliff{n}, good, 0.01, run.steps);
    CHECK(last.ok());
    CHECK(same(x, good));
    CHECK(!SiteMoves<Cliff, Sums>(verlet).advance(Cliff{n}, good, 0.01, 1).ok());
    CHECK(same(x, good));
}

TEST_CASE("a run ends where the last good step did") {
    falls<PlainSums>(1, 0);
    falls<PlainSums>(20, 17);
    falls<PlainSums>(20, 3);
    falls<PlainSums>(20000, 4096);
    falls<CompensatedSums>(20, 17);
    falls<CompensatedSums>(20000, 12345);
}

TEST_CASE("one of a million that is no number is found") {
    const std::size_t n = 1000000;
    const Chain<false> chain(static_cast<Place>(n));
    for (const std::size_t k : {std::size_t(0), std::size_t(777777), n - 1}) {
        State x = start(n);
        State rest = x;
        x.q[k] = std::numeric_limits<double>::quiet_NaN();
        const Run run = SiteMoves<Chain<false>>(verlet, 2).advance(chain, x, 0.1, 3);
        CHECK(run.status.code() == hvi::Status::Code::not_finite);
        CHECK(run.steps == 0);
        CHECK(std::isnan(x.q[k]));
        x.q[k] = rest.q[k];
        CHECK(same(x, rest));
    }
}

/// Checks that a place that goes to infinity, wherever it is, leaves all places as they were.
template <class System>
void stays(const System& system, std::size_t size, std::size_t stride) {
    for (const Moves& moves : {verlet, verlet_of_positions, drift_then_kick}) {
        SiteMoves<System> one_by_one(moves, 2);
        for (std::size_t k = 0; k < size; k += stride) {
            State x = start(size);
            x.q[k] = 1e200;
            const State first = x;
            const Run run = one_by_one.advance(system, x, 0.05, 1);
            CHECK(run.status.code() == hvi::Status::Code::not_finite);
            CHECK(same(x, first));
        }
    }
}

TEST_CASE("a step that fails leaves every place as it was, on seams and edges too") {
    // Seams of the chain are at 1 + 10000 and so on; seams of the torus are rows of sites.
    const Chain<false> chain(40000);
    stays(chain, 40000, 1999);
    stays(chain, 40000, 39999);
    stays(chain, 40000, 10001);
    stays(Torus(400, 50), 40000, 1667);
    stays(Block({60, 7, 50}), 21000, 499);
}

TEST_CASE("what is not a step leaves the state alone") {
    const Chain<true> ring(10);
    SiteMoves<Chain<true>> moves(verlet);
    const State first = start(10);
    State x = first;

    Run run = moves.advance(ring, x, 0.0, 5);
    CHECK((run.ok() && run.steps == 5));
    run = moves.advance(ring, x, 0.1, 0);
    CHECK((run.ok() && run.steps == 0));
    run = moves.advance(ring, x, 0.1, -3);
    CHECK((run.ok() && run.steps == 0));
    run = moves.advance(ring, x, HUGE_VAL, 5);
    CHECK(run.status.code() == hvi::Status::Code::not_finite);
    CHECK(same(x, first));

    State shorter{Vector(10, 1.0), Vector(9, 1.0)};
    run = moves.advance(ring, shorter, 0.1, 5);
    CHECK(run.status.code() == hvi::Status::Code::dimension_mismatch);
    shorter.p.push_back(1);
    CHECK(moves.advance(ring, shorter, 0.1, 5).ok());
}

TEST_CASE("what is called again forgets the lattice before") {
    SiteMoves<Chain<false>, CompensatedSums> moves(verlet, 2);
    for (const Place n : {20000, 10, 30000, 1}) {
        State x = start(static_cast<std::size_t>(n));
        State y = x;
        CHECK(moves.advance(Chain<false>(n), x, 0.1, 4).ok());
        CHECK(SiteMoves<Chain<false>, CompensatedSums>(verlet)
                  .advance(Chain<false>(n), y, 0.1, 4)
                  .ok());
        CHECK(same(x, y));
    }
}

}  // namespace
