#include <fmt/format.h>

#include <CLI/Error.hpp>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <sstream>

#include "lab/base/bad_input.hpp"
#include "src/cli/application.hpp"
#include "src/cli/manual.hpp"
#include "src/commands.hpp"
#include "src/output/output.hpp"
#include "src/output/table.hpp"

namespace {

constexpr int kDone = 0, kFailed = 1, kBadInput = 2;

int complain(const std::string& message, int status) {
  // A closed standard error must not turn a clear status into an abort, as an exception here would.
  std::fprintf(stderr, "triax: %s\n", triax::src::on_one_line(message).c_str());
  return status;
}

int run(int argc, char** argv) {
  using namespace triax;
  const src::Application application = src::make_application(src::commands());
  // For the build, which installs what this writes; not part of what users are told.
  if (argc == 3 && std::strcmp(argv[1], "--write-manual") == 0) {
    src::write_manual(*application.app, src::commands(), argv[2]);
    return kDone;
  }
  try {
    application.app->parse(argc, argv);
  } catch (const CLI::Success& success) {
    std::ostringstream text;
    const int status = application.app->exit(success, text, text);
    src::print(text.str());
    return status;
  } catch (const CLI::ParseError& error) {
    return complain(fmt::format("{} (see triax --help)", error.what()), kBadInput);
  }
  if (!*application.run) {
    std::fputs(application.app->help().c_str(), stderr);
    return complain("a command is wanted", kBadInput);
  }
  (*application.run)();
  return kDone;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is an error that we can tell, not a silent death
  try {
    return run(argc, argv);
  } catch (const triax::lab::BadInput& error) {
    return complain(error.what(), kBadInput);
  } catch (const std::exception& error) {
    return complain(error.what(), kFailed);
  }
}
