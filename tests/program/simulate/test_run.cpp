// `hvi-gen run`.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/cli/program.hpp"
#include "tests/program/simulate/cache.hpp"
#include "tests/program/simulate/pretended.hpp"
#include "tests/program/simulate/table.hpp"

using namespace hvi::test;

namespace {

/// A compiler that notes how it is called.
std::string noting_compiler(const Directory& directory) {
    write(directory / "cxx", "#!/bin/sh\necho \"$*\" >> '" + (directory / "calls").string() +
                                 "'\nexec " + compiler_of_tests() + " \"$@\"\n");
    std::filesystem::permissions(directory / "cxx", std::filesystem::perms::owner_all);
    return "CXX=./cxx ";
}

}  // namespace

TEST_CASE("a run of the oscillator is that of its matrix") {
    use_cache();
    const Directory directory;
    const Outcome result = hvi_gen({"run", "harmonic-oscillator", "--method", "gauss:2", "--step",
                                    "0.1", "--until", "0.3", "-o", "out", "--only", "table"},
                                   directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    CHECK(result.out.empty());
    CHECK(directory.names() == std::vector<std::string>{"out"});
    const auto lines = lines_of(contents(directory / "out/trajectory.csv"));
    REQUIRE(lines.size() == 5);
    CHECK(lines[0] == "t,q,p,energy");
    CHECK(lines[1] == "0,1,0,0.5");
    // (6.6) of the paper.
    const double h = 0.1, below = std::pow(h, 4) + 12 * h * h + 144;
    const double d = (std::pow(h, 4) - 60 * h * h + 144) / below;
    const double o = (144 * h - 12 * std::pow(h, 3)) / below;
    double q = 1, p = 0;
    for (std::size_t step = 1; step <= 3; ++step) {
        const double next = d * q + o * p;
        p = d * p - o * q;
        q = next;
        const auto row = numbers_of(lines[step + 1]);
        REQUIRE(row.size() == 4);
        CHECK(row[0] == static_cast<double>(step) * h);
        CHECK(std::abs(row[1] - q) < 1e-15);
        CHECK(std::abs(row[2] - p) < 1e-15);
        CHECK(std::abs(row[3] - 0.5) < 1e-15);
    }
}

TEST_CASE("a run finds what factors a sparse matrix") {
    use_cache();
    const Directory directory;
    write(directory / "plane.toml",
          "coordinates = \"q[1..N,1..N]\"\nmomenta = \"p[1..N,1..N]\"\nhamiltonian = "
          "\"sum(i=1..N, j=1..N, p[i,j]^2/2 + (q[mod(i,N)+1,j]-q[i,j])^2/2)\"\n[parameters]\nN = "
          "4\n[initial]\n\"q[i,j]\" = \"cos(pi*i/2)\"\n\"p[i,j]\" = 0\n");
    const Outcome result =
        hvi_gen({"run", "plane.toml", "--unroll", "no", "--method", "gauss:2", "--step", "0.1",
                 "--until", "0.1", "--columns", "q[1..4,1]", "-o", "out", "--only", "table"},
                directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const auto lines = lines_of(contents(directory / "out/trajectory.csv"));
    REQUIRE(lines.size() == 3);
    // The forces on a wave of four places are -2 q: a step is (6.6) of the paper with z = h
    // sqrt(2).
    const double z = 0.1 * std::sqrt(2.0), below = std::pow(z, 4) + 12 * z * z + 144;
    const double d = (std::pow(z, 4) - 60 * z * z + 144) / below;
    const auto row = numbers_of(lines[2]);
    REQUIRE(row.size() == 5);
    CHECK(std::abs(row[1]) < 1e-15);
    CHECK(std::abs(row[2] + d) < 1e-15);
    CHECK(std::abs(row[3]) < 1e-15);
    CHECK(std::abs(row[4] - d) < 1e-15);
}

TEST_CASE("a run of Kepler's problem leaves a table, a picture and a summary") {
    use_cache();
    const Directory directory;
    const Outcome result =
        hvi_gen({"run", "kepler", "--until", "100*pi", "--step", "pi/100", "--param", "ecc=1/5"},
                directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const std::filesystem::path out = directory / "kepler-gauss_4";
    CHECK(contents(out / "summary.txt") == result.out);
    CHECK(result.out.find("steps             10000 of ") != std::string::npos);
    const auto lines = lines_of(contents(out / "trajectory.csv"));
    REQUIRE(lines.size() == 10002);
    CHECK(lines[0] == "t,x,y,px,py,energy,angular_momentum");
    const auto start = numbers_of(lines[1]), end = numbers_of(lines.back());
    CHECK(start[1] == 0.8);
    CHECK(std::abs(start[4] - std::sqrt(1.5)) < 1e-15);
    CHECK(std::abs(end[0] - 100 * std::acos(-1.0)) < 1e-10);
    // After 50 turns.
    for (std::size_t k = 1; k < 5; ++k) CHECK(std::abs(end[k] - start[k]) < 1e-9);
    CHECK(contents(out / "picture.svg").rfind("</svg>") != std::string::npos);
    CHECK(contents(out / "picture.svg").find("angular_momentum") != std::string::npos);
}

TEST_CASE("long runs are thinned out, and counted whole") {
    use_cache();
    const Directory directory;
    const Outcome result =
        hvi_gen({"run", "harmonic-oscillator", "--until", "2500.1", "-o", "out"}, directory.path());
    REQUIRE(result.status == 0);
    const auto lines = lines_of(contents(directory / "out/trajectory.csv"));
    // 25001 steps, one row in 3 and the last.
    REQUIRE(lines.size() == 2 + 25001 / 3 + 1);
    CHECK(std::abs(numbers_of(lines[2])[0] - 0.3) < 1e-15);
    CHECK(numbers_of(lines.back())[0] == 25001 * 0.1);
    CHECK(result.out.find("steps        25001 of 0.1") != std::string::npos);
}

TEST_CASE("columns of a run are those of the whole table, in the order wished for") {
    use_cache();
    const Directory directory;
    const auto run = [&](const std::string& out, const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", "outer-solar-system", "--until", "3000", "-o", out};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = hvi_gen(words, directory.path());
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        return lines_of(contents(directory / (out + "/trajectory.csv")));
    };
    const auto all = run("all", {"--only", "table"});
    const auto some = run("some", {"--columns", "momentum_y, y[2..3], energy, px[6]"});
    REQUIRE(all.size() == 12);
    REQUIRE(some.size() == all.size());
    CHECK(all[0].find("t,x[1],x[2],x[3],") == 0);
    CHECK(some[0] == "t,momentum_y,y[2],y[3],energy,px[6]");
    for (std::size_t k = 1; k < all.size(); ++k) {
        // There are columns for 18 coordinates and as many momenta, the energy, six invariants, and
        // three ways to turn the centre of mass.
        const auto whole = numbers_of(all[k]);
        REQUIRE(whole.size() == 1 + 36 + 7 + 3);
        CHECK(numbers_of(some[k]) ==
              std::vector<double>{whole[0], whole[39], whole[8], whole[9], whole[37], whole[24]});
    }
    CHECK(contents(directory / "some/picture.svg").find("momentum_y") != std::string::npos);
    CHECK(contents(directory / "some/picture.svg").find("momentum_x") == std::string::npos);
    // Also where there is nothing to draw one against the other, or nothing that is kept.
    for (const char* list : {"energy", "py", "y[4]"}) {
        CHECK(run(list, {"--columns", list}).size() == 12);
    }
}

TEST_CASE("a summary says what the method keeps, and warns of what the motion does not keep") {
    use_cache();
    const Directory directory;
    write(directory / "bowl.toml", R"(
coordinates = ["x", "y"]
momenta     = ["px", "py"]
hamiltonian = "(px^2 + py^2)/2 + (x^2 + y^2)^2"
[invariants]
wrong = "x*px"
[initial]
x  = 1
y  = 0
px = 0
py = 1
[run]
method = "gauss:2"
step   = "1/10"
until  = 1
)");
    const auto outcome = hvi_gen({"run", "bowl.toml", "--only", "summary"}, directory.path());
    CHECK(outcome.status == 0);
    const auto said = [&](const std::string& name) {
        for (const std::string& line : lines_of(outcome.out))
            if (line.rfind(name + " ", 0) == 0) return line.substr(line.find(';') + 2);
        return std::string();
    };
    CHECK(said("J1") == "conserved");
    CHECK(said("energy") == "not conserved exactly by this method");
    const std::string wrong =
        "{wrong, H} = px^2-4*x^4-4*x^2*y^2 is not zero as a function of q and p";
    CHECK(said("wrong").rfind(wrong + "; on this run wrong changed by ", 0) == 0);
    CHECK(outcome.err.find("warning: the invariant `wrong`: " + wrong) != std::string::npos);
}

TEST_CASE("a run names momentum maps as symmetries does") {
    use_cache();
    const Directory directory;
    // x = (1, 2, 3) and p = (2, 3, 5) have the angular momenta 3-4, 5-6 and 10-9 for these pairs.
    write(directory / "space.toml", R"(coordinates = ["x", "y", "z"]
momenta     = ["px", "py", "pz"]
hamiltonian = "(px^2+py^2+pz^2)/2 + (x^2+y^2+z^2)^2"
[invariants]
spin = "x*py - y*px"
[initial]
x  = 1
y  = 2
z  = 3
px = 2
py = 3
pz = 5
[run]
method = "gauss:2"
step   = "1/10"
until  = 1
)");
    const auto found = hvi_gen({"symmetries", "space.toml"}, directory.path());
    const auto run = hvi_gen({"run", "space.toml", "--only", "summary"}, directory.path());
    REQUIRE(run.status == 0);
    const std::map<std::string, double> values{
        {"x*py-y*px", -1}, {"x*pz-z*px", -1}, {"y*pz-z*py", 1}};
    std::size_t maps = 0;
    for (const std::string& line : lines_of(found.out)) {
        if (line.rfind("  J", 0) != 0) continue;
        const std::string name = line.substr(2, 2),
                          map = line.substr(line.find_first_not_of(' ', 4));
        CAPTURE(name, map);
        ++maps;
        std::string value;
        for (const std::string& each : lines_of(run.out))
            if (each.rfind(name + " ", 0) == 0) value = each.substr(each.find_first_not_of(' ', 2));
        if (map == "x*py-y*px")
            CHECK(value.empty());
        else
            CHECK(std::stod(value) == Approx(values.at(map)));
    }
    CHECK(maps == 3);
}

TEST_CASE("what is conserved on the energy of a run alone is said to be just that") {
    use_cache();
    const Directory directory;
    // A free particle: C = q (p^2 - 1) moves with p (p^2 - 1), which is 0 where p = 1.
    write(directory / "free.toml", R"toml(
coordinates = "u"
momenta     = "w"
hamiltonian = "w^2/2"
[invariants]
C = "u*(w^2 - 1)"
b = "-w + 1"
I = "w"
[initial]
u = -2
w = 1
[run]
method = "lobatto:3"
step   = "1/10"
until  = 1
)toml");
    const auto outcome = hvi_gen({"run", "free.toml", "-o", "out"}, directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    const auto line = [&](const std::string& name) {
        for (const std::string& each : lines_of(outcome.out))
            if (each.rfind(name + " ", 0) == 0) return each.substr(13);
        return std::string();
    };
    CHECK(line("C") == "0; {C, H} = w^3-w is not zero as a function of q and p; on this run C "
                       "changed by 0.00e+00 at most, 0.00e+00 at the end");
    CHECK(line("b").rfind("0, largest error 0.00e+00", 0) == 0);
    CHECK(line("I").rfind("1, largest error 0.00e+00", 0) == 0);
    const auto table = lines_of(contents(directory / "out/trajectory.csv"));
    CHECK(table.at(0) == "t,u,w,energy,C,b,I");
    CHECK(table.at(1) == "0,-2,1,0.5,0,0,1");
}

TEST_CASE("a large step of the general form is led there from shorter ones") {
    use_cache();
    const Directory directory;
    write(directory / "relativistic.toml", R"toml(
coordinates = "q"
momenta     = "p"
hamiltonian = "sqrt(1+p^2)*(2+cos(q))"
[initial]
q = 1
p = 1
)toml");
    const auto step = [&](const std::string& h) {
        return hvi_gen({"run", "relativistic.toml", "--basis", "1, tau, tau^2", "--nodes",
                        "gauss:5", "--step", h, "--until", h, "-o", "out", "--only", "table"},
                       directory.path());
    };
    // Ends of steps by (4.6), from another program with Newton's method along h.
    const std::vector<std::pair<std::string, std::vector<double>>> ends = {
        {"2", {3.505930726494, 3.193411156000}},
        {"11/4", {4.423450626268, 1.811436530987}},
        {"3", {4.828144046891, 1.347009650109}},
        {"5", {8.190552278150, 2.171375635282}},
    };
    for (const auto& [h, end] : ends) {
        const Outcome result = step(h);
        INFO(h << result.err);
        REQUIRE(result.status == 0);
        const std::vector<double> row =
            numbers_of(lines_of(contents(directory / "out/trajectory.csv")).back());
        CHECK(std::abs(row.at(1) - end[0]) < 1e-11);
        CHECK(std::abs(row.at(2) - end[1]) < 1e-11);
    }
    // Where no way leads there the equations are not said to be singular.
    const Outcome failed = step("7");
    CHECK(failed.status == 1);
    CHECK(failed.err.find("did not converge") != std::string::npos);
}

TEST_CASE("names with two indices are cells of their own, and drawn") {
    use_cache();
    const Directory directory;
    write(directory / "sheet.toml",
          "coordinates = [\"u[1..2,1..2]\"]\nmomenta = [\"v[1..2,1..2]\"]\n"
          "hamiltonian = \"sum(i=1..2, j=1..2, v[i,j]^2 + u[i,j]^2)/2\"\n"
          "initial = {\"u[i,j]\" = \"i + 10*j\", \"v[i,j]\" = 0}\n"
          "run = {method = \"stormer-verlet\", step = 0.1, until = 1}\n");
    const Outcome result = hvi_gen(
        {"run", "sheet.toml", "-o", "out", "--columns", "v[1,1], u[1..2,2]"}, directory.path());
    INFO(result.err);
    REQUIRE(result.status == 0);
    const auto lines = lines_of(contents(directory / "out/trajectory.csv"));
    REQUIRE(lines.size() == 12);
    CHECK(lines[0] == "t,\"v[1,1]\",\"u[1,2]\",\"u[2,2]\"");
    CHECK(lines[1] == "0,0,21,22");
    CHECK(contents(directory / "out/picture.svg").find("u[2,2]") != std::string::npos);
}

TEST_CASE("what is left out at the end of a run is said") {
    use_cache();
    const Directory directory;
    const auto run = [&](const std::string& step, const std::string& until) {
        return hvi_gen(
            {"run", "harmonic-oscillator", "--step", step, "--until", until, "--only", "summary"},
            directory.path());
    };
    const auto has = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    const Outcome part = run("3/10", "2");
    CHECK(part.status == 0);
    CHECK(part.err == "note: left out is t = 1.8 to 2, which is less than a step of 0.3\n");
    CHECK(has(part.out, "\nsteps        6 of 0.3, until t = 1.8\n"));
    CHECK(has(part.out, "\nleft out     t = 1.8 to 2, which is less than a step\n"));
    const Outcome none = run("3", "2");
    CHECK(none.status == 0);
    CHECK(none.err ==
          "note: no step is made; left out is t = 0 to 2, which is less than a step of 3\n");
    CHECK(has(none.out, "\nleft out     t = 0 to 2, which is less than a step\n"));
    const Outcome back = run("-3/10", "-2");
    CHECK(back.err == "note: left out is t = -1.8 to -2, which is less than a step of -0.3\n");
    const Outcome whole = run("1/10", "2");
    CHECK(whole.err.empty());
    CHECK_FALSE(has(whole.out, "left out"));
    CHECK(run("1/10", "0").err.empty());
}

TEST_CASE("the axis of time has ticks at round numbers") {
    use_cache();
    const Directory directory;
    const std::vector<std::string> words{
        "run", "harmonic-oscillator", "--until", "17.1", "-o", "out", "--only", "picture"};
    REQUIRE(hvi_gen(words, directory.path()).status == 0);
    const std::string svg = contents(directory / "out/picture.svg");
    for (const char* tick : {"5", "10", "15"})
        CHECK(svg.find("> " + std::string(tick) + "<") != std::string::npos);
    // A fifth of the time, and multiples of it.
    for (const char* tick : {"3.42", "6.84", "10.26", "13.68"})
        CHECK(svg.find("> " + std::string(tick) + "<") == std::string::npos);
}

TEST_CASE("a gnuplot that writes nothing, or half a picture") {
    use_cache();
    const Directory directory;
    const auto run_with = [&](const std::string& gnuplot) {
        write(directory / "gnuplot", "#!/bin/sh\n" + gnuplot + "\n");
        std::filesystem::permissions(directory / "gnuplot", std::filesystem::perms::owner_all);
        return shell("PATH=\"$PWD:$PATH\" hvi-gen run pendulum --until 1 -o out", directory.path());
    };
    for (const char* gnuplot :
         {"exit 0", "echo '<svg>'", "echo 'no fonts here' >&2; exit 0", "exit 1"}) {
        const Outcome outcome = run_with(gnuplot);
        INFO(gnuplot << "\n" << outcome.err);
        CHECK(outcome.status == 3);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.find("error: gnuplot ") == 0);
        CHECK_FALSE(std::filesystem::exists(directory / "out/picture.svg"));
        CHECK(lines_of(contents(directory / "out/trajectory.csv")).size() > 2);
    }
    CHECK(run_with("echo 'no fonts here' >&2; exit 0").err.find("no fonts here") !=
          std::string::npos);
}

TEST_CASE("nothing is made that was not asked for") {
    use_cache();
    const Directory directory;
    const auto only = [&](const std::string& what, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words{"run", "pendulum", "--until", "1", "--only", what};
        words.insert(words.end(), more.begin(), more.end());
        return hvi_gen(words, directory.path());
    };
    CHECK(only("summary").status == 0);
    CHECK(directory.names().empty());
    CHECK(only("picture,summary", {"-o", "a/b"}).status == 0);
    CHECK(contents(directory / "a/b/trajectory.csv").empty());
    CHECK(!contents(directory / "a/b/picture.svg").empty());
    CHECK(!contents(directory / "a/b/summary.txt").empty());
    CHECK(only("pictures").status == 2);
    CHECK(only("").status == 2);
    CHECK(only("table,").status == 2);
}

TEST_CASE("a program is compiled once") {
    use_cache();
    const Directory directory;
    const std::string line =
        noting_compiler(directory) + "hvi-gen run pendulum --only summary --until ";
    REQUIRE(shell(line + "2", directory.path()).status == 0);
    REQUIRE(shell(line + "3", directory.path()).status == 0);
    const auto calls = lines_of(contents(directory / "calls"));
    REQUIRE(calls.size() == 3);
    CHECK(calls[0] == "--version");
    CHECK(calls[1].find("main.cpp") != std::string::npos);
    CHECK(calls[2] == "--version");
    REQUIRE(shell(line + "2 --solver fixed-point", directory.path()).status == 0);
    CHECK(lines_of(contents(directory / "calls")).size() == 5);
}

TEST_CASE("a run that stops keeps what there is, and says so") {
    use_cache();
    const Directory directory;
    // The body is at infinity before t = 2.
    write(directory / "escape.toml",
          "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
          "hamiltonian = \"p^2/2 - q^4/4\"\n"
          "initial = {q = 1, p = 1}\n"
          "run = {method = \"stormer-verlet\", step = 0.1, until = 9}\n");
    const Outcome result = hvi_gen({"run", "escape.toml", "-o", "out"}, directory.path());
    CHECK(result.status == 1);
    CHECK(result.out.empty());
    CHECK(result.err.find("error: the run stopped after ") == 0);
    CHECK(result.err.find("out") != std::string::npos);
    const auto lines = lines_of(contents(directory / "out/trajectory.csv"));
    REQUIRE(lines.size() >= 3);
    CHECK(lines.back().find("# incomplete: ") == 0);
    CHECK(contents(directory / "out/summary.txt").find("incomplete") != std::string::npos);
    CHECK(contents(directory / "out/picture.svg").find("incomplete") != std::string::npos);
}

TEST_CASE("compilers that are missing, and that fail") {
    use_cache();
    const Directory directory;
    const std::string run = "hvi-gen run pendulum --step 1/3 --solver newton";
    const Outcome missing = shell("CXX=no-such-compiler " + run, directory.path());
    CHECK(missing.status == 3);
    CHECK(missing.err.find("error: there is no C++ compiler") == 0);
    write(directory / "cxx", "#!/bin/sh\n[ \"$1\" = --version ] && exit 0\n"
                             "echo 'a warning' >&2\necho 'x.cpp:1:2: error: boom' >&2\nexit 1\n");
    std::filesystem::permissions(directory / "cxx", std::filesystem::perms::owner_all);
    const Outcome failing = shell("CXX=./cxx " + run, directory.path());
    CHECK(failing.status == 3);
    CHECK(failing.err.find("error: the compiler failed: x.cpp:1:2: error: boom\n") == 0);
    CHECK(failing.out.empty());
    CHECK(directory.names() == std::vector<std::string>{"cxx"});
}

TEST_CASE("a compiler in a directory with a blank in its name") {
    use_cache();
    const Directory directory;
    const std::string run = "hvi-gen run pendulum --step 1/5 --until 1 --only summary -o out";
    noting_compiler(directory);
    REQUIRE(shell("mkdir 'my tools' && mv cxx 'my tools'", directory.path()).status == 0);
    const Outcome blank = shell("CXX='my tools/cxx' " + run, directory.path());
    INFO(blank.err);
    CHECK(blank.status == 0);
    CHECK(contents(directory / "calls").find("-std=c++17") != std::string::npos);
}

TEST_CASE("a disk that is full, and a machine without gnuplot") {
    use_cache();
    const Directory directory;
    const std::string run = "hvi-gen run henon-heiles -o out --until 500";
    REQUIRE(shell(run + " --only summary", directory.path()).status == 0);
    // Writing fails when the file has this size, as it does on a full disk.
    const Outcome full = shell("ulimit -f 16; " + run, directory.path());
    CHECK(full.status == 3);
    CHECK(full.err.find("error: cannot write out/") == 0);
    CHECK(contents(directory / "out/trajectory.csv").empty());
    const Outcome no_gnuplot = shell("CXX=\"$(command -v c++)\"; export CXX; "
                                     "hvi-gen run henon-heiles --only summary --until 500 && "
                                     "PATH=/none && " +
                                         run,
                                     directory.path());
    CHECK(no_gnuplot.status == 3);
    CHECK(no_gnuplot.err.find("gnuplot") != std::string::npos);
    CHECK(lines_of(contents(directory / "out/trajectory.csv")).size() == 2002);
}

TEST_CASE("an interrupted run leaves nothing half written") {
    use_cache();
    const Directory directory;
    const std::string run = "hvi-gen run harmonic-oscillator --only ";
    REQUIRE(shell(run + "summary", directory.path()).status == 0);
    const Outcome interrupted = shell("\"$hvi_gen\" run harmonic-oscillator -o out --step 1/10^6 "
                                      "--until 10^6 & sleep 1; kill -INT $!; wait $!",
                                      directory.path());
    CHECK(interrupted.status == 130);
    CHECK(interrupted.out.empty());
    // CONTRACT.md, "Time": it keeps what it has.
    CHECK(names_in(directory / "out") == std::vector<std::string>{"trajectory.csv"});
    const std::string table = contents(directory / "out/trajectory.csv");
    const std::vector<std::string> lines = lines_of(table);
    REQUIRE(!lines.empty());
    CHECK(lines.back() == "# incomplete: interrupted");
    CHECK(table.back() == '\n');
    CHECK(numbers_of(lines.at(lines.size() - 2)).size() == 4);
}

TEST_CASE("whatever ends a run ends the compiler too, and leaves nothing") {
    for (const std::string signal : {"INT", "QUIT", "TERM", "HUP"}) {
        const PretendedCompiler compiler(right_answers, "sleep 100 & echo $! > \"$CHILD\"; wait");
        const Outcome outcome =
            compiler.run("export CHILD=\"$PWD/child\"; $run -o out & "
                         "while kill -0 $! && ! [ -s child ]; do sleep 0.1; done; kill -" +
                         signal + " $!; wait $!");
        INFO(signal << "\n" << outcome.err);
        CHECK(outcome.status == 130);
        CHECK(outcome.out.empty());
        CHECK(compiler.run("sleep 0.2; grep -E '^State:.[^ZX]' /proc/$(cat child)/status")
                  .out.empty());
        CHECK(std::filesystem::is_empty(compiler.directory / "cache/hvi-gen"));
        CHECK(std::filesystem::is_empty(compiler.directory / "temporary"));
        CHECK(!std::filesystem::exists(compiler.directory / "out"));
    }
}

TEST_CASE("a link where a table is to grow leads nowhere") {
    const PretendedCompiler compiler;
    const Outcome outcome =
        compiler.run("echo precious > victim; mkdir out; for end in '' -0 -1; do "
                     "ln -s ../victim out/.hvi-gen-$$$end.tmp; done; "
                     "exec \"$hvi_gen\" run henon-heiles --interpret --only table -o out "
                     "--method stormer-verlet --step 1/10 --until 1/10 --columns x");
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    CHECK(contents(compiler.directory / "victim") == "precious\n");
    CHECK(contents(compiler.directory / "out/trajectory.csv").find("t,x\n0,0\n0.1,") == 0);
}

TEST_CASE("directories of any name") {
    use_cache();
    const Directory directory;
    const std::string name = "a'b \"c\"\n; $d";
    const Outcome result =
        hvi_gen({"run", "pendulum", "--until", "1", "-o", name}, directory.path());
    INFO(result.err);
    CHECK(result.status == 0);
    CHECK(!contents(directory / (name + "/picture.svg")).empty());
}

TEST_CASE("runs that cannot be") {
    use_cache();
    CHECK(hvi_gen({"run", "kepler", "--columns", ""}).status == 2);
    const Outcome columns = hvi_gen({"run", "kepler", "--columns", "x, angular_momentu"});
    CHECK(columns.status == 2);
    CHECK(columns.out.empty());
    CHECK(columns.err == "error: there is no column `angular_momentu`\n"
                         "  --columns: x, angular_momentu\n"
                         "                ^~~~~~~~~~~~~~~\n"
                         "help: did you mean `angular_momentum`?\n");
    CHECK(hvi_gen({"run"}).status == 2);
    CHECK(hvi_gen({"run", "no-such-scene"}).status == 2);
    CHECK(hvi_gen({"run", "kepler", "--step", "w"}).status == 2);
    CHECK(hvi_gen({"run", "kepler", "--step", "0"}).status == 1);
    CHECK(hvi_gen({"run", "kepler", "--step", "-1/20"}).status == 1);
    CHECK(hvi_gen({"run", "kepler", "--param", "ecc=2"}).status == 1);
    CHECK(hvi_gen({"run", "kepler", "-o", "/dev/null/x"}).status == 3);
    CHECK(hvi_gen({"run", "--step", "kepler"}).status == 2);
    const Outcome fitted =
        hvi_gen({"run", "kepler", "--basis", "1, cos(w*tau), sin(w*tau)", "--nodes", "gauss:3"});
    CHECK(fitted.status == 2);
    CHECK(fitted.err.find("--param w=") != std::string::npos);
    CHECK(fitted.err.find("\n  --basis: 1, cos(w*tau), sin(w*tau)\n") != std::string::npos);
    CHECK(
        hvi_gen({"run", "--until", "1", "--step", "1/10", "--only", "summary", "kepler"}).status ==
        0);
}
