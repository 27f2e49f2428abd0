// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/triaxial/replay/interactive.hpp"

#include <filesystem>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "lab/base/bad_input.hpp"
#include "lab/base/text.hpp"
#include "lab/records/metadata.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"
#include "src/study/intake/import_file.hpp"
#include "src/study/triaxial/tests_of_file.hpp"
#include "src/triaxial/replay/columns_text.hpp"
#include "src/triaxial/replay/import_summary.hpp"

namespace triax::src {
namespace {

namespace fs = std::filesystem;

class Import {
 public:
  Import(const std::string& path, const lab::RecordOptions& options, const Conversation& user)
      : path_(path), options_(options), dialog_(user) {}

  lab::RecordOptions run() {
    const study::ImportFile file = study::read_proposals(path_, options_);
    const lab::Proposal& proposal = file.proposals[chosen_block(file.proposals)];
    dialog_.set_table(proposal, study::usual_choices(proposal, file.source));
    take_stated_values();
    usual_text_ = study::dialect_text(dialog_.choices());
    dialog_.say(fmt::format("{}: {} columns separated by {}, rows from line {}\n\n",
                            on_one_line(fs::path(path_).filename().string()),
                            dialog_.choices().columns.size(),
                            lab::separator_name(dialog_.choices().separator),
                            dialog_.proposal().structure.first_row_line));
    dialog_.say(columns_text(dialog_.proposal(), dialog_.choices()));
    dialog_.say("\nEnter accepts the answer in [ ], ? explains, c N corrects column N, q quits.\n");
    while (true) {
      dialog_.ask_open_questions();
      if (is_confirmed()) return confirmed_;
    }
  }

 private:
  /// Values of a file with metadata beside the record, if there is one.
  lab::RecordHeader values_beside() const {
    lab::RecordHeader out;
    std::error_code none;
    if (dialect_file() == path_ || !fs::is_regular_file(dialect_file(), none)) return out;
    try {
      const auto document = lab::TomlTable::read(dialect_file().string());
      std::optional<lab::Truth> truth;
      if (!document.has("columns")) lab::read_metadata(out, truth, document);
    } catch (const lab::BadInput&) {
      return {};  // reported when the record is read
    }
    return out;
  }

  /// Values of the command line, the job file and a file beside the record: they need no question.
  void take_stated_values() {
    lab::RecordHeader stated = values_beside();
    for (const lab::SetValue& one : options_.job)
      lab::set_metadata(stated, one.where, one.key, one.value);
    for (const auto& [key, value] : options_.sets)
      lab::set_metadata(stated, "--set " + key, key, value);
    for (const char* key : {"specimen.height_mm", "specimen.diameter_mm"})
      if (const auto value = lab::whole_text_as<double>(lab::metadata_text(stated, key)))
        dialog_.choices().set_value(key, *value);
    constexpr double kPerKPa = 1e-3;
    dialog_.choices().programme = stated.programme;
    if (stated.cell_pressure_pa)
      dialog_.choices().set_constant("cell_pressure", *stated.cell_pressure_pa * kPerKPa, "kPa");
  }

  std::size_t chosen_block(const std::vector<lab::Proposal>& proposals) const {
    if (proposals.size() == 1) return 0;
    dialog_.report(
        fmt::format("The file has {} tables side by side. The answers for one "
                    "hold for all.",
                    proposals.size()));
    while (true) {
      const std::string text = dialog_.line(fmt::format("table, 1 to {} [1]: ", proposals.size()));
      if (text.empty()) return 0;
      const auto number = lab::whole_text_as<std::int64_t>(text);
      if (number && *number >= 1 && static_cast<std::size_t>(*number) <= proposals.size())
        return static_cast<std::size_t>(*number) - 1;
      dialog_.report(fmt::format("{} is no table of this file", lab::excerpt(text)));
    }
  }

  /// Options by the answers; those of the call if the file needs none.
  lab::RecordOptions options_by_answers() const {
    lab::RecordOptions out = options_;
    out.dialect_text = study::dialect_text(dialog_.choices());
    return out;
  }

  fs::path dialect_file() const { return fs::path(path_).replace_extension(".toml"); }

  /// Sets confirmed_ and gives the summary. A kind of file that triax knows is read as such unless
  /// an answer changed something.
  std::string summary() {
    is_known_kind_ = false;
    const bool is_unchanged =
        study::dialect_text(dialog_.choices()) == usual_text_ && dialog_.choices().block == 0;
    if (is_unchanged && !fs::exists(dialect_file())) {
      try {
        const auto record = open_shown(options_);
        confirmed_ = options_;
        is_known_kind_ = record->header().dialect != "table";
        return import_summary(*record, {});
      } catch (const lab::BadInput&) {
        is_known_kind_ = false;  // what is wrong is reported below
      }
    }
    confirmed_ = options_by_answers();
    return import_summary(*open_shown(confirmed_), {});
  }

  /// The first test of a file with several, of the table that was chosen.
  std::unique_ptr<lab::RecordedRig> open_shown(const lab::RecordOptions& options) const {
    const auto tests = study::tests_of(lab::tests_in(path_, options));
    const auto shown = study::test_of_block(tests, dialog_.choices().block);
    if (tests.size() > 1)
      dialog_.report(fmt::format("The file has {} tests; all are read. Shown is test {}.",
                                 tests.size(), shown.number));
    return lab::open_record(path_, shown.options(options));
  }

  /// Shows what is read with the answers. False if nothing can be.
  bool show_summary() {
    if (dialog_.has_asked())
      dialog_.say("\n" + columns_text(dialog_.proposal(), dialog_.choices()));
    try {
      dialog_.say("\n" + summary());
      return true;
    } catch (const lab::BadInput& error) {
      dialog_.say("\n");
      dialog_.report(fmt::format("with these answers the file cannot be read: {}", error.what()));
      return false;
    }
  }

  /// False if a column was corrected, so that there may be new questions.
  bool is_confirmed() {
    const bool is_readable = show_summary();
    const std::string prompt = !is_readable          ? "c N or q: "
                               : dialog_.has_asked() ? "read it so? [y/N/s]: "
                                                     : "read it so? [Y/n/s]: ";
    while (true) {
      const std::string text = dialog_.line(prompt);
      const std::string answer = lab::folded(text);
      if (dialog_.correct_column(text)) return false;
      if (answer == "n" || answer == "no" || (answer.empty() && dialog_.has_asked() && is_readable))
        throw QuitImport();
      const bool is_to_read = is_yes(text, !dialog_.has_asked()) || (answer == "s" && is_readable);
      if (is_to_read && is_readable && (answer != "s" || is_saved())) return true;
      if (answer == "?") explain_confirmation();
      if (answer.empty() && !is_readable)
        dialog_.report("correct a column with c N, or quit with q");
      else if (answer != "?" && !is_to_read)
        dialog_.report(lab::excerpt(text) + " is no answer");
    }
  }

  static bool is_yes(const std::string& text, bool is_usual) {
    const std::string answer = lab::folded(text);
    return answer == "y" || answer == "yes" || (answer.empty() && is_usual);
  }

  void explain_confirmation() const {
    dialog_.report(
        fmt::format("y reads and stores the test, n quits and stores nothing, s saves the answers "
                    "in {} and reads the test. Files with the same columns can then be read with "
                    "--dialect. c N corrects column N.",
                    dialect_file().string()));
  }

  /// False if the user does not want an existing file to be replaced, or it cannot be written.
  bool is_saved() {
    const std::string file = dialect_file().string();
    const std::string shown = on_one_line(file);
    if (is_known_kind_) {
      dialog_.report("triax reads files of this kind without a dialect; nothing is saved");
      return true;
    }
    std::error_code none;
    if (file == path_ || fs::is_directory(file, none)) {
      dialog_.report(shown + " cannot be written");
      return false;
    }
    if (fs::exists(fs::symlink_status(file, none)) &&
        !is_yes(dialog_.line(fmt::format("{} exists; replace it? [y/N]: ", shown)), false))
      return false;
    try {
      write_file(file, study::dialect_text(dialog_.choices()));
    } catch (const lab::WorkFailed& error) {
      dialog_.report(error.what());
      return false;
    }
    confirmed_ = options_by_answers();
    dialog_.report("saved " + shown);
    return true;
  }

  const std::string& path_;
  const lab::RecordOptions& options_;
  QuestionDialog dialog_;
  std::string usual_text_;      ///< the dialect without any answer
  bool is_known_kind_ = false;  ///< a shipped dialect reads the file
  lab::RecordOptions confirmed_;
};

}  // namespace

std::optional<lab::RecordOptions> confirm_import(const std::string& path,
                                                 const lab::RecordOptions& options,
                                                 const Conversation& user) {
  try {
    return Import(path, options, user).run();
  } catch (const QuitImport&) {
    return std::nullopt;
  }
}

}  // namespace triax::src
