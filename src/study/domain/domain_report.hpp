// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// A bifurcation domain as it is reported. Values stand here in the units of the files, so that
// what was written, read and written again is the same to the byte.
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lab/materials/material_library.hpp"
#include "sim/stability/domain.hpp"

namespace triax::study {

inline constexpr double kKilo = 1e3;  ///< Pa in a kPa

/// What a domain was computed for; pieces of one domain have equal settings.
struct DomainSettings {
  struct Material {
    std::string name, law, based_on, description, source, range;
    std::vector<std::pair<std::string, std::string>> parameters;  ///< in the units of their keys
    std::vector<std::pair<std::string, std::string>> files;  ///< SHA-256 of those that they name
    bool operator==(const Material&) const = default;
  } material;
  struct Grid {
    double p_from_kPa = 0, p_to_kPa = 0, q_from_kPa = 0, q_to_kPa = 0;
    int columns = 0, rows = 0;
    double void_ratio = 0;
    std::string plane;  ///< "axisymmetric", "plane-strain"
    int directions = 0;
    /// Criteria of sim::domain_criterion_kinds() that were looked for, in its order.
    std::vector<std::string> criteria;
    bool looks_for(std::string_view criterion) const;
    bool operator==(const Grid&) const = default;
  } grid;
  std::vector<std::string> warnings;
  bool operator==(const DomainSettings&) const = default;
};

/// Where a criterion is met.
struct DomainMark {
  double q_kPa = 0, eta = 0;
  std::optional<double> alpha_deg;  ///< of the first unstable direction
};

struct ReportedBoundary {
  std::optional<DomainMark> first_unstable, isotropic_unloading, limit;
  /// Of the criteria of sim::domain_criterion_kinds() those that are met, by name.
  std::map<std::string, DomainMark, std::less<>> others;
  /// By its key; empty where it is not met.
  std::optional<DomainMark> mark(std::string_view key) const;
  void set_mark(std::string_view key, const std::optional<DomainMark>& mark);
};
/// "first_unstable", "isotropic_unloading", the criteria of the list, "limit": as files hold them.
const std::vector<std::string>& boundary_keys();

struct ReportedDomainState {
  double q_kPa = 0;
  sim::DomainStateKind kind = sim::DomainStateKind::refused;
  std::optional<double> least_work, least_angle_deg;
  std::vector<std::pair<double, double>> cones_deg;
  int refused_directions = 0;
};

struct ReportedColumn {
  int column = 0;
  double p_eff_kPa = 0;
  ReportedBoundary compression, extension;
  std::vector<ReportedDomainState> states;
  std::string refusal;  ///< the law's words; empty: nothing was refused
};

struct ReportedDomain {
  DomainSettings settings;
  std::vector<ReportedColumn> columns;  ///< ascending
};

DomainSettings domain_settings(const lab::MaterialSet& material, const DomainSettings::Grid& grid);
/// SI, made from the values that the files hold, so that every piece has the same states.
sim::DomainGrid domain_grid(const DomainSettings::Grid& grid);
ReportedColumn reported_column(const sim::DomainColumn& column);
/// All columns in SI again, for figures.
std::vector<sim::DomainColumn> domain_columns(const ReportedDomain& domain);

/// One JSON document, a line a state; what is unknown is null.
std::string domain_json(const ReportedDomain& domain);
/// "stable", "unstable", "unknown", "beyond_limit", "refused".
std::string word_of(sim::DomainStateKind kind);

}  // namespace triax::study
