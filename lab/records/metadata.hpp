// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What is said about a test beside its readings, under one set of keys wherever it is said: the
// preamble of our CSV, the TOML file beside a record, a dialect, --set on the command line.
#include <string>
#include <string_view>
#include <vector>

#include "lab/base/toml_reader.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// A key that holds a number.
struct NumberKey {
  std::string_view name;  ///< "height"
  std::string_view unit;  ///< "mm"; "" for a plain number
  double lowest;          ///< that a test can have, in `unit`; inclusive
  double highest;         ///< the same
};

/// A key of [specimen].
struct SpecimenKey : NumberKey {
  std::optional<double> SpecimenInfo::*member;
};
const std::vector<SpecimenKey>& specimen_keys();

/// Every key, with its unit: "test.name", "specimen.height_mm", "stages.N.role"...
std::vector<std::string> metadata_keys();

/// Sets one key from text. A dimension may come in another unit of its kind ("specimen.height_cm").
/// Throws BadInput "WHERE: ..." for an unknown key (names the nearest and all) and for a bad value.
void set_metadata(RecordHeader& header, const std::string& where, std::string_view key,
                  std::string_view value);

/// The key as metadata_keys() spells it, with its own unit: "specimen.height_mm" for
/// "specimen.height_cm". A key that is unknown stays as it is.
std::string canonical_key(std::string_view key);

/// The value of a canonical key as --set would give it, a number with 15 digits; empty where it is
/// unknown or the header has no such stage.
std::string metadata_text(const RecordHeader& header, std::string_view key);

/// Takes [test], [specimen], [labels], [[stages]] and [truth] of a document; unknown keys are
/// BadInput.
void read_metadata(RecordHeader& header, std::optional<Truth>& truth, const TomlTable& document);

/// The same but the ending as TOML text, known values only. Reading it back gives the same values.
std::string metadata_toml(const RecordHeader& header);

/// Lines of TOML as a record holds them, each behind "# ".
std::string as_comment(std::string_view toml);

/// What is known of a test only once it has ended, as TOML text; empty where there is nothing.
std::string ending_toml(const RecordHeader& header);

/// "cell_pressure_kPa" -> {"cell_pressure", kPa}; nothing where the last part is no unit.
struct NamedUnit {
  std::string_view name;
  sim::Unit unit;
};
std::optional<NamedUnit> split_unit(std::string_view name);

}  // namespace triax::lab
