// Arguments of the functions of modules: parameters, names, columns, and what cannot be.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <chain.h>
#include <driven.h>
#include <filed.h>
#include <kepler.h>
#include <masses.h>
#include <top.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/runtime/module/bits.hpp"

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

std::string text(int status) { return kepler_status_text(status); }

template <class Handle>
std::string refusal(const Functions<Handle>& call, const std::vector<double>& parameters) {
    Handle* handle = nullptr;
    const int status = call.create(parameters.data(), parameters.size(), &handle);
    CHECK(handle == nullptr);
    return call.status_text(status);
}

TEST_CASE("parameters are data: those of the scene where none are given") {
    // Kepler: on an ellipse of semi-axis 1 the nearest point is 1 - e away, and H = -mu/2.
    const Module<kepler_stepper> usual(FUNCTIONS_OF(kepler)), other(FUNCTIONS_OF(kepler), {4, 0.5});
    CHECK(usual.initial()[0] == 1 - 0.6);
    const std::vector<double> x = other.initial();
    CHECK(x[0] == 0.5);
    CHECK(x[3] == std::sqrt(4 * 1.5 / 0.5));
    double energy = 0;
    REQUIRE(kepler_energy(other.handle, x.data(), &energy) == 0);
    CHECK(energy == Approx(-2).epsilon(1e-15));
}

TEST_CASE("sizes and lists are parameters too") {
    const Module<chain_stepper> chain(FUNCTIONS_OF(chain), {10, 0.25, 0, 1});
    CHECK(chain_dof(chain.handle) == 10);
    CHECK(chain_size(chain.handle) == 20);
    CHECK(chain.initial()[4] == Approx(std::sin(std::acos(-1.0) * 5 / 11)).epsilon(1e-15));

    // N, k, eps, and the N masses.
    const Module<masses_stepper> two(FUNCTIONS_OF(masses), {2, 3, 0.5, 7, 11});
    CHECK(masses_dof(two.handle) == 2);
    CHECK(masses_size_of_name(two.handle, masses_parameter, 3) == 2);
    CHECK(masses_size_of_name(two.handle, masses_coordinate, 0) == 2);
    double energy = 0;
    const std::vector<double> x = {1, 2, 3, 4};
    REQUIRE(masses_energy(two.handle, x.data(), &energy) == 0);
    CHECK(energy == Approx(9 / 14.0 + 16 / 22.0 + 3 * 5 / 2.0 - 2 - 77 / std::sqrt(1.25)));
}

TEST_CASE("lists may be left out") {
    const Module<masses_stepper> some(FUNCTIONS_OF(masses), {40, 3, 0.5});
    CHECK(masses_dof(some.handle) == 40);
    CHECK(masses_size_of_name(some.handle, masses_parameter, 3) == 70);
}

TEST_CASE("parameters that cannot be are refused") {
    const auto kepler = FUNCTIONS_OF(kepler);
    CHECK(refusal(kepler, {1}) == "there are not as many parameters as that");
    CHECK(refusal(kepler, {1, 0.5, 0}) == "there are not as many parameters as that");
    const std::string no_number =
        "a parameter is no finite number, or a size that is no positive whole number";
    CHECK(refusal(kepler, {1, infinite}) == no_number);
    CHECK(refusal(kepler, {std::nan(""), 0.5}) == no_number);
    const auto chain = FUNCTIONS_OF(chain);
    for (const double N : {0.0, -3.0, 2.5, 1e300}) {
        CHECK(refusal(chain, {N, 0.25, 0, 1}) == no_number);
    }
    const auto masses = FUNCTIONS_OF(masses);
    CHECK(refusal(masses, {3, 3}) == "there are not as many parameters as that");
    CHECK(refusal(masses, {3, 3, 0.5, 1}) == "a list of the scene does not fit these sizes");
    CHECK(refusal(masses, {3, 3, 0.5, 7, 11}) == "a list of the scene does not fit these sizes");
    CHECK(refusal(masses, {1e9, 3, 0.5, 7, 11}) == "a list of the scene does not fit these sizes");
}

TEST_CASE("numbers in files are found from a directory") {
    filed_stepper* handle = nullptr;
    char message[100] = "";
    int status = filed_create_with("/nowhere", 1, nullptr, 0, &handle, message, sizeof message);
    CHECK(filed_status_text(status) ==
          std::string("a file with numbers of the scene cannot be read"));
    CHECK(std::string(message).find("/nowhere/filed.csv") != std::string::npos);
    // The message is cut to the room that there is.
    status = filed_create_with("/nowhere", 1, nullptr, 0, &handle, message, 8);
    CHECK(status != 0);
    CHECK(std::strlen(message) == 7);
    CHECK(handle == nullptr);
    REQUIRE(filed_create_with(HVI_LARGE_SCENES, 2, nullptr, 0, &handle, nullptr, 0) == 0);
    std::vector<double> x(filed_size(handle));
    REQUIRE(x.size() == 600);
    REQUIRE(filed_initial(handle, x.data()) == 0);
    CHECK(x[0] == 0.125);  // the first line of the file
    CHECK(x[300] == 2);
    CHECK(filed_destroy(handle) == 0);
}

TEST_CASE("names are those of the scene") {
    CHECK(kepler_count(kepler_parameter) == 2);
    CHECK(std::string(kepler_name(kepler_momentum, 1)) == "py");
    CHECK(std::string(kepler_name(kepler_invariant, 0)) == "angular_momentum");
    CHECK(kepler_name(kepler_coordinate, 2) == nullptr);
    CHECK(kepler_name(7, 0) == nullptr);
    CHECK(kepler_name(-1, 0) == nullptr);
    CHECK(kepler_count(7) == 0);
    CHECK(std::string(chain_name(chain_parameter, 0)) == "N");
    CHECK(std::string(chain_name(chain_coordinate, 0)) == "q");
    CHECK(top_count(top_coordinate) == 9);
    CHECK(std::string(top_name(top_coordinate, 5)) == "R[2,3]");
    const Module<top_stepper> top(FUNCTIONS_OF(top));
    CHECK(top_dof(top.handle) == 3);
    CHECK(top_size(top.handle) == 12);
}

template <class Handle>
std::vector<double> row(const Functions<Handle>& functions, const char* columns,
                        std::size_t width) {
    Module<Handle> module(functions);
    std::vector<double> x = module.initial(), table(width);
    std::size_t written = 0;
    REQUIRE(module.call.integrate(module.handle, x.data(), 2, 0.125, 3, 3, columns, table.data(), 1,
                                  &written) == 0);
    REQUIRE(written == 1);
    x.insert(x.begin(), 2.375);
    if (columns == nullptr) { CHECK(same_bits(table, x)); }
    return table;
}

TEST_CASE("columns are chosen by name, in any order and more than once") {
    const auto kepler = FUNCTIONS_OF(kepler);
    const std::vector<double> all = row(kepler, nullptr, 5);
    const std::vector<double> some = row(kepler, " py,t , x,x,angular_momentum", 5);
    CHECK(some[0] == all[4]);
    CHECK(some[1] == all[0]);
    CHECK(some[2] == all[1]);
    CHECK(some[3] == all[1]);
    CHECK(some[4] == Approx(0.8).epsilon(1e-14));

    const auto chain = FUNCTIONS_OF(chain);
    const std::vector<double> q_and_p = row(chain, "q, p", 2048);
    const std::vector<double> elements = row(chain, "p[1024], q[1], q[7]", 3);
    CHECK(elements[0] == q_and_p[2047]);
    CHECK(elements[1] == q_and_p[0]);
    CHECK(elements[2] == q_and_p[6]);

    // A comma in brackets is part of a name.
    const std::vector<double> turn = row(FUNCTIONS_OF(top), "R[2,3], J_z", 2);
    CHECK(turn[0] == row(FUNCTIONS_OF(top), nullptr, 13)[6]);
}

TEST_CASE("the time of a row is that of the state where H depends on it") {
    Module<driven_stepper> driven(FUNCTIONS_OF(driven));
    std::vector<double> x = driven.initial(), table(4);
    REQUIRE(x.size() == 15);
    CHECK(x.back() == 0);
    x.back() = 5;
    std::size_t written = 0;
    REQUIRE(driven_integrate(driven.handle, x.data(), 99, 0.25, 4, 1, "t", table.data(), 4,
                             &written) == 0);
    CHECK(table == std::vector<double>{5.25, 5.5, 5.75, 6});
    CHECK(x.back() == 6);
}

TEST_CASE("tables that cannot be are refused before a step is taken") {
    Module<kepler_stepper> planet(FUNCTIONS_OF(kepler));
    const std::vector<double> start = planet.initial();
    std::vector<double> x = start, table(100, -7.0);
    std::size_t written = 3;
    const auto refused = [&](std::size_t every, const char* columns, double* buffer,
                             std::size_t rows, std::size_t* count) {
        const int status = kepler_integrate(planet.handle, x.data(), 0, 0.1, 10, every, columns,
                                            buffer, rows, count);
        CHECK(same_bits(x, start));
        CHECK(std::all_of(table.begin(), table.end(), [](double each) { return each == -7; }));
        return text(status);
    };
    double* const buffer = table.data();
    CHECK(refused(1, "t", buffer, 9, &written) ==
          "the buffer has fewer rows than steps would fill");
    CHECK(written == 0);
    CHECK(refused(0, "t", buffer, 10, &written) == "every is 0, and there is a buffer");
    CHECK(refused(1, "t", buffer, 10, nullptr) == "an argument is a null pointer");
    for (const char* const columns : {"", "t,", "z", "x[1]", "T", "x y", "energy[1]", "q["}) {
        CAPTURE(columns);
        CHECK(refused(1, columns, buffer, 10, &written) == "there is no such column");
    }
    Module<chain_stepper> chain(FUNCTIONS_OF(chain));
    std::vector<double> of_chain = chain.initial();
    for (const char* const columns :
         {"q[0]", "q[1025]", "q[1,1]", "q[x]", "q[]", "q[1", "q[1]]", "q[99999999999999999999]"}) {
        CAPTURE(columns);
        CHECK(std::string(chain_status_text(chain_integrate(chain.handle, of_chain.data(), 0, 0.1,
                                                            1, 1, columns, buffer, 1, &written))) ==
              "there is no such column");
    }
}

TEST_CASE("null pointers are a status") {
    Module<kepler_stepper> planet(FUNCTIONS_OF(kepler));
    const std::string null = "an argument is a null pointer";
    double value = 0;
    kepler_stepper* none = nullptr;
    CHECK(text(kepler_create(nullptr, 0, nullptr)) == null);
    CHECK(text(kepler_create(nullptr, 2, &none)) == null);
    CHECK(text(kepler_copy(planet.handle, nullptr)) == null);
    CHECK(text(kepler_initial(planet.handle, nullptr)) == null);
    CHECK(text(kepler_step(planet.handle, nullptr, 0.1)) == null);
    CHECK(text(kepler_energy(planet.handle, nullptr, &value)) == null);
    CHECK(text(kepler_energy(planet.handle, planet.initial().data(), nullptr)) == null);
    CHECK(text(kepler_invariants(planet.handle, nullptr, &value)) == null);
    CHECK(text(12345) == "unknown status");
    CHECK(text(-1) == "unknown status");
}

TEST_CASE("what is no handle, or none any more, is a status") {
    const std::string no_handle = "the handle is none, or was destroyed";
    std::vector<double> x(4, 1.0);
    double value = 0;
    kepler_stepper* gone = nullptr;
    REQUIRE(kepler_create(nullptr, 0, &gone) == 0);
    REQUIRE(kepler_destroy(gone) == 0);
    // The next one may be kept where that was.
    const Module<kepler_stepper> living(FUNCTIONS_OF(kepler));
    std::vector<kepler_stepper*> none = {nullptr, gone,
                                         reinterpret_cast<kepler_stepper*>(x.data())};
    std::mt19937_64 random(1);
    for (int k = 0; k < 10000; ++k) {
        const auto number = static_cast<std::uintptr_t>(random() >> random() % 64);
        none.push_back(reinterpret_cast<kepler_stepper*>(number));
        if (none.back() == living.handle) { none.pop_back(); }
    }
    for (kepler_stepper* const handle : none) {
        kepler_stepper* other = nullptr;
        REQUIRE(text(kepler_step(handle, x.data(), 0.1)) == no_handle);
        REQUIRE(text(kepler_copy(handle, &other)) == no_handle);
        REQUIRE(text(kepler_energy(handle, x.data(), &value)) == no_handle);
        REQUIRE(text(kepler_destroy(handle)) == no_handle);
        REQUIRE(kepler_size(handle) == 0);
    }
    CHECK(x == std::vector<double>(4, 1.0));
}

TEST_CASE("many steppers come and go in many threads, which share another one") {
    const Module<kepler_stepper> shared(FUNCTIONS_OF(kepler));
    // Energies of different states, asked for at once.
    struct Asked {
        std::vector<double> x;
        double energy = 0;
        int failures = 0;
    };
    std::vector<Asked> all(8);
    for (std::size_t k = 0; k < all.size(); ++k) {
        all[k].x = {1.0 + static_cast<double>(k), 0.5, 0, 1};
        REQUIRE(kepler_energy(shared.handle, all[k].x.data(), &all[k].energy) == 0);
    }
    std::vector<std::thread> threads;
    for (Asked& asked : all) {
        threads.emplace_back([&] {
            std::vector<kepler_stepper*> handles(300);
            double energy = 0;
            std::vector<double> x = asked.x;
            int& failures = asked.failures;
            for (kepler_stepper*& each : handles) { failures += kepler_create(nullptr, 0, &each); }
            for (int k = 0; k < 20000; ++k) {
                failures += kepler_energy(shared.handle, asked.x.data(), &energy);
                failures += energy != asked.energy;
            }
            for (kepler_stepper* const each : handles) {
                failures += kepler_step(each, x.data(), 0.01);
                failures += kepler_destroy(each);
                failures += kepler_destroy(each) == 0;
            }
        });
    }
    for (std::thread& each : threads) { each.join(); }
    for (const Asked& asked : all) { CHECK(asked.failures == 0); }
}

}  // namespace
