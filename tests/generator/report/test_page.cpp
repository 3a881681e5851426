// The page of a report, from measurements that are made up.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/report/render.hpp"

using namespace hvi::gen;

namespace {

WorkPoint point(double error, double seconds, double spread) {
    WorkPoint result;
    result.h = error;
    result.steps = 10;
    result.error = error;
    result.seconds = seconds;
    result.spread = spread;
    result.evaluations = 10;
    result.status = "ok";
    return result;
}

/// A method that is `faster` times as fast as another, to errors down to 1e-12.
WorkCurve curve(const std::string& name, double seconds, double spread = 0.01) {
    return {name,
            2,
            false,
            {point(1e-2, seconds, spread), point(1e-6, 10 * seconds, 0.01),
             point(1e-12, 100 * seconds, 0.25)},
            {0.1, {1, 2}, {1e-3, 2e-3}, {}, {2e-3}}};
}

Report made_up() {
    Report report{{"a processor", "", 1, "a system"}, "c++ -O3", "c++ 1"};
    report.scenes.push_back(
        {"ring", "a ring", 10, {"exact", 0, {}}, {curve("slow", 0.3), curve("quick", 0.1)}});
    report.scenes.push_back({"<b>&",
                             "\"x\"",
                             10,
                             {"gauss:10", 3e-20, {}},
                             {curve("slow", 0.3, 0.26), curve("quick", 0.1)}});
    report.edges.push_back(
        {"stiff", "Stiff <i>", "About.", {{"quick", "ring", "h = 1e300", "a<b", "a<b", true}}, {}});
    return report;
}

std::string page_of(const Report& report) { return report_html(report, report_pictures(report)); }

std::vector<std::string> all_of(const std::string& text, const std::string& pattern) {
    const std::regex expression(pattern);
    std::vector<std::string> found;
    for (std::sregex_iterator at(text.begin(), text.end(), expression), end; at != end; ++at)
        found.push_back((*at)[1]);
    return found;
}

std::set<std::string> set_of(const std::vector<std::string>& all) {
    return {all.begin(), all.end()};
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a report begins with what is fastest where") {
    const std::string page = page_of(made_up());
    const std::size_t summary = page.find("<h2>Summary</h2>"), contents = page.find("<h2>Contents");
    REQUIRE(summary < contents);
    CHECK(page.find("<svg") > contents);
    const std::string text = page.substr(summary, contents - summary);
    CHECK(
        has(text, "quick is the fastest of 2 methods on ring and &lt;b&gt;&amp;, for each error"));
    CHECK(has(text, "<a href=\"#scene-1\">ring</a>"));
    // In between two errors by the straight line of the logarithms: 1e-4 is half-way from 1e-2 to
    // 1e-6, 1e-8 a third of the way from there to 1e-12. NOTE: ms.
    CHECK(has(text, "<b>quick</b> 316&nbsp;ms<br><small>slow: 3.0 times as long</small>"));
    CHECK(has(text, "<b>quick</b> 2.15e+03&nbsp;ms"));
    CHECK(has(text, "At the edges, all of 1 cases are as expected."));
}

TEST_CASE("a summary of methods that win here and there") {
    Report report = made_up();
    report.scenes[1].curves[0] = curve("slow", 0.01);
    const std::string page = page_of(report);
    CHECK(has(page,
              "Of 2 methods on ring and &lt;b&gt;&amp;, the fastest to an error is quick in 3 "
              "and slow in 3 of 6 cases."));
    report.scenes.pop_back();
    report.scenes[0].curves.pop_back();
    CHECK(has(page_of(report), "slow was measured alone on ring."));
    report.scenes[0].curves[0].points.resize(1);
    CHECK(has(page_of(report), "On ring no method reaches an error of"));
    report.edges[0].checks[0].agrees = false;
    CHECK(has(page_of(report), "At the edges, 1 of 1 cases are not as expected."));
}

TEST_CASE("departures over time are the largest of each hundredth of a run") {
    Report report = made_up();
    WorkCurve swinging = curve("quick", 0.1);
    swinging.departures = {0.1, {}, {}, {}, {}};
    for (int k = 1; k <= 1000; ++k) {
        swinging.departures.times.push_back(k);
        swinging.departures.energy.push_back(k == 505 ? 1e-6 : k % 10 == 5 ? 1e-3 : 1e-9);
    }
    report.scenes[0].curves = {swinging};
    const std::vector<Picture> pictures = report_pictures(report).of_scenes[0];
    REQUIRE(pictures[2].name == "ring-3-energy");
    // One path, which ends with a curve of 100 points. They are as high as each other but for one.
    std::vector<std::string> curves;
    for (const std::string& path : all_of(pictures[2].svg, "d='(M[^']*)'"))
        if (all_of(path, "(,)").size() > 50) curves.push_back(path);
    REQUIRE(curves.size() == 1);
    const std::string drawn = curves[0].substr(curves[0].rfind('M'));
    const std::vector<std::string> heights = all_of(drawn, ",([0-9.]+)");
    REQUIRE(heights.size() == 100);
    CHECK(std::count(heights.begin(), heights.end(), heights[0]) == 99);
    CHECK(heights[50] != heights[0]);
}

TEST_CASE("a report has pictures of more methods than fit in one argument of gnuplot") {
    Report report = made_up();
    report.scenes[0].curves.clear();
    for (int k = 0; k < 100; ++k) {
        WorkCurve method = curve("method-" + std::to_string(k), 0.1);
        for (int i = 3; i <= 500; ++i) {
            method.departures.times.push_back(i + 1.0 / 3);
            method.departures.energy.push_back(1e-3 / i);
        }
        report.scenes[0].curves.push_back(method);
    }
    const std::string svg = report_pictures(report).of_scenes[0][2].svg;
    CHECK(has(svg, ">method-0, h = 0.1<"));
    CHECK(has(svg, ">method-99, h = 0.1<"));
}

TEST_CASE("links of a report lead somewhere, and titles differ") {
    const std::string page = page_of(made_up());
    const auto ids = all_of(page, R"([ ]id=["']([^"']*)["'])");
    const auto targets = all_of(page, R"(href=["']#([^"']*)["'])");
    CHECK(set_of(ids).size() == ids.size());
    for (const std::string& target : targets) {
        INFO(target);
        CHECK(set_of(ids).count(target) == 1);
    }
    const std::string contents =
        page.substr(page.find("<nav"), page.find("</nav>") - page.find("<nav"));
    const std::vector<std::string> linked{"summary", "work",    "scene-1", "scene-2",
                                          "edges",   "edges-1", "making"};
    CHECK(all_of(contents, "href=\"#([^\"]*)\"") == linked);

    const Pictures pictures = report_pictures(made_up());
    std::vector<std::string> titles;
    for (const auto& of_scene : pictures.of_scenes)
        for (const Picture& picture : of_scene) titles.push_back(picture.title);
    CHECK(titles.size() == 6);
    CHECK(set_of(titles).size() == titles.size());
    for (const std::string title : {"ring: error against run time",
                                    "ring: error against evaluations", "ring: energy over time"}) {
        CHECK(set_of(titles).count(title) == 1);
        CHECK(has(page, "<title>" + title + "</title>"));
    }
    CHECK_FALSE(has(page, "Gnuplot</title>"));
}

TEST_CASE("a report stands alone, is for narrow screens too, and has texts as they are") {
    const std::string page = page_of(made_up());
    CHECK(has(page, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"));
    for (const char* outside : {"<script", "src=", "<link", "url(http", "@import"})
        CHECK_FALSE(has(page, outside));
    CHECK_FALSE(has(page, "<b>&</"));
    CHECK_FALSE(has(page, "Stiff <i>"));
    CHECK(has(page, "<title>Symplectic integrators on ring and &lt;b&gt;&amp;</title>"));
    CHECK(has(page, "h = <span class=\"power\">10<sup>300</sup></span>"));
    CHECK(has(page, "<span class=\"power\">3.0&times;10<sup>-20</sup></span>"));
    CHECK(page == page_of(made_up()));
}

TEST_CASE("noisy run times are marked, in pictures and tables") {
    const Report report = made_up();
    const std::string page = page_of(report);
    // A spread of 0.26 is one, of 0.25 none.
    CHECK(has(page, "1 of 12 run times is noisy"));
    CHECK(all_of(page, "(<tr class=\"noisy\">)").size() == 1);
    CHECK(has(page, "<td>26&nbsp;% noisy</td>"));
    CHECK(has(page, "<td>25&nbsp;%</td>"));
    const Pictures pictures = report_pictures(report);
    CHECK_FALSE(has(pictures.of_scenes[0][0].svg, "noisy run time"));
    CHECK(has(pictures.of_scenes[1][0].svg, "noisy run time"));
    CHECK_FALSE(has(pictures.of_scenes[1][1].svg, "noisy run time"));
}

TEST_CASE("runs that were taken once have no spread, and a status is told where one is not ok") {
    Report report = made_up();
    CHECK_FALSE(has(page_of(report), "<th>status</th>"));
    report.scenes[0].curves[0].points[0].status = "overflow";
    report.scenes[0].curves[0].points[0].spread = std::nan("");
    const std::string page = page_of(report);
    CHECK(has(page, "<th>status</th>"));
    CHECK(has(page, "<td>overflow</td>"));
    CHECK_FALSE(has(page, "nan"));
}
