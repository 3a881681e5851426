// Tells energies that drift from energies that walk at random.
// SPDX-License-Identifier: MIT
//
// A symplectic step whose roundings have no bias leaves an energy that walks at random, with the
// square root of the number of steps; one whose roundings have a bias makes it drift, with the
// number of steps itself. Each row takes several neighbouring starts and from each a million steps,
// fits a line to the means of windows, and compares the mean slope with its standard error.
//
//     bench_drift [--steps=N] [--starts=N] [WORD...]
//
// measures the rows in which all words occur. The table does not depend on the machine's load nor
// on the number of its processors; progress goes to stderr.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "drift/measure.hpp"

namespace {

using drift::Means;
using drift::Row;

/// A slope is a drift where it is more than this many standard errors,
constexpr double clear = 4;
/// and more than this much of |H| a step: 1e-9 of it in 2e11 steps.
constexpr double worth_a_word = 5e-21;

struct Wishes {
    long steps = 1'000'000;
    int starts = 16;
    std::vector<std::string> words;
};

// ---- statistics ----

/// Returns the slope by least squares.
double slope_of(const std::vector<double>& x, const std::vector<double>& y) {
    const auto count = static_cast<double>(x.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        sx += x[k];
        sy += y[k];
        sxx += x[k] * x[k];
        sxy += x[k] * y[k];
    }
    return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

struct Drift {
    double slope = 0, error = 0;  ///< relative to |H|, a step
    double exponent = 0;  ///< exponent of the growth of the root mean square over the starts
};

Drift drift_of(const std::vector<Means>& all, double steps_of_window) {
    std::vector<double> slopes;
    for (const Means& means : all) {
        std::vector<double> x, y;
        for (std::size_t w = 0; w < means.size(); ++w) {
            x.push_back(static_cast<double>(w) * steps_of_window);
            y.push_back(static_cast<double>(means[w] - means[0]));
        }
        slopes.push_back(slope_of(x, y));
    }
    const auto count = static_cast<double>(slopes.size());
    Drift drift;
    double squares = 0;
    for (const double slope : slopes) { drift.slope += slope / count; }
    for (const double slope : slopes) { squares += (slope - drift.slope) * (slope - drift.slope); }
    drift.error = std::sqrt(squares / (count - 1) / count);

    std::vector<double> x, y;
    for (std::size_t w = 1; w < drift::windows; ++w) {
        double square = 0;
        for (const Means& means : all) {
            const auto moved = static_cast<double>(means[w] - means[0]);
            square += moved * moved;
        }
        x.push_back(std::log(static_cast<double>(w)));
        y.push_back(std::log(square) / 2);
    }
    drift.exponent = slope_of(x, y);
    return drift;
}

// ---- the table ----

std::string name_of(const Row& row) {
    char h[32];
    std::snprintf(h, sizeof h, "%.8g", row.h);
    return row.form + ' ' + row.scene + ' ' + row.method + ' ' + row.layout + " h=" + h;
}

void print_head() {
    std::printf("%-10s %-18s %-26s %-10s %10s   %-19s %6s %5s\n", "form", "scene", "method",
                "layout", "h", "1e-19 |H| a step", "sigma", "exp");
}

void print(const Row& row, const Drift& drift) {
    const double sigmas = std::fabs(drift.slope) / drift.error;
    const bool drifts = sigmas > clear && std::fabs(drift.slope) > worth_a_word;
    std::printf("%-10s %-18s %-26s %-10s %10.8g   %+8.3f +- %7.3f %6.1f %5.2f  %s\n",
                row.form.c_str(), row.scene.c_str(), row.method.c_str(), row.layout.c_str(), row.h,
                1e19 * drift.slope, 1e19 * drift.error, sigmas, drift.exponent,
                drifts ? "drift" : "random walk");
}

void print_failure(const Row& row, const std::string& message) {
    std::printf("%-10s %-18s %-26s %-10s %10.8g   %s\n", row.form.c_str(), row.scene.c_str(),
                row.method.c_str(), row.layout.c_str(), row.h, message.c_str());
}

/// Measures rows on all processors and prints each as soon as those before it are known.
class Table {
public:
    Table(std::vector<Row> rows, const Wishes& wishes)
        : rows_(std::move(rows)), results_(rows_.size()) {
        for (std::size_t r = 0; r < rows_.size(); ++r) {
            const double steps = rows_[r].share * static_cast<double>(wishes.steps);
            weights_.push_back(
                drift::smooth_weights(std::max(100L, std::lround(steps / drift::windows))));
            for (int start = 1; start <= wishes.starts; start += rows_[r].at_once) {
                tasks_.push_back({r, start});
                ++results_[r].missing;
            }
        }
    }

    void measure() {
        print_head();
        std::vector<std::thread> threads;
        for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k) {
            threads.emplace_back([this] { work(); });
        }
        for (std::thread& thread : threads) { thread.join(); }
    }

private:
    using Clock = std::chrono::steady_clock;

    struct Task {
        std::size_t row;
        int start;
    };
    struct Result {
        std::vector<std::pair<int, std::vector<Means>>> parts;  ///< by start
        std::string failure;
        int missing = 0;
        double seconds = 0;
    };

    void work() {
        for (;;) {
            const std::size_t next = next_++;
            if (next >= tasks_.size()) { return; }
            const Task& task = tasks_[next];
            const auto begin = Clock::now();
            std::vector<Means> means;
            std::string failure;
            try {
                means = rows_[task.row].run(task.start, weights_[task.row]);
            } catch (const std::exception& error) { failure = error.what(); }
            const std::chrono::duration<double> time = Clock::now() - begin;
            const std::lock_guard<std::mutex> lock(mutex_);
            Result& result = results_[task.row];
            result.parts.emplace_back(task.start, std::move(means));
            result.seconds += time.count();
            if (!failure.empty()) { result.failure = failure; }
            if (--result.missing == 0) { finish(task.row); }
        }
    }

    void finish(std::size_t row) {
        ++finished_;
        std::fprintf(stderr, "%zu of %zu: %s, %.1f s\n", finished_, rows_.size(),
                     name_of(rows_[row]).c_str(), results_[row].seconds);
        for (; printed_ < rows_.size() && results_[printed_].missing == 0; ++printed_) {
            print_result(printed_);
        }
        std::fflush(stdout);
    }

    void print_result(std::size_t r) {
        const Row& row = rows_[r];
        Result& result = results_[r];
        if (!result.failure.empty()) { return print_failure(row, result.failure); }
        std::sort(result.parts.begin(), result.parts.end(),
                  [](const auto& a, const auto& b) { return a.first < b.first; });
        std::vector<Means> all;
        for (const auto& [start, means] : result.parts) {
            all.insert(all.end(), means.begin(), means.end());
        }
        print(row, drift_of(all, static_cast<double>(weights_[r].size())));
    }

    std::vector<Row> rows_;
    std::vector<drift::Weights> weights_;  ///< for each row
    std::vector<Task> tasks_;
    std::vector<Result> results_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::size_t finished_ = 0, printed_ = 0;
};

Wishes wishes_of(int argc, char** argv) {
    Wishes wishes;
    for (int k = 1; k < argc; ++k) {
        const std::string_view word = argv[k];
        const auto number = [&](std::string_view option) {
            return std::atol(word.substr(option.size()).data());
        };
        if (word.substr(0, 8) == "--steps=") {
            wishes.steps = number("--steps=");
        } else if (word.substr(0, 9) == "--starts=") {
            wishes.starts = static_cast<int>(std::max(2L, number("--starts=")));
        } else {
            wishes.words.emplace_back(word);
        }
    }
    return wishes;
}

bool has_all(const std::string& name, const std::vector<std::string>& words) {
    return std::all_of(words.begin(), words.end(), [&](const std::string& word) {
        return (name + ' ').find(word) != std::string::npos;
    });
}

}  // namespace

int main(int argc, char** argv) {
    const Wishes wishes = wishes_of(argc, argv);
    std::vector<Row> rows;
    drift::add_positions(rows);
    drift::add_pairs(rows);
    drift::add_lagrangian(rows);
    drift::add_galerkin(rows);
    drift::add_charts(rows);
    drift::add_explicit(rows);
    drift::add_stiff(rows);
    rows.erase(std::remove_if(rows.begin(), rows.end(),
                              [&](const Row& row) { return !has_all(name_of(row), wishes.words); }),
               rows.end());
    if (rows.empty()) {
        std::fprintf(stderr, "error: no row has all of these words\n");
        return 2;
    }
    Table(std::move(rows), wishes).measure();
    return 0;
}
