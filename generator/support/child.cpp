// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/child.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <sstream>
#include <system_error>
#include <utility>

#include "generator/support/error.hpp"
#include "generator/support/process.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_errors = 64 * 1024;

[[noreturn]] void cannot(const std::string& what, int error) {
    throw EnvironmentError("cannot " + what + ": " + std::generic_category().message(error));
}

/// The two ends of a pipe.
class Pipe {
public:
    Pipe() {
        if (::pipe2(ends_.data(), O_CLOEXEC) != 0) cannot("make a pipe", errno);
    }
    ~Pipe() {
        close(0);
        close(1);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    [[nodiscard]] int reading() const { return ends_[0]; }
    [[nodiscard]] int writing() const { return ends_[1]; }
    void close_writing() { close(1); }

    /// Adds the readable bytes to the text. Returns false at the end of the pipe.
    [[nodiscard]] bool read_into(std::string& text) const {
        std::array<char, 4096> buffer;
        const ssize_t size = ::read(ends_[0], buffer.data(), buffer.size());
        if (size < 0) return errno == EINTR;
        text.append(buffer.data(), static_cast<std::size_t>(size));
        return size > 0;
    }

private:
    void close(std::size_t end) {
        if (ends_[end] >= 0) ::close(std::exchange(ends_[end], -1));
    }

    std::array<int, 2> ends_{-1, -1};
};

/// Returns the path of a program. NOTE: posix_spawnp() would take relative names in PATH, and empty
/// ones, from the program's future directory, where anybody may have put something.
fs::path in_path(const std::string& name) {
    if (name.find('/') != std::string::npos) return name;
    const char* path = std::getenv("PATH");
    std::istringstream directories(path == nullptr ? "/usr/local/bin:/bin:/usr/bin" : path);
    for (std::string directory; std::getline(directories, directory, ':');) {
        const fs::path file = fs::path(directory) / name;
        std::error_code ignored;
        if (file.is_absolute() && fs::is_regular_file(file, ignored) &&
            ::access(file.c_str(), X_OK) == 0)
            return file;
    }
    cannot("start " + name, ENOENT);
}

/// Settings of posix_spawn() for the new process.
class Setup {
public:
    Setup(const std::filesystem::path& directory, const Pipe& output, const Pipe& errors) {
        posix_spawn_file_actions_init(&actions_);
        posix_spawn_file_actions_addchdir_np(&actions_, directory.c_str());
        posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_adddup2(&actions_, output.writing(), STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions_, errors.writing(), STDERR_FILENO);
        posix_spawnattr_init(&attributes_);
        // NOTE: a group of its own, so that its children can be ended with it; signals as usual,
        // which threads of this program hold back.
        posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF |
                                                   POSIX_SPAWN_SETSIGMASK);
        sigset_t usual;
        sigemptyset(&usual);
        posix_spawnattr_setsigmask(&attributes_, &usual);
        for (const int signal : {SIGPIPE, SIGINT, SIGQUIT, SIGTERM}) sigaddset(&usual, signal);
        posix_spawnattr_setsigdefault(&attributes_, &usual);
    }
    ~Setup() {
        posix_spawnattr_destroy(&attributes_);
        posix_spawn_file_actions_destroy(&actions_);
    }
    Setup(const Setup&) = delete;
    Setup& operator=(const Setup&) = delete;

    [[nodiscard]] pid_t start(const std::vector<std::string>& words) const {
        const fs::path program = in_path(words.front());
        std::vector<char*> arguments;
        for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.data()));
        arguments.push_back(nullptr);
        pid_t child = 0;
        const int error = ::posix_spawn(&child, program.c_str(), &actions_, &attributes_,
                                        arguments.data(), environ);
        if (error != 0) cannot("start " + words.front(), error);
        return child;
    }

private:
    posix_spawn_file_actions_t actions_{};
    posix_spawnattr_t attributes_{};
};

/// A running process. The destructor ends it, with the processes that it has started, if nobody
/// waits for it.
class Running {
public:
    explicit Running(pid_t process) : process_(process) {}
    ~Running() {
        if (process_ == 0) return;
        ::kill(-process_, SIGKILL);
        static_cast<void>(wait());
    }
    Running(Running&& other) noexcept : process_(std::exchange(other.process_, 0)) {}
    Running& operator=(Running&&) = delete;

    [[nodiscard]] pid_t process() const { return process_; }

    [[nodiscard]] int wait() {
        const pid_t process = std::exchange(process_, 0);
        int status = 0;
        while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {}
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }

private:
    pid_t process_;
};

void hand_on_lines(std::string& text, const std::function<void(std::string_view)>& on_line) {
    if (!on_line) return;
    std::size_t begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
        on_line(std::string_view(text).substr(begin, end - begin));
    text.erase(0, begin);
}

std::atomic<pid_t> saves_itself = 0;  ///< the child that SIGUSR1 is handed on to

/// Hands SIGUSR1 on to a child as long as it lives.
class HandsOn {
public:
    explicit HandsOn(pid_t child) {
        if (child == 0) return;
        saves_itself.store(child);
        before_ = ::signal(SIGUSR1, [](int) {
            if (const pid_t process = saves_itself.load(); process != 0) ::kill(process, SIGUSR1);
        });
    }
    ~HandsOn() {
        saves_itself.store(0);
        if (before_ != SIG_ERR) ::signal(SIGUSR1, before_);
    }
    HandsOn(const HandsOn&) = delete;
    HandsOn& operator=(const HandsOn&) = delete;

private:
    void (*before_)(int) = SIG_ERR;
};

/// A running process, and what it has said so far.
struct Child {
    Running running;
    std::unique_ptr<Pipe> output, errors;
    ChildResult result = {};
};

/// Takes a line of the child with this number.
using OnLineOfChild = std::function<void(std::size_t, std::string_view)>;

/// Reads the output of children, and passes interruptions on to them.
class Listener {
public:
    Listener(std::vector<Child>& children, WhenInterrupted end) : children_(children), end_(end) {}

    /// Reads until all pipes are closed at their other end.
    void read_all(const OnLineOfChild& on_line) {
        std::vector<pollfd> wanted{{interruption_descriptor(), POLLIN, 0}};
        for (const Child& child : children_)
            for (const Pipe* pipe : {child.output.get(), child.errors.get()})
                wanted.push_back({pipe->reading(), POLLIN, 0});
        const auto is_open = [](const pollfd& each) { return each.fd >= 0; };
        while (std::any_of(wanted.begin() + 1, wanted.end(), is_open)) {
            const int ready = ::poll(wanted.data(), wanted.size(), milliseconds_);
            if (ready == 0) throw Interruption();  // they do not stop
            if (ready < 0) continue;               // a signal
            if (wanted.front().revents != 0) interrupt(wanted.front());
            for (std::size_t k = 0; k < children_.size(); ++k)
                read(k, wanted[1 + 2 * k], wanted[2 + 2 * k], on_line);
        }
    }

private:
    void read(std::size_t number, pollfd& output, pollfd& errors, const OnLineOfChild& on_line) {
        Child& child = children_[number];
        if (output.revents != 0) {
            if (!child.output->read_into(child.result.output)) output.fd = -1;
            if (on_line)
                hand_on_lines(child.result.output,
                              [&](std::string_view line) { on_line(number, line); });
        }
        if (errors.revents != 0) {
            if (!child.errors->read_into(child.result.errors)) errors.fd = -1;
            if (child.result.errors.size() > most_errors) child.result.errors.resize(most_errors);
        }
    }

    void interrupt(pollfd& wanted) {
        if (end_ == WhenInterrupted::it_is_ended) throw Interruption();
        constexpr int time_to_stop = 20'000;
        for (const Child& child : children_) ::kill(child.running.process(), SIGTERM);
        milliseconds_ = time_to_stop;
        wanted.fd = -1;
        wanted.revents = 0;
    }

    std::vector<Child>& children_;
    WhenInterrupted end_;
    int milliseconds_ = -1;
};

/// Returns the outputs of the children, and their ends.
std::vector<ChildResult> heard_out(std::vector<Child> children, const OnLineOfChild& on_line,
                                   WhenInterrupted end = WhenInterrupted::it_is_ended) {
    for (Child& child : children) {
        child.output->close_writing();
        child.errors->close_writing();
    }
    Listener(children, end).read_all(on_line);
    std::vector<ChildResult> results;
    for (Child& child : children) {
        child.result.status = child.running.wait();
        results.push_back(std::move(child.result));
    }
    return results;
}

OnLineOfChild of_any_child(const std::function<void(std::string_view)>& on_line) {
    if (!on_line) return nullptr;
    return [&on_line](std::size_t, std::string_view line) { on_line(line); };
}

/// Runs in a copy of this process: makes the settings of Setup, does the work, and exits.
[[noreturn]] void work_in_copy(const std::function<int()>& work, const Pipe& output,
                               const Pipe& errors) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // whose files another one may go on with
    for (const int signal : {SIGPIPE, SIGINT, SIGQUIT, SIGTERM}) ::signal(signal, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::dup2(output.writing(), STDOUT_FILENO);
    ::dup2(errors.writing(), STDERR_FILENO);
    constexpr int broken = 70;
    int status = broken;
    try {
        status = work();
    } catch (const std::exception& error) { std::fputs(error.what(), stderr); }
    std::fflush(nullptr);
    ::_exit(status);
}

/// Starts work in a copy of this process.
Child started(const std::function<int()>& work) {
    auto output = std::make_unique<Pipe>();
    auto errors = std::make_unique<Pipe>();
    std::fflush(nullptr);  // or the copy writes it once more
    const pid_t child = ::fork();
    if (child < 0) cannot("start another process", errno);
    if (child == 0) work_in_copy(work, *output, *errors);
    ::setpgid(child, child);  // whoever comes first
    return {Running(child), std::move(output), std::move(errors)};
}

}  // namespace

ChildResult run_child(const std::function<int()>& work,
                      const std::function<void(std::string_view)>& on_line, WhenInterrupted end) {
    std::vector<Child> child;
    child.push_back(started(work));
    const bool hands_on = end == WhenInterrupted::it_stops;
    const HandsOn signals(hands_on ? child.front().running.process() : 0);
    return heard_out(std::move(child), of_any_child(on_line), end).front();
}

std::vector<ChildResult>
run_children(std::size_t count, const std::function<int(std::size_t)>& work,
             const std::function<void(std::size_t, std::string_view)>& on_line) {
    std::vector<Child> children;
    for (std::size_t k = 0; k < count; ++k) children.push_back(started([&, k] { return work(k); }));
    return heard_out(std::move(children), on_line, WhenInterrupted::it_stops);
}

ChildResult run_child(const std::vector<std::string>& words, const std::filesystem::path& directory,
                      const std::function<void(std::string_view)>& on_line) {
    HVI_CHECK(!words.empty());
    auto output = std::make_unique<Pipe>();
    auto errors = std::make_unique<Pipe>();
    const pid_t process = Setup(directory, *output, *errors).start(words);
    std::vector<Child> child;
    child.push_back({Running(process), std::move(output), std::move(errors)});
    return heard_out(std::move(child), of_any_child(on_line)).front();
}

}  // namespace hvi::gen
