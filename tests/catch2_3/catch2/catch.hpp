// SPDX-License-Identifier: GPL-3.0-or-later
// Catch2 3 (Debian 13) under the names that the tests use, which are those of Catch2 2 (Debian 12).
// On the include path only if CMake finds version 3.
#pragma once

#include <catch2/catch_approx.hpp>
#include <catch2/catch_template_test_macros.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators_all.hpp>
#include <catch2/matchers/catch_matchers.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <catch2/matchers/catch_matchers_vector.hpp>

namespace Catch {
namespace Matchers {
inline StringContainsMatcher Contains(const std::string& text,
                                      CaseSensitive sensitivity = CaseSensitive::Yes) {
  return ContainsSubstring(text, sensitivity);
}
namespace StdString {
using ContainsMatcher = StringContainsMatcher;
}
}  // namespace Matchers
using namespace Matchers;
}  // namespace Catch
using Catch::Approx;
