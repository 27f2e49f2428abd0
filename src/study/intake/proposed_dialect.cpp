// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/study/intake/proposed_dialect.hpp"

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "src/study/intake/column_evidence.hpp"

namespace triax::study {

WrittenDialect proposed_dialect(const lab::Proposal& proposal, const std::string& file,
                                const ImportSource& source) {
  ImportChoices choices = usual_choices(proposal, source);
  for (std::size_t i = 0; i < choices.columns.size(); ++i) {
    const lab::ColumnReading& reading = proposal.meaning.columns[i].reading;
    ColumnChoice& choice = choices.columns[i];
    if (!reading.quantity || reading.quantity->name != choice.quantity) continue;
    choice.note = fmt::format("{}: {}", lab::excerpt(choice.heading), column_evidence(proposal, i));
    if (reading.unit_source == lab::UnitSource::asked) choice.unit = "?";
  }
  WrittenDialect out = dialect_of(choices);
  out.remark = fmt::format(
      "How triax understands {}. Each column has its evidence; larger numbers are surer.", file);
  for (const lab::LabelValue& label : proposal.labels)
    if (label.value)
      out.remarks.push_back(fmt::format(
          "{}: {} = {:g}", label.line > 0 ? fmt::format("line {}", label.line) : "other worksheet",
          label.name, *label.value));
  for (const lab::TableQuestion& question : proposal.questions)
    out.remarks.push_back(fmt::format("? {}: {}", question.text, question.remedy));
  return out;
}

}  // namespace triax::study
