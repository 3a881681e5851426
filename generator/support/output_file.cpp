// Writing a file beside its target and renaming it into place.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/support/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <optional>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

#include "generator/support/error.hpp"

namespace hvi::gen {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const std::string& target, int error, std::string help = {}) {
    throw EnvironmentError("cannot write " + target + ": " + std::generic_category().message(error),
                           std::move(help));
}

/// An open file descriptor.
class Descriptor {
public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int number() const { return number_; }

    /// Closing can fail too: some file systems report a full disk only then.
    [[nodiscard]] bool close() { return ::close(std::exchange(number_, -1)) == 0; }

private:
    int number_;
};

bool write_all(int descriptor, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(descriptor, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

/// Opens a new file beside a target of this name. NOTE: not with mkstemp, whose files are private:
/// this one gets the permissions of any new file of the user.
std::pair<fs::path, int> open_new_file(const fs::path& directory, const std::string& target) {
    for (int attempt = 0;; ++attempt) {
        const fs::path path = directory / (".hvi-gen-" + std::to_string(::getpid()) + "-" +
                                           std::to_string(attempt) + ".tmp");
        const int opened = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (opened >= 0) return {path, opened};
        if (errno != EEXIST) cannot_write(target, errno);
    }
}

/// Holds interruptions back while a temporary file exists, so that none is left behind.
class SignalsHeld {
public:
    SignalsHeld() {
        sigset_t held;
        sigemptyset(&held);
        for (const int signal : {SIGINT, SIGQUIT, SIGTERM, SIGHUP}) sigaddset(&held, signal);
        pthread_sigmask(SIG_BLOCK, &held, &before_);
    }
    ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    SignalsHeld(const SignalsHeld&) = delete;
    SignalsHeld& operator=(const SignalsHeld&) = delete;

private:
    sigset_t before_{};
};

/// A new file in the directory. The destructor removes it unless it is renamed.
class TemporaryFile {
public:
    TemporaryFile(const fs::path& directory, const std::string& target) {
        std::tie(path_, descriptor_) = open_new_file(directory, target);
    }
    ~TemporaryFile() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] int descriptor() const { return descriptor_; }

    [[nodiscard]] bool rename_to(const fs::path& target) {
        if (::rename(path_.c_str(), target.c_str()) != 0) return false;
        path_.clear();
        return true;
    }

private:
    fs::path path_;
    int descriptor_ = -1;
};

void replace_file(const fs::path& target, std::optional<mode_t> mode, std::string_view text) {
    const SignalsHeld signals_held;
    TemporaryFile temporary(target.has_parent_path() ? target.parent_path() : ".", target.string());
    Descriptor file(temporary.descriptor());
    const bool written = (!mode || ::fchmod(file.number(), *mode) == 0) &&
                         write_all(file.number(), text) && file.close() &&
                         temporary.rename_to(target);
    if (!written) cannot_write(target.string(), errno);
}

/// Writes into a device or a pipe, which must not be replaced by a file.
void write_into(const fs::path& target, std::string_view text) {
    Descriptor file(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.number() < 0 || !write_all(file.number(), text) || !file.close())
        cannot_write(target.string(), errno);
}

}  // namespace

void write_file(const fs::path& path, std::string_view text) {
    std::error_code unresolved;
    const fs::path resolved = fs::canonical(path, unresolved);
    const fs::path target = unresolved ? path : resolved;  // a link stays, its target is replaced

    struct stat old {};
    if (::stat(target.c_str(), &old) != 0) return replace_file(target, {}, text);
    if (S_ISDIR(old.st_mode)) cannot_write(path.string(), EISDIR, "-o takes the name of a file");
    if (!S_ISREG(old.st_mode)) return write_into(target, text);
    if (::access(target.c_str(), W_OK) != 0) cannot_write(path.string(), errno);
    // NOTE: drops the bits that make a program run as its owner, who may have changed.
    replace_file(target, old.st_mode & 0777U, text);
}

fs::path new_file(const fs::path& directory) {
    const auto [path, opened] = open_new_file(directory, (directory / "").string());
    ::close(opened);
    return path;
}

void write_standard_output(std::string_view text) {
    if (!write_all(STDOUT_FILENO, text)) cannot_write("standard output", errno);
}

}  // namespace hvi::gen
