// A place for files.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace hvi::gen {

/// A directory that is gone at the end of the test.
struct Scratch {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() /
        ("hvi-read-" +
         std::to_string(std::filesystem::file_time_type::clock::now().time_since_epoch().count()));
    Scratch() { std::filesystem::create_directories(path); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { std::filesystem::remove_all(path); }
};

}  // namespace hvi::gen
