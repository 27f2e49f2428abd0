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
/// lab/intake/lexicon/stages.toml (words for stages, names of types of tests)
extern const std::span<const EmbeddedFile> kStageWords;
/// lab/ags/dictionary/*.txt (groups of AGS4)
extern const std::span<const EmbeddedFile> kAgsDictionary;
/// lab/intake/lexicon/*.toml (names of columns, labels, stages and software), by name
extern const std::span<const EmbeddedFile> kLexiconFiles;
/// lab/intake/units.toml (spellings of units)
extern const std::span<const EmbeddedFile> kUnitFiles;

/// lab/intake/cells/clock_words.toml (months, marks and zones in cells of clocks)
extern const std::span<const EmbeddedFile> kClockWords;
/// lab/intake/lexicon/fill_values.toml (cells that hold no value)
extern const std::span<const EmbeddedFile> kFillValues;

}  // namespace triax::lab
