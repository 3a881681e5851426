// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/grammar.hpp"

#include <string>

#include "generator/support/version.hpp"

namespace hvi::gen {

namespace {

constexpr std::string_view method_help = R"help(METHOD is one of
  --method gauss:3                          `hvi-gen list methods` prints them all
  --basis "1, cos(pi*tau)" --nodes "0, 1"   functions of tau in [0,1], as many as nodes
  --method-file FILE.toml                   with name, basis, nodes, [parameters])help";

void add_value(CLI::App& command, const std::string& names, const std::string& type,
               const std::string& help) {
    // NOTE: exactly one value for each occurrence, so that no word behind it is swallowed.
    command
        .add_option(
            names, [](const CLI::results_t&) { return true; }, help)
        ->expected(1)
        ->allow_extra_args(false)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name(type);
}

void add_flag(CLI::App& command, const std::string& name, const std::string& help) {
    command.add_flag(name, help);
}

void add_method(CLI::App& command) {
    add_value(command, "--method", "NAME", "A named method or family");
    add_value(command, "--basis", "FUNCTIONS", "Basis functions of tau");
    add_value(command, "--nodes", "NODES", "Nodes in [0,1]");
    add_value(command, "--weights", "WEIGHTS", "Weights of the general form (to come)");
    add_value(command, "--method-file", "FILE", "A method in TOML");
    add_value(command, "--param", "NAME=VALUE", "The value of a parameter; repeatable");
    command.footer(std::string(method_help));
}

void add_system(CLI::App& command) {
    add_value(command, "SCENE", "SCENE", "A system by name (`hvi-gen list scenes`), or in TOML");
    add_value(command, "--hamiltonian", "H", "Or H(q, p, t), as in \"p^2/2 + w^2*q^2/2\"");
    add_value(command, "--coordinates", "NAMES", "Its coordinates (q, or q1, q2, ... in H)");
    add_value(command, "--momenta", "NAMES", "Their momenta (p, or p1, p2, ...)");
}

}  // namespace

void describe(CLI::App& app) {
    app.name("hvi-gen");
    app.description("Derives symplectic integrators exactly and writes them as C++ headers.");
    app.set_version_flag("--version", "hvi-gen " + std::string(version));
    app.require_subcommand(0, 1);
    app.allow_extras();

    CLI::App& tableau = *app.add_subcommand("tableau", "Print the exact tableau of a method");
    add_method(tableau);
    add_value(tableau, "--format", "FORMAT", "text, json, latex, markdown or csv");
    add_value(tableau, "--digits", "N", "Significant digits of decimal values (50)");
    add_value(tableau, "-o,--output", "FILE", "Write to this file");

    CLI::App& check =
        *app.add_subcommand("check", "Order, symplecticity, symmetry, stability, with proof");
    add_method(check);
    add_value(check, "--tableau", "FILE", "A tableau in JSON, from wherever, in place of METHOD");
    add_value(check, "--max-order", "N", "Look at conditions up to this order (8)");
    add_value(check, "--format", "FORMAT", "text or json");
    add_value(check, "--plot", "FILE", "Draw trace/2 on the oscillator as SVG");
    add_value(check, "-o,--output", "FILE", "Write to this file");

    CLI::App& stepper = *app.add_subcommand("stepper", "Write a method as a C++ header");
    add_method(stepper);
    add_system(stepper);
    add_flag(stepper, "--separable", "For a class of your own with H = T(p) + U(q)");
    add_value(stepper, "--solver", "SOLVER", "auto, fixed-point, newton or newton-taylor");
    add_value(stepper, "--lanes", "LANES",
              "auto, stages or ensemble (of trajectories) side by side, or none");
    add_flag(stepper, "--energy", "The class has a member energy(x)");
    add_value(stepper, "--compose", "NAME", "Of higher order: yoshida:4, ..., kahan-li:8");
    add_value(stepper, "--accuracy", "E", "In place of METHOD: the fastest with this error");
    add_value(stepper, "--until", "T", "At this time, in place of the scene's");
    add_flag(stepper, "--invariants", "And one for each invariant of the scene");
    add_flag(stepper, "--evaluations", "And one that counts those of dH/dq");
    add_flag(stepper, "--dense", "And one for positions within the last step");
    add_flag(stepper, "--float128", "It computes in __float128 too, where libm does");
    add_value(stepper, "--name", "NAME", "Name of the class");
    add_flag(stepper, "--explain", "Say what is solved and what is left out");
    add_value(stepper, "-o,--output", "FILE", "Write to this file");

    CLI::App& scheme =
        *app.add_subcommand("scheme", "Print the equations of a step for a Hamiltonian");
    add_method(scheme);
    add_system(scheme);
    add_flag(scheme, "--generating", "Also the generating function, of a quadratic H");
    add_value(scheme, "--format", "FORMAT", "text, json or latex");
    add_value(scheme, "-o,--output", "FILE", "Write to this file");

    CLI::App& run = *app.add_subcommand("run", "Integrate a scene: table, picture, summary");
    add_method(run);
    add_value(run, "SCENE", "SCENE", "A scene by name (`hvi-gen list scenes`), or in TOML");
    add_value(run, "--step", "H", "Size of a step, in place of the scene's");
    add_value(run, "--until", "T", "Time at the end, in place of the scene's");
    add_value(run, "--solver", "SOLVER", "auto, fixed-point, newton or newton-taylor");
    add_value(run, "--lanes", "LANES", "auto, stages (side by side) or none");
    add_value(run, "--compose", "NAME", "Of higher order: yoshida:4, ..., kahan-li:8");
    add_value(run, "--accuracy", "E", "In place of METHOD and H: the fastest with this error");
    add_value(run, "--only", "LIST", "Of table, picture, summary; all when not given");
    add_value(run, "-o,--output", "DIR", "Write to this directory");

    CLI::App& report =
        *app.add_subcommand("report", "Error against run time, of methods on scenes");
    report
        .add_option(
            "SCENE", [](const CLI::results_t&) { return true; }, "Scenes by name, or in TOML")
        ->expected(1)
        ->allow_extra_args()  // of one for each of them: as many as there are
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->type_name("SCENE...");
    add_value(report, "--methods", "LIST",
              "Methods between commas, composed too: gauss:2-kahan-li:8");
    add_value(report, "--steps", "LIST", "Sizes of steps between commas, or auto");
    add_value(report, "--until", "T", "Time at the end, in place of the scene's");
    add_value(report, "--only", "LIST",
              "Of html, json, csv, svg; and of work, rejections, stiff, extreme, long, "
              "symplecticity");
    add_flag(report, "--peers", "Boost.Odeint and GSL too, where they are installed");
    add_flag(report, "--edges", "Stiff and extreme cases; needs no SCENE");
    add_value(report, "-o,--output", "DIR", "Write to this directory (report)");

    CLI::App& list = *app.add_subcommand("list", "Print what can be named");
    add_value(list, "TOPIC", "TOPIC",
              "bases, nodes, methods, scenes or functions; all when not given");

    for (CLI::App* command : app.get_subcommands(nullptr)) command->allow_extras();
}

}  // namespace hvi::gen
