// Certificates of methods: what stands where in JSON. The numbers are checked in
// tests/generator/exact.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "generator/render/certificate.hpp"
#include "tests/generator/exact/exact.hpp"

using namespace hvi::gen;
using Read = nlohmann::json;

namespace {

Read certificate(const std::string& given, int max_order = 4) {
    return Read::parse(render_json(certify(derive(any_method(given)), max_order)));
}

}  // namespace

TEST_CASE("trig3 is of order 2, symplectic and self-adjoint, and has a pole") {
    const Read json = certificate("trig3");
    CHECK(json["schema"] == "hvi-check/1");
    CHECK(json["name"] == "trig3");
    CHECK(json["stages"] == 3);
    for (const char* name : {"consistent", "symplectic", "symmetric", "proved"}) {
        CHECK(json[name] == true);
    }
    for (const char* name : {"order", "order_separable", "order_nystrom"}) {
        CHECK(json[name] == 2);
    }
    CHECK(json["runge_kutta"] == false);
    CHECK(json["order_is_at_least"] == false);
    CHECK(json["conditions"] == Read({2, 4, 14}));
    // sum_i b_i c_i^2 - 1/3 = 1/6 - 1/(2 pi).
    CHECK(json["failures"][0]["tree"] == "f[f,f]");
    CHECK(json["failures"][0]["residual"]["exact"] == "1/6-1/(2*pi)");
    CHECK(json["conserves"] == Read({{"linear", true}, {"qCp", true}, {"quadratic", false}}));
    CHECK(json["explicit"] == Read({{"separable", false}, {"general", false}}));
    const Read& stability = json["linear_stability"];
    CHECK(stability["until"] == 20);
    CHECK(stability["determinant_is_one"] == true);
    // pi sqrt((pi - 2)/2), and where DESIGN has the pole.
    CHECK(stability["stable"][0][0] == 0.0);
    CHECK(stability["stable"][0][1].get<double>() == Approx(2.3735066755879478).epsilon(1e-15));
    CHECK(stability["poles"][0].get<double>() == Approx(7.381425027442868).epsilon(1e-15));
}

TEST_CASE("an order that is only a bound is said to be one") {
    const Read gauss = certificate("gauss:3");
    CHECK(gauss["order"] == 4);
    CHECK(gauss["order_is_at_least"] == true);
    CHECK(gauss["failures"].is_null());
    CHECK(gauss["error_constant"].is_null());
    CHECK(gauss["runge_kutta"] == true);
    CHECK(gauss["conserves"]["quadratic"] == true);
    CHECK(gauss["linear_stability"]["at_infinity"]["stable"] == true);
}

TEST_CASE("signs of weights, places of nodes, explicit steps") {
    // Milne's open rule: 2/3, -1/3, 2/3.
    const Read milne = certificate("newton-cotes-open:3");
    CHECK(milne["negative_weights"] == Read({2}));
    CHECK(milne["nodes_outside"] == Read::array());
    CHECK(certificate("1, tau | -1/2, 1")["nodes_outside"] == Read({1}));
    const Read verlet = certificate("stormer-verlet");
    CHECK(verlet["explicit"] == Read({{"separable", true}, {"general", false}}));
    CHECK(verlet["linear_stability"]["stable"] == Read({{0.0, 2.0}}));
}

TEST_CASE("with a free parameter stability is a formula") {
    const Read json = certificate("1, cos(w*tau), sin(w*tau) | 0, 1/2, 1", 3);
    CHECK(json["parameters"] == Read({"w"}));
    CHECK(json["order"] == 2);
    CHECK(json["linear_stability"]["stable"].is_null());
    CHECK(json["linear_stability"]["poles"].is_null());
    CHECK(json["linear_stability"]["half_trace"].is_string());
}

TEST_CASE("where the map is too long, why and what helps is told") {
    Certificate found = certify(derive(any_method("1, cos(w*tau), sin(w*tau) | 0, 1/2, 1")), 3);
    CHECK_FALSE(Read::parse(render_json(found))["linear_stability"].contains("not_looked_at"));
    found.oscillator.reset();
    const Read stability = Read::parse(render_json(found))["linear_stability"];
    CHECK(stability["half_trace"].is_null());
    const std::string why = stability["not_looked_at"];
    CHECK(why.find("too long") != std::string::npos);
    CHECK(why.find("--param w=1") != std::string::npos);
    CHECK(render_text(found).find("oscillator    not looked at: ") != std::string::npos);
}

TEST_CASE("a residual of thousands of terms is told by their number") {
    const Certificate found =
        certify(derive(any_method("1, tau, cos(w*tau), sin(w*tau) | gauss:4")), 3);
    const std::string text = render_text(found);
    CHECK(text.size() < 10000);
    CHECK(text.find(" terms, too long for a line") != std::string::npos);
    CHECK(text.find("trace/2 has coefficients that are too long") != std::string::npos);
    CHECK(text.find("All of it is proved.") != std::string::npos);
}

TEST_CASE("names, the adjoint, and the stages that couple") {
    const Read left = certificate("radau-left:3");
    CHECK(left["known_as"] == Read({"radau-left:3"}));
    CHECK(left["adjoint"] == Read({"radau-right:3"}));
    const Read lobatto = certificate("1, tau, tau^2 | 0, 1/2, 1");
    CHECK(lobatto["known_as"] == Read({"lobatto:3", "newton-cotes:3", "clenshaw-curtis:3"}));
    // The first row of A is zero, the last one b: Q_1 is given, Q_3 = q' needs what is solved for.
    CHECK(lobatto["coupled"]["separable"] == Read::parse(R"([["Q_2", "P_1", "P_2", "P_3"]])"));
    CHECK(lobatto["coupled"]["general"] == Read::parse(R"([["Q_2", "Q_3", "P_1", "P_2", "P_3"]])"));
    CHECK(certificate("stormer-verlet")["coupled"]["separable"].empty());
    // P_1 = p - h/2 dH/dq(q, P_1), then Q_2, then P_2 = P_1.
    CHECK(certificate("stormer-verlet")["coupled"]["general"] ==
          Read::parse(R"([["P_1"], ["Q_2"]])"));
}

TEST_CASE("values of a parameter that raise the order") {
    const Read json =
        Read::parse(render_json(std::get<Certificate>(certify(any_method("1, tau | 0, w"), 4))));
    CHECK(json["order"] == 2);
    CHECK(json["exceptions"].size() == 1);
    CHECK(json["exceptions"][0]["parameter"] == "w");
    CHECK(json["exceptions"][0]["value"]["exact"] == "2/3");
    CHECK(json["exceptions"][0]["order"] == 3);
    CHECK(json["exceptions"][0]["order_is_at_least"] == false);
    CHECK(certificate("gauss:2")["exceptions"].empty());
}

TEST_CASE("what rests on enclosures is not called proved") {
    const Read json = certificate("1, exp(tau^2) | 0, 1");
    CHECK(json["proved"] == false);
    CHECK(json["order"] == 1);
    CHECK(json["linear_stability"]["determinant_is_one"] == false);
}
