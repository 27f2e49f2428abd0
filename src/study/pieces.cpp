// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lab/base/bad_input.hpp"
#include "lab/base/byte_source.hpp"
#include "lab/base/digest.hpp"

namespace triax::study {
namespace {

/// A domain of the largest grid is some hundred megabytes.
constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;

constexpr const char* kSeal = ",\n\"sha256\": \"";

/// What ends a document that begins so.
std::string seal_of(const std::string& document) {
  return kSeal + lab::sha256(*lab::open_memory("piece", document)) + "\"\n}\n";
}

}  // namespace

void check_together(const std::vector<PieceName>& pieces, const std::string& whole,
                    const std::function<std::string(std::size_t)>& difference) {
  const PieceName& first = pieces.front();
  std::vector<const PieceName*> of(static_cast<std::size_t>(first.count), nullptr);
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const PieceName& piece = pieces[k];
    const auto refuse = [&](const std::string& why) { throw lab::BadInput(piece.file, 0, why); };
    if (piece.count != first.count)
      refuse(
          fmt::format("is one of {} pieces, {} one of {}; all pieces must be of the same division",
                      piece.count, first.file, first.count));
    if (const std::string other = difference(k); !other.empty())
      refuse(fmt::format("is a piece of another {}: {}", whole, other));
    if (piece.program != first.program)
      refuse(fmt::format("was written by triax {}, {} by {}; compute all pieces with one version",
                         piece.program, first.file, first.program));
    const PieceName*& place = of[static_cast<std::size_t>(piece.index - 1)];
    if (place != nullptr)
      refuse(fmt::format("is piece {} of {}, like {}; give each piece once", piece.index,
                         piece.count, place->file));
    place = &piece;
  }
  const auto missing = std::ranges::find(of, nullptr);
  if (missing == of.end()) return;
  throw lab::BadInput(fmt::format("--merge: piece {} of {} is missing ({} given)",
                                  missing - of.begin() + 1, first.count, pieces.size()));
}

std::string sealed(std::string document) {
  document.resize(document.rfind("\n}\n"));
  return document + seal_of(document);
}

void check_seal(const std::string& text, const std::string& file) {
  const auto start = text.rfind(kSeal);
  if (start == std::string::npos)
    throw lab::BadInput(file, 0,
                        "has no checksum: it was written by an older triax or changed by another "
                        "program; compute the piece again");
  const std::string document = text.substr(0, start);
  if (text.substr(start) != seal_of(document))
    throw lab::BadInput(file, 0,
                        "was changed since it was written: wrong checksum (SHA-256); copy it "
                        "again, or compute the piece again");
}

std::string piece_text(const std::string& path, const std::string& writer,
                       const std::string& whole) {
  std::error_code none;
  if (!std::filesystem::exists(path, none))
    throw lab::BadInput(path, 0, "file does not exist; expected a file written by " + writer);
  if (!std::filesystem::is_regular_file(path, none))
    throw lab::BadInput(path, 0, "is not a regular file; expected a file written by " + writer);
  if (std::filesystem::file_size(path, none) > kLargestFile)
    throw lab::BadInput(path, 0, "is larger than 1 GB; cut the " + whole + " into more pieces");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file) throw lab::BadInput(path, 0, "cannot be read");
  return std::move(text).str();
}

}  // namespace triax::study
