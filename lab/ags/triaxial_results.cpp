// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/ags/triaxial_results.hpp"

#include <fmt/format.h>

#include <array>

#include "lab/ags/ags_number.hpp"
#include "lab/ags/ags_reader.hpp"
#include "lab/ags/result_rows.hpp"
#include "lab/ags/specimen_match.hpp"
#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

/// No investigation has that many; more would only fill the memory.
constexpr std::size_t kMostResults = 100'000;

/// Of the stress that governs: "TREG" and "TRET", or "TRIG" and "TRIT".
struct GroupPair {
  const char* general;
  const char* results;
  SpecimenMatch generals;
};

void read_delivery(AgsResults& all, const AgsReader& reader) {
  if (reader.group().name == "TRAN") all.edition = reader.cell("TRAN_AGS");
  if (reader.group().name != "PROJ") return;
  const std::string_view name = reader.cell("PROJ_NAME");
  all.project = name.empty() ? reader.cell("PROJ_ID") : name;
}

[[noreturn]] void fail_without_results(const AgsReader& reader) {
  std::vector<std::string> triaxial, cyclic;
  for (const auto& name : reader.group_names()) {
    if (name == "TREG" || name == "TRET" || name == "TRIG" || name == "TRIT")
      triaxial.push_back(name);
    if (name.size() == 4 && name.starts_with("CTR")) cyclic.push_back(name);
  }
  std::string what = "AGS4 without a triaxial result: ";
  if (!triaxial.empty())
    what += "no row of data in " + joined(triaxial);
  else if (!cyclic.empty())
    what += joined(cyclic) +
            " are of cyclic tests, which triax does not import; none of its groups "
            "is TREG, TRET, TRIG or TRIT";
  else if (reader.group_names().empty())
    what += "it has no group";
  else
    what += "it has the groups " + joined(reader.group_names()) +
            ", and none of them is a triaxial one (TREG, TRET, TRIG, TRIT)";
  throw BadInput(reader.file(), 0, what);
}

/// What the general row says holds for each result of its specimen.
void join(ReferenceResult& result, GroupPair& pair, Findings& findings) {
  const ReferenceResult* general = pair.generals.find(result.specimen);
  if (general == nullptr) {
    findings.note(std::string("no ") + pair.general, result.line,
                  fmt::format("the specimen of this row of {} has no row in {}, or several: the "
                              "type of test is unknown",
                              pair.results, pair.general));
    return;
  }
  add_general(result, *general);
}

void note_encoding(const AgsReader& reader, Findings& findings) {
  if (reader.recoded_line() > 0)
    findings.note("encoding", reader.recoded_line(), "not UTF-8: read as Windows-1252");
}

}  // namespace

AgsResults read_triaxial_results(ByteSource& source) {
  AgsResults all;
  all.file = source.name();
  Findings findings(all.warnings);
  AgsReader reader(source);
  AgsNumbers numbers(reader, findings);
  std::array<GroupPair, 2> pairs{{{"TREG", "TRET", {}}, {"TRIG", "TRIT", {}}}};
  std::size_t rows = 0;
  while (reader.next()) {
    read_delivery(all, reader);
    for (GroupPair& pair : pairs) {
      const bool general = reader.group().name == pair.general;
      if (!general && reader.group().name != pair.results) continue;
      if (++rows > kMostResults)
        throw BadInput(reader.file(), reader.line(),
                       fmt::format("more than {} triaxial results", kMostResults));
      if (general)
        pair.generals.add(general_row(reader, numbers));
      else
        all.results.push_back(result_row(reader, numbers));
    }
  }
  if (rows == 0) fail_without_results(reader);
  for (ReferenceResult& result : all.results)
    join(result, result.group == pairs[0].results ? pairs[0] : pairs[1], findings);
  for (GroupPair& pair : pairs) pair.generals.append_unmatched(all.results);
  note_encoding(reader, findings);
  findings.finish();
  return all;
}

}  // namespace triax::lab
