// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/version.hpp"

namespace triax::study {

std::string_view version() { return TRIAX_VERSION; }

}  // namespace triax::study
