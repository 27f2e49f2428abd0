// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The parts that the JSON documents of a domain and of its pieces share.
#include <nlohmann/json.hpp>

#include "src/study/domain/domain_report.hpp"

namespace triax::study {

nlohmann::ordered_json material_json(const DomainSettings::Material& material);
nlohmann::ordered_json grid_json(const DomainSettings::Grid& grid);
nlohmann::ordered_json mark_json(const std::optional<DomainMark>& mark);
/// All of boundary_keys().
nlohmann::ordered_json boundary_json(const ReportedBoundary& boundary);
nlohmann::ordered_json state_json(const ReportedDomainState& state);
/// On one line; bytes that are no UTF-8 are replaced.
std::string dumped(const nlohmann::ordered_json& value);

}  // namespace triax::study
