// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/machine.hpp"

#include <sys/utsname.h>

#include <fstream>
#include <string_view>
#include <thread>

namespace hvi::gen {

namespace {

/// Reads the value behind the colon, where the line begins with the key.
bool read_value(const std::string& line, std::string_view key, std::string& value) {
    const std::size_t colon = line.find(':');
    if (!line.starts_with(key) || colon == std::string::npos || !value.empty()) return false;
    const std::size_t begin = line.find_first_not_of(' ', colon + 1);
    if (begin != std::string::npos) value = line.substr(begin);
    return true;
}

}  // namespace

Machine this_machine() {
    Machine machine;
    machine.threads = static_cast<int>(std::thread::hardware_concurrency());
    utsname names{};
    if (::uname(&names) == 0)
        machine.system = std::string(names.sysname) + " " + names.release + " " + names.machine;
    std::ifstream processors("/proc/cpuinfo");
    for (std::string line; std::getline(processors, line) && !line.empty();) {
        if (read_value(line, "model name", machine.processor)) continue;
        static_cast<void>(read_value(line, "flags", machine.extensions) ||
                          read_value(line, "Features", machine.extensions));
    }
    return machine;
}

}  // namespace hvi::gen
