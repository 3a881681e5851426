// A compiler that makes in no time a module which runs a script of shell, and answers as it is
// told.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "tests/program/cli/program.hpp"

namespace hvi::test {

/// Answers as a run does of a scene that keeps its energy.
inline const std::string right_answers =
    "printf '%s\\n' 'seconds_of_step 1e-7' 'status ok' 'steps 10' 't 1' 'rest 0' 'rows 11' "
    "'iterations 0' 'evaluations 10' 'start 0.5' 'largest 0' 'last 0' 'drift 0'";

/// A place with that compiler and a scene; the cache is in `cache`, and other files that are for
/// this time only in `temporary`.
class PretendedCompiler {
public:
    explicit PretendedCompiler(const std::string& program = right_answers,
                               const std::string& compilation = "") {
        write(directory / "cxx",
              "#!/bin/sh\n[ \"$1\" = --version ] && echo pretended 1.0 && exit 0\n"
              "echo >> '" +
                  (directory / "compilations").string() + "'\n" + compilation +
                  "\ncp '" HVI_PRETENDED_MODULE "' program\n");
        write(directory / "program.sh", program + "\n");
        std::filesystem::permissions(directory / "cxx", std::filesystem::perms::owner_all);
        write(directory / "scene.toml", "hamiltonian = \"(p^2 + q^2)/2\"\n"
                                        "coordinates = [\"q\"]\nmomenta = [\"p\"]\n"
                                        "initial = {q = 1, p = 0}\n"
                                        "run = {method = \"midpoint\", step = 0.1, until = 1}\n");
        std::filesystem::create_directory(directory / "temporary");
    }

    /// Runs the line, in which $run is the scene's run.
    [[nodiscard]] Outcome run(const std::string& line) const {
        return shell("export CXX=\"$PWD/cxx\" TMPDIR=\"$PWD/temporary\" "
                     "XDG_CACHE_HOME=\"$PWD/cache\" HVI_PRETENDED=\"$PWD/program.sh\"; "
                     "run=\"$hvi_gen run scene.toml --only summary\"; " +
                         line,
                     directory.path());
    }

    [[nodiscard]] std::size_t compilations() const {
        return lines_of(contents(directory / "compilations")).size();
    }

    const Directory directory;
};

}  // namespace hvi::test
