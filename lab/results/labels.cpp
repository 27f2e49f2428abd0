// SPDX-License-Identifier: GPL-3.0-or-later
#include "lab/results/labels.hpp"

#include <algorithm>
#include <array>

#include "lab/base/text.hpp"

namespace triax::lab {
namespace {

constexpr auto kLabelKeys = std::to_array<LabelKey>({
    {"project", "Project"},
    {"location", "Location"},
    {"borehole", "Borehole"},
    {"sample", "Sample"},
    {"depth", "Depth (m)"},
    {"description", "Soil"},
    {"specimen_type", "Specimen"},
    {"laboratory", "Laboratory"},
    {"operator", "Operator"},
    {"date", "Begun"},
    {"date_end", "Ended"},
    {"checked", "Checked"},
    {"client", "Client"},
    {"ordered_by", "Ordered by"},
    {"remarks", "Remarks"},
});

/// "specimen_type" -> "Specimen type", as a preamble would name it.
std::string note_label(const LabelKey& label) {
  std::string text(label.key);
  std::ranges::replace(text, '_', ' ');
  text.front() = static_cast<char>(text.front() - 'a' + 'A');
  return text;
}

}  // namespace

std::span<const LabelKey> label_keys() { return kLabelKeys; }

const LabelKey* find_label(std::string_view key) {
  if (key == "depth_m") key = "depth";
  const auto* const found = std::ranges::find(kLabelKeys, key, &LabelKey::key);
  return found == kLabelKeys.end() ? nullptr : found;
}

std::string label_text(const RecordHeader& header, const LabelKey& label) {
  const auto found = std::ranges::find(header.notes, note_label(label), &Note::label);
  return found == header.notes.end() ? std::string() : found->text;
}

void set_label(RecordHeader& header, const LabelKey& label, std::string_view text) {
  const std::string of_note = note_label(label);
  std::erase_if(header.notes, [&](const Note& note) { return note.label == of_note; });
  if (!trimmed(text).empty())
    header.notes.insert(header.notes.begin(), {of_note, std::string(trimmed(text))});
}

}  // namespace triax::lab
