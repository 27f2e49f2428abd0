// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Where results go: a file appears whole or not at all; standard output says when it is broken.
#include <string>
#include <string_view>

#include "lab/base/bad_input.hpp"

namespace triax::src {

/// Whoever read standard output has stopped (`| head`): nothing is wrong, there is only nothing
/// left to do.
struct ClosedPipe : lab::WorkFailed {
  ClosedPipe() : lab::WorkFailed("standard output was closed by its reader") {}
};

/// Writes to standard output and makes sure it arrived. Throws ClosedPipe where its reader is
/// gone, lab::WorkFailed with the reason (full disk); what was printed before stays printed.
void print(std::string_view text);

/// The same in passing: the text may wait in a buffer until the next print(), which says whether
/// all of it arrived. For output of many small pieces.
void put(std::string_view text);

/// Writes a file whole or not at all (lab::WholeFile), so that a failure leaves what was there
/// before, and notes it as a WrittenFile; a pipe or a character device is written straight. "-"
/// stands for standard output.
/// Throws lab::BadInput for a folder or another thing that is no file, lab::WorkFailed.
void write_file(const std::string& path, std::string_view bytes);

}  // namespace triax::src
