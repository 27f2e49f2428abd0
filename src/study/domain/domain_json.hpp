#pragma once
// The parts that the JSON documents of a domain and of its pieces share.
#include <nlohmann/json.hpp>

#include "src/study/domain/domain_report.hpp"

namespace triax::study {

nlohmann::ordered_json material_json(const DomainSettings::Material& material);
nlohmann::ordered_json grid_json(const DomainSettings::Grid& grid);
nlohmann::ordered_json mark_json(const std::optional<DomainMark>& mark);
/// The five criteria by name.
nlohmann::ordered_json boundary_json(const ReportedBoundary& boundary);
nlohmann::ordered_json state_json(const ReportedDomainState& state);
/// On one line; bytes that are no UTF-8 are replaced.
std::string dumped(const nlohmann::ordered_json& value);

/// The keys and members of a boundary, in their order.
struct BoundaryKey {
  const char* key;
  std::optional<DomainMark> ReportedBoundary::*mark;
};
inline constexpr BoundaryKey kBoundaryKeys[] = {
    {"first_unstable", &ReportedBoundary::first_unstable},
    {"isotropic_unloading", &ReportedBoundary::isotropic_unloading},
    {"determinant", &ReportedBoundary::determinant},
    {"localisation", &ReportedBoundary::localisation},
    {"limit", &ReportedBoundary::limit},
};

}  // namespace triax::study
