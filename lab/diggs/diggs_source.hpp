// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A triaxial test of a DIGGS file as a record in the CSV format of triax, so that everything reads
// it that reads CSV.
#include <memory>
#include <string>
#include <vector>

#include "lab/base/byte_source.hpp"
#include "lab/diggs/diggs_document.hpp"
#include "lab/results/record_header.hpp"

namespace triax::lab {

/// Parameters of a test (otherTestProperty) that are metadata of triax have names that begin so,
/// the rest is the key of --set: "triax stages.1.role". "triax truth" holds the truth of a
/// simulation as TOML.
inline constexpr std::string_view kDiggsKeyPrefix = "triax ";

/// Name of a project without a name, which DIGGS requires.
inline constexpr std::string_view kUnnamedProject = "not stated";

/// The record of one test: metadata behind #, a heading line, rows, the ending. Lines of the text
/// are no lines of the file.
class DiggsSource : public ByteSource {
 public:
  /// `number` counts the tests of diggs_tests() from 1. Throws BadInput "FILE:LINE: ..." where the
  /// test has no readings, or values that cannot be read.
  DiggsSource(const DiggsDocument& document, std::size_t number, std::unique_ptr<ByteSource> file);

  const std::string& name() const override { return text_->name(); }
  std::uint64_t size() const override { return text_->size(); }
  std::size_t read(std::span<char> into) override { return text_->read(into); }
  void rewind() override { text_->rewind(); }
  /// The file if it has one test; else the record, so that tests of one file differ.
  ByteSource& file() override { return is_only_ ? *file_ : *text_; }

  /// Client, borehole, sample and depth, as preambles of loggers label them.
  const std::vector<Note>& notes() const { return notes_; }
  /// Values that were left out or assumed, with lines of the file.
  const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  std::unique_ptr<ByteSource> file_, text_;
  bool is_only_;
  std::vector<Note> notes_;
  std::vector<Warning> warnings_;
};

/// Names of the tests of a DIGGS file, one for each trial, in the order of the file. Throws
/// BadInput for a file without a triaxial test, naming the procedures that it has, and for one with
/// more than 2000.
std::vector<std::string> diggs_tests(const DiggsDocument& document);

/// The drainage of shear in a type of test ("CIUC", "CD", "UU").
Drainage drainage_of_type(std::string_view type);

}  // namespace triax::lab
