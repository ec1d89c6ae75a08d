#include "synthesis/report/json_text.h"

#include <gtest/gtest.h>

namespace mechwright {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonText, KeepsPlainListsOnOneLine) {
    const Json json{{"a", 1}, {"points", {{1.5, 2.0}, {3.0, 4.25}}}, {"none", Json::array()}, {"o", Json::object()}};
    EXPECT_EQ(json_text(json),
              "{\n"
              "  \"a\": 1,\n"
              "  \"points\": [\n"
              "    [1.5, 2.0],\n"
              "    [3.0, 4.25]\n"
              "  ],\n"
              "  \"none\": [],\n"
              "  \"o\": {}\n"
              "}\n");
}

TEST(JsonText, ReadsBackAsTheSame) {
    const Json json{{"third", 1.0 / 3}, {"tiny", 5e-324}, {"text", "a \"quoted\"\nline\tü"}, {"yes", true}, {"n", {}}};
    EXPECT_EQ(Json::parse(json_text(json)), json);
}

TEST(JsonText, ReplacesBytesThatAreNotText) {
    const Json json{{"file\xff", "\xfe.toml"}};
    EXPECT_NO_THROW(EXPECT_TRUE(Json::accept(json_text(json))));
}

}  // namespace
}  // namespace mechwright
