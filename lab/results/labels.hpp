// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// Texts of a test that no computation needs: where the specimen came from, who ordered and who made
// the test. Reports and test reports print them.
#include <span>
#include <string>
#include <string_view>

#include "lab/results/record_header.hpp"

namespace triax::lab {

struct LabelKey {
  std::string_view key;    ///< "borehole", of --set labels.borehole=B3
  std::string_view label;  ///< "Borehole", as a test report prints it
};
/// All of them, in the order of the head of a test report.
std::span<const LabelKey> label_keys();

/// The label of the key; nullptr for an unknown key. "depth_m" is another spelling of "depth".
const LabelKey* find_label(std::string_view key);

/// The text of this label; empty if there is none. A line of a preamble that is named like the
/// key ("Specimen type" of specimen_type) counts.
std::string label_text(const RecordHeader& header, const LabelKey& label);

/// Replaces the notes of this label by one with `text`, or removes them if the text is empty. The
/// note is placed first, so that it is stronger than the preamble of the record.
void set_label(RecordHeader& header, const LabelKey& label, std::string_view text);

}  // namespace triax::lab
