// SPDX-License-Identifier: BSD-3-Clause
#include "io/models/read_model.h"

#include "io/error.h"
#include "io/lines/model_edges.h"
#include "io/lines/read_lines.h"
#include "io/models/add_attributes.h"
#include "io/models/write_model.h"
#include "tests/io/models/made_model.h"
#include "tests/support/temp_folder.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <zlib.h>

#include <algorithm>

namespace ridgeline::io {
namespace {

using testing::HasSubstr;

BuildingModel made_model() {
  const std::vector<test::MadeBuilding> made{test::make_building({}),
                                             test::make_building({.position = {40.0, 0.0, 0.0}})};
  BuildingModel model = model_of(made, true);
  model.crs = {"EPSG:25832"};
  return model;
}

std::string compressed(const std::string& text) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 6, Z_DEFLATED, MAX_WBITS + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out(deflateBound(&stream, text.size()), '\0');
  std::string in = text;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// A made model as a file of each format.
class ModelFiles : public testing::Test {
 protected:
  ModelFiles() {
    write_model(folder_.file("a.json"), made_model(), ModelFormat::kCityJson);
    write_model(folder_.file("a.gml"), made_model(), ModelFormat::kCityGml);
  }

  TempFolder folder_;
};

TEST_F(ModelFiles, GiveTheLinesOfTheModelWhateverTheirNames) {
  const std::size_t n_lines = lines_of_model(made_model()).lines.size();
  for (const char* const name : {"a.json", "a.gml"}) {
    const std::string text = folder_.read(name);
    for (const std::string& as : {std::string("b.xyz"), std::string("b.json"), std::string("b")}) {
      const LineSet set = read_lines(folder_.write(as, text));
      EXPECT_EQ(set.lines.size(), n_lines) << name << " as " << as;
      ASSERT_TRUE(set.model);
      EXPECT_EQ(set.crs.definition, "EPSG:25832");
    }
    const LineSet unpacked = read_lines(folder_.write("c.gz", compressed(text)));
    EXPECT_EQ(unpacked.lines.size(), n_lines) << name;
    const std::string cut = compressed(text);
    EXPECT_THROW((void)read_lines(folder_.write("d.gz", cut.substr(0, cut.size() / 2))), IoError);
  }
}

TEST_F(ModelFiles, OfSequencesAreRecognised) {
  nlohmann::json document = nlohmann::json::parse(folder_.read("a.json"));
  nlohmann::json feature{{"type", "CityJSONFeature"},
                         {"CityObjects", document["CityObjects"]},
                         {"vertices", document["vertices"]}};
  document["CityObjects"] = nlohmann::json::object();
  document["vertices"] = nlohmann::json::array();
  const std::string text = document.dump() + "\n" + feature.dump() + "\n";
  for (const char* const name : {"s.city.jsonl", "s.jsonl", "s.json"}) {
    const LineSet set = read_lines(folder_.write(name, text));
    EXPECT_EQ(set.lines.size(), lines_of_model(made_model()).lines.size()) << name;
    EXPECT_EQ(set.format, "CityJSON 2.0 in lines, edges of roofs");
  }
}

TEST_F(ModelFiles, WithoutFacesInTheWantedLevelAreRefused) {
  try {
    (void)read_model(folder_.file("a.json"), {"1.3"});
    FAIL();
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.json: has 2 buildings without faces in LoD 1.3"));
  }
}

TEST_F(ModelFiles, KeepNoAttributeOfAnEarlierTimeThatHasNoNewValue) {
  const std::vector<Column> columns{{"verdict", ColumnType::kText}, {"rms_m", ColumnType::kReal}};
  const std::string text = folder_.read("a.json");
  const auto first =
      with_attributes("a.json", text, columns, {{"2", {{0, std::string("right")}, {1, 0.25}}}});
  const auto second =
      with_attributes("a.json", *first, columns, {{"2", {{0, std::string("gone")}}}});
  const nlohmann::json attributes =
      nlohmann::json::parse(*second)["CityObjects"]["2"]["attributes"];
  EXPECT_EQ(attributes["verdict"], "gone");
  EXPECT_FALSE(attributes.contains("rms_m"));
}

TEST_F(ModelFiles, TakeFurtherAttributesAndKeepAllElse) {
  const std::vector<Column> columns{{"verdict", ColumnType::kText}, {"rms_m", ColumnType::kReal}};
  const std::string text = folder_.read("a.json");
  const BuildingValues values{{"2", {{0, std::string("right")}, {1, 0.25}}}, {"none", {{1, 1.0}}}};
  const nlohmann::json before = nlohmann::json::parse(text);
  nlohmann::json after = nlohmann::json::parse(*with_attributes("a.json", text, columns, values));
  EXPECT_EQ(after["CityObjects"]["2"]["attributes"]["verdict"], "right");
  EXPECT_EQ(after["CityObjects"]["2"]["attributes"]["rms_m"], 0.25);
  for (const char* const name : {"verdict", "rms_m"})
    after["CityObjects"]["2"]["attributes"].erase(name);
  if (!before["CityObjects"]["2"].contains("attributes"))
    after["CityObjects"]["2"].erase("attributes");
  EXPECT_EQ(after, before);
}

TEST(Gzip, RecognisesModelsAndLeavesOtherArchives) {
  const TempFolder folder;
  EXPECT_FALSE(is_model(folder.write("a.gz", compressed("some text"))));
  EXPECT_FALSE(is_model(folder.write("b.gz", "\x1F\x8B")));
  EXPECT_TRUE(is_model(folder.write("c.gz", compressed(R"({"type":"CityJSON","vertices":[]})"))));
}

}  // namespace
}  // namespace ridgeline::io
