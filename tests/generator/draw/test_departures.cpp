// Departures of what is kept: a drift is told from oscillations.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/draw/departures.hpp"

using namespace hvi::gen;

namespace {

constexpr double full_turn = 2 * 3.14159265358979323846;

/// The panel of an energy of 2 that departs by f(row), of so many rows, ten in each unit of time.
template <class Departure>
DeparturesPanel panel_of(int rows, Departure departure) {
    const auto file = std::filesystem::temp_directory_path() /
                      ("hvi-departures-" + std::to_string(std::rand()) + ".csv");
    {
        std::ofstream table(file);
        table.precision(17);
        table << "t,energy\n";
        for (int row = 0; row < rows; ++row)
            table << row / 10.0 << ',' << 2 + departure(row) << '\n';
    }
    TrajectoryPicture picture;
    picture.table = file;
    picture.kept = {{{2, "energy"}, 2}};
    const DeparturesPanel panel = departures_panel(picture, 0, 1);
    std::filesystem::remove(file);
    return panel;
}

/// The numbers of the first array whose name begins like this.
std::vector<double> array_of(const std::string& script, const std::string& name) {
    std::vector<double> numbers;
    const std::size_t at = script.find("array " + name);
    if (at == std::string::npos) return numbers;
    const std::size_t begin = script.find("= [", at) + 3;
    std::istringstream list(script.substr(begin, script.find(']', begin) - begin));
    for (std::string number; std::getline(list, number, ',');) numbers.push_back(std::stod(number));
    return numbers;
}

}  // namespace

TEST_CASE("the band of many swings shows a drift by its mean") {
    // Ten rows a swing of 1e-4, and a drift of 2e-7 a unit of time: in units of 1e-4.
    const auto drifting = [](int row) {
        return 1e-4 * std::cos(full_turn * row / 10) + 2e-7 * row / 10;
    };
    const DeparturesPanel panel = panel_of(10000, drifting);
    CHECK(panel.title == "energy, less that at the start, in 1e-4");
    CHECK(panel.script.find("(shaded: range, line: mean)") != std::string::npos);
    const auto x = array_of(panel.script, "x0"), least = array_of(panel.script, "least0"),
               most = array_of(panel.script, "most0"), mean = array_of(panel.script, "mean0");
    REQUIRE(x.size() == 100);
    REQUIRE((least.size() == 100 && most.size() == 100 && mean.size() == 100));
    for (std::size_t k = 0; k < 100; ++k) {
        CHECK(x[k] == Approx(10 * static_cast<double>(k) + 4.95));
        CHECK(mean[k] == Approx(2e-3 * x[k]).margin(1e-5));
        CHECK(most[k] == Approx(1 + 2e-3 * x[k]).margin(0.02));
        CHECK(least[k] == Approx(-1 + 2e-3 * x[k]).margin(0.02));
    }
}

TEST_CASE("few swings are a line") {
    const auto swinging = [](int row) { return 3 * std::cos(full_turn * row / 100); };
    const DeparturesPanel panel = panel_of(4000, swinging);  // turns back 79 times
    CHECK(panel.title == "energy, less that at the start");
    CHECK(panel.script.find("filledcurves") == std::string::npos);
    CHECK(panel.script.find("shaded") == std::string::npos);
    CHECK(panel.script.find("with lines linestyle 1") != std::string::npos);
    // Some 4000 of 5000 rows show 80 of 99 turns: parts of eight turns are 400 rows.
    const DeparturesPanel more = panel_of(5000, swinging);
    const auto most = array_of(more.script, "most0");
    CHECK(most.size() == 12);
    for (const double value : most) CHECK(value == Approx(3).margin(0.001));
}

TEST_CASE("what never departs, or is no number, is drawn as a line") {
    CHECK(panel_of(5000, [](int) { return 0.0; }).script.find("filled") == std::string::npos);
    const auto lost = [](int row) { return row == 0 ? 0.0 : std::nan(""); };
    CHECK(panel_of(5000, lost).script.find("filled") == std::string::npos);
}
