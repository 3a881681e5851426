// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/ensembles/claims.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr long seconds_between_touches = 20, seconds_until_stale = 300;

std::string host() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

/// Returns when a process began, in ticks of the system; empty where there is no such process, or
/// it has ended and nobody has asked how. NOTE: it tells a process from a later one with the same
/// number.
std::string start_of(const std::string& process) {
    std::ifstream file("/proc/" + process + "/stat");
    std::string text;
    std::getline(file, text);
    // NOTE: the second word is a name, which may contain anything.
    std::istringstream words(text.substr(std::min(text.rfind(')') + 2, text.size())));
    constexpr int before_start = 18;
    std::string state, word;
    words >> state;
    for (int k = 0; k <= before_start; ++k) words >> word;
    return words && state != "Z" && state != "X" ? word : "";
}

/// The words in a lock: its machine, process and the start of that.
std::string own_words() {
    const std::string process = std::to_string(::getpid());
    return fmt::format("{} {} {}\n", host(), process, start_of(process));
}

/// Whether the process that made a lock has died. Only its own machine knows.
bool has_died(const std::string& words) {
    std::istringstream text(words);
    std::string machine, process, start;
    text >> machine >> process >> start;
    return text && machine == host() && start_of(process) != start;
}

std::string contents(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Returns the time of a file's last touch by the clock of its file system; nothing where it is
/// gone.
std::optional<long> touched(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return {};
    return status.st_mtime;
}

/// Returns the path of a file of this process beside a lock.
fs::path beside(const fs::path& lock) {
    return fmt::format("{}.{}.{}", lock.string(), host(), ::getpid());
}

long seconds_here() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return static_cast<long>(std::chrono::duration_cast<std::chrono::seconds>(now).count());
}

/// Returns the time of a file that is made beside a lock now.
std::optional<long> now_beside(const fs::path& lock) {
    const fs::path probe = beside(lock);
    std::ofstream(probe) << "now";
    const std::optional<long> now = touched(probe);
    std::error_code ignored;
    fs::remove(probe, ignored);
    return now;
}

// ---- the touched lock ----

volatile std::sig_atomic_t touched_lock = -1;

void touch(int) {
    const int before = errno;
    if (touched_lock >= 0) ::futimens(touched_lock, nullptr);
    errno = before;
}

void touch_regularly() {
    struct sigaction action {};
    action.sa_handler = touch;
    action.sa_flags = SA_RESTART;
    ::sigaction(SIGALRM, &action, nullptr);
    const itimerval timer{{seconds_between_touches, 0}, {seconds_between_touches, 0}};
    ::setitimer(ITIMER_REAL, &timer, nullptr);
}

void touch_no_more() {
    const itimerval none{};
    ::setitimer(ITIMER_REAL, &none, nullptr);
    if (touched_lock >= 0) ::close(touched_lock);
    touched_lock = -1;
}

/// Returns a descriptor of a new lock with our words; -1 where there is one. NOTE: a link makes a
/// lock that has its words from the first moment on, and only where there is none.
int new_lock(const fs::path& path) {
    const fs::path own = beside(path);
    const int file = ::open(own.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    const std::string words = own_words();
    const bool is_written = file >= 0 && ::write(file, words.data(), words.size()) ==
                                             static_cast<ssize_t>(words.size());
    const bool is_ours = is_written && ::link(own.c_str(), path.c_str()) == 0;
    const int error = errno;
    ::unlink(own.c_str());
    if (is_ours) return file;
    if (file >= 0) ::close(file);
    // NOTE: whoever finishes the study removes what is left, our file too.
    if (is_written && (error == EEXIST || error == ENOENT)) return -1;
    throw EnvironmentError("cannot write " + path.string() + ": " +
                           std::generic_category().message(error));
}

/// Takes a lock away that counts no more. NOTE: of several workers that try only one moves it.
void take_away(const fs::path& lock) {
    const fs::path away = beside(lock);
    std::error_code ignored;
    fs::rename(lock, away, ignored);
    fs::remove(away, ignored);
}

}  // namespace

LockClaims::LockClaims(const Study& study)
    : study_(study),
      first_(static_cast<std::int64_t>(std::hash<std::string>()(own_words()) %
                                       static_cast<std::size_t>(study.chunks()))) {
    touch_regularly();
}

LockClaims::~LockClaims() {
    release();
    touch_no_more();
}

std::optional<std::int64_t> LockClaims::next() {
    release();
    while (looked_at_ < study_.chunks()) {
        const std::int64_t chunk = (first_ + looked_at_) % study_.chunks();
        ++looked_at_;
        if (!was_done(chunk) && !is_done(study_, chunk) && claim(chunk)) return chunk;
    }
    return {};
}

/// Whether a chunk was done when this worker came to its directory.
bool LockClaims::was_done(std::int64_t chunk) {
    const std::int64_t directory = chunk / Study::in_directory;
    if (listed_ != directory) {
        done_ = done_in(study_, directory);
        listed_ = directory;
    }
    return done_[static_cast<std::size_t>(chunk % Study::in_directory)];
}

/// Whether a lock was not touched for long. NOTE: clocks of machines differ, and that of the file
/// system is one. It is asked once, as that takes a new file.
bool LockClaims::is_old(const fs::path& lock) {
    const std::optional<long> then = touched(lock);
    if (!then) return false;
    if (!ahead_) {
        const std::optional<long> now = now_beside(lock);
        if (!now) return false;
        ahead_ = *now - seconds_here();
    }
    return seconds_here() + *ahead_ - *then > seconds_until_stale;
}

bool LockClaims::claim(std::int64_t chunk) {
    const fs::path path = study_.file(chunk, "lock");
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    // NOTE: a look changes no directory, as a lock that is made in vain would.
    int lock = touched(path) ? -1 : new_lock(path);
    if (lock < 0 && (has_died(contents(path)) || is_old(path))) {
        take_away(path);
        lock = new_lock(path);
    }
    if (lock < 0) return false;
    touched_lock = lock;
    claimed_ = chunk;
    if (!is_done(study_, chunk)) return true;
    release();  // another worker has just finished it
    return false;
}

void LockClaims::release() {
    if (!claimed_) return;
    const int lock = touched_lock;
    touched_lock = -1;
    ::close(lock);
    std::error_code ignored;
    fs::remove(study_.file(*claimed_, "lock"), ignored);
    claimed_.reset();
}

}  // namespace hvi::gen
