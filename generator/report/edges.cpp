// The edges in a page.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "generator/emit/text/embedded.hpp"
#include "generator/report/markup.hpp"
#include "generator/report/render.hpp"

namespace hvi::gen {

namespace {

std::ptrdiff_t disagreements(const EdgeChapter& chapter) {
    return std::count_if(chapter.checks.begin(), chapter.checks.end(),
                         [](const EdgeCheck& check) { return !check.agrees; });
}

std::string row(const EdgeCheck& check, const EdgeCheck* before) {
    const bool is_first = before == nullptr || before->method != check.method;
    const bool same_scene = !is_first && before->scene == check.scene;
    std::string text = is_first ? "<tr class=\"first\">" : "<tr>";
    for (const std::string& cell :
         {is_first ? check.method : "", same_scene ? "" : check.scene, check.what, check.expected,
          check.seen, std::string(check.agrees ? "yes" : "NO")})
        text += "<td>" + escaped(cell) + "</td>";
    return text + "</tr>\n";
}

std::string table(const EdgeChapter& chapter) {
    std::string text = "<div class=\"scroll words\"><table>\n<tr>";
    for (const char* head : {"method", "scene", "case", "expected", "seen", "agrees"})
        text += fmt::format("<th>{}</th>", head);
    text += "</tr>\n";
    const EdgeCheck* before = nullptr;
    for (const EdgeCheck& check : chapter.checks) {
        text += row(check, before);
        before = &check;
    }
    return text + "</table></div>\n";
}

std::string section(const EdgeChapter& chapter, const std::vector<Picture>& pictures) {
    const std::ptrdiff_t wrong = disagreements(chapter);
    std::string text =
        fmt::format("<h3>{}</h3>\n<p>{}</p>\n<p>{} cases, {}.</p>\n", escaped(chapter.title),
                    escaped(chapter.about), chapter.checks.size(),
                    wrong == 0 ? "all as expected" : fmt::format("{} NOT as expected", wrong));
    for (const Picture& picture : pictures) text += inlined(picture.svg) + "\n";
    return text + table(chapter);
}

std::string verdict(const Report& report) {
    std::ptrdiff_t wrong = 0;
    std::size_t all = 0;
    for (const EdgeChapter& chapter : report.edges) {
        wrong += disagreements(chapter);
        all += chapter.checks.size();
    }
    return wrong == 0 ? fmt::format("<p>All of {} cases are as expected.</p>", all)
                      : fmt::format("<p class=\"incomplete\">{} of {} cases are not as "
                                    "expected.</p>",
                                    wrong, all);
}

}  // namespace

std::string edges_html(const Report& report, const Pictures& pictures) {
    if (report.edges.empty()) return "";
    std::string text = std::string(embedded_template("edges.html")) + verdict(report) + "\n";
    for (std::size_t i = 0; i < report.edges.size(); ++i)
        text += section(report.edges[i], pictures.of_edges[i]);
    return text;
}

}  // namespace hvi::gen
