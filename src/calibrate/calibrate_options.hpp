// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What triax calibrate can be asked for.
#include <CLI/App.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "src/study/calibrate/calibration_start.hpp"

namespace triax::src {

struct CalibrateOptions {
  std::string law;
  std::vector<std::string> tests;  ///< none: all of the database
  std::string db = "triax.db";
  std::string start;
  std::vector<std::string> free, fixed;  ///< keys; keys or KEY=VALUE
  int searches = 3;
  std::uint64_t seed = 1;
  double void_ratio_error = 0;
  int jobs = 0;
  std::string piece;               ///< I/N; empty: all searches
  std::vector<std::string> merge;  ///< files of pieces; empty: the searches are run
  std::string output;              ///< parameter file; with `piece` the file of the piece
  std::string figures;             ///< folder
  bool json = false;
};

/// Adds all options; touches no file.
void add_calibrate_options(CLI::App& app, CalibrateOptions& options);
/// Throws lab::BadInput for options that exclude or need each other.
void check_calibrate_options(const CalibrateOptions& options);
study::StartWish start_wish(const CalibrateOptions& options);

}  // namespace triax::src
