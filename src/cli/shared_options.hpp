#pragma once
// Options that several commands share, each written once.
#include <CLI/App.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace triax::src {

/// --db FILE, triax.db in the current folder by default.
void add_db(CLI::App& app, std::string& path);

/// --json: one document on standard output and nothing else there.
void add_json(CLI::App& app, bool& json);

/// --speed max|N: 0 in `speed` stands for max.
void add_speed(CLI::App& app, double& speed);

/// One of `count` pieces of a whole that a batch system computes.
struct Piece {
  int index = 1, count = 1;
};
/// What --piece I/N gave; 1 of 1 for an empty text. Throws lab::BadInput.
Piece piece_of(const std::string& text);

/// What --set KEY=VALUE gave; `example` completes the message of the BadInput that a text without a
/// key throws.
std::vector<std::pair<std::string, std::string>> key_values(const std::vector<std::string>& sets,
                                                            const std::string& example);

}  // namespace triax::src
