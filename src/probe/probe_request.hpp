// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What the options of triax probe ask a study for.
#include <string>
#include <vector>

#include "src/probe/probe_options.hpp"
#include "src/study/probe/run_probe.hpp"
#include "src/study/probe/strain_paths.hpp"

namespace triax::src {

/// The probes of a plane. Throws lab::BadInput for options that make no sense, for a material or a
/// path file that there is not.
study::ProbeRequest probe_request(const ProbeOptions& options);
/// Those of all directions of space. Throws likewise.
study::SphereRequest sphere_request(const ProbeOptions& options);
study::StrainPathsRequest strain_paths_request(const ProbeOptions& options);

/// The files of which none may be overwritten.
std::vector<std::string> files_read(const ProbeOptions& options);

}  // namespace triax::src
