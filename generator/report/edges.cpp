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
    std::string text = "<div class=\"scroll\"><table class=\"words\">\n<thead><tr>";
    for (const char* head : {"method", "scene", "case", "expected", "seen", "agrees"})
        text += fmt::format("<th>{}</th>", head);
    text += "</tr></thead>\n<tbody>\n";
    const EdgeCheck* before = nullptr;
    for (const EdgeCheck& check : chapter.checks) {
        text += row(check, before);
        before = &check;
    }
    return text + "</tbody></table></div>\n";
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
