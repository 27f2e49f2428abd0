// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Clean records of closed-form tests as text, with codes and dropouts in one channel.
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace triax::lab::testing {

/// A test by closed form: q and p' in kPa and the volumetric strain over the axial strain.
struct ClosedFormTest {
  std::string name;
  bool drained = false;
  double (*q)(double strain) = nullptr;
  double (*p)(double strain) = nullptr;
  double (*volume)(double strain) = nullptr;
};
/// They harden to the end: contracting, dilating and straight, undrained and drained.
const std::vector<ClosedFormTest>& hardening_tests();
/// They lose four fifths of q after a peak, undrained.
const std::vector<ClosedFormTest>& collapsing_tests();

/// How a record is written.
struct RecordForm {
  std::string columns;  ///< "raw", "q p'", "s1' s3'", "q u", "all"
  int readings = 24;
  double last_strain = 0.12;
  bool equal_steps = true;  ///< of strain; otherwise they are shorter at the start
  double noise = 0;         ///< of each value, as a fraction
};

/// The cells of a record, before they become text.
struct Sheet {
  std::string preamble;
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::size_t> channels;  ///< columns that an instrument gave or that follow from one
  std::string text() const;
};
Sheet write_sheet(const ClosedFormTest& test, const RecordForm& form, std::mt19937& random);

/// What is written over the cells: a code of loggers, "0", or a factor of the largest value
/// ("x2.5").
struct Spoiler {
  std::string code;
  double where = 0;  ///< of the record, 0 to 1
  int cells = 1;
};
/// Spoils `cells` cells of that column; returns the first row of them.
std::size_t spoil(Sheet& sheet, std::size_t column, const Spoiler& spoiler);

}  // namespace triax::lab::testing
