// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/module/python_package.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "generator/emit/text/text.hpp"
#include "generator/module/embedded.hpp"
#include "generator/module/stepper_part.hpp"

namespace hvi::gen {

namespace {

/// Returns a string of Python with this text.
std::string python_text(const std::string& text) {
    std::string result = "\"";
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '"' || letter == '\\') {
            result += '\\';
            result += letter;
        } else if (code < 0x20 || code == 0x7f) {
            result += fmt::format("\\x{:02x}", code);
        } else {
            result += letter;
        }
    }
    return result + '"';
}

std::string python_number(const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "None";
}

/// Returns entries of a dictionary: sizes and numbers with their defaults.
std::string python_numbers(const System& system) {
    std::vector<std::string> names;
    if (has_sizes(system)) {
        for (const SystemSize& size : system.sizes) { names.push_back(size.name); }
    }
    for (const SystemParameter& each : system.parameters) { names.push_back(each.name); }
    const std::vector<double> values = values_of_numbers(system);
    Writer writer(2);
    for (std::size_t k = 0; k < names.size(); ++k) {
        writer.line("{}: {},", python_text(names[k]), python_number(values[k]));
    }
    return writer.str();
}

std::string python_formulas(const std::vector<ComputedParameter>& computed) {
    Writer writer(2);
    for (const ComputedParameter& each : computed) {
        writer.line("{}: {},", python_text(each.name), python_text(each.formula));
    }
    return writer.str();
}

std::string python_lists(const System& system) {
    Writer writer(2);
    for (const SystemTable& table : system.tables) {
        writer.line("{},", python_text(table.family.name));
    }
    return writer.str();
}

/// Returns the directory of the scene, from which its files are found; empty where it reads none.
std::string directory(const System& system) {
    if (!system.reads_files()) { return ""; }
    return std::filesystem::absolute("." / system.directory).lexically_normal().string();
}

}  // namespace

std::string package_library(const std::string& name) { return "lib" + name + ".so"; }

std::vector<PackageFile> python_package(const SceneStepper& stepper, const std::string& name,
                                        const std::string& command, const PackageScene& scene) {
    const System& system = stepper.system;
    std::vector<PackageFile> files = {
        {"__init__.py", fill("package.py.in", {{"command", python_text(command)},
                                               {"name", python_text(name)},
                                               {"scene", python_text(system.name)},
                                               {"description", python_text(system.description)},
                                               {"method", python_text(stepper.method.title())},
                                               {"library", python_text(package_library(name))},
                                               {"numbers", python_numbers(system)},
                                               {"formulas", python_formulas(scene.computed)},
                                               {"lists", python_lists(system)},
                                               {"directory", python_text(directory(system))},
                                               {"has_time", system.time ? "True" : "False"},
                                               {"step", python_number(scene.step)},
                                               {"until", python_number(scene.until)}})},
        {"py.typed", ""}};
    for (const EmbeddedFile& file : embedded_python()) {
        files.push_back({std::string(file.name), std::string(file.text)});
    }
    return files;
}

}  // namespace hvi::gen
