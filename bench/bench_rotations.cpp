// Bodies that rotate: ours in natural charts and as splittings, splittings by hand, and quaternions
// with Odeint.
// SPDX-License-Identifier: MIT
//
// A free body with three moments of inertia, and the heavy top of heavy-top; both begin as the
// latter does. First the time of a splitting's step, ours and by hand; then the time to an error of
// 1e-8 at the end, the coarsest steps or tolerance that reaches it being searched for; then what is
// conserved over very many periods. The argument is how many, in place of 1000000.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <hvi/state.hpp>
#include <rotations/free_gauss_2.hpp>
#include <rotations/free_gauss_4.hpp>
#include <rotations/free_gauss_6.hpp>
#include <rotations/free_kahan_li.hpp>
#include <rotations/top_gauss_2.hpp>
#include <rotations/top_gauss_4.hpp>
#include <rotations/top_gauss_6.hpp>
#include <rotations/top_kahan_li.hpp>

#include "rotations_by_hand.hpp"

namespace {

using bench::Body;

constexpr double until = 100;
constexpr double wanted_error = 1e-8;
constexpr double steps_of_period = 20;

template <class Number>
Body<Number> start() {
    const auto x = hvi::generated::BasicTopGauss4<Number>::initial();
    return {x.R, x.L};
}

/// The body turns once about its axis of the beginning.
double period() {
    double square = 0;
    const Body<double> x = start<double>();
    for (std::size_t i = 0; i < 3; ++i) {
        square += std::pow(x.L[i] / bench::inertia<double>[i], 2);
    }
    return 2 * M_PI / std::sqrt(square);
}

// ---- what moves a body on ----

struct Work {
    std::int64_t steps = 0;
    std::int64_t parts = 0;  ///< sweeps, turns and kicks, or evaluations of the right side
};

class Mover {
public:
    Mover() = default;
    Mover(const Mover&) = delete;
    Mover& operator=(const Mover&) = delete;
    virtual ~Mover() = default;

    /// Advances by `time`; unless `exactly`, a method with steps of its own goes on to their end.
    virtual void advance(double time, bool exactly) = 0;
    [[nodiscard]] virtual Body<double> body() const = 0;
    /// Returns the distance of its rotation from a true rotation.
    [[nodiscard]] virtual double defect() const = 0;
    [[nodiscard]] virtual Work work() const = 0;
};

/// The largest entry of R^T R - 1.
template <class Number>
double defect_of(const std::array<Number, 9>& R) {
    Number most = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const Number entry = R[i] * R[j] + R[3 + i] * R[3 + j] + R[6 + i] * R[6 + j];
            most = std::max(most, std::fabs(entry - (i == j ? 1 : 0)));
        }
    }
    return static_cast<double>(most);
}

/// A stepper that hvi-gen writes, with steps of size h.
template <class Stepper>
class Ours : public Mover {
public:
    explicit Ours(double h) : h_(h) {
        const auto at = start<typename Stepper::Scalar>();
        x_.R = at.R;
        x_.L = at.L;
    }

    void advance(double time, bool) override {
        for (long step = std::lround(time / h_); step > 0 && is_ok_; --step) {
            const hvi::Status status = stepper_.step(x_, static_cast<Number>(h_));
            is_ok_ = status.ok();
            work_.parts += status.iterations;
            ++work_.steps;
        }
    }
    [[nodiscard]] Body<double> body() const override {
        Body<double> all{};
        const double none = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t k = 0; k < 9; ++k) { all.R[k] = is_ok_ ? double(x_.R[k]) : none; }
        for (std::size_t k = 0; k < 3; ++k) { all.L[k] = is_ok_ ? double(x_.L[k]) : none; }
        return all;
    }
    [[nodiscard]] double defect() const override { return defect_of(x_.R); }
    [[nodiscard]] Work work() const override { return work_; }

private:
    using Number = typename Stepper::Scalar;

    Stepper stepper_;
    typename Stepper::State x_;
    double h_;
    bool is_ok_ = true;
    Work work_;
};

/// A splitting written by hand, with steps of size h.
template <bool is_heavy>
class Split : public Mover {
public:
    Split(double h, bench::Splitting splitting)
        : split_(start<double>(), std::move(splitting)), h_(h) {}

    void advance(double time, bool) override {
        const long steps = std::lround(time / h_);
        split_.advance(h_, steps);
        work_.steps += steps;
        work_.parts += steps * split_.parts_of_step();
    }
    [[nodiscard]] Body<double> body() const override { return split_.body(); }
    [[nodiscard]] double defect() const override { return defect_of(split_.body().R); }
    [[nodiscard]] Work work() const override { return work_; }

private:
    bench::SplitBody<is_heavy> split_;
    double h_;
    Work work_;
};

/// A stepper of Odeint, with steps that a tolerance controls.
template <class Stepper, bool is_heavy, bool normalises>
class Controlled : public Mover {
public:
    explicit Controlled(double tolerance)
        : stepper_(typename Tried::error_checker_type(tolerance, tolerance)),
          x_(bench::in_quaternions(start<double>())) {}

    void advance(double time, bool exactly) override {
        const double end = goal_ + time;
        goal_ = end;
        const auto f = [this](const bench::Quaternion& x, bench::Quaternion& out, double) {
            ++work_.parts;
            bench::right_side<is_heavy>(x, out);
        };
        while (end - t_ > 1e-13 * end) {
            if (exactly) { h_ = std::min(h_, end - t_); }
            if (stepper_.try_step(f, x_, t_, h_) == boost::numeric::odeint::success) {
                ++work_.steps;
                if constexpr (normalises) { bench::normalise(x_); }
            }
        }
    }
    [[nodiscard]] Body<double> body() const override { return bench::in_matrices(x_); }
    [[nodiscard]] double defect() const override { return std::fabs(bench::length(x_) - 1); }
    [[nodiscard]] Work work() const override { return work_; }

private:
    using Tried = boost::numeric::odeint::controlled_runge_kutta<Stepper>;

    Tried stepper_;
    bench::Quaternion x_;
    double t_ = 0, goal_ = 0;
    double h_ = 0.01;
    Work work_;
};

/// `make` takes the size of a step, or the tolerance.
struct Method {
    std::string name;
    bool has_tolerance;
    std::function<std::unique_ptr<Mover>(double)> make;
    double fineness = 0;  ///< the fineness that reaches wanted_error
    std::vector<double> times{};
};

template <class Stepper>
Method ours(const char* name) {
    return {name, false, [](double h) { return std::make_unique<Ours<Stepper>>(h); }};
}

template <bool is_heavy>
Method split(const char* name, const bench::Splitting& splitting) {
    return {name, false, [=](double h) { return std::make_unique<Split<is_heavy>>(h, splitting); }};
}

template <class Stepper, bool is_heavy, bool normalises = false>
Method odeint(const char* name) {
    return {name, true, [](double tolerance) {
                return std::make_unique<Controlled<Stepper, is_heavy, normalises>>(tolerance);
            }};
}

template <bool is_heavy>
void add_others(std::vector<Method>& methods) {
    namespace of = boost::numeric::odeint;
    using Fehlberg = of::runge_kutta_fehlberg78<bench::Quaternion>;
    using Dopri = of::runge_kutta_dopri5<bench::Quaternion>;
    methods.push_back(split<is_heavy>("split", bench::of_symmetric_steps({1})));
    methods.push_back(split<is_heavy>("split, suzuki:4", bench::suzuki_4()));
    methods.push_back(split<is_heavy>("split, blanes-moan:6", bench::blanes_moan_6()));
    methods.push_back(split<is_heavy>("split, kahan-li:8", bench::kahan_li_8()));
    methods.push_back(odeint<Fehlberg, is_heavy>("fehlberg78"));
    methods.push_back(odeint<Fehlberg, is_heavy, true>("fehlberg78, |q| = 1"));
    methods.push_back(odeint<Dopri, is_heavy>("dopri5"));
}

// ---- time to an error ----

double distance(const Body<double>& x, const Body<double>& y) {
    double square = 0;
    for (std::size_t k = 0; k < 9; ++k) { square += std::pow(x.R[k] - y.R[k], 2); }
    for (std::size_t k = 0; k < 3; ++k) { square += std::pow(x.L[k] - y.L[k], 2); }
    return std::sqrt(square);
}

/// Returns the error; infinite where the run failed.
double error_of(const Method& method, double fineness, const Body<double>& reference) {
    const auto mover = method.make(fineness);
    mover->advance(until, true);
    const double error = distance(mover->body(), reference);
    return std::isfinite(error) ? error : std::numeric_limits<double>::infinity();
}

/// Returns the k-th fineness: steps that are 9 % smaller each, a whole number of them, or
/// tolerances, eight to a power of ten.
double fineness(const Method& method, int k) {
    if (method.has_tolerance) { return std::pow(10.0, -4 - k / 8.0); }
    return until / std::ceil(16 * std::pow(2, k / 8.0));
}

/// The coarsest that reaches the error, as does the next finer one: an error may pass through 0. Or
/// 0 where there is none.
double coarsest(const Method& method, const Body<double>& reference) {
    int reached = 0;
    for (int k = 0; k < 160; ++k) {
        const bool reaches = error_of(method, fineness(method, k), reference) <= wanted_error;
        reached = reaches ? reached + 1 : 0;
        if (reached == 2) { return fineness(method, k - 1); }
    }
    return 0;
}

/// Seconds of one run, of so many that they take some milliseconds: of the processor, since others
/// may be at work on it.
double timed(const Method& method) {
    std::int64_t runs = 0;
    const std::clock_t begin = std::clock();
    std::clock_t time = 0;
    while (time < CLOCKS_PER_SEC / 200) {
        method.make(method.fineness)->advance(until, true);
        ++runs;
        time = std::clock() - begin;
    }
    return static_cast<double>(time) / CLOCKS_PER_SEC / static_cast<double>(runs);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// The ratios are to the fastest of ours, which are the first four.
void print_times(const std::vector<Method>& methods, const Body<double>& reference) {
    double best = median(methods[0].times);
    for (std::size_t k = 1; k < 4; ++k) { best = std::min(best, median(methods[k].times)); }
    std::printf("%-22s %9s %9s %7s %9s %9s %8s\n", "", "fineness", "error", "steps", "per step",
                "us", "ratio");
    for (const Method& method : methods) {
        if (method.fineness == 0) {
            std::printf("%-22s does not reach it\n", method.name.c_str());
            continue;
        }
        const auto mover = method.make(method.fineness);
        mover->advance(until, true);
        const Work work = mover->work();
        const double time = median(method.times);
        std::printf("%-22s %9.2e %9.2e %7lld %9.1f %9.1f %8.2f\n", method.name.c_str(),
                    method.fineness, error_of(method, method.fineness, reference),
                    static_cast<long long>(work.steps),
                    static_cast<double>(work.parts) / static_cast<double>(work.steps), 1e6 * time,
                    time / best);
    }
}

void compare_times(std::vector<Method>& methods, const Body<double>& reference) {
    std::printf("\nTo an error of %.0e at t = %.0f; fineness is the step, or the tolerance, and per"
                " step are\nsweeps of gauss, turns and kicks by hand, or evaluations\n",
                wanted_error, until);
    for (Method& method : methods) { method.fineness = coarsest(method, reference); }
    for (int round = 0; round < 15; ++round) {
        for (Method& method : methods) {
            if (method.fineness != 0) { method.times.push_back(timed(method)); }
        }
    }
    print_times(methods, reference);
}

// ---- the same splitting, ours and by hand ----

/// Seconds of the processor for steps of size h; infinite where the run failed.
template <class Moved>
double time_of_steps(double h, std::int64_t steps) {
    Moved mover(h);
    const std::clock_t begin = std::clock();
    mover.advance(h * static_cast<double>(steps), true);
    const std::clock_t time = std::clock() - begin;
    if (!std::isfinite(mover.body().L[0])) { return std::numeric_limits<double>::infinity(); }
    return static_cast<double>(time) / CLOCKS_PER_SEC;
}

template <bool is_heavy>
struct KahanLiByHand : Split<is_heavy> {
    explicit KahanLiByHand(double h) : Split<is_heavy>(h, bench::kahan_li_8()) {}
};

/// Compares steps of size h. NOTE: by hand changes are not summed up with compensation. The least
/// times of many short runs, in turn, are those that nothing else disturbed.
template <bool is_heavy, class Stepper>
void compare_splittings(double h) {
    constexpr std::int64_t steps = 5000;
    double of_ours = std::numeric_limits<double>::infinity(), by_hand = of_ours;
    for (int round = 0; round < 100; ++round) {
        of_ours = std::min(of_ours, time_of_steps<Ours<Stepper>>(h, steps));
        by_hand = std::min(by_hand, time_of_steps<KahanLiByHand<is_heavy>>(h, steps));
    }
    std::printf("a step of strang with kahan-li:8, h = %.2f: ours %.0f ns, by hand %.0f ns, ratio"
                " %.2f\n",
                h, 1e9 * of_ours / steps, 1e9 * by_hand / steps, by_hand / of_ours);
}

// ---- what is conserved ----

struct Kept {
    double energy = 0, spin = 0, defect = 0;  ///< largest so far

    template <bool is_heavy>
    void look(const Mover& mover, double energy_at_start, const std::array<double, 3>& J) {
        const Body<double> x = mover.body();
        energy = std::max(energy, std::fabs(bench::energy<is_heavy>(x) / energy_at_start - 1));
        const auto now = bench::spin(x);
        for (std::size_t i = is_heavy ? 2 : 0; i < 3; ++i) {
            spin = std::max(spin, std::fabs(now[i] - J[i]));
        }
        defect = std::max(defect, mover.defect());
    }
};

/// Looks seven times in twenty steps of ours, at all the phases of a period.
template <bool is_heavy>
void print_kept(const Method& method, double periods) {
    const double h = period() / steps_of_period, between = 7 * h;
    const double J_of[3] = {periods / 100, periods / 10, periods};
    const auto mover = method.make(method.has_tolerance ? method.fineness : h);
    const double H = bench::energy<is_heavy>(start<double>());
    const auto J = bench::spin(start<double>());
    Kept kept, parts[3];
    std::int64_t looks = 0;
    for (std::size_t part = 0; part < 3; ++part) {
        for (; static_cast<double>(looks) * between < J_of[part] * period(); ++looks) {
            mover->advance(between, false);
            kept.look<is_heavy>(*mover, H, J);
        }
        parts[part] = kept;
    }
    std::printf("%-22s %9.1e %9.1e %9.1e %8.2f %11.1e %11.1e\n", method.name.c_str(),
                parts[0].energy, parts[1].energy, parts[2].energy,
                std::log10(parts[2].energy / parts[0].energy) / 2, kept.spin, kept.defect);
    std::fflush(stdout);
}

template <bool is_heavy>
void compare_conserved(const std::vector<Method>& methods, double periods) {
    std::printf("\nOver %.0f periods, in %.0e steps of ours and of splittings, and with the"
                " tolerances above:\nlargest relative errors of the energy up to a hundredth, a"
                " tenth and the end, the exponent with\nwhich they grow, departures of %s, and of"
                " R^T R or |q| from 1\n",
                periods, periods * steps_of_period, is_heavy ? "(R L)_3" : "R L");
    std::printf("%-22s %9s %9s %9s %8s %11s %11s\n", "", "1/100", "1/10", "energy", "exponent",
                "momentum", "rotation");
    for (const Method& method : methods) { print_kept<is_heavy>(method, periods); }
}

// ---- the comparison ----

/// Computes the end with our stepper in long double. A splitting by hand must agree, up to its
/// rounding errors, which the heavy top magnifies.
template <class Fine>
Body<double> reference_of(const Method& other) {
    Ours<Fine> fine(until / 1000);
    fine.advance(until, true);
    const double departs = error_of(other, until / 4000, fine.body());
    std::printf("reference: departs by %.1e from %s\n", departs, other.name.c_str());
    if (!(departs < 1e-9)) {
        std::fprintf(stderr, "error: they do something else\n");
        std::exit(1);
    }
    return fine.body();
}

template <bool is_heavy, class Fine, class Splitting>
void compare(const char* title, std::vector<Method> methods, double h, double periods) {
    std::printf("\n== %s ==\n", title);
    compare_splittings<is_heavy, Splitting>(h);
    methods.push_back(ours<Splitting>("strang, kahan-li:8"));
    add_others<is_heavy>(methods);
    const Body<double> reference = reference_of<Fine>(methods[7]);
    compare_times(methods, reference);
    compare_conserved<is_heavy>(methods, periods);
}

}  // namespace

int main(int argc, char** argv) {
    using namespace hvi::generated;
    const double given = argc > 1 ? std::atof(argv[1]) : 0;
    const double periods = given > 0 ? given : 1e6;
    compare<false, BasicFreeGauss6<long double>, FreeKahanLi>(
        "free body",
        {ours<FreeGauss2>("gauss:2"), ours<FreeGauss4>("gauss:4"), ours<FreeGauss6>("gauss:6")},
        0.25, periods);
    compare<true, BasicTopGauss6<long double>, TopKahanLi>(
        "heavy top",
        {ours<TopGauss2>("gauss:2"), ours<TopGauss4>("gauss:4"), ours<TopGauss6>("gauss:6")}, 0.1,
        periods);
    return 0;
}
