// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What triax domain can be asked for.
#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "src/cli/material_option.hpp"
#include "src/cli/output_guard.hpp"
#include "src/study/domain/domain_report.hpp"

namespace triax::src {

struct DomainOptions {
  MaterialOptions material;
  std::string p, q;  ///< ranges; empty: what the set is for
  std::string plane = "axisymmetric";
  int directions = 360;
  int jobs = 0;                    ///< threads; 0: all cores
  std::string piece;               ///< I/N; empty: the whole domain
  std::vector<std::string> merge;  ///< files of pieces; empty: the domain is computed
  std::string output;              ///< folder; with `piece` a file
  std::string prefix() const { return prefix_in(output, "domain"); }
  std::vector<std::string> tests;
  std::string db = "triax.db";
  std::vector<std::string> criteria;  ///< asked for, of sim::domain_criterion_kinds()
  bool json = false;
};

/// Adds all options; touches no file.
void add_domain_options(CLI::App& app, DomainOptions& options);

/// Throws lab::BadInput for an option beside --merge that has no meaning there, which is every one
/// that says what to compute or how, and for others that exclude or need each other.
void check_domain_options(const CLI::App& app, const DomainOptions& options);

/// --p-kPa, --q-kPa and the rest of the grid, what is not given being what the set is for. Throws
/// lab::BadInput for a grid that is none, and where the material has no law for its plane.
study::DomainSettings::Grid chosen_grid(const DomainOptions& options,
                                        const lab::MaterialSet& material);

}  // namespace triax::src
