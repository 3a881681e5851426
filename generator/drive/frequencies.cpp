// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/frequencies.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/Cholesky>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <unsupported/Eigen/FFT>

#include "generator/drive/window.hpp"

namespace hvi::gen {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A term a cos(frequency tau) + b sin(frequency tau); tau is measured from the middle of the
/// samples.
struct Pair {
    double frequency = 0, a = 0, b = 0;
    double home = 0;  ///< its frequency stays near this, and others stay away

    [[nodiscard]] double amplitude() const { return std::hypot(a, b); }
};

/// A sum of a mean and pairs that is fitted to some samples.
class Fit {
public:
    explicit Fit(std::span<const double> values)
        : values_(values), window_(values.size()), whole_(window_, values) {
        solve();
    }

    [[nodiscard]] double mean() const { return mean_; }
    [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }

    /// Returns the resolution, 2 pi over the whole time: closer frequencies are not distinguished.
    [[nodiscard]] double resolution() const { return 2 * pi / static_cast<double>(values_.size()); }

    void add(double frequency) {
        pairs_.push_back({frequency, 0, 0, frequency});
        solve();
        improve(10);
    }

    /// Fits each term again, with the others subtracted, until the changes do not affect the
    /// others, but at most `most` times.
    void improve(int most) {
        for (int k = 0; k < most; ++k) {
            double largest = 0;
            for (Pair& pair : pairs_) {
                const std::vector<double> values = rest(&pair);
                const double before = pair.frequency;
                pair.frequency = peak(values, pair.home, resolution() / 2);
                fit_alone(pair, values);
                const double part = std::min(1.0, pair.amplitude() / pairs_.front().amplitude());
                largest = std::max(largest, std::abs(pair.frequency - before) * part);
            }
            solve();
            if (largest <= 4 * epsilon) return;
        }
    }

    /// Returns the samples without the mean and all pairs, except one.
    [[nodiscard]] std::vector<double> rest(const Pair* but = nullptr) const {
        std::vector<double> result(values_.begin(), values_.end());
        for (double& value : result) value -= mean_;
        for (const Pair& pair : pairs_)
            if (&pair != but) take_away(pair, result);
        return result;
    }

    /// Returns the frequency near `about` at which the projection is largest. NOTE: a search for
    /// the largest value gives half of the digits, a search for the zero of the derivative gives
    /// all.
    [[nodiscard]] double peak(const std::vector<double>& values, double about, double by) const {
        const WindowedSamples samples(window_, values);
        const double low = std::max(about - by, resolution() / 2);
        const double high = std::min(about + by, pi - resolution() / 2);
        const auto slope = [&](double frequency) { return projection(samples, frequency).second; };
        const double at_low = slope(low), at_high = slope(high);
        std::uintmax_t most = 60;
        if (at_low > 0 && at_high < 0) {
            const auto root = boost::math::tools::toms748_solve(
                slope, low, high, at_low, at_high, boost::math::tools::eps_tolerance<double>(),
                most);
            return root.first + (root.second - root.first) / 2;
        }
        const auto less = [&](double frequency) { return -projection(samples, frequency).first; };
        return boost::math::tools::brent_find_minima(less, low, high, 30, most).first;
    }

private:
    void fit_alone(Pair& pair, const std::vector<double>& values) const {
        const auto f = WindowedSamples(window_, values).products(pair.frequency);
        const double w = window_.transform(2 * pair.frequency);
        pair.a = 2 * f.cosine / (1 + w);
        pair.b = 2 * f.sine / (1 - w);
    }

    /// Returns half the square of the projection of samples onto cos and sin, which are orthogonal,
    /// and its derivative by the frequency.
    [[nodiscard]] std::pair<double, double> projection(const WindowedSamples& samples,
                                                       double frequency) const {
        const WindowedSamples::Products f = samples.products(frequency);
        const double w = window_.transform(2 * frequency);
        const double w_slope = 2 * window_.transform_slope(2 * frequency);
        const double c = 1 + w, s = 1 - w;  // twice the squares of the norms of cos and sin
        const double value = f.cosine * f.cosine / c + f.sine * f.sine / s;
        const double slope = 2 * f.cosine * f.cosine_slope / c -
                             f.cosine * f.cosine * w_slope / (c * c) +
                             2 * f.sine * f.sine_slope / s + f.sine * f.sine * w_slope / (s * s);
        return {value, slope};
    }

    void take_away(const Pair& pair, std::vector<double>& from) const {
        for_each_turn(
            pair.frequency, window_.time(0), from.size(),
            [&](std::size_t k, double c, double s) { from[k] -= pair.a * c + pair.b * s; });
    }

    /// Fits the mean and the amplitudes. The cosines, with the constant 1, and the sines are
    /// orthogonal to each other and are fitted separately.
    void solve() {
        const auto n = static_cast<Eigen::Index>(pairs_.size());
        Eigen::MatrixXd cosines(n + 1, n + 1), sines(n, n);
        Eigen::VectorXd by_cosines(n + 1), by_sines(n);
        const auto frequency = [&](Eigen::Index i) {
            return i == n ? 0 : pairs_[static_cast<std::size_t>(i)].frequency;
        };
        for (Eigen::Index i = 0; i <= n; ++i) {
            const WindowedSamples::Products f = whole_.products(frequency(i));
            by_cosines(i) = f.cosine;
            if (i < n) by_sines(i) = f.sine;
            for (Eigen::Index j = 0; j <= n; ++j) {
                const double difference = window_.transform(frequency(i) - frequency(j));
                const double sum = window_.transform(frequency(i) + frequency(j));
                cosines(i, j) = (difference + sum) / 2;
                if (i < n && j < n) sines(i, j) = (difference - sum) / 2;
            }
        }
        const Eigen::VectorXd a = cosines.ldlt().solve(by_cosines);
        const Eigen::VectorXd b = sines.ldlt().solve(by_sines);
        mean_ = a(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            pairs_[static_cast<std::size_t>(i)].a = a(i);
            pairs_[static_cast<std::size_t>(i)].b = b(i);
        }
    }

    std::span<const double> values_;
    HanningWindow window_;
    WindowedSamples whole_;
    double mean_ = 0;
    std::vector<Pair> pairs_;
};

/// The largest amplitude of the spectrum that belongs to no known term. Zeros after the samples
/// make their number a power of two.
struct SpectralPeak {
    double frequency = 0, amplitude = 0, by = 0;
};

std::optional<SpectralPeak> largest_peak(const Fit& fit) {
    std::vector<double> values = fit.rest();
    const HanningWindow window(values.size());
    for (std::size_t k = 0; k < values.size(); ++k) values[k] *= window.weight(k);
    values.resize(std::bit_ceil(values.size()));
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double>().fwd(spectrum, values);
    const double spacing = 2 * pi / static_cast<double>(values.size());
    const double apart = 2 * fit.resolution();
    const auto is_known = [&](double frequency) {
        return frequency < apart || frequency > pi - apart ||
               std::any_of(fit.pairs().begin(), fit.pairs().end(), [&](const Pair& pair) {
                   return std::abs(pair.frequency - frequency) < apart;
               });
    };
    std::optional<SpectralPeak> best;
    for (std::size_t k = 1; k < values.size() / 2; ++k) {
        const double frequency = spacing * static_cast<double>(k);
        const double amplitude = 2 * std::abs(spectrum[k]);
        if ((best && amplitude <= best->amplitude) || is_known(frequency)) continue;
        best = {frequency, amplitude, spacing};
    }
    return best;
}

constexpr std::size_t samples_of_term = 16;

/// The most sweeps over all terms: each makes the disturbances by others much smaller.
constexpr int most_sweeps = 30;

/// Returns the mean and the main terms of samples.
Fit fitted(std::span<const double> values, std::size_t most) {
    double size = 0;
    for (const double value : values) size = std::max(size, std::abs(value));
    // NOTE: lines are several times 2 pi over the whole time apart.
    most = std::min(most, values.size() / samples_of_term);
    Fit fit(values);
    while (fit.pairs().size() < most) {
        const auto peak = largest_peak(fit);
        if (!peak || peak->amplitude <= 16 * epsilon * size) break;
        fit.add(fit.peak(fit.rest(), peak->frequency, peak->by));
    }
    fit.improve(most_sweeps);
    return fit;
}

/// Returns the distance of a frequency from the nearest one of a fit.
double distance(double frequency, const Fit& from) {
    double nearest = pi;
    for (const Pair& pair : from.pairs())
        nearest = std::min(nearest, std::abs(pair.frequency - frequency));
    return nearest;
}

/// Numbers of the size of 1, and the power of two that restores their size: their squares stay
/// finite.
struct Normalized {
    std::vector<double> values;
    int exponent = 0;
};

Normalized normalized(const std::vector<double>& values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    Normalized result{values, largest == 0 ? 0 : std::ilogb(largest)};
    for (double& value : result.values) value = std::scalbn(value, -result.exponent);
    return result;
}

/// Returns the phase at time 0, from -pi to pi, of a pair whose middle is at another time.
double phase_at_zero(const Pair& pair, const Samples& samples) {
    using Long = long double;
    const Long middle = static_cast<Long>(samples.values.size() - 1) / 2;
    const Long tau = -static_cast<Long>(samples.first) / static_cast<Long>(samples.step) - middle;
    const Long angle =
        static_cast<Long>(pair.frequency) * tau - static_cast<Long>(std::atan2(pair.b, pair.a));
    const auto phase =
        static_cast<double>(std::remainder(angle, 2 * std::numbers::pi_v<long double>));
    return samples.step < 0 ? -phase : phase;
}

}  // namespace

std::vector<FrequencyTerm> frequencies(const Samples& samples, std::size_t most) {
    const Normalized of_size_one = normalized(samples.values);
    const std::span<const double> values(of_size_one.values);
    const std::size_t half = values.size() / 2;
    const Fit fit = fitted(values, most), first = fitted(values.first(half), most),
              last = fitted(values.last(half), most);
    const double unit = 1 / std::abs(samples.step);
    const auto amplitude = [&](double value) { return std::scalbn(value, of_size_one.exponent); };
    std::vector<FrequencyTerm> terms;
    for (const Pair& pair : fit.pairs()) {
        const double off =
            std::max(distance(pair.frequency, first), distance(pair.frequency, last));
        const double rounding =
            4 * epsilon * (pair.frequency + fit.resolution() / pair.amplitude());
        terms.push_back({pair.frequency * unit, amplitude(pair.amplitude()),
                         phase_at_zero(pair, samples), (off + rounding) * unit});
    }
    std::stable_sort(terms.begin(), terms.end(), [](const auto& left, const auto& right) {
        return left.amplitude > right.amplitude;
    });
    terms.insert(terms.begin(), {0, amplitude(std::abs(fit.mean())), fit.mean() < 0 ? pi : 0, 0});
    return terms;
}

}  // namespace hvi::gen
