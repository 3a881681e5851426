// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/edges/energy_shifts.hpp"

#include <cmath>
#include <future>

namespace hvi::gen {

namespace {

/// Returns the start of run i, a little away from the scene's start.
std::vector<double> moved(std::vector<double> start, std::size_t i) {
    for (double& x : start) x *= 1 + 0.01 * static_cast<double>(i);
    return start;
}

std::vector<Heard> runs(const EdgeProgram& program, const std::string& command, const LongRun& run,
                        const std::vector<double>& values) {
    const std::vector<double> start = program.ask({"start"}).answers.numbers("start");
    std::vector<std::future<Heard>> going;
    for (std::size_t i = 0; i < run.starts; ++i)
        going.push_back(std::async(std::launch::async, [&, i] {
            return program.ask(command, run.h, run.steps, moved(start, i), values);
        }));
    std::vector<Heard> all;
    for (std::future<Heard>& each : going) all.push_back(each.get());
    return all;
}

}  // namespace

EnergyShifts energy_shifts(const EdgeProgram& program, const std::string& command,
                           const LongRun& run, const std::vector<double>& values) {
    EnergyShifts result;
    for (const Heard& heard : runs(program, command, run, values)) {
        if (!heard.failure.empty()) return {{}, heard.failure};
        if (heard.answers.text("status") != "ok") return {{}, heard.answers.text("status")};
        const auto windows = heard.answers.numbers("window"),
                   shift = heard.answers.numbers("shift", windows.size());
        result.of_windows.resize(windows.size());
        for (std::size_t k = 0; k < windows.size(); ++k) {
            result.of_windows[k].first = windows[k];
            result.of_windows[k].second += shift[k] * shift[k];
        }
    }
    for (auto& [steps, sum] : result.of_windows)
        sum = std::sqrt(sum / static_cast<double>(run.starts));
    return result;
}

std::vector<std::pair<double, double>> above_zero(const EnergyShifts& shifts) {
    std::vector<std::pair<double, double>> result;
    for (const auto& point : shifts.of_windows)
        if (point.second > 0) result.push_back(point);
    return result;
}

}  // namespace hvi::gen
