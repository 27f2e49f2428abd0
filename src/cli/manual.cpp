// SPDX-License-Identifier: GPL-3.0-or-later
#include "src/cli/manual.hpp"

#include <filesystem>

#include "src/output/output.hpp"

namespace triax::src {

void write_manual(const CLI::App& app, const std::vector<Command>& commands,
                  const std::string& folder) {
  const std::filesystem::path root(folder);
  std::filesystem::create_directories(root);
  write_file((root / "triax.1").string(), man_page(app));
  for (const auto& command : commands)
    write_file((root / ("triax-" + command.name + ".1")).string(),
               man_page(*app.get_subcommand(command.name), command));
  write_file((root / "triax.bash").string(), completion_script(app, "bash"));
  write_file((root / "_triax").string(), completion_script(app, "zsh"));
  write_file((root / "triax.fish").string(), completion_script(app, "fish"));
}

}  // namespace triax::src
