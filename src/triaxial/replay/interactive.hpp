// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// `triax replay FILE --interactive`: shows how a table is understood, asks what the file does not
// decide, and shows what is read with the answers.
#include <optional>
#include <string>

#include "lab/rig/recorded.hpp"
#include "src/triaxial/replay/question_dialog.hpp"

namespace triax::src {

/// The options to read the record with, as the user confirmed them; nothing if the user quits or
/// the input ends. Stores nothing but the dialect that the user asks to save, as NAME.toml beside
/// the record. Throws BadInput for a file that holds no table of numbers.
std::optional<lab::RecordOptions> confirm_import(const std::string& path,
                                                 const lab::RecordOptions& options,
                                                 const Conversation& user);

}  // namespace triax::src
