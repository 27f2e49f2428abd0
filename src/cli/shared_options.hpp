// SPDX-License-Identifier: GPL-3.0-or-later
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

/// --format of what standard output gets, one of `formats` (the first is what it is otherwise), and
/// --json, short for --format json: one document and nothing else.
void add_format(CLI::App& app, std::string& format, const std::vector<std::string>& formats);

/// The same of a command that knows text and JSON only.
void add_json(CLI::App& app, bool& json);

/// --live: not what a test came to but what was said while it ran.
void add_live(CLI::App& app, bool& live);

/// --earlier TEST: tests of the same sand, of which the alarm is told.
void add_earlier(CLI::App& app, std::vector<std::string>& tests);

/// --jobs N: threads or tests at a time; 0 in `jobs`: not given, all cores. `what` describes it.
void add_jobs(CLI::App& app, int& jobs, const std::string& what, int most = 1024);
/// As many as were asked for, or as there are cores.
[[nodiscard]] int chosen_jobs(int jobs);

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
