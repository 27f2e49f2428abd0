// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an instrument says, in its unit, as a quantity in the unit of the field, and back.
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace triax::lab {

class TomlTable;

struct CalibratedValue {
  double value = 0;      ///< in the unit of the field; NaN: none
  bool in_range = true;  ///< false: outside what was calibrated, or the instrument is at its end
};

/// value = gain · raw + offset
struct Calibration {
  double gain = 1;    ///< unit of the field per unit of the instrument; not 0
  double offset = 0;  ///< in the unit of the field
  /// Least and most value, in the unit of the field, for which the certificate holds; empty: any.
  std::optional<std::pair<double, double>> range;
  std::string date;         ///< "2026-03-17"; may be empty
  std::string certificate;  ///< number or name; may be empty

  /// An infinite raw value (beyond the end of the instrument's range) is no value out of range.
  CalibratedValue value_of(double raw) const;
  /// raw = (value − offset)/gain: what an instrument says that feels `value`.
  double raw_of(double value) const;
  /// One line that tells every member, the same for the same calibration.
  std::string text() const;
};

/// calibration = { gain = 0.125, offset = -3.2, range = [0, 1000], date = "2026-03-17", certificate
/// = "..." }; all keys may be left out. Throws BadInput.
Calibration read_calibration(const TomlTable& table);

/// SHA-256, as 64 digits, of an instrument's identity and the calibrations of its channels, each by
/// the channel's name; their order does not matter.
std::string instrument_digest(const std::string& identity,
                              std::vector<std::pair<std::string, Calibration>> channels);

}  // namespace triax::lab
