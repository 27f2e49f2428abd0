#pragma once
// The states that triax probe is asked to probe.
#include <vector>

#include "src/probe/probe_options.hpp"
#include "src/probe/probe_report.hpp"

namespace triax::src {

/// The material of the states: as named, or that of the path file. Throws lab::BadInput.
lab::MaterialSet material_of(const ProbeOptions& options);

/// The files of which none may be overwritten.
std::vector<std::string> files_read(const ProbeOptions& options);

/// The states in the space of the options' plane, and what is to be told of where they come from,
/// put into `report`, whose material is there. Throws lab::BadInput.
template <class Space>
std::vector<study::StateToProbe<Space>> states_to_probe(const ProbeOptions& options,
                                                        ProbeReport& report);

extern template std::vector<study::StateToProbe<sim::Axisymmetric>> states_to_probe(
    const ProbeOptions&, ProbeReport&);
extern template std::vector<study::StateToProbe<sim::Tensor>> states_to_probe(const ProbeOptions&,
                                                                              ProbeReport&);

}  // namespace triax::src
