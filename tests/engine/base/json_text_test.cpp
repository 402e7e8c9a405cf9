#include "engine/base/text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace rift::base {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonText, ReplacesBytesThatAreNoUtf8) {
  EXPECT_EQ(json_text(Json{{"run", "r\xe9sultats"}}), "{\"run\":\"r\uFFFDsultats\"}");
}

TEST(JsonText, HoldsNoControlCharacterAndComesBackAsItWas) {
  const Json value{{"run", "a\x1b[2J\n\x7f\u009b\u0085 µ"}};
  const std::string text = json_text(value);
  EXPECT_EQ(text, "{\"run\":\"a\\u001b[2J\\n\\u007f\\u009b\\u0085 µ\"}");
  EXPECT_EQ(Json::parse(text), value);
}

TEST(JsonText, HasNullForWhatIsNotFinite) {
  EXPECT_EQ(json_text(Json{std::numeric_limits<double>::quiet_NaN(), 1.5}), "[null,1.5]");
}

TEST(JsonText, IndentsAsAsked) { EXPECT_EQ(json_text(Json{{"a", 1}}, 2), "{\n  \"a\": 1\n}"); }

}  // namespace
}  // namespace rift::base
