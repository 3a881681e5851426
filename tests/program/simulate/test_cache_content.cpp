// Compiled programs that are kept, and those that go.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "generator/program/cache_content.hpp"
#include "generator/program/directory_lock.hpp"
#include "tests/program/simulate/pretended.hpp"

namespace fs = std::filesystem;

using namespace hvi::test;

namespace {

using Names = std::vector<std::string>;

/// A program as an earlier run has left it, that was used so many hours ago; all of it is holes.
void add_entry(const fs::path& cache, const std::string& name, std::uintmax_t bytes, int hours) {
    fs::create_directories(cache / name);
    write(cache / name / "key", "key");
    write(cache / name / "program", "");
    fs::resize_file(cache / name / "program", bytes - 3);
    fs::last_write_time(cache / name / "key",
                        fs::file_time_type::clock::now() - std::chrono::hours(hours));
}

const std::string first_name(16, '0'), second_name(16, 'a'), third_name(16, '7');

}  // namespace

TEST_CASE("beyond the limit the least recently used programs go, and what is unfinished") {
    const Directory cache;
    add_entry(cache.path(), first_name, 1000, 2);
    add_entry(cache.path(), second_name, 2000, 3);
    add_entry(cache.path(), third_name, 500, 1);
    fs::create_directories(cache / "new-abcdef/of-ghijkl");
    fs::create_directories(cache / "another's");
    write(cache / "note", "of somebody");
    const hvi::gen::CacheContent content = hvi::gen::content_of(cache.path());
    CHECK(content.bytes() == 3500);
    REQUIRE(content.programs.size() == 3);
    CHECK(content.programs.front().directory == cache / second_name);
    CHECK(content.unfinished == std::vector<fs::path>{cache / "new-abcdef"});

    hvi::gen::tidy(cache.path(), 3500);
    CHECK(cache.names() == Names{first_name, third_name, second_name, "another's", "note"});
    hvi::gen::mark_used(cache / second_name);
    hvi::gen::tidy(cache.path(), 3499);
    CHECK(cache.names() == Names{third_name, second_name, "another's", "note"});
    hvi::gen::tidy(cache.path(), 0);
    CHECK(cache.names() == Names{"another's", "note"});
}

TEST_CASE("a run tidies up behind those that were killed, and keeps to the limit") {
    const PretendedCompiler compiler;
    const fs::path cache = compiler.directory / "cache/hvi-gen";
    const Outcome killed = compiler.run("exec 2> /dev/null; $run");
    CHECK(killed.status == 0);
    const Names mine = names_in(cache);
    REQUIRE(mine.size() == 1);
    CHECK(names_in(cache / mine.front()) == Names{"key", "program"});
    fs::create_directory(cache / "new-abcdef");
    add_entry(cache, first_name, 200'000'000, 2);
    add_entry(cache, second_name, 100'000'000, 1);
    const Outcome again = compiler.run("$run");
    CHECK(again.err.empty());
    CHECK(compiler.compilations() == 1);
    Names left{mine.front(), second_name};
    std::sort(left.begin(), left.end());
    CHECK(names_in(cache) == left);
}

TEST_CASE("a compiler that is killed with its run leaves something, for the next run to remove") {
    const PretendedCompiler compiler(
        right_answers, "[ -f ../../../../slow ] && touch ../../../../begun && sleep 3");
    const fs::path cache = compiler.directory / "cache/hvi-gen";
    const Outcome killed =
        compiler.run("touch slow; $run & while kill -0 $! && ! [ -f begun ]; do sleep 0.1; done; "
                     "kill -KILL $!; wait $!; rm slow");
    INFO(killed.err);
    REQUIRE(names_in(cache).size() == 1);
    CHECK(names_in(cache).front().starts_with("new-"));
    CHECK(compiler.run("$run").status == 0);
    REQUIRE(names_in(cache).size() == 1);
    CHECK(names_in(cache).front().size() == 16);
}

TEST_CASE("nothing is removed while another process uses the cache") {
    const PretendedCompiler compiler;
    const fs::path cache = compiler.directory / "cache/hvi-gen";
    REQUIRE(compiler.run("$run").status == 0);
    add_entry(cache, first_name, 300'000'000, 2);
    fs::create_directory(cache / "new-abcdef");
    const Names before = names_in(cache);
    {
        hvi::gen::DirectoryLock lock(cache);
        lock.share();
        CHECK(compiler.run("$run").status == 0);
        CHECK(names_in(cache) == before);
        const Outcome refused = compiler.run("$hvi_gen cache --clear");
        CHECK(refused.status == 3);
        CHECK(refused.err.find("error: another hvi-gen uses the programs in ") == 0);
        CHECK(names_in(cache) == before);
    }
    CHECK(compiler.run("$run").status == 0);
    CHECK(names_in(cache).size() == 1);
}

TEST_CASE("the cache is shown, and cleared") {
    const PretendedCompiler compiler;
    const fs::path cache = compiler.directory / "cache/hvi-gen";
    REQUIRE(compiler.run("$hvi_gen cache").status == 0);
    const auto shown = [&](const std::string& programs, const std::string& size) {
        return "directory  " + fs::canonical(cache).string() + "\nprograms   " + programs +
               "\nsize       " + size +
               ", of at most 256.0 MB: beyond, the least recently used go\n";
    };
    CHECK(compiler.run("$hvi_gen cache").out == shown("0", "0.0 MB"));
    add_entry(cache, first_name, 12'300'000, 2);
    add_entry(cache, second_name, 100'000, 1);
    CHECK(compiler.run("$hvi_gen cache").out == shown("2", "12.4 MB"));
    CHECK(compiler.run("$hvi_gen cache --clear").out == "2 programs removed, 12.4 MB\n");
    CHECK(fs::is_empty(cache));
    CHECK(compiler.run("$hvi_gen cache --clear").out == "0 programs removed, 0.0 MB\n");
    CHECK(compiler.run("$hvi_gen cache --clean").status == 2);
    CHECK(compiler.run("$hvi_gen cache everything").status == 2);
}
