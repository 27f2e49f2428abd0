// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/ags_data_type.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace triax::lab;

TEST_CASE("numbers of AGS4: so many decimals or figures, no exponent but where it is asked for") {
  CHECK(ags_number(12.345, "2DP") == "12.35");
  CHECK(ags_number(12.345, "0DP") == "12");
  CHECK(ags_number(-0.001, "2DP") == "0.00");
  CHECK(ags_number(0.012345, "2SF") == "0.012");
  CHECK(ags_number(123456, "2SF") == "120000");
  CHECK(ags_number(0.0996, "2SF") == "0.10");
  CHECK(ags_number(0, "2SF") == "0");
  CHECK(ags_number(12345, "2SCI") == "1.23e+04");
  CHECK(ags_number(std::nullopt, "2DP").empty());
  CHECK(ags_number(std::numeric_limits<double>::quiet_NaN(), "2DP").empty());
  for (const char* const type : {"0DP", "2DP", "2SF", "3SF", "2SCI"})
    for (const double value : {0.0, 1.0, -3.14159, 99.99, 1e-7, 123456.789}) {
      INFO(type << ' ' << value);
      CHECK(fits_ags_type(ags_number(value, type), type, ""));
    }
}

TEST_CASE("what a type takes and what it does not (rule 8)") {
  CHECK(fits_ags_type("", "2DP", "m"));
  CHECK(fits_ags_type("1.50", "2DP", "m"));
  for (const char* const bad : {"1.5", "1,50", "1.5e1", "1.500", "x", "nan", "1.50 "})
    CHECK_FALSE(fits_ags_type(bad, "2DP", "m"));
  CHECK_FALSE(fits_ags_type("1.0", "0DP", ""));
  CHECK(fits_ags_type("12", "2SF", ""));
  CHECK_FALSE(fits_ags_type("123", "2SF", ""));
  CHECK(fits_ags_type("2026-11-25", "DT", "yyyy-mm-dd"));
  CHECK(fits_ags_type("2026-11", "DT", "yyyy-mm-dd"));
  CHECK(fits_ags_type("2017-07-18T00:00", "DT", "yyyy-mm-ddThh:mm"));
  CHECK_FALSE(fits_ags_type("25/11/2026", "DT", "yyyy-mm-dd"));
  CHECK_FALSE(fits_ags_type("2026-1", "DT", "yyyy-mm-dd"));
  CHECK(fits_ags_type("Y", "YN", ""));
  CHECK_FALSE(fits_ags_type("maybe", "YN", ""));
  CHECK(fits_ags_type("anything at all", "X", ""));
  CHECK(fits_ags_type("1e3", "U", ""));
  CHECK_FALSE(fits_ags_type("much", "U", ""));
}
