// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/report/markup.hpp"

#include <fmt/format.h>

#include <cmath>

#include "generator/support/powers.hpp"

namespace hvi::gen {

namespace {

std::string power_markup(const PowerOfTen& number) {
    if (number.exponent == 0) return number.factor.empty() ? "1" : number.factor;
    return fmt::format("<span class=\"power\">{}10<sup>{}</sup></span>",
                       number.factor.empty() ? "" : number.factor + "&times;", number.exponent);
}

/// A tag in which `prefix` stands before each id, and before each that is referred to.
std::string with_ids(std::string tag, const std::string& prefix) {
    for (const std::string before :
         {" id='", " id=\"", "href='#", "href=\"#", "url(#", "url('#", "url(\"#"}) {
        for (std::size_t at = tag.find(before); at != std::string::npos;
             at = tag.find(before, at + before.size()))
            tag.insert(at + before.size(), prefix);
    }
    return tag;
}

}  // namespace

std::string attribute(const std::string& text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&': result += "&amp;"; break;
        case '<': result += "&lt;"; break;
        case '>': result += "&gt;"; break;
        case '"': result += "&quot;"; break;
        default: result += c;
        }
    }
    return result;
}

std::string escaped(const std::string& text) { return with_powers(text, attribute, power_markup); }

std::string number_markup(double value) {
    return std::isfinite(value) ? escaped(fmt::format("{:.2e}", value)) : "-";
}

std::string table_of(const std::string& kind, const std::string& caption,
                     const std::vector<std::string>& heads) {
    std::string text = fmt::format("<div class=\"scroll\"><table class=\"{}\">\n<caption>"
                                   "<span>{}</span></caption>\n<thead><tr>",
                                   kind, escaped(caption));
    for (const std::string& head : heads) text += "<th>" + head + "</th>";
    return text + "</tr></thead>\n<tbody>\n";
}

std::string group_row(const std::string& text, std::size_t columns) {
    return fmt::format(
        "<tr class=\"first\"><th colspan=\"{}\" scope=\"rowgroup\"><span>{}</span></th></tr>\n",
        columns, escaped(text));
}

std::string inlined(const std::string& svg, const std::string& title, const std::string& prefix) {
    const std::string own_title = "<title>Gnuplot</title>";
    std::string result;
    std::size_t done = svg.find("<svg");
    if (done == std::string::npos) return "";
    // NOTE: gnuplot escapes < in texts, so that each one begins a tag.
    for (std::size_t at = done; at != std::string::npos; at = svg.find('<', done)) {
        result += svg.substr(done, at - done);
        const std::size_t end = svg.find('>', at);
        done = end == std::string::npos ? svg.size() : end + 1;
        result += with_ids(svg.substr(at, done - at), prefix);
    }
    result += svg.substr(done);
    const std::size_t at = result.find(own_title);
    if (at != std::string::npos)
        result.replace(at, own_title.size(), "<title>" + attribute(title) + "</title>");
    return result;
}

}  // namespace hvi::gen
