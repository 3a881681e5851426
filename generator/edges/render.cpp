// The edges as JSON and as a page.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "generator/edges/edges.hpp"
#include "generator/emit/embedded.hpp"
#include "generator/emit/text.hpp"
#include "generator/report/markup.hpp"

namespace hvi::gen {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const EdgeCheck& check) {
    return {{"method", check.method},     {"scene", check.scene}, {"case", check.what},
            {"expected", check.expected}, {"seen", check.seen},   {"agrees", check.agrees}};
}

Json json_of(const EdgeChapter& chapter) {
    Json checks = Json::array();
    for (const EdgeCheck& check : chapter.checks) checks.push_back(json_of(check));
    return {{"name", chapter.name}, {"about", chapter.about}, {"checks", std::move(checks)}};
}

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
    std::string text = "<div class=\"scroll\"><table>\n<tr>";
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

bool is_empty(const CurvesPicture& picture) {
    return std::all_of(picture.curves.begin(), picture.curves.end(),
                       [](const auto& curve) { return curve.points.empty(); });
}

std::string section(const EdgeChapter& chapter) {
    const std::ptrdiff_t wrong = disagreements(chapter);
    std::string text =
        fmt::format("<h2>{}</h2>\n<p>{}</p>\n<p>{} cases, {}.</p>\n", escaped(chapter.title),
                    escaped(chapter.about), chapter.checks.size(),
                    wrong == 0 ? "all as expected" : fmt::format("{} NOT as expected", wrong));
    for (const CurvesPicture& picture : chapter.pictures)
        if (!is_empty(picture)) text += inlined(draw(picture)) + "\n";
    return text + table(chapter);
}

std::string verdict(const EdgeReport& report) {
    std::ptrdiff_t wrong = 0;
    std::size_t all = 0;
    for (const EdgeChapter& chapter : report.chapters) {
        wrong += disagreements(chapter);
        all += chapter.checks.size();
    }
    return wrong == 0 ? fmt::format("<p>All of {} cases are as expected.</p>", all)
                      : fmt::format("<p class=\"incomplete\">{} of {} cases are not as "
                                    "expected.</p>",
                                    wrong, all);
}

}  // namespace

std::string edges_json(const EdgeReport& report) {
    Json json{{"schema", "hvi-edges/1"},
              {"machine",
               {{"processor", report.machine.processor},
                {"threads", report.machine.threads},
                {"system", report.machine.system}}},
              {"compiler", {{"command", report.compiler}, {"version", report.compiler_version}}}};
    json["chapters"] = Json::array();
    for (const EdgeChapter& chapter : report.chapters) json["chapters"].push_back(json_of(chapter));
    return json.dump(2) + "\n";
}

std::string edges_html(const EdgeReport& report) {
    std::string chapters;
    for (const EdgeChapter& chapter : report.chapters) chapters += section(chapter);
    return fill("edges.html.in",
                {{"style", std::string(embedded_template("report.css"))},
                 {"verdict", verdict(report)},
                 {"machine", escaped(fmt::format("{}, {} threads, {}", report.machine.processor,
                                                 report.machine.threads, report.machine.system))},
                 {"compiler", escaped(report.compiler_version + ": " + report.compiler)},
                 {"chapters", chapters}});
}

}  // namespace hvi::gen
