// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "lab/base/byte_source.hpp"

namespace triax::lab {

/// SHA-256 of all bytes from the first on, 64 digits of 0-9a-f, in constant memory; the source then
/// stands at its first byte. Throws WorkFailed where the medium fails.
std::string sha256(ByteSource& source);

}  // namespace triax::lab
