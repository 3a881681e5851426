// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "generator/render/render.hpp"
#include "tests/generator/render/output.hpp"
#include "tests/generator/render/tableaux.hpp"

using namespace hvi::gen;
using Json = nlohmann::ordered_json;

namespace {

Json json(const Tableau& tableau, int digits = 50) {
    return Json::parse(render_json(tableau, digits));
}

}  // namespace

TEST_CASE("the keys stand in the order of the schema") {
    const Json gauss = json(tableau("gauss:2"));
    CHECK(keys(gauss) == std::vector<std::string>{"schema", "name", "stages", "parameters", "basis",
                                                  "c", "b", "c_tilde", "A", "A_tilde", "M",
                                                  "M_inverse", "B", "A_psi"});
    CHECK(keys(gauss["c"][0]) == std::vector<std::string>{"exact", "decimal", "double"});
    CHECK(gauss["schema"] == "hvi-tableau/1");
    CHECK(gauss["name"] == "gauss:2");
    CHECK(gauss["stages"] == 2);
    CHECK(gauss["parameters"] == Json::array());
    CHECK(gauss["basis"] == Json({"1", "tau"}));
}

TEST_CASE("coefficients that Algorithm 4.3 did not make have nothing of Galerkin's") {
    Tableau alone = tableau("gauss:2");
    alone.galerkin.reset();
    CHECK(keys(json(alone)) == std::vector<std::string>{"schema", "name", "stages", "parameters",
                                                        "basis", "c", "b", "c_tilde", "A",
                                                        "A_tilde"});
}

TEST_CASE("an entry has its three forms") {
    const Json cheby = json(tableau("chebyshev:3"));
    CHECK(cheby["A"][0][2]["exact"] == "1/6-5*sqrt(2)/48");
    CHECK(cheby["A"][0][2]["decimal"] == "0.019352753919469265749824091228156450148992512981568");
    CHECK(cheby["A"][0][2]["double"] == "0x1.3d13554afc6acp-6");
    CHECK(cheby["b"][1]["double"] == "0x1.5555555555555p-2");
    CHECK(json(tableau("symplectic-euler"))["A"][0][0] ==
          Json({{"exact", "0"}, {"decimal", "0"}, {"double", "0x0p+0"}}));
    CHECK(json(tableau("trig3"), 3)["c_tilde"][0]["decimal"] == "-0.0577");
}

TEST_CASE("what there is not is null") {
    const Json gauss = json(tableau("gauss:6"), 5);
    CHECK(gauss["c"][0]["exact"].is_null());
    CHECK(gauss["c"][0]["decimal"] == "0.033765");
    const Json fitted = json(tableau("1, cos(w*tau)", "0, 1"));
    CHECK(fitted["name"] == "");
    CHECK(fitted["parameters"] == Json({"w"}));
    CHECK(fitted["b"][0]["exact"].is_string());
    CHECK(fitted["b"][0]["decimal"].is_null());
    CHECK(fitted["b"][0]["double"].is_null());
    CHECK(fitted["c"][1]["decimal"].is_string());
}

TEST_CASE("the same tableau gives the same bytes") {
    CHECK(render_json(tableau("trig3"), 50) == render_json(tableau("trig3"), 50));
    CHECK(render_json(tableau("trig3"), 50).back() == '\n');
}
