// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/wire/scpi/scpi_error.hpp"

#include "lab/base/names.hpp"

namespace triax::lab {
namespace {
constexpr std::pair<int, std::string_view> kScpiErrors[] = {
    {0, "No error"},
    {-101, "Invalid character"},
    {-102, "Syntax error"},
    {-103, "Invalid separator"},
    {-104, "Data type error"},
    {-108, "Parameter not allowed"},
    {-109, "Missing parameter"},
    {-113, "Undefined header"},
    {-114, "Header suffix out of range"},
    {-131, "Invalid suffix"},
    {-151, "Invalid string data"},
    {-161, "Invalid block data"},
    {-221, "Settings conflict"},
    {-222, "Data out of range"},
    {-224, "Illegal parameter value"},
    {-230, "Data corrupt or stale"},
    {-350, "Queue overflow"},
    {-363, "Input buffer overrun"},
    {-410, "Query INTERRUPTED"},
    {-420, "Query UNTERMINATED"},
    {-430, "Query DEADLOCKED"},
    {-440, "Query UNTERMINATED after indefinite response"},
};
}  // namespace

std::string_view scpi_error_text(int code) { return name_of<int>(code, kScpiErrors); }

ScpiError::ScpiError(int code, const std::string& detail)
    : std::runtime_error(std::string(scpi_error_text(code)) + (detail.empty() ? "" : "; ") +
                         detail),
      code_(code) {}

}  // namespace triax::lab
