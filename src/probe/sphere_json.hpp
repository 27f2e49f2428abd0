// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "src/study/probe/sphere.hpp"

namespace triax::src {

/// As probe_json: a single state is part of the document, several are its list "states".
std::string sphere_json(const study::SphereResult& result);

}  // namespace triax::src
