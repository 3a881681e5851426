// Times everything in one run and prints ratios of median times last.
// SPDX-License-Identifier: MIT
//
// Several repetitions in random order, and their medians, so that a slow or busy machine matters
// little.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace bench {

/// The time of the benchmark `what` over the time of `by`, with its wanted value in words.
struct Ratio {
    std::string what, by;
    const char* wanted;
};

/// Prints as usual and keeps the medians.
class Medians : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs) {
            if (run.aggregate_name == "median") {
                // NOTE: benchmarks with several threads are measured in real time.
                medians_[run.run_name.function_name] = run.run_name.time_type.empty()
                                                           ? run.GetAdjustedCPUTime()
                                                           : run.GetAdjustedRealTime();
            }
        }
    }

    /// Nothing where one of the two was not timed.
    void print(const Ratio& ratio) const {
        const auto numerator = medians_.find(ratio.what);
        const auto denominator = medians_.find(ratio.by);
        if (numerator == medians_.end() || denominator == medians_.end()) { return; }
        std::printf("%-28s / %-28s = %6.2f   (%s)\n", ratio.what.c_str(), ratio.by.c_str(),
                    numerator->second / denominator->second, ratio.wanted);
    }

private:
    std::map<std::string, double> medians_;
};

/// Runs the registered benchmarks with the options of the command line; the exit code of main().
inline int time_all(int argc, char** argv, const std::vector<Ratio>& ratios) {
    std::vector<std::string> words(argv, argv + argc);
    words.insert(words.begin() + 1,
                 {"--benchmark_repetitions=9", "--benchmark_enable_random_interleaving=true",
                  "--benchmark_min_time=0.1", "--benchmark_report_aggregates_only=true"});
    std::vector<char*> arguments;
    for (std::string& word : words) { arguments.push_back(word.data()); }
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) { return 2; }

    Medians medians;
    benchmark::RunSpecifiedBenchmarks(&medians);
    std::printf("\nRatios of median times:\n");
    for (const Ratio& ratio : ratios) { medians.print(ratio); }
    return 0;
}

}  // namespace bench
