// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/files/folder_claim.hpp"

#include <catch2/catch.hpp>
#include <optional>

#include "tests/db/temporary_folder.hpp"

using triax::db::FolderClaim;
using Kind = FolderClaim::Kind;
using triax::testing::TemporaryFolder;

TEST_CASE(
    "who removes a file waits for nobody and has to be alone; who opens one may have company") {
  const TemporaryFolder folder;
  const std::string file = folder.file("t.db"), neighbour = folder.file("another.db");
  std::optional<FolderClaim> first(std::in_place, file, Kind::shared);
  CHECK(first->held());
  CHECK(FolderClaim(file, Kind::shared).held());
  CHECK_FALSE(FolderClaim(file, Kind::exclusive).held());
  CHECK_FALSE(FolderClaim(neighbour, Kind::exclusive).held());  // the claim is on the folder
  first.reset();
  CHECK(FolderClaim(file, Kind::exclusive).held());
  CHECK_FALSE(FolderClaim(folder.file("none/t.db"), Kind::exclusive).held());
}
