// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// How one make of instrument is asked and set: a data file that names each of its values once, with
// its SCPI header and its registers. Controller and served device are both made from it.
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace triax::lab {

enum class Protocol { scpi, modbus, lines };
std::string_view to_text(Protocol protocol);

/// float32: IEEE 754 in two registers, high word first (float32_low_first: low word first). int16,
/// uint16: value = factor · register; the largest negative and the largest unsigned number stand
/// for "no value". coil, discrete: one bit.
enum class RegisterForm { float32, float32_low_first, int16, uint16, coil, discrete };

/// Where a value stands in a device that speaks Modbus.
struct PointRegister {
  RegisterForm form = RegisterForm::float32;
  int address = 0;     ///< as on the wire, from 0; of the first of its registers
  double factor = 1;   ///< of int16 and uint16
  bool input = false;  ///< the controller asks by function 4 (input), not 3 (holding)

  bool is_bit() const { return form == RegisterForm::coil || form == RegisterForm::discrete; }
  /// How many registers, or 1 bit.
  int size() const {
    return form == RegisterForm::float32 || form == RegisterForm::float32_low_first ? 2 : 1;
  }
};

struct PersonalityPoint {
  std::string name;  ///< ends with the unit of the field: "pressure_kPa"
  std::string help;
  bool readable = true, writable = false;
  std::string scpi;  ///< "SOURce:PRESsure:TARGet"; empty: not by SCPI
  /// Empty: not by Modbus. The controller uses the first; a scaled integer may stand beside it.
  std::vector<PointRegister> registers;
  /// Smallest and largest value that the instrument can give; empty: any.
  std::optional<std::pair<double, double>> range;
};

struct PersonalityIdentity {
  std::string ask;               ///< by SCPI or lines; empty: it does not say who it is
  std::optional<int> register_;  ///< first of the input registers that hold it as text, by Modbus
  int registers = 0;             ///< two characters each, filled up with NUL
  std::string begins, holds;     ///< what the answer begins with, and holds; may be empty
};

/// One question for all channels at once, or lines that come unasked.
struct PersonalityScan {
  std::vector<std::string> prepare;  ///< sent once; "{at}" is the list of channels
  std::string ask;                   ///< empty: it speaks unasked
  int lines = 1;                     ///< of one answer
  int columns = 1;                   ///< numbers of a line, apart by commas or semicolons
  std::string no_value;              ///< its word for no value: "OPEN"; empty: it has none
  /// Behind every number stand year,month,day,hour,minute,second of its instant, by the
  /// instrument's own clock.
  bool stamped = false;
  /// Smallest and largest number that the instrument can give; empty: any.
  std::optional<std::pair<double, double>> range;
  /// Channels are chosen by `prepare` or `ask` and answered in rising order, in one line; else all
  /// numbers come always, the first is channel 1.
  bool chooses() const;
};

struct Personality {
  std::string name, file;
  std::string title, about;
  std::vector<Protocol> protocols;
  PersonalityIdentity identity;
  std::string terminator = "\n";
  double deadline_s = 1;  ///< for a whole answer
  double pause_s = 0;     ///< from an answer to the next question
  bool compound = false;  ///< ":A?;:B?" is answered "a;b"
  std::string set_check;  ///< asked behind every setting; right is an answer that begins with 0
  std::vector<std::string> prepare;  ///< sent once a link stands, by SCPI or lines
  std::optional<PersonalityScan> scan;
  std::vector<PersonalityPoint> points;  ///< in the order in which they are set

  bool speaks(Protocol protocol) const;
  const PersonalityPoint* find(std::string_view point) const;
  /// Throws BadInput for an unknown name, with the nearest right one.
  const PersonalityPoint& at(std::string_view point) const;
  /// Why the answer is not this make's; empty: it is.
  std::string complaint_about(std::string_view identity_text) const;
};

/// Throws BadInput "FILE:LINE: ...": unknown keys, registers that overlap, a protocol without
/// values.
Personality parse_personality(std::string_view toml, const std::string& file);
/// lab/wire/personalities/*.toml, by name.
const std::vector<Personality>& shipped_personalities();
/// A shipped one by name, or a file that ends with ".toml". Throws BadInput.
Personality find_personality(const std::string& name_or_file);

}  // namespace triax::lab
