// Affine symmetries, against those of textbooks.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <catch2/catch.hpp>

#include "tests/generator/read/refusal.hpp"
#include "tests/generator/symmetry/found.hpp"

using namespace hvi::gen;

namespace {

using Texts = std::vector<std::string>;

/// All of them, and there are no others.
void check_all(const SceneSymmetries& found, const Texts& expected, const std::string& algebra) {
    INFO(found.name);
    CHECK(momentum_maps(found) == expected);
    CHECK(found.affine.doubt == "");
    if (!expected.empty()) CHECK(algebra_name(found) == algebra);
}

void check_count(const SceneSymmetries& found, std::size_t count, const std::string& algebra) {
    INFO(found.name);
    CHECK(found.affine.basis.size() == count);
    CHECK(found.affine.doubt == "");
    if (count > 0) CHECK(algebra_name(found) == algebra);
}

}  // namespace

TEST_CASE("Central forces") {
    check_all(found_of("(px^2+py^2)/(2*m) - k/sqrt(x^2+y^2)", "x, y", "px, py"), {"x*py-y*px"},
              "so(2)");
    check_all(found_of("(px^2+py^2+pz^2)/2 - 1/sqrt(x^2+y^2+z^2)", "x, y, z", "px, py, pz"),
              {"x*py-y*px", "x*pz-z*px", "y*pz-z*py"}, "so(3)");
    // one of which nothing is known but that it depends on the distance
    check_all(found_of("(px^2+py^2)/2 + log(x^2+y^2)*atan(x^2+y^2)", "x, y", "px, py"),
              {"x*py-y*px"}, "so(2)");
    // a force that is not central
    check_all(found_of("(px^2+py^2)/2 - 1/sqrt(x^2+2*y^2)", "x, y", "px, py"), {}, "");
    // the axis is elsewhere, and so is the centre
    check_all(found_of("(px^2+py^2)/2 + (x^2-2*x+y^2)^2", "x, y", "px, py"), {"x*py-py-y*px"},
              "so(2)");
}

TEST_CASE("Oscillators") {
    check_count(found_of("(p1^2+p2^2+p3^2)/2 + w^2*(q1^2+q2^2+q3^2)/2"), 3, "so(3)");
    check_count(found_of("(p1^2+p2^2+p3^2+p4^2+q1^2+q2^2+q3^2+q4^2)/2"), 6, "so(4)");
    check_count(found_of("(p1^2+p2^2+p3^2+p4^2+p5^2+q1^2+q2^2+q3^2+q4^2+q5^2)/2"), 10, "so(5)");
    check_all(found_of("(p1^2+p2^2)/2 + a*q1^2 + b*q2^2"), {}, "");
    check_all(found_of("(p1^2+p2^2+p3^2)/2 + a*(q1^2+q2^2) + b*q3^2"), {"q1*p2-q2*p1"}, "so(2)");
    // different masses: a rotation of ellipses
    check_all(found_of("p1^2/2 + p2^2/8 + q1^2/2 + 2*q2^2"), {"q1*p2-4*q2*p1"}, "so(2)");
    // a saddle
    check_all(found_of("p1*p2 + q1*q2"), {"q1*p1-q2*p2"}, "R");
}

TEST_CASE("Free particles, and what is linear") {
    check_all(found_of("p^2/2"), {"p"}, "R");
    check_count(found_of("(p1^2+p2^2)/2"), 3, "se(2)");
    check_count(found_of("(p1^2-p2^2)/2"), 3, "e(1,1)");
    check_count(found_of("(p1^2+p2^2+p3^2)/(2*m)"), 6, "se(3)");
    check_all(found_of("q*p"), {"q*p"}, "R");
    check_all(found_of("q^2*p^2"), {"q*p"}, "R");
    check_all(found_of("sqrt(q^2)*sqrt(p^2)"), {"q*p"}, "R");
    check_all(found_of("q*p+q^2*p^2+exp(q*p)"), {"q*p"}, "R");
    check_all(found_of("p"), {"p"}, "R");
    check_all(found_of("p*q + p"), {"p+q*p"}, "R");
    // what does not occur may be moved and stretched
    check_count(found_of("(q1^2+1)*p1 + 0*p2", "q1, q2", "p1, p2"), 2, "aff(1)");
    check_all(found_of("p^2/2 + g*q"), {}, "");
}

TEST_CASE("Charges in a field, in two gauges") {
    // what is conserved is the same; a point symmetry of H is what each gauge makes of it
    check_all(found_of("((px + B*y/2)^2 + (py - B*x/2)^2)/(2*m)", "x, y", "px, py"), {"x*py-y*px"},
              "so(2)");
    check_all(found_of("(px^2 + (py - B*x)^2)/(2*m)", "x, y", "px, py"), {"py"}, "R");
}

TEST_CASE("Bodies of any masses, and the motion of their centre") {
    const auto plane = found_of("(px1^2+py1^2)/(2*m1) + (px2^2+py2^2)/(2*m2)"
                                " - m1*m2/sqrt((x1-x2)^2+(y1-y2)^2)",
                                "x1, x2, y1, y2", "px1, px2, py1, py2");
    check_all(plane,
              {"px1+px2", "py1+py2", "x1*py1+x2*py2-y1*px1-y2*px2",
               "(m1*x1+m2*x2)*(py1+py2)-(m1*y1+m2*y2)*(px1+px2)"},
              "");  // the masses have no values
    const auto heavy = found_of("(px1^2+py1^2)/4 + (px2^2+py2^2)/6"
                                " - 6/sqrt((x1-x2)^2+(y1-y2)^2)",
                                "x1, y1, x2, y2", "px1, py1, px2, py2");
    check_count(heavy, 4, "se(2)+R");
    CHECK(momentum_maps(heavy).back() == "(2*x1+3*x2)*(py1+py2)-(2*y1+3*y2)*(px1+px2)");
}

TEST_CASE("Chains") {
    check_all(found_of("(p1^2+p2^2+p3^2)/2 + exp(q1-q2) + exp(q2-q3)"), {"p1+p2+p3"}, "R");
    // of a ring as well
    check_all(found_of("(p1^2+p2^2+p3^2)/2 + exp(q1-q2) + exp(q2-q3) + exp(q3-q1)"), {"p1+p2+p3"},
              "R");
    check_all(found_of("(p1^2+p2^2+p3^2)/2 + (q1-q2)^4 + (q2-q3)^4 + (q1-q2)^3 + (q2-q3)^3"),
              {"p1+p2+p3"}, "R");
    check_all(found_of("(p1^2+p2^2)/2 + (q1-q2)^4 + q1^2"), {}, "");
}

TEST_CASE("What is the same in another form is seen to be") {
    // a power that nobody multiplies out
    CHECK(momentum_maps(found_of("(p1^2+p2^2+p3^2+p4^2)/2 + (q1+q2+q3+q4)^40 + (q1-q2)^2"
                                 " + (q3-q4)^4")) == Texts{"p1+p2-p3-p4"});
    check_all(found_of("p^2/2 + sin(q)^2 + cos(q)^2"), {"p"}, "R");
    check_all(found_of("p^2/2 + exp(q)*exp(-q) + cosh(q)^2 - sinh(q)^2"), {"p"}, "R");
    check_all(found_of("p^2/2 + sin(2*q) - 2*sin(q)*cos(q)"), {"p"}, "R");
    check_all(found_of("p^2/2 + cos(q)"), {}, "");
    check_all(found_of("(p1^2+p2^2)/2 + cos(q1)*cos(q2) + sin(q1)*sin(q2)"), {"p1+p2"}, "R");
    check_all(found_of("(p1^2+p2^2)/2 + tan(q1-q2) + tanh(q1-q2)"), {"p1+p2"}, "R");
    check_all(found_of("(p1^2+p2^2)/2 + q1/(q1+q2) + q2/(q1+q2)"), {"p1", "p2", "q1*p2-q2*p1"},
              "se(2)");
    check_all(found_of("(p1^2+p2^2)*sqrt(q1^2+q2^2) + (p1^2+p2^2)*(q1^2+q2^2)/sqrt(q1^2+q2^2)"),
              {"q1*p2-q2*p1"}, "so(2)");
    check_all(found_of("p^2/2 + (q^2-2*q+1) - (q-1)^2"), {"p"}, "R");
    check_all(found_of("p^2/2 + (sqrt(2)*sqrt(3)-sqrt(6))*q^2"), {"p"}, "R");
}

TEST_CASE("What jumps is no symmetry, though no derivative sees it") {
    CHECK(momentum_maps(found_of("p^2/2 + sign(q)")).empty());
    CHECK(momentum_maps(found_of("(p1^2+p2^2)/2 + if(q1 < 2, q1-q2, 0)")).empty());
    CHECK(momentum_maps(found_of("(p1^2+p2^2)/2 + if((q1-q2)^2 < 2, (q1-q2)^2, 2)")) ==
          Texts{"p1+p2"});
    CHECK(momentum_maps(found_of("(p1^2+p2^2)/2 + abs(q1-q2) + min(q1-q2, 3)")) == Texts{"p1+p2"});
}

TEST_CASE("Time") {
    check_all(found_of("p^2/2 + cos(t)*q"), {}, "");
    check_all(found_of("p^2/(2*(1+t))"), {"p"}, "R");
    // moved along with the time it would stay; but not the same at all times
    check_all(found_of("p^2/2 + (q-t)^2"), {}, "");
    check_all(found_of("(p1^2+p2^2)/2 + t*(q1^2+q2^2)^2 + cos(w*t)*(q1^2+q2^2)"), {"q1*p2-q2*p1"},
              "so(2)");
}

TEST_CASE("Values of parameters decide") {
    const std::string scene = R"(
        coordinates = ["x", "y"]
        momenta = ["px", "py"]
        hamiltonian = "(px^2+py^2)/2 + a*x^2 + b*y^2 + c*x^4"
        [parameters]
        a = A
        b = 2
        c = 0
        [initial]
        x = 1
        y = 0
        px = 0
        py = 0
    )";
    const auto with = [&](const std::string& a) {
        std::string text = scene;
        return found_of_scene(text.replace(text.find(" A"), 2, " " + a));
    };
    check_all(with("1"), {}, "");
    check_all(with("2"), {"x*py-y*px"}, "so(2)");
    check_all(found_of("(px^2+py^2)/2 + a*x^2 + b*y^2", "x, y", "px, py"), {}, "");
}

TEST_CASE("Lagrangians") {
    const auto of = [](const std::string& text, const std::string& coordinates,
                       const std::string& velocities, const std::string& initial) {
        return found_of_scene("coordinates = [" + coordinates + "]\nvelocities = [" + velocities +
                              "]\nlagrangian = \"" + text + "\"\n[initial]\n" + initial);
    };
    const std::string two = "x = 1\ny = 1\nvx = 0\nvy = 0\n";
    check_all(of("(vx^2+vy^2)/2 + 1/sqrt(x^2+y^2)", "\"x\", \"y\"", "\"vx\", \"vy\"", two),
              {"x*vy-y*vx"}, "so(2)");
    check_all(of("(vx^2+vy^2)/2 + cos(x-y)", "\"x\", \"y\"", "\"vx\", \"vy\"", two), {"vx+vy"},
              "R");
    // a sphere: no matrix is inverted for it
    check_all(of("(vx^2+sin(x)^2*vy^2)/2", "\"x\", \"y\"", "\"vx\", \"vy\"", two), {"vy*sin(x)^2"},
              "R");
    check_all(of("vx^2/2 - cos(x)", "\"x\"", "\"vx\"", "x = 1\nvx = 0\n"), {}, "");
}

TEST_CASE("Scenes that come with the program") {
    const auto of = [](const char* name) {
        return find_symmetries(find_scene(given("scene", name)));
    };
    check_count(of("outer-solar-system"), 9, "se(3)+so(3)");
    check_all(of("kepler"), {"x*py-y*px"}, "so(2)");
    check_all(of("qp"), {"q*p"}, "R");
    check_count(of("point-vortices"), 2, "aff(1)");
    CHECK(momentum_maps(of("point-vortices")) ==
          Texts{"p[1]+p[2]+p[3]+p[4]",
                "(g[1]*x[1]+g[2]*x[2]+g[3]*x[3]+g[4]*x[4])*(p[1]+p[2]+p[3]+p[4])"});
    check_count(of("robot-arm"), 1, "R");
    for (const char* name : {"harmonic-oscillator", "henon-heiles", "nonseparable", "pendulum",
                             "fpu", "double-pendulum", "two-pendulums", "bead-on-hoop"})
        check_all(of(name), {}, "");
}

TEST_CASE("Coefficients of which nobody knows whether they are zero are no end of it") {
    // For an unknown b it is open which of the two coordinates the choice is.
    const SceneSymmetries chosen = found_of_scene(R"toml(
        coordinates = ["x", "y"]
        velocities = ["vx", "vy"]
        lagrangian = "vx^2/2 + vy^2/2 - abs(if(b > 3, y, x))"
        [parameters]
        b = 1
        [initial]
        x = 1
        y = 1
        vx = 0
        vy = 0
    )toml");
    CHECK(momentum_maps(chosen) == std::vector<std::string>{"vy"});
    // cosh(1e300) is larger than what an enclosure holds.
    const SceneSymmetries large = found_of_scene(R"toml(
        coordinates = "x"
        velocities = "v"
        lagrangian = "v^2/2 - x^2/2"
        [invariants]
        constant = "cbrt(cosh(1e300))"
        [initial]
        x = 1
        v = 0
    )toml");
    CHECK(large.invariants[0].finding.conserved == Vanishing::proved);
}

TEST_CASE("A number that is not real is refused where the text has symbols in it") {
    for (const char* term : {"sqrt(q/q-cbrt(3))", "asin(q/q+1)", "log10(q/q-2)", "acosh(p-p)"}) {
        const Refusal found = refusal([&] { return found_of("p^2/2 + " + std::string(term)); });
        INFO(term);
        CHECK(found.what == "this is not real");
        CHECK(found.marked == "p^2/2 + [" + std::string(term) + "]");
        CHECK(found.status == 1);
    }
    CHECK(momentum_maps(found_of("p^2/2 + sqrt(cbrt(3)-q/q)")) == std::vector<std::string>{"p"});
}

TEST_CASE("What is refused of a vector field points to its line") {
    for (const char* component : {"y^10000", "asin(2)*y", "sqrt(x/x-cbrt(3))*y"}) {
        const Refusal found = refusal([&] {
            return found_of_scene("coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\n"
                                  "hamiltonian = \"(px^2+py^2)/2\"\n[symmetries]\nturn = {x = \"" +
                                  std::string(component) +
                                  "\", y = \"x\"}\n[initial]\nx = 1\ny = 0\npx = 0\npy = 1\n");
        });
        CHECK(found.status > 0);
        CHECK(found.marked.find("turn = ") != std::string::npos);
    }
}
