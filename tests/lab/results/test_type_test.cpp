// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/test_type.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "lab/results/record_header.hpp"

using namespace triax::lab;

namespace {

std::string code(std::string_view text) {
  const TestType* type = find_test_type(text);
  return type == nullptr ? "" : type->codes.front();
}

bool is_drained(std::string_view text) {
  const TestType* type = find_test_type(text);
  REQUIRE(type != nullptr);
  return type->drained;
}

bool is_total(const std::string& programme) {
  RecordHeader header;
  header.programme = programme;
  return header.is_total_stress();
}

}  // namespace

TEST_CASE("find_test_type: codes of AGS and DIGGS with their drainage") {
  for (const char* type :
       {"CIU", "CIUC", "CIUE",  "CAU", "CAUC", "CAUE", "CK0U", "CK0UC", "CK0UE", "CU",
        "CUM", "CUP",  "CIUCM", "UU",  "UUM",  "UC",   "UNC",  "CTRC",  "ICU",   "CSU"})
    CHECK_FALSE(is_drained(type));
  for (const char* type :
       {"CID", "CIDC", "CIDE", "CAD", "CADC", "CADE", "CK0D", "CD", "CDM", "ICD", "CSD"})
    CHECK(is_drained(type));
  CHECK(find_test_type("CADC")->consolidation == TestType::Consolidation::anisotropic);
  CHECK(find_test_type("CK0UE")->extension == true);
  CHECK(find_test_type("CIUC")->extension == false);
  CHECK(find_test_type("CDM")->multi_stage);
  CHECK(find_test_type("CTRC")->cyclic);
}

TEST_CASE("find_test_type: spelling, punctuation and words around a code") {
  CHECK(code("ciuc") == "CIU");
  CHECK(code(" C.I.U. ") == "CIU");
  CHECK(code("CK₀U") == "CK0U");
  CHECK(code("CKoU") == "CK0U");
  CHECK(code("CU+u") == "CU");
  CHECK(code("CIDC 100 kPa") == "CID");
  CHECK(code("TX-CAUE") == "CAUE");
  CHECK(code("CIU3") == "CIU");
  CHECK(code("CU_12") == "CU");
}

TEST_CASE("find_test_type: names in words, the longest one counts") {
  CHECK(code("Consolidated Undrained Triaxial Test") == "CU");
  CHECK(code("Unconsolidated undrained triaxial") == "UU");
  CHECK(code("isotropically consolidated drained compression") == "CID");
  CHECK(code("anisotropically consolidated undrained extension") == "CAUE");
  CHECK(code("固结不排水三轴试验") == "CU");
  CHECK(code("Unconfined compression test") == "UC");
}

TEST_CASE("find_test_type: a text that names no type") {
  for (const char* text : {"", " ", "sand", "standard", "S 12", "site Q", "Du", "quick-load",
                           "12345", "\xff\xfe", "...", "-"})
    CHECK(code(text).empty());
  CHECK(code(std::string(1, '\0') + "CIU") == "CIU");
  std::string long_text(10'000'000, 'x');
  CHECK(code(long_text.append(" CIU")).empty());
  CHECK(code(std::string(10'000'000, ' ')).empty());
}

TEST_CASE("test_types: no code stands for two types") {
  std::set<std::string> codes;
  REQUIRE(test_types().size() > 20);
  for (const TestType& type : test_types()) {
    REQUIRE_FALSE(type.codes.empty());
    for (const std::string& one : type.codes) CHECK(codes.insert(one).second);
  }
}

TEST_CASE("RecordHeader: tests in total stresses by their type") {
  for (const char* type : {"UU", "uu", "UUM", "UC", "UNC", "UCS", "Unconfined compression"})
    CHECK(is_total(type));
  for (const char* type : {"", "CU", "CIUC", "UUP", "CTRC", "sand"}) CHECK_FALSE(is_total(type));
  RecordHeader header;
  header.programme = "UNC";
  CHECK(header.is_unconfined());
  header.programme = "UU";
  CHECK_FALSE(header.is_unconfined());
}

TEST_CASE("find_type_in_title: codes, names and standards in titles of reports") {
  const auto title = [](std::string_view text) {
    const TestType* type = find_type_in_title(text);
    return type == nullptr ? std::string() : type->codes.front();
  };
  CHECK(title("Consolidated undrained triaxial compression test, ASTM D4767") == "CU");
  CHECK(title("CIU") == "CIU");
  CHECK(title("UU test BS 1377-7") == "UU");
  CHECK(title("CID triaxial test - Project X") == "CID");
  CHECK(title("Triaxial CU Test Report") == "CU");
  CHECK(title("Triaxial test CIU 100 kPa") == "CIU");
  CHECK(title("Triaxialversuch: konsolidiert drainiert, CID Versuch") == "CID");
  CHECK(title("Unconsolidated undrained triaxial test (ASTM D2850)") == "UU");
  CHECK(title("Unconfined compression test (ASTM D 2166)") == "UC");
  CHECK(title("三轴固结不排水试验") == "CU");
  CHECK(title("C.I.U.") == "CIU");
}

TEST_CASE("find_type_in_title: names of people, places and several types name none") {
  for (const char* text :
       {"", "Triaxial test report", "UC Berkeley test laboratory", "CAD drawing 12, test pit",
        "Report of R. Smith, Q section", "Consolidated undrained and consolidated drained tests",
        "CIU and CID tests", "cu", "Data CD", "BS 1377-8:1990", "ISO 17892-9"}) {
    INFO(text);
    CHECK(find_type_in_title(text) == nullptr);
  }
}
