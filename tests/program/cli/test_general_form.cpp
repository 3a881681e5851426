// The general Galerkin form (4.6) on the command line.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/program/cli/program.hpp"

using namespace hvi::test;
using Json = nlohmann::json;

namespace {

using Arguments = std::vector<std::string>;

Outcome with_simpson(Arguments before, const Arguments& after = {}) {
    before.insert(before.end(), {"--basis", "1, tau", "--nodes", "0, 1/2, 1"});
    before.insert(before.end(), after.begin(), after.end());
    return hvi_gen(before);
}

Json read(const Outcome& outcome) {
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    return Json::parse(outcome.out);
}

}  // namespace

TEST_CASE("tableau prints the numbers of (4.6), and the Nystrom method that they are") {
    const Json found = read(with_simpson({"tableau", "--format", "json"}));
    CHECK(found.at("schema") == "hvi-galerkin/1");
    CHECK(found.at("functions") == 2);
    CHECK(found.at("nodes") == 3);
    CHECK(found.at("basis") == Json({"1", "tau"}));
    CHECK(found.at("b").at(1).at("exact") == "2/3");
    CHECK(found.at("B").at(1).at("exact") == "1/2");
    CHECK(found.at("Psi").size() == 2);
    CHECK(found.at("Psi").at(1).at(2).at("exact") == "1");
    CHECK(found.at("A_psi").size() == 3);
    CHECK(found.at("A_psi").at(1).at(1).at("exact") == "1/8");
    CHECK(found.at("gram").at(1).at(1).at("exact") == "1/3");
    const Json& nystroem = found.at("nystroem");
    CHECK(nystroem.at("A_bar").at(1).at(0).at("exact") == "1/12");
    CHECK(nystroem.at("b_bar").at(1).at("exact") == "1/3");
    CHECK(nystroem.at("c").at(1).at("exact") == "1/2");
    CHECK(nystroem.at("b").at(0).at("double") == "0x1.5555555555555p-3");

    const Outcome csv = with_simpson({"tableau", "--format", "csv"});
    CHECK(csv.out.find("\nA_bar,2,2,1/24,") != std::string::npos);
    CHECK(with_simpson({"tableau", "--format", "latex"}).out.find("\\frac{1}{24}") !=
          std::string::npos);
    CHECK(
        with_simpson({"tableau", "--format", "markdown"}).out.find("| A_bar | 2 | 2 | `1/24` |") !=
        std::string::npos);
}

TEST_CASE("with as many nodes as functions --weights may say what they are") {
    const Arguments line = {"tableau", "--basis", "1, tau", "--nodes", "0, 1", "--format", "json"};
    Arguments weighted = line;
    weighted.insert(weighted.end(), {"--weights", "1/2, 1/2"});
    const Json plain = read(hvi_gen(line)), found = read(hvi_gen(weighted));
    CHECK(found.at("schema") == "hvi-tableau/1");
    CHECK(found.at("A") == plain.at("A"));
    weighted.back() = "1/3, 2/3";
    const Outcome other = hvi_gen(weighted);
    CHECK(other.status == 1);
    CHECK(other.err.find("is off by -1/6") != std::string::npos);
}

TEST_CASE("check proves the order of the Nystrom method, and says null where trees do not apply") {
    const Json found = read(with_simpson({"check", "--format", "json"}));
    CHECK(found.at("schema") == "hvi-check/1");
    CHECK(found.at("order").is_null());
    CHECK(found.at("order_separable").is_null());
    CHECK(found.at("order_nystrom") == 4);
    CHECK(found.at("order_is_at_least") == false);
    CHECK(found.at("proved") == true);
    CHECK(found.at("symplectic") == true);
    CHECK(found.at("symmetric") == true);
    CHECK(found.at("linear_stability").at("determinant_is_one") == true);
}

TEST_CASE("H that the general form does not step is refused, with the reason") {
    const auto refused = [](const Arguments& scene, int status, const std::string& words) {
        const Outcome outcome = with_simpson({"stepper"}, scene);
        INFO(outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.find(words) != std::string::npos);
    };
    refused({"qp"}, 1, "its rank is below the degrees of freedom");
    refused({"--hamiltonian", "(p1+p2)^2/2+q1^4+q2^2", "--coordinates", "q1, q2", "--momenta",
             "p1, p2"},
            1, "its rank is 1 of 2");
    refused({"--hamiltonian", "sin(q1)*(p1+p2)^2+exp(p1+p2)+q2^2", "--coordinates", "q1, q2",
             "--momenta", "p1, p2"},
            1, "its rank is 1 of 2");
    refused({"--hamiltonian", "(q1*p1+q2*p2)^2"}, 1, "its rank is 1 of 2");
    refused({"--hamiltonian", "sqrt(p^2)"}, 1, "its rank is 0 of 1");
    refused({}, 2, "for one H alone");
    CHECK(with_simpson({"stepper", "pendulum", "--dense"}).status == 0);
    CHECK(with_simpson({"stepper", "nonseparable", "--dense"}).status == 0);
    CHECK(with_simpson({"stepper", "pendulum", "--dense", "--action"}).status == 0);
    // Nodes without a closed form, where orthogonality makes zeros that no enclosure proves.
    for (const char* const scene : {"nonseparable", "two-pendulums"}) {
        CHECK(
            hvi_gen({"stepper", "--basis", "1, tau, tau^2", "--nodes", "gauss:6", scene, "--dense"})
                .status == 0);
    }
    const Outcome open = hvi_gen(
        {"stepper", "--basis", "1, cos(w*tau), sin(w*tau)", "--nodes", "gauss:3", "robot-arm"});
    CHECK(open.status == 2);
    CHECK(open.err.find("--param w=1") != std::string::npos);
    refused({"nonseparable", "--lanes", "stages"}, 2, "the velocities of the curve");
    refused({"nonseparable", "--lanes", "ensemble"}, 2, "the velocities of the curve");
    refused({"nonseparable", "--solver", "newton-taylor"}, 2, "--solver newton takes any H");
    CHECK(with_simpson({"stepper", "pendulum"}).status == 0);
    CHECK(with_simpson({"stepper", "pendulum", "--compose", "yoshida:4"}).status == 0);
    CHECK(with_simpson({"stepper", "nonseparable", "--compose", "blanes-moan:6"}).status == 0);
}

TEST_CASE("the action takes the general form, with momenta at the nodes") {
    const auto header = [](const Arguments& scene) {
        const Outcome outcome = with_simpson({"stepper", "--action"}, scene);
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(outcome.out.find(" generating_function() const ") != std::string::npos);
        return outcome.out;
    };
    const std::string reason = "the action is summed\n//         over both";
    CHECK(header({"pendulum"}).find(reason) != std::string::npos);
    CHECK(header({"kepler", "--compose", "yoshida:4"}).find(reason) != std::string::npos);
    CHECK(header({"nonseparable"}).find(reason) == std::string::npos);
    CHECK(header({"two-pendulums"}).find(reason) == std::string::npos);
}

TEST_CASE("compositions of rules that are not symmetric take the adjoint, or are refused") {
    const auto composed = [](const std::string& composition) {
        return hvi_gen({"stepper", "--basis", "1, tau", "--nodes", "0, 2/3, 1", "nonseparable",
                        "--compose", composition});
    };
    const Outcome refused = composed("yoshida:4");
    CHECK(refused.status == 1);
    CHECK(refused.err.find("not its own adjoint") != std::string::npos);
    const Outcome adjoint = composed("blanes-moan:6");
    CHECK(adjoint.status == 0);
    CHECK(adjoint.out.find("is_adjoint ? D : A") != std::string::npos);
    const Outcome symmetric =
        with_simpson({"stepper", "nonseparable"}, {"--compose", "blanes-moan:6"});
    CHECK(symmetric.out.find("is_adjoint") == std::string::npos);
}

TEST_CASE("a quadratic H is stepped by the map of the rule, and has a generating function") {
    const Outcome stepper = with_simpson({"stepper", "harmonic-oscillator"});
    CHECK(stepper.status == 0);
    CHECK(stepper.out.find("LinearMap") != std::string::npos);
    const Outcome dense = with_simpson({"stepper", "harmonic-oscillator", "--dense", "--action"});
    CHECK(dense.status == 0);
    CHECK(dense.out.find("LinearMap") == std::string::npos);
    const Outcome scheme = with_simpson({"scheme", "--hamiltonian", "p^2/2+q^2/2", "--generating"});
    CHECK(scheme.status == 0);
    CHECK(scheme.out.find("by (4.2)") != std::string::npos);
    CHECK(scheme.out.find("gives map     yes") != std::string::npos);
    CHECK(with_simpson({"scheme", "--hamiltonian", "q*p", "--generating"}).status == 1);
}

TEST_CASE("the general form runs a scene that is not separable") {
    const Directory directory;
    const Outcome outcome =
        hvi_gen({"run", "--basis", "1, tau", "--nodes", "gauss:3", "nonseparable", "--until", "20"},
                directory.path());
    INFO(outcome.err << outcome.out);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.find("largest error") != std::string::npos);
}

TEST_CASE("scheme prints (4.6) and (4.14), and the map of a quadratic H") {
    const Json found = read(with_simpson({"scheme", "pendulum", "--format", "json"}));
    CHECK(found.at("schema") == "hvi-scheme/1");
    CHECK(found.at("basis") == Json({"1", "tau"}));
    CHECK(found.at("map").is_null());
    CHECK(found.at("explicit") == false);
    CHECK(found.at("stages").at(3) == "P_1/6+2*P_2/3+P_3/6 = p-h*(sin(Q_1)/6+sin(Q_2)/3)");
    const Outcome text = with_simpson({"scheme", "pendulum"});
    CHECK(text.out.find("\nbasis         1, tau\n") != std::string::npos);
    CHECK(text.out.find("\n V_q_1+V_q_2/2 = P_2\n") != std::string::npos);
    const Outcome latex = with_simpson({"scheme", "pendulum", "--format", "latex"});
    CHECK(latex.out.find("V_{q,1} + \\frac{V_{q,2}}{2} &= P_{2}, \\\\\n") != std::string::npos);
    const Json map =
        read(with_simpson({"scheme", "--hamiltonian", "p^2/2 + w^2*q^2/2", "--format", "json"}));
    // Half the trace of what `check` finds by another way.
    CHECK(map.at("map").at(0).at(0) == "(h^4*w^4-22*h^2*w^2+48)/(2*h^2*w^2+48)");
    const Outcome lagrangian = with_simpson({"scheme", "pendulum", "--lagrangian"});
    CHECK(lagrangian.out.find("\n Q_dot_2 = V_q_1+V_q_2/2\n") != std::string::npos);
    CHECK(with_simpson({"scheme", "qp"}).status == 1);
}
