// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/window.hpp"

#include <cmath>
#include <numbers>

namespace hvi::gen {

HanningWindow::HanningWindow(std::size_t count) : count_(count) {}

double HanningWindow::weight(std::size_t k) const {
    const auto n = static_cast<double>(count_);
    return (1 + std::cos(2 * std::numbers::pi * time(k) / n)) / n;
}

namespace {

/// Returns the sum of cos(f tau) over n times, sin(n f/2)/sin(f/2), and its derivative by f.
double kernel(double n, double f) {
    const double below = std::sin(f / 2);
    return below == 0 ? n : std::sin(n * f / 2) / below;
}

double kernel_slope(double n, double f) {
    const double below = std::sin(f / 2);
    if (below == 0) return 0;
    return (n * std::cos(n * f / 2) - std::sin(n * f / 2) * std::cos(f / 2) / below) / (2 * below);
}

/// Returns the kernel of the weights, from the kernel of equal weights.
template <class Kernel>
double under_window(double n, double f, Kernel of) {
    const double shift = 2 * std::numbers::pi / n;
    return (of(n, f) + (of(n, f + shift) + of(n, f - shift)) / 2) / n;
}

}  // namespace

double HanningWindow::transform(double frequency) const {
    return under_window(static_cast<double>(count_), frequency, kernel);
}

double HanningWindow::transform_slope(double frequency) const {
    return under_window(static_cast<double>(count_), frequency, kernel_slope);
}

WindowedSamples::WindowedSamples(const HanningWindow& window, std::span<const double> values)
    : first_(window.count() % 2 == 0 ? 0.5 : 0) {
    const std::size_t n = window.count();
    for (std::size_t k = n / 2; k < n; ++k) {
        const std::size_t mirrored = n - 1 - k;
        const double weight = k == mirrored ? window.weight(k) / 2 : window.weight(k);
        even_.push_back(weight * (values[k] + values[mirrored]));
        odd_.push_back(weight * (values[k] - values[mirrored]));
    }
}

WindowedSamples::Products WindowedSamples::products(double frequency) const {
    Products sums;
    for_each_turn(frequency, first_, even_.size(), [&](std::size_t k, double c, double s) {
        const double tau = first_ + static_cast<double>(k);
        sums.cosine += even_[k] * c;
        sums.sine += odd_[k] * s;
        sums.cosine_slope -= even_[k] * tau * s;
        sums.sine_slope += odd_[k] * tau * c;
    });
    return sums;
}

}  // namespace hvi::gen
