// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/page.h"

#include "apps/report/base64.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace ridgeline::apps {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::string base64_of(const std::string& text) {
  return base64(std::as_bytes(std::span<const char>(text)));
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Base64, AgreesWithTheVectorsOfRfc4648) {
  EXPECT_EQ(base64_of(""), "");
  EXPECT_EQ(base64_of("f"), "Zg==");
  EXPECT_EQ(base64_of("fo"), "Zm8=");
  EXPECT_EQ(base64_of("foo"), "Zm9v");
  EXPECT_EQ(base64_of("foob"), "Zm9vYg==");
  EXPECT_EQ(base64_of("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64_of("foobar"), "Zm9vYmFy");
}

TEST(Base64, WritesNumbersLittleEndian) {
  // 01 00 ff fe
  EXPECT_EQ(base64(std::vector<std::uint16_t>{1, 0xfeff}), "AQD//g==");
}

TEST(ScriptSafe, LeavesNothingThatCouldEndTheScriptAndTheSameValue) {
  const std::string hostile = "</script><!-- <script> & 'quote' \"quote\" \\";
  const std::string safe = script_safe(nlohmann::json(hostile).dump());
  EXPECT_THAT(safe, Not(HasSubstr("<")));
  EXPECT_EQ(nlohmann::json::parse(safe).get<std::string>(), hostile);
}

TEST(ReportPage, IsClosedAsOftenAsItIsOpened) {
  const std::string data = R"({"id": "</script><script>alert(1)</script>"})";
  const std::string page = report_page("</title><script>", data, run_front_end());
  EXPECT_THAT(page, StartsWith("<!doctype html>"));
  EXPECT_EQ(count(page, "</script>"), 2U);  // the data and the front end
  EXPECT_EQ(count(page, "</title>"), 1U);
  EXPECT_THAT(page, HasSubstr("<title>&lt;/title&gt;&lt;script&gt;</title>"));
  EXPECT_EQ(count(page, "<style>"), count(page, "</style>"));
}

TEST(ReportPage, AllowsNothingFromTheNetwork) {
  const std::string page = report_page("t", "{}", block_front_end());
  EXPECT_THAT(page, HasSubstr("default-src 'none'; script-src 'unsafe-inline'; style-src "
                              "'unsafe-inline'; img-src data:"));
  EXPECT_THAT(page, Not(HasSubstr("<script src")));
  EXPECT_THAT(page, Not(HasSubstr("rel=\"stylesheet\"")));
}

TEST(FrontEnd, IsEmbedded) {
  for (const FrontEnd& front_end : {run_front_end(), block_front_end()}) {
    EXPECT_GT(front_end.script.size(), 10000U);
    EXPECT_GT(front_end.style.size(), 1000U);
    EXPECT_THAT(std::string(front_end.style), Not(HasSubstr("</style")));
    EXPECT_THAT(std::string(front_end.script), Not(HasSubstr("sourceMappingURL")));
  }
}

TEST(FrontEnd, OfABlockIsSmallAsEveryPatchHasACopy) {
  EXPECT_LT(block_front_end().script.size() + block_front_end().style.size(), 60000U);
}

}  // namespace
}  // namespace ridgeline::apps
