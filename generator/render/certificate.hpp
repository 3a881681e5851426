// What a method can do, for people and programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>

#include "generator/certify/audit.hpp"
#include "generator/certify/rule_certificate.hpp"
#include "generator/render/statements.hpp"

namespace hvi::gen {

/// For a terminal of 80 columns. At its end is what the method keeps of what a scene conserves,
/// where one is given.
[[nodiscard]] std::string render_text(const Certificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});

/// The schema `hvi-check/1`, with members for what the method keeps of a scene.
[[nodiscard]] std::string render_json(const Certificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});

/// The same of the general form: what is asked of partitioned methods is null in JSON.
[[nodiscard]] std::string render_text(const RuleCertificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});
[[nodiscard]] std::string render_json(const RuleCertificate& certificate,
                                      const std::optional<SceneStatements>& scene = {});

/// The same with what was found out about a tableau that someone else made: in JSON under `audit`.
[[nodiscard]] std::string render_text(const Audit& audit,
                                      const std::optional<SceneStatements>& scene = {});
[[nodiscard]] std::string render_json(const Audit& audit,
                                      const std::optional<SceneStatements>& scene = {});

}  // namespace hvi::gen
