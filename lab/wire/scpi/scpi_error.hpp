// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Errors of SCPI-99 volume 2, chapter 21.8, as far as our instruments make them.
#include <stdexcept>
#include <string>
#include <string_view>

namespace triax::lab {

/// What a message is refused with. -1xx: it is none (command error), -2xx: it cannot be done
/// (execution error), -3xx: the instrument fails, -4xx: answers got out of step (query error).
class ScpiError : public std::runtime_error {
 public:
  explicit ScpiError(int code, const std::string& detail = "");
  int code() const { return code_; }

 private:
  int code_;
};

/// "Data out of range" for -222; "No error" for 0.
std::string_view scpi_error_text(int code);

}  // namespace triax::lab
