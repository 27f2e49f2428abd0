// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "lab/base/byte_source.hpp"

namespace triax::lab {

/// True if the first 64 kB of a file look like readings: a zip archive or an old Office file (a
/// workbook may be in it), or text with three lines after one another of at least two numbers each.
/// False for pictures, letters and programmes. The source is then at its first byte. Throws
/// WorkFailed where the medium fails.
bool looks_like_readings(ByteSource& source);

}  // namespace triax::lab
