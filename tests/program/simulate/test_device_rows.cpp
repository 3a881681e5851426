// Modules that take rows of a study at once as threads of a GPU: what their compilers make of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/drive/rows_module.hpp"
#include "generator/interpret/interpretation.hpp"
#include "generator/module/device_module.hpp"
#include "generator/read/method.hpp"
#include "generator/simulate/device_program.hpp"
#include "generator/support/error.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::gen;

namespace {

/// A stepper of verlet steps, whose bits are those of a trajectory alone where H calls no function
/// but sqrt.
SceneStepper verlet(const std::string& scene, const StepperWishes& wishes,
                    const std::string& value = "") {
    std::vector<Parameter> values;
    if (!value.empty()) {
        const Given text = given("--param", value);
        values.push_back({"ecc", parse_expression(text), {}});
    }
    return scene_stepper(named_method(given("--method", "stormer-verlet")),
                         find_scene(given("SCENE", scene), values), wishes);
}

SceneStepper verlet_of_device(const std::string& scene, const std::string& value = "") {
    return verlet(scene, device_wishes(simulation_wishes(Solver::automatic)), value);
}

/// Rows around the start of a scene, with steps of several sizes.
struct RowsOfScene {
    std::size_t count = 7, size;
    std::vector<double> numbers, h, states, energy_errors, conserved;
    std::vector<std::int64_t> steps, taken;
    std::vector<int> statuses;

    RowsOfScene(const std::vector<double>& of_scene, const hvi::detail::DrivenSizes& sizes)
        : size(sizes.coordinates + sizes.momenta) {
        for (std::size_t i = 0; i < count; ++i) {
            const double part = static_cast<double>(i) / 100;
            for (const double number : of_scene) numbers.push_back(number * (1 + part));
            h.push_back(i % 2 == 0 ? 1.0 / 64 : -0.01);
            steps.push_back(static_cast<std::int64_t>(i * i * 150));
        }
        states.resize(count * size);
        energy_errors.resize(count);
        conserved.resize(count * (1 + sizes.invariants));
        taken.resize(count);
        statuses.resize(count);
    }

    void take(const hvi::detail::RowFunctions& call) {
        take_rows(call, ".", numbers.size() / count,
                  {count, numbers.data(), h.data(), steps.data(), states.data(), taken.data(),
                   statuses.data(), energy_errors.data(), conserved.data(), [] { return false; }});
    }

    /// Checks row i against steps of the stepper, one after the other.
    void check(std::size_t i, NumberStepper& stepper) const {
        const std::size_t values_of_row = 1 + stepper.sizes().invariants;
        std::vector<double> state(size), values(values_of_row);
        stepper.begin(state.data());
        std::vector<hvi::detail::Departure> departures(values_of_row);
        departures.front().start = stepper.energy(state.data());
        REQUIRE(stepper.follow(state.data(), h[i], steps[i], departures.data()) == 0);
        values.front() = stepper.energy(state.data());
        stepper.invariants(state.data(), values.data() + 1);
        INFO("row " << i);
        CHECK(statuses[i] == 0);
        CHECK(taken[i] == steps[i]);
        CHECK(std::memcmp(&states[i * size], state.data(), size * sizeof(double)) == 0);
        CHECK(energy_errors[i] == departures.front().largest);
        CHECK(std::memcmp(conserved.data() + i * values_of_row, values.data(),
                          values_of_row * sizeof(double)) == 0);
    }
};

/// Takes rows of a module, and checks them against an interpreted stepper.
void check_rows(const std::string& scene, const hvi::detail::RowFunctions& call,
                const std::vector<double>& numbers) {
    const StepperFamily family =
        interpretations(verlet(scene, simulation_wishes(Solver::automatic)));
    RowsOfScene rows(numbers, call.sizes);
    rows.take(call);
    const std::size_t each = numbers.size();
    for (std::size_t i = 0; i < rows.count; ++i) {
        const auto begin = rows.numbers.begin() + static_cast<std::ptrdiff_t>(i * each);
        const auto stepper = family({begin, begin + static_cast<std::ptrdiff_t>(each)})();
        rows.check(i, *stepper);
    }
}

}  // namespace

TEST_CASE("a module of rows on a device has the bits of steps that are interpreted") {
    hvi::test::use_cache();
    Builds builds(find_compiler());
    for (const std::string scene : {"kepler", "henon-heiles"}) {
        INFO(scene);
        const SimulationProgram made = device_program(verlet_of_device(scene), Artifact::library);
        const auto& call = loaded_rows(built(made.order(builds).build).string());
        check_rows(scene, call, made.library.parameters);
    }
}

TEST_CASE("the source of a module of rows does not depend on values") {
    const DeviceModule usual = device_module(verlet_of_device("kepler")),
                       other = device_module(verlet_of_device("kepler", "1/10"));
    CHECK(usual.source == other.source);
    // mu, ecc, and the start (1 - ecc, 0), (0, sqrt((1 + ecc)/(1 - ecc))).
    CHECK(usual.numbers == std::vector<double>{1, 0.6, 0.4, 0, 0, 2});
    CHECK(other.numbers.at(1) == 0.1);
    CHECK(other.numbers.at(2) == 0.9);
}

TEST_CASE("nvcc compiles a module of rows, which wants a card") {
    hvi::test::use_cache();
    std::optional<Compiler> compiler;
    try {
        compiler = find_device_compiler();
    } catch (const EnvironmentError&) { return; }  // nvcc is not everywhere
    CHECK(compiler->version.find("release") != std::string::npos);
    Builds builds(*compiler);
    const SimulationProgram made = device_program(verlet_of_device("kepler"));
    const std::filesystem::path library = built(made.order(builds).build);
    CHECK(hvi::test::contents(library).find("body_kernel") != std::string::npos);
    const auto& call = loaded_rows(library.string());
    CHECK(call.sizes.coordinates == 2);
    CHECK(call.sizes.momenta == 2);
    CHECK(call.sizes.invariants == 1);
    CHECK_FALSE(call.sizes.has_time);
    try {
        check_rows("kepler", call, made.library.parameters);
    } catch (const EnvironmentError& error) {
        CHECK(std::string(error.what()).find("no CUDA device was found") == 0);
    }
}

TEST_CASE("without nvcc there is no GPU, and what is no module of rows is none") {
    const char* const before = std::getenv("NVCC");
    const std::string kept = before == nullptr ? "" : before;
    ::setenv("NVCC", "/there/is/no/nvcc", 1);
    CHECK_THROWS_WITH(find_device_compiler(),
                      "there is no compiler of CUDA: `/there/is/no/nvcc --version` fails");
    if (before == nullptr) ::unsetenv("NVCC");
    if (before != nullptr) ::setenv("NVCC", kept.c_str(), 1);

    CHECK_THROWS_AS(loaded_rows("/there/is/no/library"), std::runtime_error);
    CHECK_THROWS_AS(loaded_rows(HVI_PRETENDED_MODULE), std::runtime_error);
    hvi::test::use_cache();
    Builds builds(find_compiler());
    const auto other = builds.order({.main = "extern \"C\" const int hvi_rows;\n"
                                             "const int hvi_rows = 1234;\n",
                                     .headers = {},
                                     .artifact = Artifact::library});
    CHECK_THROWS_WITH(loaded_rows(built(other).string()),
                      Catch::EndsWith("is no module of this version of hvi"));
}
