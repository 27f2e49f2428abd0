// SPDX-License-Identifier: GPL-3.0-or-later
#define CATCH_CONFIG_MAIN  // of Catch2 2: version 3 has its main in a library
#include <catch2/catch.hpp>
