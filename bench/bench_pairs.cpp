// Forces of n bodies on one another, as hvi-gen writes them, against loops written by hand.
// SPDX-License-Identifier: MIT
//
// All of H = - sum_{i<j} G m_i m_j / sqrt(r^2 + eps^2), from the same positions. Before anything is
// timed, all compute the same forces.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <hvi/detail/lanes/lane_functions.hpp>
#include <hvi/detail/loops/along.hpp>
#include <hvi/detail/loops/chunks.hpp>

#include "report.hpp"

namespace {

using hvi::detail::Place;
using hvi::detail::Team;

constexpr double G = 1, eps = 0.01;

struct Bodies {
    explicit Bodies(std::size_t n) : m(n), q(3 * n) {
        std::mt19937_64 random(n);
        std::uniform_real_distribution<double> number(-1, 1);
        for (double& x : q) { x = number(random); }
        for (double& x : m) { x = 1.5 + number(random); }
    }
    std::vector<double> m, q;
};

// ---- as hvi-gen writes it ----

template <std::size_t width>
void add_pairs(const Bodies& bodies, double* out, Place from, Place to, Place stride) {
    const Place n = static_cast<Place>(bodies.m.size());
    const double* const m = bodies.m.data();
    const double* const x = bodies.q.data();
    const double* const y = x + n;
    const double* const z = y + n;
    double* const out_x = out;
    double* const out_y = out + n;
    double* const out_z = out + 2 * n;
    const double eps2 = eps * eps;
    for (Place i = from; i < to; i += stride) {
        const double x_i = x[i], y_i = y[i], z_i = z[i];
        const double g_i = G * m[i];
        hvi::detail::Total<double, width> total_x, total_y, total_z;
        hvi::detail::along<double, width>(i + 1, n, [&](auto stretch, Place j) HVI_INLINED {
            const auto dx = x_i - stretch.load(x + j);
            const auto dy = y_i - stretch.load(y + j);
            const auto dz = z_i - stretch.load(z + j);
            const auto r2 = dx * dx + dy * dy + dz * dz + eps2;
            const auto f = g_i * stretch.load(m + j) / (r2 * hvi::math::sqrt(r2));
            const auto f_x = f * dx;
            const auto f_y = f * dy;
            const auto f_z = f * dz;
            total_x.add(f_x);
            total_y.add(f_y);
            total_z.add(f_z);
            hvi::detail::subtract(out_x + j, f_x);
            hvi::detail::subtract(out_y + j, f_y);
            hvi::detail::subtract(out_z + j, f_z);
        });
        out_x[i] += total_x.sum();
        out_y[i] += total_y.sum();
        out_z[i] += total_z.sum();
    }
}

template <std::size_t width>
void ours(const Bodies& bodies, std::vector<double>& out) {
    std::fill(out.begin(), out.end(), 0.0);
    const Place n = static_cast<Place>(bodies.m.size());
    add_pairs<width>(bodies, out.data(), 0, n, 1);
}

// ---- by hand, for g++ to vectorise ----

/// Each pair twice, lanes over i: nothing is scattered, and nothing summed over lanes.
void all_pairs(const Bodies& bodies, std::vector<double>& out) {
    const std::size_t n = bodies.m.size();
    const double* __restrict x = bodies.q.data();
    const double* __restrict m = bodies.m.data();
    double* __restrict a = out.data();
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t j = 0; j < n; ++j) {
        const double x_j = x[j], y_j = x[n + j], z_j = x[2 * n + j], m_j = G * m[j];
        for (std::size_t i = 0; i < n; ++i) {
            const double dx = x[i] - x_j, dy = x[n + i] - y_j, dz = x[2 * n + i] - z_j;
            const double r2 = dx * dx + dy * dy + dz * dz + eps * eps;
            const double f = m_j * m[i] / (r2 * std::sqrt(r2));
            a[i] += f * dx;
            a[n + i] += f * dy;
            a[2 * n + i] += f * dz;
        }
    }
}

/// Each pair twice, lanes over j, summed at the end.
void all_pairs_summed(const Bodies& bodies, std::vector<double>& out) {
    const std::size_t n = bodies.m.size();
    const double* __restrict x = bodies.q.data();
    const double* __restrict m = bodies.m.data();
    double* __restrict a = out.data();
    for (std::size_t i = 0; i < n; ++i) {
        const double x_i = x[i], y_i = x[n + i], z_i = x[2 * n + i], m_i = G * m[i];
        double a_x = 0, a_y = 0, a_z = 0;
#pragma omp simd reduction(+ : a_x, a_y, a_z)
        for (std::size_t j = 0; j < n; ++j) {
            const double dx = x_i - x[j], dy = y_i - x[n + j], dz = z_i - x[2 * n + j];
            const double r2 = dx * dx + dy * dy + dz * dz + eps * eps;
            const double f = m_i * m[j] / (r2 * std::sqrt(r2));
            a_x += f * dx;
            a_y += f * dy;
            a_z += f * dz;
        }
        a[i] = a_x;
        a[n + i] = a_y;
        a[2 * n + i] = a_z;
    }
}

/// Each pair once.
void triangle(const Bodies& bodies, std::vector<double>& out) {
    const std::size_t n = bodies.m.size();
    const double* __restrict x = bodies.q.data();
    const double* __restrict m = bodies.m.data();
    double* __restrict a = out.data();
    std::fill(out.begin(), out.end(), 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        const double x_i = x[i], y_i = x[n + i], z_i = x[2 * n + i], m_i = G * m[i];
        double a_x = 0, a_y = 0, a_z = 0;
#pragma omp simd reduction(+ : a_x, a_y, a_z)
        for (std::size_t j = i + 1; j < n; ++j) {
            const double dx = x_i - x[j], dy = y_i - x[n + j], dz = z_i - x[2 * n + j];
            const double r2 = dx * dx + dy * dy + dz * dz + eps * eps;
            const double f = m_i * m[j] / (r2 * std::sqrt(r2));
            a_x += f * dx;
            a_y += f * dy;
            a_z += f * dz;
            a[j] -= f * dx;
            a[n + j] -= f * dy;
            a[2 * n + j] -= f * dz;
        }
        a[i] += a_x;
        a[n + i] += a_y;
        a[2 * n + i] += a_z;
    }
}

// ---- timings ----

using Forces = void (*)(const Bodies&, std::vector<double>&);

bool agree(Forces forces, const Bodies& bodies) {
    std::vector<double> expected(bodies.q.size()), out(bodies.q.size());
    all_pairs_summed(bodies, expected);
    forces(bodies, out);
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (!(std::abs(out[i] - expected[i]) < 1e-9 * (1 + std::abs(expected[i])))) {
            return false;
        }
    }
    return true;
}

double pairs_of(std::size_t n) { return static_cast<double>(n) * static_cast<double>(n - 1) / 2; }

/// Counts pairs i < j, whoever computes them twice: 300M/s are 3.3 ns for each.
void time(const std::string& name, Forces forces, std::size_t n) {
    const Bodies bodies(n);
    if (!agree(forces, bodies)) {
        std::fprintf(stderr, "%s: other forces\n", name.c_str());
        std::exit(1);
    }
    benchmark::RegisterBenchmark(
        (name + "_" + std::to_string(n)).c_str(), [=](benchmark::State& state) {
            std::vector<double> out(3 * n);
            for (auto _ : state) {
                forces(bodies, out);
                benchmark::DoNotOptimize(out.data());
                benchmark::ClobberMemory();
            }
            state.counters["pairs"] =
                benchmark::Counter(pairs_of(n), benchmark::Counter::kIsIterationInvariantRate);
        });
}

void time_threads(unsigned threads, std::size_t n) {
    const Bodies bodies(n);
    benchmark::RegisterBenchmark(
        (std::to_string(threads) + "_threads_" + std::to_string(n)).c_str(),
        [=](benchmark::State& state) {
            Team team(threads);
            std::vector<double> out(3 * n), memory;
            for (auto _ : state) {
                std::fill(out.begin(), out.end(), 0.0);
                hvi::detail::chunked(team, 0, static_cast<Place>(n), out.data(), out.size(), memory,
                                     [&](Place from, Place to, Place stride, double* to_out) {
                                         add_pairs<4>(bodies, to_out, from, to, stride);
                                     });
                benchmark::DoNotOptimize(out.data());
                benchmark::ClobberMemory();
            }
            state.counters["pairs"] =
                benchmark::Counter(pairs_of(n), benchmark::Counter::kIsIterationInvariantRate);
        })
        ->UseRealTime();
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<bench::Ratio> ratios;
    for (const std::size_t n : {20U, 100U, 1000U}) {
        time("width_8", ours<8>, n);
        time("width_4", ours<4>, n);
        time("all_pairs", all_pairs, n);
        time("all_pairs_summed", all_pairs_summed, n);
        time("triangle", triangle, n);
        const std::string size = "_" + std::to_string(n);
        for (const char* by : {"all_pairs", "all_pairs_summed", "triangle"}) {
            ratios.push_back({"width_4" + size, by + size, "at most 1.0"});
        }
        ratios.push_back({"width_4" + size, "width_8" + size, "at most 1.05"});
    }
    for (const unsigned threads : {1U, 2U}) { time_threads(threads, 2000); }
    ratios.push_back({"1_threads_2000", "2_threads_2000", "at least 1.8 with two processors"});
    return bench::time_all(argc, argv, ratios);
}
