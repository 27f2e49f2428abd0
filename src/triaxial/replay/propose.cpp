// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/propose.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "src/study/intake/import_file.hpp"
#include "src/study/intake/proposed_dialect.hpp"
#include "src/triaxial/replay/proposal_text.hpp"

namespace triax::src {

std::string proposal_of(const std::string& path, const lab::RecordOptions& options,
                        ProposalFormat format) {
  const study::ImportFile file = study::read_proposals(path, options);
  const std::string name = std::filesystem::path(path).filename().string();
  if (format == ProposalFormat::meaning)
    return meaning_text(file.proposals, name, file.source.encoding);
  std::string out =
      study::write_dialect(study::proposed_dialect(file.proposals.front(), name, file.source));
  if (file.proposals.size() > 1)
    out +=
        fmt::format("# The {} tables side by side have the same columns: this is the first one.\n",
                    file.proposals.size());
  return out;
}

}  // namespace triax::src
