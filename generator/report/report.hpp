// The content of a report, before it is a page, JSON or CSV.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/edges/edges.hpp"
#include "generator/program/machine.hpp"
#include "generator/study/curves.hpp"
#include "generator/support/time_spent.hpp"

namespace hvi::gen {

struct Report {
    Machine machine;
    std::string compiler;  ///< its name and options
    std::string compiler_version;
    std::vector<SceneReport> scenes = {};
    std::vector<EdgeChapter> edges = {};
    TimeSpent time_spent = {};
    std::vector<std::string> notes = {};  ///< sentences without a full stop
    std::string incomplete = {};          ///< why there is not more; empty where it is whole
};

}  // namespace hvi::gen
