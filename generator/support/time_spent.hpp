// The run time of parts of a program.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace hvi::gen {

/// Seconds of wall time by their use, in the order of first use.
class TimeSpent {
public:
    /// Counts while it lives.
    class Part {
    public:
        Part(TimeSpent& all, std::string what) : all_(all), what_(std::move(what)) {}
        ~Part() {
            const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start_;
            all_.add(what_, taken.count());
        }
        Part(const Part&) = delete;
        Part& operator=(const Part&) = delete;

    private:
        TimeSpent& all_;
        std::string what_;
        std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    };

    void add(const std::string& what, double seconds) {
        for (auto& [name, sum] : parts_)
            if (name == what) {
                sum += seconds;
                return;
            }
        parts_.emplace_back(what, seconds);
    }

    [[nodiscard]] const std::vector<std::pair<std::string, double>>& parts() const {
        return parts_;
    }

private:
    std::vector<std::pair<std::string, double>> parts_;
};

}  // namespace hvi::gen
