// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "lab/devices/transducer.hpp"
#include "lab/results/quantity.hpp"

namespace triax::lab {

class TomlTable;

/// The transducer of a channel: what a set of instruments says of it (`base`), and over that, key
/// by key, what the programme's own table says; perfect where neither is there. Throws BadInput for
/// unknown keys, values that no instrument has, and keys that need another one beside them.
Transducer read_transducer(Quantity channel, const std::optional<TomlTable>& base,
                           const std::optional<TomlTable>& own);

}  // namespace triax::lab
