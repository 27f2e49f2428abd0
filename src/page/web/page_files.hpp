// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "lab/base/embedded.hpp"

namespace triax::lab {

/// The files of this folder that a browser is given, and uPlot's: `name` is the file's name with
/// its ending, as the page asks for it below /web/.
extern const std::span<const EmbeddedFile> kPageFiles;

}  // namespace triax::lab
