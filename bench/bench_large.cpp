// Systems of many degrees of freedom: what comes from the runtime against loops by hand.
// SPDX-License-Identifier: MIT
//
// Störmer-Verlet of an FPU-beta chain between walls, H = sum p^2/2 + sum r^2/2 + beta r^4/4 over
// the bonds r. `ours` has the force as one writes it by hand, `generated` as hvi-gen derives it
// from H. Before anything is timed, all end in the same states to round-off.

#include <benchmark/benchmark.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#include <hvi/detail/loops/site_moves.hpp>

#include "large/fpu_beta.hpp"
#include "report.hpp"

namespace {

using hvi::detail::Place;
using Vector = std::vector<double>;

constexpr double beta = 0.5;
constexpr double h = 1e-2;

// ---- by the runtime ----

class Chain {
public:
    using Scalar = double;
    static constexpr std::size_t dimension = 1;
    static constexpr std::size_t components = 1;
    static constexpr hvi::detail::Site<1> reach = {1};

    explicit Chain(std::size_t n) : n_(static_cast<Place>(n)) {}

    [[nodiscard]] hvi::detail::Sites<1> sites() const { return {{{1}, {n_ + 1}}, {{2}, {n_}}}; }

    template <class V>
    HVI_INLINE_IN_LANES void force(const double* q, Place e, const hvi::detail::Site<1>&,
                                   V (&out)[1]) const {
        using S = hvi::detail::Stretch<V>;
        const V x = S::load(q + e);
        out[0] = bond<V>(x - S::load(q + e - 1)) - bond<V>(S::load(q + e + 1) - x);
    }

    void force_at_edge(const double* q, Place e, const hvi::detail::Site<1>& k,
                       double (&out)[1]) const {
        out[0] = bond(q[e] - (k[0] > 1 ? q[e - 1] : 0)) - bond((k[0] < n_ ? q[e + 1] : 0) - q[e]);
    }

    template <class V>
    HVI_INLINE_IN_LANES void velocity(const V (&p)[1], Place, const hvi::detail::Site<1>&,
                                      V (&out)[1]) const {
        out[0] = p[0];
    }

private:
    template <class V>
    HVI_INLINE_IN_LANES static V bond(const V& r) {
        return r + V(beta) * (r * (r * r));
    }

    Place n_;
};

template <template <class> class Sums, unsigned threads>
class Ours {
public:
    explicit Ours(std::size_t n)
        : chain_(n), moves_({{Move::kick, 0.5}, {Move::drift, 1}, {Move::kick, 0.5}}, threads) {}

    void advance(hvi::State<Vector>& x, int steps) {
        if (!moves_.advance(chain_, x, h, steps).ok()) { std::puts("it is not finite"); }
    }

private:
    using Move = hvi::detail::Move<double>;

    Chain chain_;
    hvi::detail::SiteMoves<Chain, Sums> moves_;
};

/// Steps one by one, as where each is looked at: the state stands after each, and is that of before
/// where a step fails.
class OursOneByOne {
public:
    explicit OursOneByOne(std::size_t n) : one_(n) {}

    void advance(hvi::State<Vector>& x, int steps) {
        for (int step = 0; step < steps; ++step) { one_.advance(x, 1); }
    }

private:
    Ours<hvi::detail::PlainSums, 1> one_;
};

class Generated {
public:
    explicit Generated(std::size_t n) : stepper_(of(n)) {}

    void advance(hvi::State<Vector>& x, int steps) {
        if (!stepper_.advance(x, h, steps).ok()) { std::puts("it is not finite"); }
    }

private:
    using Stepper = hvi::generated::FpuBeta;

    [[nodiscard]] static Stepper::Parameters of(std::size_t n) {
        Stepper::Parameters parameters;
        parameters.N = static_cast<Place>(n);
        parameters.beta = beta;
        return parameters;
    }

    Stepper stepper_;
};

// ---- by hand ----

double bond(double r) { return r + beta * (r * (r * r)); }

/// Forces of the sites first <= k < end, which have neighbours.
template <class F>
void for_each_force(const double* __restrict q, std::size_t first, std::size_t end, F&& f) {
    for (std::size_t k = first; k < end; ++k) {
        f(k, bond(q[k + 1] - q[k]) - bond(q[k] - q[k - 1]));
    }
}

/// Kick and drift in one sweep: while a block is in the nearest cache it is kicked, and then drifts
/// but for its last site.
class FusedByHand {
public:
    explicit FusedByHand(std::size_t n) : n_(n) {}

    void sweep(double* __restrict q, double* __restrict p, double kick, double drift) const {
        const double last = bond(-q[n_ - 1]) - bond(q[n_ - 1] - q[n_ - 2]);
        p[0] += kick * (bond(q[1] - q[0]) - bond(q[0]));
        std::size_t drifted = 0;
        for (std::size_t first = 1; first + 1 < n_; first += block) {
            const std::size_t end = std::min(first + block, n_ - 1);
            for_each_force(q, first, end,
                           [=](std::size_t k, double force) { p[k] += kick * force; });
            for (std::size_t k = drifted; k < end - 1; ++k) { q[k] += drift * p[k]; }
            drifted = end - 1;
        }
        p[n_ - 1] += kick * last;
        for (std::size_t k = drifted; k < n_; ++k) { q[k] += drift * p[k]; }
    }

private:
    static constexpr std::size_t block = 512;

    std::size_t n_;
};

/// The chain in two loops.
class TwoLoopsByHand {
public:
    explicit TwoLoopsByHand(std::size_t n) : n_(n) {}

    void sweep(double* __restrict q, double* __restrict p, double kick, double drift) const {
        p[0] += kick * (bond(q[1] - q[0]) - bond(q[0]));
        for_each_force(q, 1, n_ - 1, [=](std::size_t k, double force) { p[k] += kick * force; });
        p[n_ - 1] += kick * (bond(-q[n_ - 1]) - bond(q[n_ - 1] - q[n_ - 2]));
        for (std::size_t k = 0; k < n_; ++k) { q[k] += drift * p[k]; }
    }

private:
    std::size_t n_;
};

/// Steps of such sweeps: the last kick of one is made with the first of the next.
template <class Sweeps>
class ByHand {
public:
    explicit ByHand(std::size_t n) : sweeps_(n) {}

    void advance(hvi::State<Vector>& x, int steps) const {
        if (steps == 0) { return; }
        double* q = x.q.data();
        double* p = x.p.data();
        sweeps_.sweep(q, p, h / 2, h);
        for (int step = 1; step < steps; ++step) { sweeps_.sweep(q, p, h, h); }
        sweeps_.sweep(q, p, h / 2, 0);
    }

private:
    Sweeps sweeps_;
};

/// The same, one by one, and without a look at the numbers.
class OneByOneByHand {
public:
    explicit OneByOneByHand(std::size_t n) : by_hand_(n) {}

    void advance(hvi::State<Vector>& x, int steps) const {
        for (int step = 0; step < steps; ++step) { by_hand_.advance(x, 1); }
    }

private:
    ByHand<FusedByHand> by_hand_;
};

class Odeint {
public:
    explicit Odeint(std::size_t n) : n_(n) {}

    void advance(hvi::State<Vector>& x, int steps) {
        stepper_.reset();
        auto state = std::make_pair(std::ref(x.q), std::ref(x.p));
        for (int step = 0; step < steps; ++step) {
            stepper_.do_step(std::cref(*this), state, 0, h);
        }
    }

    void operator()(const Vector& at, const Vector&, Vector& out, double) const {
        const double* q = at.data();
        double* a = out.data();
        a[0] = bond(q[1] - q[0]) - bond(q[0]);
        for_each_force(q, 1, n_ - 1, [=](std::size_t k, double force) { a[k] = force; });
        a[n_ - 1] = bond(-q[n_ - 1]) - bond(q[n_ - 1] - q[n_ - 2]);
    }

private:
    std::size_t n_;
    boost::numeric::odeint::velocity_verlet<Vector> stepper_;
};

// ---- the comparison ----

hvi::State<Vector> start(std::size_t n) {
    hvi::State<Vector> x{Vector(n), Vector(n)};
    for (std::size_t k = 0; k < n; ++k) { x.q[k] = 0.1 * std::sin(0.01 * static_cast<double>(k)); }
    return x;
}

class Comparison {
public:
    explicit Comparison(std::size_t n)
        : n_(n),
          steps_(n < 100000    ? 2560
                 : n < 1000000 ? 256
                               : 64),
          wanted_(start(n)) {
        ByHand<TwoLoopsByHand>(n).advance(wanted_, 10);
    }

    /// Whether it ends where the others do.
    template <class One>
    [[nodiscard]] bool add(const std::string& kind) const {
        const std::string name = kind + "_" + std::to_string(n_);
        hvi::State<Vector> x = start(n_);
        One(n_).advance(x, 10);
        for (std::size_t k = 0; k < n_; ++k) {
            if (!(std::fabs(x.q[k] - wanted_.q[k]) + std::fabs(x.p[k] - wanted_.p[k]) < 1e-14)) {
                std::printf("%s does something else\n", name.c_str());
                return false;
            }
        }
        benchmark::RegisterBenchmark(name.c_str(),
                                     [n = n_, steps = steps_](benchmark::State& state) {
                                         One one(n);
                                         hvi::State<Vector> y = start(n);
                                         for (auto _ : state) { one.advance(y, steps); }
                                         const double sites = static_cast<double>(n) * steps;
                                         state.counters["per_site"] = benchmark::Counter(
                                             sites, benchmark::Counter::kIsIterationInvariantRate |
                                                        benchmark::Counter::kInvert);
                                     })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
        return true;
    }

private:
    std::size_t n_;
    int steps_;
    hvi::State<Vector> wanted_;
};

}  // namespace

int main(int argc, char** argv) {
    using hvi::detail::CompensatedSums;
    using hvi::detail::PlainSums;
    // NOTE: so that all vectors begin as far from a line of the cache. Where they begin is worth a
    // sixth of the time of a loop, more than loops differ by.
    mallopt(M_MMAP_THRESHOLD, 4096);
    std::vector<bench::Ratio> ratios;
    bool all_agree = true;
    for (const std::size_t n : {1000U, 100000U, 1000000U}) {
        const Comparison compare(n);
        all_agree &= compare.add<Ours<PlainSums, 1>>("ours");
        all_agree &= compare.add<Generated>("generated");
        all_agree &= compare.add<Ours<PlainSums, 2>>("ours_on_two_threads");
        all_agree &= compare.add<Ours<CompensatedSums, 1>>("ours_compensated");
        all_agree &= compare.add<ByHand<FusedByHand>>("fused_by_hand");
        all_agree &= compare.add<ByHand<TwoLoopsByHand>>("two_loops_by_hand");
        all_agree &= compare.add<OursOneByOne>("ours_one_by_one");
        all_agree &= compare.add<OneByOneByHand>("one_by_one_by_hand");
        all_agree &= compare.add<Odeint>("odeint");
        const std::string size = "_" + std::to_string(n);
        ratios.push_back({"ours" + size, "fused_by_hand" + size, "at most 1.05"});
        ratios.push_back({"ours" + size, "two_loops_by_hand" + size, "at most 1.1"});
        ratios.push_back({"generated" + size, "ours" + size, "at most 1.1"});
        ratios.push_back({"generated" + size, "fused_by_hand" + size, "at most 1.05"});
        ratios.push_back({"generated" + size, "two_loops_by_hand" + size, "at most 1.1"});
        ratios.push_back({"ours_one_by_one" + size, "one_by_one_by_hand" + size,
                          "a copy, and a look at the numbers"});
        ratios.push_back({"odeint" + size, "ours" + size, "at least 1.5"});
        ratios.push_back({"ours_compensated" + size, "ours" + size, "what compensation costs"});
        ratios.push_back({"ours" + size, "ours_on_two_threads" + size,
                          n == 100000 ? "at least 1.8 on two cores" : "as it comes"});
    }
    return all_agree ? bench::time_all(argc, argv, ratios) : 1;
}
