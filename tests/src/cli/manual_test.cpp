// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/manual.hpp"

#include <catch2/catch.hpp>

#include "lab/base/bad_input.hpp"

using namespace triax::src;

namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A command line that is none of triax's, so that nothing here can come from its own words.
struct Kettle {
  Kettle() : app("boils water", "kettle"), sub(*app.add_subcommand("boil", "it's hot: water")) {
    sub.add_option("CUP", cups, "where to")->type_name("");
    sub.add_option("--heat", heat, "how fast [low]")->type_name("low|high");
    sub.add_flag("--tea,-t", tea, "with tea");
    sub.add_option("--pot", pot, "which pot")->type_name("tea-pot|3d|FILE");
    sub.add_option("--minutes", minutes, "how long")->type_name("MIN")->capture_default_str();
    command.name = "boil";
    command.purpose = "make water hot";
    command.description = {".dots and 'quotes' at the start of a line", "back\\slash"};
    command.diagnostics = {{"no water", "fill it"}};
    command.examples = {{"kettle boil --heat high", "quickly"}};
  }
  CLI::App app;
  CLI::App& sub;
  std::vector<std::string> cups;
  std::string heat;
  bool tea = false;
  std::string pot;
  int minutes = 3;
  Command command;
};

}  // namespace

TEST_CASE("a man page holds what the command says of itself, as roff that hides nothing") {
  const Kettle kettle;
  const auto page = man_page(kettle.sub, kettle.command);
  CHECK(page.rfind(".TH TRIAX\\-BOIL 1 ", 0) == 0);
  CHECK(contains(page, "\n.SH SYNOPSIS\n\\fBtriax boil\\fR [\\fICUP\\fR...]"));
  CHECK(contains(page, ".TP\n\\fB\\-\\-heat\\fR \\fIlow|high\\fR\nhow fast [low]\n"));
  CHECK(contains(page, "\\-t,\\-\\-tea\\fR\nwith tea\n"));
  CHECK(contains(page, "\n\\&.dots and 'quotes'"));
  CHECK(contains(page, "back\\eslash"));
  CHECK(contains(page, ".SH DIAGNOSTICS\n.TP\nno water\nfill it\n"));
  CHECK(contains(page, "\\fBkettle boil \\-\\-heat high\\fR\nquickly\n"));
}

TEST_CASE("completion offers commands, options, and the values of options that have few") {
  const Kettle kettle;
  const auto bash = completion_script(kettle.app, "bash");
  CHECK(contains(bash, "boil) words=\"-h --help --heat -t --tea --pot --minutes\""));
  CHECK(contains(bash, "boil:--heat) words=\"low high\""));
  const auto zsh = completion_script(kettle.app, "zsh");
  CHECK(contains(zsh, "'--heat[how fast \\[low\\]]:value:(low high)'"));
  const auto fish = completion_script(kettle.app, "fish");
  CHECK(contains(fish, "-l heat -d 'how fast [low]' -x -a 'low high'"));
  CHECK_THROWS_AS(completion_script(kettle.app, "tcsh"), triax::lab::BadInput);
}

TEST_CASE("completion_script: offers values with hyphens and digits, no placeholders", "[cli]") {
  const Kettle kettle;
  CHECK(contains(completion_script(kettle.app, "bash"), "boil:--pot) words=\"tea-pot 3d\"; only"));
  CHECK(contains(completion_script(kettle.app, "zsh"), ":value:(tea-pot 3d)'"));
  CHECK(contains(completion_script(kettle.app, "fish"), "-x -a 'tea-pot 3d'"));
}

TEST_CASE("man_page, completion_script: show the default of an option in brackets", "[cli]") {
  const Kettle kettle;
  CHECK(contains(man_page(kettle.sub, kettle.command), "\\fIMIN\\fR\nhow long [3]\n"));
  CHECK(contains(completion_script(kettle.app, "zsh"), "'--minutes[how long \\[3\\]]:value"));
  CHECK(contains(completion_script(kettle.app, "fish"), "-l minutes -d 'how long [3]' -r"));
}

TEST_CASE("quotation marks in a purpose do not end the shell's own") {
  const Kettle kettle;
  CHECK(contains(completion_script(kettle.app, "fish"), "-d 'it\\'s hot: water'"));
  CHECK(contains(completion_script(kettle.app, "zsh"), "'boil:it'\\''s hot\\: water'"));
}
