// Splittings among the methods that --accuracy measures.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/study/raced_splittings.hpp"
#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"

using namespace hvi::gen;
using namespace hvi::test;

namespace {

using RacedNames = std::vector<std::string>;

RacedNames raced(const Scene& scene) {
    const auto names = raced_splittings(lowered(scene));
    return {names.begin(), names.end()};
}

Scene plane_scene(const std::string& hamiltonian, const std::string& more = "") {
    return scene_from_toml({"s.toml", "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                                      "hamiltonian = \"" +
                                          hamiltonian + "\"\n" + more +
                                          "[initial]\nx = 1\ny = 0\npx = 0\npy = 1\n"});
}

Scene known_scene(const char* name) { return find_scene(given("SCENE", name)); }

const RacedNames race_of_parts{"strang", "strang-suzuki:4", "strang-blanes-moan:6",
                               "strang-kahan-li:8"};

bool shows_words(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("splittings are raced where parts of H have known flows") {
    CHECK(raced(known_scene("free-rigid-body")) == race_of_parts);
    CHECK(raced(known_scene("heavy-top")) == race_of_parts);
    CHECK(raced(plane_scene("(x^2 + px^2)^2 + (y^2 + py^2)/2 + x*y^2")) == race_of_parts);
    RacedNames with_two = race_of_parts;
    with_two.insert(with_two.end(), {"saba:4", "mclachlan:8.4", "blanes:10.6.4"});
    CHECK(raced(plane_scene("(px^2 + py^2 + x^2 + y^2)/2 + x^2*y/100",
                            "[split]\nA = \"(px^2 + py^2 + x^2 + y^2)/2\"\nB = \"x^2*y/100\"\n")) ==
          with_two);
    CHECK(raced(plane_scene("(px^2 + py^2 + x^2 + y^2)/2 + x^2*y/100",
                            "[split]\nA = \"(px^2 + x^2)/2\"\nB = \"(py^2 + y^2)/2\"\nC = "
                            "\"x^2*y/100\"\n")) == race_of_parts);
}

TEST_CASE("splittings are not raced where they are refused, or kicks and drifts") {
    CHECK(raced(known_scene("kepler")).empty());
    CHECK(raced(known_scene("henon-heiles")).empty());
    CHECK(raced(known_scene("double-pendulum")).empty());  // no flows are known
    CHECK(raced(plane_scene("(1 + x^2)*px^2/2 + py^2/2 + sin(x*py)")).empty());
    CHECK(raced(plane_scene("(px^2 + py^2)^2 + x^4*sin(t)")).empty());  // a time
    Scene without = known_scene("free-rigid-body");
    without.split = SplitChoice::none;
    CHECK(raced(without).empty());
    Scene found = known_scene("henon-heiles");
    found.split = SplitChoice::automatic;
    CHECK(raced(found) == race_of_parts);
}

TEST_CASE("stepper --accuracy of a body measures splittings, and writes the fastest") {
    use_cache();
    const Directory directory;
    const Outcome result = hvi_gen(
        {"stepper", "free-rigid-body", "--until", "10", "--accuracy", "1e-6", "-o", "body.hpp"},
        directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    for (const std::string& name : race_of_parts) CHECK(shows_words(result.err, "  " + name + " "));
    CHECK(shows_words(result.err, "  gauss:4 "));
    CHECK_FALSE(shows_words(result.err, "saba"));
    // The first row is the fastest, whichever that is on this machine.
    const std::size_t first = result.err.find("\n  method ") + 1;
    const std::size_t row = result.err.find('\n', first) + 3;
    const bool is_splitting = result.err.compare(row, 6, "strang") == 0;
    CHECK(shows_words(contents(directory / "body.hpp"), "--method strang free-rigid-body") ==
          is_splitting);
}
