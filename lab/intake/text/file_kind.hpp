// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Names files that are no tables of readings, so that a message can say what they are.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "lab/base/byte_source.hpp"

namespace triax::lab {

struct FileKind {
  std::string name;    ///< with its article: "a PDF document"
  std::string remedy;  ///< what to do: "export the readings as CSV"
};

/// Bytes that find_file_kind() needs to distinguish all kinds.
inline constexpr std::size_t kFileKindBytes = 4096;

/// The kind of a file that is no table, from its first bytes: XML (DIGGS by its name), JSON, GEF,
/// AGS 3, PDF, images, archives, databases, binary formats of measurements. Nothing for text that
/// may be a table, AGS4 and workbooks (.xlsx).
std::optional<FileKind> find_file_kind(std::string_view first);

/// Throws BadInput with the kind and the remedy if the file is no table. Leaves `source` at its
/// first byte.
void refuse_other_kinds(ByteSource& source);

/// True for the first line of a group of AGS 3 ("**PROJ"), which AGS4 does not have.
bool begins_ags3(std::string_view line);

}  // namespace triax::lab
