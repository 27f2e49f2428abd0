// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the pieces of any piece of work cut for a batch system have in common.
#include <functional>
#include <string>
#include <vector>

namespace triax::study {

struct PieceName {
  std::string file;     ///< it was read from
  std::string program;  ///< version that wrote it
  int index = 1, count = 1;
};

/// Throws lab::BadInput, one line that names the file, unless the pieces are all of one cut, once
/// each. `difference` says how piece k is of another `whole` ("domain") than the first, empty if it
/// is of the same. Pre-condition: at least one piece, indices within 1 to count.
void check_together(const std::vector<PieceName>& pieces, const std::string& whole,
                    const std::function<std::string(std::size_t)>& difference);

/// The bytes of a file. Throws lab::BadInput if it is none, larger than 1 GB or cannot be read;
/// `writer` is the command that writes such files, `whole` what it cuts.
std::string piece_text(const std::string& path, const std::string& writer,
                       const std::string& whole);

/// The JSON document of a piece ("{...\n}\n") with a last member "sha256", of all bytes before it.
std::string sealed(std::string document);

/// Throws lab::BadInput unless the text is a sealed document, every byte as it was written: a digit
/// that changed on the way would go unseen.
void check_seal(const std::string& text, const std::string& file);

}  // namespace triax::study
