// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/checkpoint_saver.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>

namespace hvi::gen {

namespace {

volatile std::sig_atomic_t stops = 0, saves = 0;

/// Appends the text. Returns whether it is in the file, even if the power is cut.
bool append(const char* path, const std::string& text) {
    std::FILE* const file = std::fopen(path, "ab");
    if (file == nullptr) return false;
    const bool is_written = std::fwrite(text.data(), 1, text.size(), file) == text.size() &&
                            std::fflush(file) == 0 && ::fsync(::fileno(file)) == 0;
    return std::fclose(file) == 0 && is_written;
}

}  // namespace

void heed_signals() {
    stops = 0;
    saves = 0;
    std::signal(SIGTERM, [](int) { stops = 1; });
    std::signal(SIGUSR1, [](int) { saves = 1; });
}

bool is_stopped() { return stops != 0; }

std::int64_t CheckpointSaver::ahead(std::int64_t taken) const {
    if (!wishes_ || wishes_->every == 0) return std::numeric_limits<std::int64_t>::max();
    return wishes_->every - taken % wishes_->every;
}

bool CheckpointSaver::is_due(std::int64_t taken) const {
    if (!wishes_) return false;
    if (saves != 0 || (wishes_->every != 0 && taken % wishes_->every == 0)) return true;
    const std::chrono::duration<double> passed = Clock::now() - last_;
    return wishes_->minutes > 0 && passed.count() >= 60 * wishes_->minutes;
}

void CheckpointSaver::save(const Checkpoint& checkpoint) {
    saves = 0;
    last_ = Clock::now();
    if (!append(wishes_->file.c_str(), text(checkpoint, wishes_->key)))
        throw std::runtime_error("cannot write " + wishes_->file.string());
}

}  // namespace hvi::gen
