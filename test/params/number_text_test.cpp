// SPDX-License-Identifier: BSD-3-Clause
#include "pomdp_crowd_nav/params/number_text.h"

#include <gtest/gtest.h>

namespace pomdp_crowd_nav {
namespace {

TEST(NumberText, ParsesWholeNumbersOnly) {
  EXPECT_EQ(parseDouble("-1.5e2"), -150.0);
  EXPECT_EQ(parseDouble(".5"), 0.5);
  EXPECT_EQ(parseInteger("-9000000000"), -9000000000);
  for (const char* text : {"", " 1", "1 ", "1.0.0", "1,5", "nan", "inf", "1e999", "one"}) {
    EXPECT_EQ(parseDouble(text), std::nullopt) << text;
    EXPECT_EQ(parseInteger(text), std::nullopt) << text;
  }
  EXPECT_EQ(parseInteger("1.5"), std::nullopt);
  EXPECT_EQ(parseInteger("99999999999999999999"), std::nullopt);
}

TEST(NumberText, WritesLists) {
  EXPECT_EQ(toText({}), "[]");
  EXPECT_EQ(toText({1.0, -2.5}), "[1, -2.5]");
}

}  // namespace
}  // namespace pomdp_crowd_nav
