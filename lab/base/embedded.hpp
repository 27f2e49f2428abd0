// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Data files that ship inside the program: dialects of record files, parameter sets of materials.
// They are ordinary TOML files of this repository, compiled in so that no install path can be
// wrong.
#include <span>
#include <string_view>

namespace triax::lab {

struct EmbeddedFile {
  std::string_view name;  ///< file name without its ending, e.g. "gdslab"
  std::string_view text;  ///< the whole file, UTF-8
};

/// lab/records/dialects/*.toml
extern const std::span<const EmbeddedFile> kShippedDialects;
/// lab/materials/*.toml (parameter sets of the laws in sim/materials)
extern const std::span<const EmbeddedFile> kShippedMaterials;
/// lab/devices/instruments/*.toml (sets of instruments for the rig of a programme)
extern const std::span<const EmbeddedFile> kShippedInstruments;
/// lab/wire/personalities/*.toml (how instruments on the wire are asked and set)
extern const std::span<const EmbeddedFile> kShippedPersonalities;
/// lab/ags/dictionary/*.txt (groups of AGS4)
extern const std::span<const EmbeddedFile> kAgsDictionary;

}  // namespace triax::lab
