// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/reference/reference_words.hpp"

#include <fmt/format.h>

#include "lab/base/text.hpp"
#include "src/output/words.hpp"

namespace triax::src {
namespace {

std::string depth(std::optional<double> metres) {
  return metres ? with_unit(number(metres, 2), "m") : std::string();
}

}  // namespace

std::string what_it_is(const lab::AgsResults& file) {
  const std::size_t count = file.results.size();
  return fmt::format("AGS4 results without readings, nothing to assess; {} triaxial result{}",
                     count, count == 1 ? "" : "s");
}

std::string sample_of(const lab::ReferenceSpecimen& specimen) {
  const std::string& id =
      specimen.sample_reference.empty() ? specimen.sample_id : specimen.sample_reference;
  return lab::joined({lab::joined({id, specimen.sample_type}, " "), depth(specimen.sample_top_m)});
}

std::string specimen_of(const lab::ReferenceSpecimen& specimen) {
  return lab::joined({specimen.specimen_reference, depth(specimen.specimen_depth_m)});
}

}  // namespace triax::src
