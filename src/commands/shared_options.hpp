#pragma once
// Options that several commands share, each written once.
#include <CLI/App.hpp>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "src/report/reported_test.hpp"

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

/// The text report without what would command a terminal or break a line: names come from files of
/// others.
std::string text_for_people(std::vector<ReportedTest> tests);

/// Reads the named tests back from the database and prints them as text or JSON: the one way in
/// which simulate, replay and report say what a test came to.
void print_tests(const std::string& db, const std::vector<std::int64_t>& ids, bool json);

}  // namespace triax::src
