// Rows of studies as threads of a GPU, which here are turns of a loop of the host.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/studies/study_run.hpp"

using namespace hvi::test;

namespace {

/// The compiler of CUDA, while this lives.
class NamedNvcc {
public:
    explicit NamedNvcc(const std::string& path) {
        if (const char* const before = std::getenv("NVCC")) before_ = before;
        ::setenv("NVCC", path.c_str(), 1);
    }
    NamedNvcc(const NamedNvcc&) = delete;
    NamedNvcc& operator=(const NamedNvcc&) = delete;
    ~NamedNvcc() {
        if (before_)
            ::setenv("NVCC", before_->c_str(), 1);
        else
            ::unsetenv("NVCC");
    }

private:
    std::optional<std::string> before_;
};

const std::string stars_on_cards =
    "hamiltonian = \"(px^2 + py^2)/2 + (x^2 + y^2)/2 + k*(x^2*y - y^3/3)\"\n"
    "coordinates = [\"x\", \"y\"]\nmomenta = [\"px\", \"py\"]\nparameters = {k = 1}\n"
    "initial = {x = 0, y = \"1/10\", px = \"2/5\", py = 0}\n"
    "run = {method = \"stormer-verlet\", step = \"1/10\", until = 20}\n";

}  // namespace

TEST_CASE("rows of a GPU are those of a processor, up to rounding") {
    const NamedNvcc nvcc(HVI_PRETENDED_NVCC);
    const std::string words =
        "--vary k=1/2:1:7 --vary until=5:20:3 --vary step=1/10:1/5:2 --columns energy";
    for (const std::string method : {"stormer-verlet", "gauss:2"}) {
        const TextTable device = study_of(stars_on_cards, words + " --cuda --method " + method),
                        alone =
                            study_of(stars_on_cards, words + " --lanes none --method " + method);
        REQUIRE(device.names == alone.names);
        REQUIRE(device.rows.size() == alone.rows.size());
        for (std::size_t row = 0; row < alone.rows.size(); ++row) {
            CAPTURE(method, row);
            for (const std::string word : {"row", "k", "t", "status", "steps"})
                CHECK(device.at(row, word) == alone.at(row, word));
            for (const std::string column : {"x", "y", "px", "py", "energy_error", "energy"}) {
                CAPTURE(column);
                CHECK(std::abs(device.number(row, column) - alone.number(row, column)) < 1e-12);
            }
        }
    }
}

TEST_CASE("rows of a GPU do not depend on chunks and workers, and fail one by one") {
    const NamedNvcc nvcc(HVI_PRETENDED_NVCC);
    const std::string words = "--vary y=1/10:601/10:13 --cuda";
    const TextTable rows = study_of(stars_on_cards, words),
                    parted = study_of(stars_on_cards, words + " --chunk 2 --workers 2");
    CHECK(rows.rows == parted.rows);
    for (std::size_t row = 0; row < 13; ++row) {
        CAPTURE(row);
        const bool is_bound = row == 0;  // the others are above the saddle, and leave for ever
        CHECK(rows.at(row, "status") == (is_bound ? "ok" : "not_finite"));
    }
}

TEST_CASE("what no GPU takes is refused, and so is a machine without a compiler of CUDA") {
    const auto check = [](const std::string& scene, const std::string& words, int status,
                          const std::string& message) {
        const Directory directory;
        write(directory / "scene.toml", scene);
        const Outcome outcome = study_in(directory, "eval \"$study --cuda " + words + "\"");
        CAPTURE(words, outcome.err);
        CHECK(outcome.status == status);
        CHECK(outcome.err.find(message) != std::string::npos);
    };
    check(stars_on_cards + "[events.up]\nzero = \"y\"\n", "--vary k=0:1:2", 2,
          "--cuda is not built for events");
    check(stars_on_cards + "[time]\nscale = \"1/(1 + x^2)\"\n", "--vary k=0:1:2 --method gauss:2",
          2, "--cuda");
    check(stars_on_cards, "--vary k=0:1:2 --method gauss:2 --solver newton", 2, "--lanes gpu");
    check("hamiltonian = \"sum(i=1..9, p[i]^2/2) + sum(i=1..8, k*(q[i+1] - q[i])^2/2)\"\n"
          "coordinates = [\"q[1..9]\"]\nmomenta = [\"p[1..9]\"]\nparameters = {k = 1}\n"
          "initial = {\"q[i]\" = \"i\", \"p[i]\" = 0}\n"
          "run = {method = \"stormer-verlet\", step = \"1/10\", until = 5}\n",
          "--vary k=1:2:2 --unroll no", 2, "--cuda is not built where sums stay loops");
    const NamedNvcc nvcc("/there/is/no/nvcc");
    check(stars_on_cards, "--vary k=0:1:2", 3,
          "there is no compiler of CUDA: `/there/is/no/nvcc --version` fails");
}
