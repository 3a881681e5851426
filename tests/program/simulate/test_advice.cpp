// The method that is advised for an accuracy, and the search for it.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "generator/study/path_to_accuracy.hpp"
#include "generator/study/time_to_accuracy.hpp"
#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::gen;
using namespace hvi::test;

namespace {

/// A method whose error is (coarse/steps)^order, and no less than `floor`; it needs as many
/// steps as `least` to come to the end, and a microsecond for each times `cost`.
struct Model {
    int order;
    double coarse, floor = 0, cost = 1;
    std::int64_t least = 0;

    [[nodiscard]] WorkPoint run(std::int64_t steps) const {
        WorkPoint point;
        const auto n = static_cast<double>(steps);
        point.h = 1 / n;
        point.steps = steps;
        point.status = steps < least ? "diverged" : "ok";
        point.error = std::max(floor, std::pow(coarse / n, order));
        if (point.ok()) point.seconds = cost * 1e-6 * n;
        return point;
    }
};

WorkCurve begun(const Model& model, std::int64_t steps) {
    WorkCurve curve;
    curve.order = model.order;
    add_point(curve, model.run(steps));
    return curve;
}

WorkCurve followed(const Model& model, double accuracy, std::int64_t first) {
    WorkCurve curve = begun(model, first);
    while (const auto next = next_count(curve, accuracy)) add_point(curve, model.run(*next));
    return curve;
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("the path to an accuracy ends at the fewest steps, from wherever it begins") {
    for (const int order : {2, 4, 6, 8, 16})
        for (const double accuracy : {1e-2, 1e-5, 1e-9, 1e-12})
            for (const std::int64_t first : {1, 30, 1000, 200'000}) {
                const Model model{order, 20};
                const double fewest = 20 * std::pow(accuracy, -1.0 / order);
                if (fewest > 1e7) continue;
                const WorkCurve curve = followed(model, accuracy, first);
                const auto there = cheapest(curve, accuracy);
                INFO(order << " " << accuracy << " " << first);
                REQUIRE(there);
                CHECK(there->error <= accuracy);
                CHECK(static_cast<double>(there->steps) <= 1.05 * fewest + 1);
                CHECK(curve.points.size() <= 14);
            }
}

TEST_CASE("of two times of the same run the lesser stays") {
    WorkCurve curve = begun({2, 20, 0, 3}, 100);
    add_point(curve, Model{2, 20, 0, 1}.run(100));
    add_point(curve, Model{2, 20, 0, 5}.run(100));
    add_point(curve, Model{2, 20}.run(50));
    REQUIRE(curve.points.size() == 2);
    CHECK(curve.points[0].steps == 50);
    CHECK(curve.points[1].seconds == Approx(1e-4));
}

TEST_CASE("steps that are too large are no obstacle") {
    const Model model{4, 100, 0, 1, 5000};
    const auto there = cheapest(followed(model, 1e-4, 10), 1e-4);
    REQUIRE(there);
    CHECK(there->steps >= 5000);
    CHECK(there->steps <= 5200);
}

TEST_CASE("an accuracy beyond round-off is given up") {
    const WorkCurve curve = followed({8, 20, 1e-13}, 1e-15, 10);
    CHECK_FALSE(cheapest(curve, 1e-15));
    CHECK(curve.points.size() <= 16);
    CHECK(curve.points.back().steps < 1'000'000);
    CHECK_FALSE(fastest({curve}, 1e-15));
}

TEST_CASE("the fastest is that of the least time, not of the fewest steps") {
    // At 1e-8 they take 20 * 10^4, 20 * 10^2, 20 * 10 steps of 1, 3 and 40 microseconds.
    const std::vector<WorkCurve> curves{followed({2, 20, 0, 1}, 1e-8, 100),
                                        followed({4, 20, 0, 3}, 1e-8, 100),
                                        followed({8, 20, 0, 40}, 1e-8, 100)};
    CHECK(fastest(curves, 1e-8) == std::optional<std::size_t>(1));
    CHECK(fastest(curves, 1e-15) == std::nullopt);
}

TEST_CASE("what has no hope is not followed") {
    const double best = 1e-3;
    // At an error of 1e-4 and 1e-8 it is 10^2 times as long as now: 0.02 s.
    CHECK(is_hopeless(begun({2, 2}, 200), 1e-8, best));
    CHECK_FALSE(is_hopeless(begun({4, 20, 0, 1}, 200), 1e-8, best));  // 2 ms
    // An error of 4e-2 may fall faster than with order two: 13 times as long is no reason.
    CHECK_FALSE(is_hopeless(begun({2, 20, 0, 1}, 100), 1e-5, best / 2));
    // At round-off the order says nothing of fewer steps.
    CHECK_FALSE(is_hopeless(begun({16, 20, 1e-15, 100}, 1000), 1e-6, best));
    // Where no run comes to the end nothing is known.
    CHECK_FALSE(is_hopeless(begun({2, 20, 0, 1, 1000}, 100), 1e-8, best));
}

TEST_CASE("the time to an accuracy is on the line between two runs") {
    // Order 4: a tenth of a thousandth of the error takes ten times the steps.
    const Model model{4, 1.0, 0, 1, 100};
    WorkCurve curve;
    CHECK_FALSE(seconds_to(curve, 1e-4));
    add_point(curve, model.run(10));  // it does not come to the end
    CHECK_FALSE(seconds_to(curve, 1e-4));
    add_point(curve, model.run(100));    // 1e-8
    add_point(curve, model.run(10000));  // 1e-16
    CHECK(*seconds_to(curve, 1e-4) == Approx(1e-4).epsilon(1e-12));
    CHECK(*seconds_to(curve, 1e-8) == Approx(1e-4).epsilon(1e-12));
    CHECK(*seconds_to(curve, 1e-12) == Approx(1e-3).epsilon(1e-12));
    CHECK_FALSE(seconds_to(curve, 1e-17));
}

TEST_CASE("methods and those of other libraries are told apart") {
    SceneReport scene;
    const auto add = [&](const std::string& name, double cost, bool is_peer) {
        WorkCurve& curve = scene.curves.emplace_back();
        curve.name = name;
        curve.is_peer = is_peer;
        for (const int steps : {1, 10, 100, 1000, 10000})
            add_point(curve, Model{4, 1.0, 1e-9, cost}.run(steps));
    };
    add("slow", 3, false);
    add("fast", 2, false);
    add("theirs", 1, true);
    const auto times = times_to_accuracies(scene);
    REQUIRE(times.size() == 3);
    CHECK(times[0].own->method == "fast");
    CHECK(times[0].own->seconds == Approx(2e-5).epsilon(1e-12));
    CHECK(times[0].peer->method == "theirs");
    CHECK(times[1].own->seconds == Approx(2e-4).epsilon(1e-12));
    CHECK_FALSE(times[2].own);  // the floor is at 1e-9
    CHECK_FALSE(times[2].peer);
}

TEST_CASE("stepper --accuracy writes the header of the method that it advises") {
    use_cache();
    const Directory directory;
    const Outcome result = hvi_gen({"stepper", "--until", "20", "--accuracy", "1e-6", "--energy",
                                    "harmonic-oscillator", "-o", "x.hpp"},
                                   directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    CHECK(result.out.empty());
    const std::string header = contents(directory / "x.hpp");
    const std::size_t begin = header.find("hvi-gen stepper");
    const std::string command = header.substr(begin, header.find('\n', begin) - begin);
    CHECK(has(result.err, command));
    CHECK(has(command, " --energy"));
    const std::string note = "// advised for an error of 1e-06 at t = 20: steps of 20/";
    const std::size_t noted = header.find(note);
    REQUIRE(noted != std::string::npos);
    // The command writes the same but for the note.
    const Outcome again = shell(command, directory.path());
    REQUIRE(again.status == 0);
    std::string without = header;
    without.erase(noted, header.find('\n', noted) + 1 - noted);
    CHECK((again.out == without));
    // In that step a report sees the error that is promised.
    const std::string step =
        "20/" + std::to_string(std::atol(header.c_str() + noted + note.size()));
    const auto word_after = [&](const std::string& option) {
        const std::size_t at = command.find(option);
        if (at == std::string::npos) return std::string();
        return command.substr(at + option.size(),
                              command.find(' ', at + option.size()) - at - option.size());
    };
    const std::string composition = word_after("--compose ");
    const std::string method =
        word_after("--method ") + (composition.empty() ? "" : "-" + composition);
    const Outcome report = hvi_gen({"report", "harmonic-oscillator", "--until", "20", "--steps",
                                    step, "--only", "json,work", "--methods", method},
                                   directory.path());
    REQUIRE(report.status == 0);
    const auto json = nlohmann::json::parse(contents(directory / "report/report.json"));
    const auto& point = json["scenes"][0]["methods"][0]["points"][0];
    CHECK(point["error"].get<double>() <= 1e-6);
    CHECK(point["error"].get<double>() > 0);
}

TEST_CASE("stepper --accuracy --explain shows what the model says beside what was measured") {
    use_cache();
    const Directory directory;
    const Outcome result = hvi_gen(
        {"stepper", "pendulum", "--until", "5", "--accuracy", "1e-4", "--explain", "-o", "x.hpp"},
        directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    std::istringstream lines(result.err.substr(result.err.find("costs by the model")));
    std::string line, method;
    std::getline(lines, line);
    std::getline(lines, line);
    int rows = 0;
    while (std::getline(lines, line) && line.compare(0, 8, "  gauss:") == 0) {
        std::istringstream row(line);
        double iterations = 0;
        int operations = 0;
        REQUIRE((row >> method >> iterations >> operations));
        CHECK(iterations >= 2);
        // A component of s stages: s products for its sum, and sin.
        CHECK(operations > std::stoi(method.substr(6)));
        ++rows;
    }
    CHECK(rows >= 3);
}

TEST_CASE("run --accuracy takes the steps that it advises") {
    use_cache();
    const Directory directory;
    const Outcome run = hvi_gen(
        {"run", "harmonic-oscillator", "--until", "20", "--only", "summary", "--accuracy", "1e-6"},
        directory.path());
    CHECK(run.status == 0);
    CHECK(has(run.out, "until t = 20\n"));
    CHECK(hvi_gen({"run", "kepler", "--accuracy", "1e-3", "--step", "1/10"}).status == 2);
}

TEST_CASE("accuracies that cannot be") {
    use_cache();
    const Directory directory;
    const auto error = [&](std::vector<std::string> words, int status) {
        words.insert(words.begin(), "stepper");
        const Outcome result = hvi_gen(words, directory.path());
        INFO(result.err);
        CHECK(result.status == status);
        CHECK(result.out.empty());
        return result.err;
    };
    CHECK(has(error({"kepler", "--accuracy", "1e-8", "--method", "gauss:2"}, 2),
              "error: --accuracy chooses what --method gives\n"));
    CHECK(has(error({"kepler", "--accuracy", "1e-8", "--compose", "yoshida:4"}, 2), "--compose"));
    CHECK(has(error({"kepler", "--accuracy", "1e-8", "--solver", "newton"}, 2), "--solver"));
    for (const std::string number : {"0", "1", "-1e-3", "1e-8x", "nan", "", "1e-400"})
        CHECK(has(error({"kepler", "--accuracy", number}, 2), "a positive number below 1"));
    CHECK(has(error({"--accuracy", "1e-8"}, 2), "needs a scene"));
    CHECK(has(error({"--hamiltonian", "p^2/2 + q^2/2", "--accuracy", "1e-8"}, 2), "needs a scene"));
    CHECK(has(error({"kepler", "--method", "gauss:2", "--until", "3"}, 2), "goes with --accuracy"));
    write(directory / "open.toml", "coordinates = \"q\"\nmomenta = \"p\"\n"
                                   "hamiltonian = \"p^2/2 + q^2/2\"\ninitial = {q = 1, p = 0}\n");
    CHECK(has(error({"open.toml", "--accuracy", "1e-3"}, 2), "does not say `until`"));
    CHECK(has(error({"harmonic-oscillator", "--until", "3", "--accuracy", "1e-18"}, 1),
              "help: the best is "));
    CHECK(directory.names() == std::vector<std::string>{"open.toml"});
    const Outcome none =
        shell("CXX=/none hvi-gen stepper kepler --accuracy 1e-3", directory.path());
    CHECK(none.status == 3);
    CHECK(none.out.empty());
}

TEST_CASE("a scene whose sums stay loops comes to its end with the error that was asked for") {
    use_cache();
    const Directory directory;
    constexpr int n = 300;
    write(directory / "rings.toml",
          "coordinates = \"q[1..N]\"\nmomenta = \"p[1..N]\"\nhamiltonian = \"sum(i=1..N, "
          "(q[i]^2 + p[i]^2)^2/4)\"\n[parameters]\nN = 300\n[initial]\n\"q[i]\" = \"1 + "
          "i/1000\"\n\"p[i]\" = 0\n[run]\nuntil = 2\n");
    const Outcome outcome =
        hvi_gen({"run", "rings.toml", "--accuracy", "1e-6", "--budget", "20", "--columns",
                 "q[1..300], p[1..300]", "--only", "table,summary", "-o", "out"},
                directory.path());
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(has(outcome.err, "errors of at most 1e-06 on rings at t = 2, beside gauss:6 in "));
    const std::string table = contents(directory / "out/trajectory.csv");
    std::istringstream row(table.substr(table.rfind('\n', table.size() - 2) + 1));
    std::vector<double> values;
    for (std::string word; std::getline(row, word, ',');) values.push_back(std::stod(word));
    REQUIRE(values.size() == 2 * n + 1);
    CHECK(values[0] == 2);
    // Each turns by the square of its radius in the unit of time.
    double distance = 0, size = 0;
    for (int i = 0; i < n; ++i) {
        const double r = 1 + (i + 1) / 1000.0, angle = 2 * r * r;
        const auto k = static_cast<std::size_t>(i);
        distance += std::pow(values[1 + k] - r * std::cos(angle), 2) +
                    std::pow(values[1 + n + k] + r * std::sin(angle), 2);
        size += r * r;
    }
    CHECK(std::sqrt(distance / size) <= 1.1e-6);
}
