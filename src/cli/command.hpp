// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The description of a command: the only source of --help, man page and shell completion.
#include <CLI/App.hpp>
#include <CLI/Formatter.hpp>
#include <functional>
#include <string>
#include <vector>

namespace triax::src {

struct Example {
  std::string line;     ///< as typed, without the prompt
  std::string purpose;  ///< imperative half sentence: "list all tests"
};

struct Command {
  std::string name;
  std::string purpose;                   ///< one line: imperative verb and object
  std::vector<std::string> description;  ///< paragraphs
  std::vector<Example> diagnostics;      ///< a message (or its beginning) and the remedy
  std::vector<Example> examples;
  /// Exit statuses other than 0, 1 and 2 (the number, its meaning).
  std::vector<Example> statuses = {};
  /// Adds the options to the sub-command and gives what is to be run once they are parsed. Touches
  /// no file. What is run throws lab::BadInput (status 2), EndedEarly (its own status) or anything
  /// else (status 1).
  std::function<std::function<void()>(CLI::App&)> set_up;
};

}  // namespace triax::src
