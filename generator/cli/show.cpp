// `hvi-gen show`: a scene as it is written.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/cli/commands.hpp"
#include "generator/read/scene.hpp"

namespace hvi::gen {

void run(const ShowOptions& options) { write_result(options.output, scene_text(options.scene)); }

}  // namespace hvi::gen
