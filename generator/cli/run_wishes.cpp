// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/run_wishes.hpp"

#include <fmt/format.h>

#include <memory>
#include <system_error>

#include "generator/support/error.hpp"

namespace hvi::gen {

NamedExpression wish(const SceneTimes& times, const Given& given,
                     const std::optional<NamedExpression>& of_scene, const std::string& name,
                     const std::string& option) {
    if (given) return expression_of_parameters(times, name, given);
    if (of_scene) return *of_scene;
    throw InputError(fmt::format("the scene does not say `{}`", name), times.place,
                     fmt::format("give {}, or a section [run] with {} = \"1/10\"",
                                 option.empty() ? fmt::format("--{} 1/10", name) : option, name));
}

std::string duration(double seconds) {
    if (seconds < 1e-6) return fmt::format("{:.3g} ns", seconds * 1e9);
    if (seconds < 1e-3) return fmt::format("{:.3g} us", seconds * 1e6);
    if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
    return fmt::format("{:.3g} s", seconds);
}

std::string sweeps_text(int sweeps) {
    return fmt::format("explicit: exactly {} sweep{}; symplectic up to the last change alone",
                       sweeps, sweeps == 1 ? "" : "s");
}

void make_directory(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error)
        throw EnvironmentError("cannot make the directory " + path.string() + ": " +
                               error.message());
}

}  // namespace hvi::gen
