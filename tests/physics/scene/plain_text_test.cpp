#include "physics/scene/plain_text.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(PlainText, WhatATerminalWouldActOnIsEscaped) {
  EXPECT_EQ(printable("a\x1b[31m\r\n\t\x7f"), "a\\x1b[31m\\x0d\\x0a\\x09\\x7f");
  EXPECT_EQ(printable("\xc2\x9b"), "\\u009b");  // C1
  EXPECT_EQ(printable("\u202egnp\u2066\u200f"), "\\u202egnp\\u2066\\u200f");
  EXPECT_EQ(printable("\u2028\ufeff"), "\\u2028\\ufeff");
  EXPECT_EQ(printable("\xff\xc0\xaf\xed\xa0\x80"), "\\xff\\xc0\\xaf\\xed\\xa0\\x80");
  EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82");  // cut off
  EXPECT_EQ(printable("Kugel β 球 🎱 \xc3\xa9"), "Kugel β 球 🎱 é");
}

TEST(PlainText, LongOnesAreCutAtWholeCharacters) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc...");
  EXPECT_EQ(shortened("ab\xc3\xa9x", 3), "ab...");
  EXPECT_EQ(shortened(std::string(200'000, 'x'), 10), "xxxxxxxxxx...");
  EXPECT_LT(shortened(std::string(200'000, '\x01'), 60).size(), 70U);
}

TEST(PlainText, BytesThatAreNoUtf8AreReplaced) {
  EXPECT_EQ(valid_utf8("a\xff"
                       "b"),
            "a\uFFFDb");
  EXPECT_EQ(valid_utf8("é"), "é");
  EXPECT_EQ(first_bad_byte("aé\xff"), 3U);
  EXPECT_EQ(first_bad_byte("aé"), 3U);
  EXPECT_EQ(characters("é球"), 2U);
}

}  // namespace
}  // namespace carom
