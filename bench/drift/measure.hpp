// Measures how the energy of a stepper moves over many steps.
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include <hvi/detail/trajectories/flat.hpp>
#include <hvi/ensemble.hpp>

namespace drift {

constexpr int windows = 16;

/// Mean energies of one motion in windows of equal length that follow each other, less its energy
/// at the start, over the size of that.
using Means = std::array<long double, windows>;

/// Weights of the steps of a window. They go to zero smoothly at both ends: oscillations vanish
/// from the mean faster than any power of the length, also where no period divides it.
using Weights = std::vector<double>;

inline Weights smooth_weights(long steps) {
    Weights weights;
    double sum = 0;
    for (long i = 0; i < steps; ++i) {
        const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(steps);
        weights.push_back(std::exp(-1 / (u * (1 - u))));
        sum += weights.back();
    }
    for (double& weight : weights) { weight /= sum; }
    return weights;
}

/// One line of the table. `run(start, weights)` makes as many motions as begin `at_once`, from the
/// neighbours `start`, `start` + 1, ... of where the scene begins.
struct Row {
    std::string form, scene, method, layout;
    double h;
    double share;  ///< relative number of steps, lower where they are slow
    int at_once;
    std::function<std::vector<Means>(int, const Weights&)> run;
};

/// A neighbour of where the scene begins. Of bodies only the angular momenta are others, so that
/// rotations stay rotations.
template <class Stepper>
auto neighbour(int start) {
    auto x = Stepper::initial();
    const auto move = [&](auto& numbers, double by, std::size_t different) {
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            numbers[k] *= 1 + by * start * static_cast<double>(k % different + 1);
        }
    };
    if constexpr (hvi::detail::HasFlat<Stepper>::value) {
        auto at = Stepper::flat(x);
        move(at.p, 1e-3, 3);
        Stepper::set(x, at);
    } else {
        move(x.q, 0.7e-3, 1);
        move(x.p, 1e-3, 3);
    }
    return x;
}

/// The energy in long double of a state in double. `Fine` is the stepper of long double.
template <class Stepper, class Fine>
class Energy {
public:
    template <class State>
    long double operator()(const State& x) {
        if constexpr (hvi::detail::HasFlat<Stepper>::value) {
            auto at = Fine::flat(x_);
            copy(Stepper::flat(x), at);
            Fine::set(x_, at);
        } else {
            copy(x, x_);
        }
        return fine_.energy(x_);
    }

private:
    template <class From, class To>
    static void copy(const From& from, To& to) {
        for (std::size_t k = 0; k < from.q.size(); ++k) { to.q[k] = from.q[k]; }
        for (std::size_t k = 0; k < from.p.size(); ++k) { to.p[k] = from.p[k]; }
    }

    Fine fine_;
    decltype(Fine::initial()) x_ = Fine::initial();
};

/// Motions that a stepper advances together: one, or as many as there are lanes in an ensemble.
template <class Stepper>
class Motions {
    static constexpr bool are_lanes = hvi::detail::TakesSeveral<Stepper>::value;

public:
    static constexpr int count = are_lanes ? static_cast<int>(hvi::trajectories_at_once) : 1;

    explicit Motions(int start) {
        if constexpr (are_lanes) {
            for (int k = 0; k < count; ++k) { x_.set(lane(k), neighbour<Stepper>(start + k)); }
        } else {
            x_ = neighbour<Stepper>(start);
        }
    }

    void step(double h) {
        const auto status = stepper_.step(x_, h);
        if (!status.ok()) { throw std::runtime_error(first_of(status).message()); }
    }

    [[nodiscard]] decltype(auto) operator[](int k) const {
        if constexpr (are_lanes) {
            return x_[lane(k)];
        } else {
            return (x_);
        }
    }

private:
    static std::size_t lane(int k) { return static_cast<std::size_t>(k); }
    static hvi::Status first_of(const hvi::Status& status) { return status; }
    static hvi::Status first_of(const hvi::LaneStatus& status) {
        std::size_t k = 0;
        while (status[k].ok()) { ++k; }
        return status[k];
    }

    Stepper stepper_;
    typename Stepper::State x_{};
};

template <class Stepper, class Fine>
std::vector<Means> means_of(double h, int start, const Weights& weights) {
    Motions<Stepper> motions(start);
    Energy<Stepper, Fine> energy;
    std::vector<long double> begin;
    for (int k = 0; k < motions.count; ++k) { begin.push_back(energy(motions[k])); }
    std::vector<Means> all(begin.size(), Means{});
    for (std::size_t window = 0; window < windows; ++window) {
        for (const double weight : weights) {
            motions.step(h);
            for (std::size_t k = 0; k < all.size(); ++k) {
                const long double now = energy(motions[static_cast<int>(k)]);
                all[k][window] += weight * (now - begin[k]);
            }
        }
        for (std::size_t k = 0; k < all.size(); ++k) { all[k][window] /= std::fabs(begin[k]); }
    }
    return all;
}

/// Words of a row about a stepper.
struct Words {
    const char *form, *scene, *method, *layout;
};

/// Rows of one stepper, whose classes in double and long double are the template arguments.
template <class Stepper, class Fine>
void add(std::vector<Row>& rows, const Words& words, std::initializer_list<double> sizes,
         double share = 1) {
    for (const double h : sizes) {
        rows.push_back({words.form, words.scene, words.method, words.layout, h, share,
                        Motions<Stepper>::count, [h](int start, const Weights& weights) {
                            return means_of<Stepper, Fine>(h, start, weights);
                        }});
    }
}

// Each form in a file of its own.
void add_positions(std::vector<Row>& rows);
void add_pairs(std::vector<Row>& rows);
void add_lagrangian(std::vector<Row>& rows);
void add_galerkin(std::vector<Row>& rows);
void add_charts(std::vector<Row>& rows);
void add_explicit(std::vector<Row>& rows);
void add_stiff(std::vector<Row>& rows);

}  // namespace drift
