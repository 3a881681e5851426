// The edges in a page.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "generator/emit/text/embedded.hpp"
#include "generator/report/markup.hpp"
#include "generator/report/sections.hpp"

namespace hvi::gen {

namespace {

std::ptrdiff_t disagreements(const EdgeChapter& chapter) {
    return std::count_if(chapter.checks.begin(), chapter.checks.end(),
                         [](const EdgeCheck& check) { return !check.agrees; });
}

std::string row(const EdgeCheck& check) {
    std::string text = check.agrees ? "<tr>" : "<tr class=\"wrong\">";
    for (const std::string& cell :
         {check.what, check.expected, check.seen, std::string(check.agrees ? "yes" : "NO")})
        text += "<td>" + escaped(cell) + "</td>";
    return text + "</tr>\n";
}

std::string table(const EdgeChapter& chapter) {
    const std::vector<std::string> heads{"case", "expected", "seen", "agrees"};
    std::string text = table_of("words", "Cases: " + chapter.title, heads);
    const EdgeCheck* before = nullptr;
    for (const EdgeCheck& check : chapter.checks) {
        if (before == nullptr || before->method != check.method || before->scene != check.scene)
            text += group_row(check.method + " on " + check.scene, heads.size());
        text += row(check);
        before = &check;
    }
    return text + end_of_table;
}

std::string section(const EdgeChapter& chapter, const std::vector<Picture>& pictures,
                    const std::string& id) {
    const std::ptrdiff_t wrong = disagreements(chapter);
    std::string text =
        fmt::format("<h3 id=\"{}\">{}</h3>\n<p>{}</p>\n<p>{} cases, {}.</p>\n", id,
                    escaped(chapter.title), escaped(chapter.about), chapter.checks.size(),
                    wrong == 0 ? "all as expected" : fmt::format("{} NOT as expected", wrong));
    return text + pictures_html(pictures, id) + table(chapter);
}

}  // namespace

std::string edges_html(const Report& report, const Pictures& pictures) {
    if (report.edges.empty()) return "";
    std::string text(embedded_template("edges.html"));
    for (std::size_t i = 0; i < report.edges.size(); ++i)
        text += section(report.edges[i], pictures.of_edges[i], id_of_chapter(i));
    return text + "</section>\n";
}

}  // namespace hvi::gen
