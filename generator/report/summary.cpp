// The summary and the contents of a report.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "generator/report/markup.hpp"
#include "generator/report/sections.hpp"
#include "generator/study/time_to_accuracy.hpp"

namespace hvi::gen {

namespace {

/// `a`, `a and b`, `a, b and c`.
std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return text;
}

std::vector<std::string> names_of_scenes(const Report& report) {
    std::vector<std::string> names;
    for (const SceneReport& scene : report.scenes) names.push_back(scene.name);
    return names;
}

/// How often a method is the fastest of ours, over scenes and errors.
struct Wins {
    std::string method;
    std::size_t count = 0;
};

/// From the most to the fewest wins.
std::vector<Wins> wins(const Report& report) {
    std::vector<Wins> result;
    for (const SceneReport& scene : report.scenes)
        for (const TimeToAccuracy& time : times_to_accuracies(scene)) {
            if (!time.own) continue;
            const auto found = std::find_if(result.begin(), result.end(), [&](const Wins& each) {
                return each.method == time.own->method;
            });
            if (found == result.end())
                result.push_back({time.own->method, 1});
            else
                ++found->count;
        }
    std::stable_sort(result.begin(), result.end(),
                     [](const Wins& a, const Wins& b) { return a.count > b.count; });
    return result;
}

std::size_t most_own_methods(const Report& report) {
    std::size_t most = 0;
    for (const SceneReport& scene : report.scenes)
        most = std::max(most, static_cast<std::size_t>(std::count_if(
                                  scene.curves.begin(), scene.curves.end(),
                                  [](const WorkCurve& curve) { return !curve.is_peer; })));
    return most;
}

std::string sentence_on_work(const Report& report) {
    const std::string scenes = listed(names_of_scenes(report));
    const std::vector<Wins> all = wins(report);
    const std::size_t methods = most_own_methods(report);
    if (all.empty()) return fmt::format("On {} no method reaches an error of 1e-4.", scenes);
    if (methods == 1)
        return fmt::format("{} was measured alone on {}.", all.front().method, scenes);
    if (all.size() == 1)
        return fmt::format("{} is the fastest of {} methods on {}, for each error that is reached.",
                           all.front().method, methods, scenes);
    std::size_t cases = 0;
    for (const Wins& each : all) cases += each.count;
    std::vector<std::string> parts;
    for (const Wins& each : all) parts.push_back(fmt::format("{} in {}", each.method, each.count));
    return fmt::format("Of {} methods on {}, the fastest to an error is {} of {} cases.", methods,
                       scenes, listed(parts), cases);
}

std::string sentence_on_noise(const Report& report) {
    std::size_t noisy = 0, timed = 0;
    for (const SceneReport& scene : report.scenes)
        for (const WorkCurve& curve : scene.curves)
            for (const WorkPoint& point : curve.points) {
                timed += point.seconds > 0 ? 1 : 0;
                noisy += point.is_noisy() ? 1 : 0;
            }
    if (noisy == 0) return "";
    return fmt::format(
        " {} of {} run times {} noisy: the middle half of their repetitions is wider "
        "than a quarter of the median. They have a ring in the pictures, and a word "
        "in the tables.",
        noisy, timed, noisy == 1 ? "is" : "are");
}

std::string sentence_on_edges(const Report& report) {
    std::size_t all = 0, wrong = 0;
    for (const EdgeChapter& chapter : report.edges)
        for (const EdgeCheck& check : chapter.checks) {
            ++all;
            wrong += check.agrees ? 0 : 1;
        }
    if (all == 0) return "";
    if (wrong == 0)
        return fmt::format("<p>At the edges, all of {} cases are as expected.</p>\n", all);
    return fmt::format("<p class=\"incomplete\">At the edges, {} of {} cases are not as expected."
                       "</p>\n",
                       wrong, all);
}

/// `4.9`, `31`: a number of two digits or more.
std::string ratio(double value) {
    return value < 9.95 ? fmt::format("{:.1f}", value) : fmt::format("{:.0f}", value);
}

/// `gauss:4, 0.19 ms`, and on a line of its own how much longer the next one takes.
std::string cell(const SceneReport& scene, double accuracy) {
    const std::vector<Quickest> all = in_order_of_time(scene, accuracy);
    const auto own =
        std::find_if(all.begin(), all.end(), [](const Quickest& each) { return !each.is_peer; });
    if (own == all.end()) return "<td>-</td>";
    const auto other = std::find_if(all.begin(), all.end(), [&](const Quickest& each) {
        return each.method != own->method || each.is_peer;
    });
    std::string text =
        fmt::format("<td><b>{}</b> {:.3g}&nbsp;ms", escaped(own->method), 1e3 * own->seconds);
    if (other != all.end())
        text += fmt::format("<br><small>{}: {} times as long</small>", escaped(other->method),
                            ratio(other->seconds / own->seconds));
    return text + "</td>";
}

std::string table_of_fastest(const Report& report) {
    if (report.scenes.empty()) return "";
    const auto times = times_to_accuracies(report.scenes.front());
    std::vector<std::string> heads{"scene"};
    for (const TimeToAccuracy& time : times)
        heads.push_back(escaped(fmt::format("error at most {:.0e}", time.accuracy)));
    std::string text =
        table_of("words", "The fastest method of each scene, and the next one", heads);
    for (std::size_t i = 0; i < report.scenes.size(); ++i) {
        const SceneReport& scene = report.scenes[i];
        text += fmt::format("<tr class=\"first\"><th><a href=\"#{}\">{}</a></th>", id_of_scene(i),
                            escaped(scene.name));
        for (const TimeToAccuracy& time : times) text += cell(scene, time.accuracy);
        text += "</tr>\n";
    }
    return text + end_of_table;
}

std::string link(const std::string& id, const std::string& text) {
    return fmt::format("<li><a href=\"#{}\">{}</a>", id, escaped(text));
}

template <class Parts, class Id, class Name>
std::string links(const Parts& parts, Id id, Name name) {
    std::string text = "\n<ul>\n";
    for (std::size_t i = 0; i < parts.size(); ++i) text += link(id(i), name(parts[i])) + "</li>\n";
    return text + "</ul>";
}

}  // namespace

std::string id_of_scene(std::size_t k) { return fmt::format("scene-{}", k + 1); }

std::string id_of_chapter(std::size_t k) { return fmt::format("edges-{}", k + 1); }

std::string report_title(const Report& report) {
    if (report.scenes.empty()) return "Symplectic integrators in stiff and extreme cases";
    return "Symplectic integrators on " + listed(names_of_scenes(report));
}

std::string summary_html(const Report& report) {
    std::string text = "<section id=\"summary\">\n<h2>Summary</h2>\n";
    if (!report.scenes.empty())
        text += "<p>" + escaped(sentence_on_work(report) + sentence_on_noise(report)) + "</p>\n";
    text += table_of_fastest(report) + sentence_on_edges(report);
    for (const std::string& note : report.notes)
        text += "<p class=\"note\">Note: " + escaped(note) + ".</p>\n";
    return text + "</section>\n";
}

std::string contents_html(const Report& report) {
    std::string text = "<nav aria-label=\"Contents\">\n<h2>Contents</h2>\n<ul>\n" +
                       link("summary", "Summary") + "</li>\n";
    if (!report.scenes.empty())
        text += link("work", "Error against run time") +
                links(report.scenes, id_of_scene, [](const auto& scene) { return scene.name; }) +
                "</li>\n";
    if (!report.edges.empty())
        text +=
            link("edges", "Stiff and extreme cases") +
            links(report.edges, id_of_chapter, [](const auto& chapter) { return chapter.title; }) +
            "</li>\n";
    return text + link("making", "How this was made") + "</li>\n</ul>\n</nav>\n";
}

}  // namespace hvi::gen
