// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/named_by_columns.h"

#include "io/error.h"
#include "io/lines/read_lines.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace ridgeline::io {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kRows =
    "Nr,house,wkt\n"
    "A7,12,\"LINESTRING Z (0 0 5, 5 0 5)\"\n"
    "A7,,\"LINESTRING Z (0 0 5, 0 5 5, 5 9 5)\"\n"
    ",13,\"LINESTRING Z (9 0 5, 5 5 5)\"\n";

LineSet named_by(const std::string& id, const std::string& building) {
  const TempFolder folder;
  return read_lines(folder.write("lines.csv", kRows),
                    {.id_column = id, .building_column = building});
}

std::vector<std::string> values_of(const LineSet& set, std::string Line::*member) {
  std::vector<std::string> values;
  for (const Line& line : set.lines) values.push_back(line.*member);
  return values;
}

TEST(NameByColumns, GivesTheUsersIdsWhateverTheCaseOfTheColumn) {
  const LineSet set = named_by("nr", "");
  EXPECT_THAT(values_of(set, &Line::id), ElementsAre("A7", "A7.0", "A7.1", "2"));
  EXPECT_THAT(values_of(set, &Line::parent_id), ElementsAre("", "A7", "A7", ""));
}

TEST(NameByColumns, GivesBuildingsOnlyToLinesThatHaveOne) {
  EXPECT_THAT(values_of(named_by("", "house"), &Line::building), ElementsAre("12", "", "", "13"));
}

TEST(NameByColumns, UnknownColumnsAreRefusedWithTheKnownOnes) {
  try {
    (void)named_by("number", "");
    FAIL() << "taken";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("has no column number; it has Nr, house"));
  }
}

}  // namespace
}  // namespace ridgeline::io
