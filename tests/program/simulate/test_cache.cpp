// Where compiled programs are kept: by whom they can be put there, and what becomes of damage.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "tests/program/simulate/pretended.hpp"

namespace fs = std::filesystem;

using namespace hvi::test;

namespace {

mode_t mode_of(const fs::path& path) {
    struct stat found {};
    REQUIRE(::lstat(path.c_str(), &found) == 0);
    return found.st_mode & 07777U;
}

/// The only entry of a cache.
fs::path entry_of(const fs::path& cache) {
    const auto names = names_in(cache);
    REQUIRE(names.size() == 1);
    return cache / names.front();
}

/// Checks that a program that was compiled for this run alone does it, and that a warning says so.
void is_refused(const PretendedCompiler& compiler, const std::string& line,
                const std::string& reason) {
    const std::size_t before = compiler.compilations();
    const auto temporary = names_in(compiler.directory / "temporary");
    const Outcome outcome = compiler.run(line);
    INFO(line << "\n" << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.out.find("steps") != std::string::npos);
    CHECK(compiler.compilations() == before + 1);
    CHECK(outcome.err.find("warning: compiled programs are not kept in ") == 0);
    CHECK(outcome.err.find(reason) != std::string::npos);
    CHECK(outcome.err.find("\nhelp: ") != std::string::npos);
    CHECK(names_in(compiler.directory / "temporary") == temporary);
}

void is_used(const PretendedCompiler& compiler, const std::string& line) {
    const std::size_t before = compiler.compilations();
    const Outcome outcome = compiler.run(line);
    INFO(line << "\n" << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK(compiler.compilations() == before);
}

}  // namespace

TEST_CASE("a cache is made for the user alone, whatever new files are for") {
    const PretendedCompiler compiler;
    REQUIRE(compiler.run("umask 0; $run").status == 0);
    CHECK(mode_of(compiler.directory / "cache") == 0700);
    CHECK(mode_of(compiler.directory / "cache/hvi-gen") == 0700);
    CHECK(mode_of(entry_of(compiler.directory / "cache/hvi-gen")) == 0700);
    is_used(compiler, "umask 0; $run");
    is_used(compiler, "$run");
    CHECK(names_in(compiler.directory / "temporary").empty());
}

TEST_CASE("no program is taken from where others could have put it") {
    const PretendedCompiler compiler;
    const fs::path above = compiler.directory / "cache", cache = above / "hvi-gen";
    REQUIRE(compiler.run("$run").status == 0);
    for (const mode_t mode : {0777U, 0770U, 0722U, 0720U, 0702U, 01777U, 02755U}) {
        ::chmod(cache.c_str(), mode);
        is_refused(compiler, "$run", "cache/hvi-gen: others may ");
    }
    ::chmod(cache.c_str(), 0700);
    for (const mode_t mode : {0777U, 0770U, 0775U, 0702U}) {
        ::chmod(above.c_str(), mode);
        is_refused(compiler, "$run", ": others may write to " + fs::canonical(above).string());
    }
    ::chmod(above.c_str(), 0700);
    is_used(compiler, "$run");
    ::chmod(above.c_str(), 01777);  // as /tmp
    is_used(compiler, "$run");
    fs::rename(cache, above / "elsewhere");
    fs::create_directory_symlink("elsewhere", cache);
    is_refused(compiler, "$run", "it is a symbolic link");
    fs::remove(cache);
    fs::create_directory_symlink("nowhere", cache);
    is_refused(compiler, "$run", "it is a symbolic link");
    fs::remove(cache);
    write(cache, "");
    is_refused(compiler, "$run", "it is no directory");
}

TEST_CASE("a link above the cache is no harm, but where it leads is looked at") {
    const PretendedCompiler compiler;
    fs::create_directories(compiler.directory / "open/cache");
    fs::create_directory_symlink("open/cache", compiler.directory / "cache");
    REQUIRE(compiler.run("$run").status == 0);
    is_used(compiler, "$run");
    ::chmod((compiler.directory / "open").c_str(), 0777);
    is_refused(compiler, "$run", "/open");
}

TEST_CASE("a cache that is refused twice is spoken of once") {
    const Directory directory;
    fs::create_directory(directory / "cache");
    fs::create_directory_symlink("elsewhere", directory / "cache/hvi-gen");
    // The search for a method compiles programs of its own.
    const Outcome outcome = shell("XDG_CACHE_HOME=\"$PWD/cache\" hvi-gen run harmonic-oscillator "
                                  "--accuracy 1e-3 --only summary",
                                  directory.path());
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    const std::string warning = "warning: compiled programs are not kept in ";
    CHECK(outcome.err.find(warning) == 0);
    CHECK(outcome.err.rfind(warning) == 0);
}

TEST_CASE("a cache that others could only read becomes private") {
    const PretendedCompiler compiler;
    const fs::path cache = compiler.directory / "cache/hvi-gen";
    REQUIRE(compiler.run("$run").status == 0);
    for (const mode_t mode : {0755U, 0711U, 0740U}) {
        ::chmod(cache.c_str(), mode);
        is_used(compiler, "$run");
        CHECK(mode_of(cache) == 0700);
    }
}

TEST_CASE("a cache of another user") {
    if (::geteuid() != 0) {
        WARN("only root can give directories away");
        return;
    }
    constexpr uid_t other = 12345;
    const PretendedCompiler compiler;
    const fs::path above = compiler.directory / "cache", cache = above / "hvi-gen";
    REQUIRE(compiler.run("$run").status == 0);
    const fs::path entry = entry_of(cache);
    // Others' programs in a directory that once was open to them.
    for (const fs::path& path : {entry, entry / "program"}) {
        REQUIRE(::chown(path.c_str(), other, 0) == 0);
        const Outcome outcome = compiler.run("$run");
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(outcome.err.find("warning: ") == 0);
        is_used(compiler, "$run");
    }
    REQUIRE(::chown(cache.c_str(), other, 0) == 0);
    is_refused(compiler, "$run", "it belongs to another user");
    REQUIRE(::chown(cache.c_str(), 0, 0) == 0);
    REQUIRE(::chown(above.c_str(), other, 0) == 0);
    is_refused(compiler, "$run", "cache belongs to another user");
    // Nor is anything made there.
    fs::remove_all(cache);
    is_refused(compiler, "$run", "cache belongs to another user");
    CHECK(fs::is_empty(above));
}

TEST_CASE("without a home, a name among the temporary files that anybody can guess") {
    const std::string line = "unset XDG_CACHE_HOME HOME; $run";
    const PretendedCompiler compiler;
    const fs::path cache =
        compiler.directory / ("temporary/hvi-gen-" + std::to_string(::geteuid()));
    for (const char* set_up : {"unset XDG_CACHE_HOME HOME; $run", "HOME=; XDG_CACHE_HOME=; $run",
                               "HOME=. XDG_CACHE_HOME=cache; $run"})
        REQUIRE(compiler.run(set_up).err.empty());
    CHECK(compiler.compilations() == 1);
    CHECK(mode_of(cache) == 0700);
    is_used(compiler, line);
    ::chmod(cache.c_str(), 0777);
    is_refused(compiler, line, "others may write to it");
    fs::rename(cache, compiler.directory / "planted");
    fs::create_directory_symlink(compiler.directory / "planted", cache);
    is_refused(compiler, line, "it is a symbolic link");
    // Where the new one could be replaced too there is none.
    ::chmod((compiler.directory / "temporary").c_str(), 0777);
    const Outcome unsafe = compiler.run(line);
    INFO(unsafe.err);
    CHECK(unsafe.status == 3);
    CHECK(unsafe.out.empty());
    CHECK(unsafe.err.find("error: compiled programs could be replaced by those of others: ") == 0);
    CHECK(unsafe.err.find("\nhelp: ") != std::string::npos);
}

TEST_CASE("directories that are not there: status 3") {
    for (const std::string& line : std::vector<std::string>{
             "unset XDG_CACHE_HOME; HOME= TMPDIR=\"$PWD/none\"",
             "unset XDG_CACHE_HOME HOME; TMPDIR=/dev/null", "XDG_CACHE_HOME=/dev/null",
             "unset XDG_CACHE_HOME; HOME=\"$PWD/scene.toml\"",
             "mkdir -m 777 cache; TMPDIR=\"$PWD/none\"", "XDG_CACHE_HOME=/proc",
             "XDG_CACHE_HOME=/$(printf '%0300d' 0)"}) {
        const PretendedCompiler compiler;
        const Outcome outcome = compiler.run(line + "; $run");
        INFO(line << "\n" << outcome.err);
        CHECK(outcome.status == 3);
        CHECK(outcome.out.empty());
        CHECK(outcome.err.find("error: ") == 0);
        CHECK(compiler.compilations() == 0);
        CHECK(fs::is_empty(compiler.directory / "temporary"));
    }
}

TEST_CASE("a damaged program is compiled again, once, and a word is said") {
    const PretendedCompiler compiler;
    REQUIRE(compiler.run("$run").status == 0);
    const fs::path entry = entry_of(compiler.directory / "cache/hvi-gen");
    const std::string good = contents(entry / "program");
    std::string flipped = good;
    flipped.back() ^= 1;
    for (const std::string damage :
         {": > program", "truncate -s -1 program", "chmod -x program", "rm program",
          "rm program; mkdir program", "rm program; ln -s ../../../other program",
          "rm program; mkfifo program", "cp ../../../flipped program", ": > key",
          "truncate -s 20 key", "echo >> key", "rm key", "rm key; mkdir key", "rm key; mkfifo key",
          "rm -r ../*/*", "e=$PWD; cd ..; rm -r $e; : > $e",
          "e=$PWD; cd ..; mv $e ../../moved; ln -s ../../moved $e", "chmod 0 program key"}) {
        if (damage == "chmod 0 program key" && ::geteuid() == 0) continue;
        write(compiler.directory / "flipped", flipped);
        write(compiler.directory / "other", good);
        const std::size_t before = compiler.compilations();
        const Outcome outcome = compiler.run("(cd cache/hvi-gen/*/ && " + damage + ") && $run");
        INFO(damage << "\n" << outcome.err);
        CHECK(outcome.status == 0);
        CHECK(compiler.compilations() == before + 1);
        CHECK(outcome.err.find("warning: ") == 0);
        CHECK(outcome.err.find(" is damaged, and compiled again\n") != std::string::npos);
        CHECK(names_in(compiler.directory / "cache/hvi-gen") ==
              std::vector<std::string>{entry.filename()});
        CHECK(contents(entry / "program") == good);
        is_used(compiler, "$run");
        fs::remove_all(compiler.directory / "moved");
    }
}

TEST_CASE("a compiler that makes no program") {
    for (const std::string compilation :
         {"exit 0", ": > program; exit 0", "mkdir program; exit 0"}) {
        const PretendedCompiler compiler(right_answers, compilation);
        for (int i = 0; i < 2; ++i) {
            const Outcome outcome = compiler.run("$run");
            INFO(compilation << "\n" << outcome.err);
            CHECK(outcome.status == 3);
            CHECK(outcome.err.find("error: the compiler has made no program\n") == 0);
            CHECK(fs::is_empty(compiler.directory / "cache/hvi-gen"));
        }
    }
}

TEST_CASE("many at a time, on nothing and on damage") {
    const PretendedCompiler compiler(right_answers, "sleep 0.2");
    const std::string all = "for i in 1 2 3 4 5 6; do $run & all=\"$all $!\"; done; "
                            "for each in $all; do wait $each || exit 1; done";
    REQUIRE(compiler.run(all).status == 0);
    const fs::path entry = entry_of(compiler.directory / "cache/hvi-gen");
    for (int i = 0; i < 3; ++i) {
        write(entry / "program", "damaged");
        const Outcome outcome = compiler.run(all);
        INFO(outcome.err);
        CHECK(outcome.status == 0);
        CHECK(entry_of(compiler.directory / "cache/hvi-gen") == entry);
        is_used(compiler, "$run");
    }
}
