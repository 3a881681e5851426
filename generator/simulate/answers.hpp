// What a driver has said: see src/driver/answer.hpp.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hvi::gen {

/// Keys with their values in the order in which they were said. What is asked for and was not said,
/// or is no number, is a broken invariant.
class Answers {
public:
    void hear(std::string_view line);

    [[nodiscard]] bool has(const std::string& key) const { return values_.count(key) != 0; }
    [[nodiscard]] const std::string& text(const std::string& key) const;
    [[nodiscard]] std::int64_t integer(const std::string& key) const;
    [[nodiscard]] double number(const std::string& key) const;
    [[nodiscard]] std::vector<double> numbers(const std::string& key) const;  ///< none is fine

private:
    std::map<std::string, std::vector<std::string>> values_;
};

/// Calls a compiled driver with these words and hears it out; `on_progress` gets the part that is
/// done as often as the driver says. Throws EnvironmentError where it was ended by a signal, or
/// could not write `file`, and Interruption.
[[nodiscard]] Answers ask(const std::filesystem::path& program, std::vector<std::string> words,
                          const std::filesystem::path& file = {},
                          const std::function<void(double)>& on_progress = nullptr);

}  // namespace hvi::gen
