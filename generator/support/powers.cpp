// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/powers.hpp"

#include <regex>

namespace hvi::gen {

namespace {

bool is_of_a_word(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
           c == '.';
}

}  // namespace

std::string with_powers(const std::string& text,
                        const std::function<std::string(const std::string&)>& plain,
                        const std::function<std::string(const PowerOfTen&)>& shown) {
    static const std::regex number(R"((\d+(?:\.\d+)?)e([+-]?\d{1,4})(?![0-9A-Za-z_]|\.\d))");
    std::string result;
    auto done = text.cbegin();
    for (std::sregex_iterator at(text.cbegin(), text.cend(), number), end; at != end; ++at) {
        const auto begin = (*at)[0].first;
        if (begin != text.cbegin() && is_of_a_word(*(begin - 1))) continue;
        const std::string factor = (*at)[1];
        result += plain(std::string(done, begin)) +
                  shown({factor == "1" ? "" : factor, std::stoi((*at)[2])});
        done = (*at)[0].second;
    }
    return result + plain(std::string(done, text.cend()));
}

}  // namespace hvi::gen
