// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/columns_text.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "src/output/table.hpp"
#include "src/study/intake/column_evidence.hpp"

namespace triax::src {
namespace {

/// The first values of a column as in the file: "0, 0.5, 1".
std::string first_values(const lab::TableColumn& column) {
  constexpr std::size_t kMaxShown = 3;
  if (column.clock || !column.sample.is_number) return column.first_cell;
  std::vector<std::string> shown;
  for (const double value : column.all)
    if (shown.size() < kMaxShown)
      shown.push_back(std::isnan(value) ? "–" : fmt::format("{:g}", value));
  return lab::joined(shown);
}

}  // namespace

std::string columns_text(const lab::Proposal& proposal, const study::ImportChoices& choices) {
  Table table{{{"No.", Align::right},
               {"Heading"},
               {"First values"},
               {"Quantity"},
               {"Unit"},
               {"Sign", Align::right},
               {"Evidence"}},
              {}};
  for (std::size_t i = 0; i < choices.columns.size(); ++i) {
    const study::ColumnChoice& choice = choices.columns[i];
    const bool is_used =
        study::is_of_record(choice.quantity) && study::column_before(choices, choice) == 0;
    table.rows.push_back({fmt::format("{}", choice.position),
                          choice.heading.empty() ? "–" : lab::excerpt(choice.heading),
                          first_values(proposal.table.columns[i]),
                          is_used ? choice.quantity : "not used", is_used ? choice.unit : "",
                          is_used && choice.sign < 0 ? "-1" : "",
                          is_used ? study::choice_evidence(proposal, choice, i) : ""});
  }
  std::string out = to_text(table);
  for (const study::WrittenConstant& one : choices.constants)
    out += fmt::format("{} = {:g} {} in all rows\n", one.quantity, one.value, one.unit);
  for (const study::WrittenValue& one : choices.values)
    out += fmt::format("{} = {:g}\n", one.key, one.value);
  return out;
}

}  // namespace triax::src
