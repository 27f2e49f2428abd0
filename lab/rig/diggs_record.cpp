// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/rig/diggs_record.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/diggs/diggs_source.hpp"

namespace triax::lab {
namespace {

constexpr std::size_t kMaxNamedTests = 10;

std::size_t chosen_test(const DiggsDocument& document, std::size_t wanted) {
  auto names = diggs_tests(document);
  if (wanted == 0 && names.size() == 1) return 1;
  if (wanted >= 1 && wanted <= names.size()) return wanted;
  const auto count = names.size();
  if (count > kMaxNamedTests) names.resize(kMaxNamedTests);
  throw BadInput(document.file, 0,
                 fmt::format("{} tests in one file ({}{}); triax replay FILE reads them all", count,
                             joined(names), count > kMaxNamedTests ? ", ..." : ""));
}

}  // namespace

std::unique_ptr<ByteSource> diggs_or_other(std::unique_ptr<ByteSource> source,
                                           const RecordOptions& options) {
  if (!looks_like_diggs(*source)) return source;
  if (options.names_dialect() || !options.sheet.empty())
    throw BadInput(source->name(), 0,
                   "a DIGGS file is read by the names of its elements; leave --dialect and --sheet "
                   "out");
  const auto document = options.tests && options.tests->document
                            ? options.tests->document
                            : std::make_shared<const DiggsDocument>(read_diggs(*source));
  const auto number = chosen_test(*document, options.test);
  return std::make_unique<DiggsSource>(*document, number, std::move(source));
}

void take_diggs_notes(RecordHeader& header, ByteSource& source, Findings& findings) {
  const auto* const diggs = dynamic_cast<const DiggsSource*>(&source);
  if (diggs == nullptr) return;
  header.dialect = "diggs";
  header.notes = diggs->notes();
  for (const Warning& warning : diggs->warnings())
    findings.note(warning.text, warning.line, warning.text);
}

void remove_text_lines(std::vector<Warning>& warnings, ByteSource& source) {
  const auto* const diggs = dynamic_cast<const DiggsSource*>(&source);
  if (diggs == nullptr) return;
  const auto is_of_file = [&](const Warning& warning) {
    return std::ranges::find(diggs->warnings(), warning.text, &Warning::text) !=
           diggs->warnings().end();
  };
  for (Warning& warning : warnings)
    if (!is_of_file(warning)) warning.line = 0;
}

}  // namespace triax::lab
