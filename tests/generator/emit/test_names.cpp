// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "generator/emit/text/names.hpp"

using namespace hvi::gen;

TEST_CASE("classes and files are named after methods") {
    CHECK(class_name("gauss:2") == "Gauss2");
    CHECK(file_name("gauss:2") == "gauss_2.hpp");
    CHECK(class_name("stormer-verlet") == "StormerVerlet");
    CHECK(file_name("stormer-verlet") == "stormer_verlet.hpp");
    CHECK(class_name("adjoint-symplectic-euler") == "AdjointSymplecticEuler");
    CHECK(class_name("trig3") == "Trig3");
    CHECK(class_name("newton-cotes-open:12") == "NewtonCotesOpen12");
    CHECK(class_name("") == "Stepper");
    CHECK(file_name("") == "stepper.hpp");
    CHECK(class_name("3 nodes") == "Stepper3Nodes");
    CHECK(class_name("system") == "SystemStepper");
    CHECK(class_name("EOF") == "EOFStepper");
    CHECK(class_name("RK4") == "RK4Stepper");
}

TEST_CASE("names that C++ allows and the header does not use are taken") {
    for (const char* name : {"Gauss2", "my_stepper", "X", "X2", "Coupledness", "integrator"}) {
        CHECK_NOTHROW(check_class_name(name, {}));
    }
}

TEST_CASE("a parameter of a scene is a member of that name, if it can be") {
    CHECK(member_name("mu") == "mu");
    CHECK(member_name("m") == "m");
    for (const std::string name :
         {"double", "Number", "Numbers", "Scalar", "Parameters", "std", "hvi", "M_PI", "errno"}) {
        CHECK(member_name(name) == name + "_");
    }
}

TEST_CASE("other names are refused") {
    for (const char* name :
         {"",        "2nd",      "a-b",   "a b",      "class",  "co_await", "xor_eq", "alignas",
          "__x",     "a__b",     "_Big",  "\xc3\xa4", "System", "Solver",   "State",  "Status",
          "Coupled", "Coupled2", "Steps", "hvi",      "std",    "m"}) {
        CAPTURE(name);
        CHECK_THROWS_AS(check_class_name(name, {}), InputError);
    }
}

TEST_CASE("tables of a header give way to invariants") {
    for (const char* name : {"b", "c", "k", "m", "n", "p", "q", "x", "N"})
        CHECK_NOTHROW(check_function_name(name, {}));
    CHECK_THROWS_AS(check_function_name("k1", {}), InputError);   // a constant of System
    CHECK_THROWS_AS(check_function_name("LZ_", {}), InputError);  // what LZ becomes
    CHECK(member_name("I") == "I_");
    const std::string text = "static Scalar b[3];  // b_1\n"
                             "Scalar b(const State& x) const { return system_.b(x.q); }\n"
                             "f(b, b_q, 2 * b[0], s.b, a_b); // b\n";
    CHECK(with_other_tables(text, "b") ==
          "static Scalar b_[3];  // b_1\n"
          "Scalar b(const State& x) const { return system_.b(x.q); }\n"
          "f(b_, b_q, 2 * b_[0], s.b, a_b); // b\n");
    CHECK(with_other_tables(text, "f") == text);
}

TEST_CASE("an invariant is not called as what a header with lanes or sums has") {
    for (const char* name : {"N_lanes", "m_lanes", "mt_lanes", "cn_lanes", "sums_"}) {
        CAPTURE(name);
        CHECK_THROWS_AS(check_function_name(name, {}), InputError);
    }
    for (const char* name : {"LZ_", "I_"}) {  // which LZ and I are called
        CHECK_THROWS_AS(check_function_name(name, {}), InputError);
    }
    CHECK_NOTHROW(check_function_name("table", {}));
}
