// Text of files is safe to print: no control character, no byte that is not UTF-8 is left.
#include "common/core/printable_text.h"

#include <gtest/gtest.h>

namespace gibench::test {
namespace {

TEST(PrintableText, LettersOfEveryAlphabetStay) {
  for (const char* text : {"", "sala.obj: \"a b\" \\ 50% ~", "W/m² · größer – дом 家 𝄞"}) EXPECT_EQ(printable_text(text), text);
}

TEST(PrintableText, LineEndsAndTabsBecomeBlanks) { EXPECT_EQ(printable_text("a\r\nb\tc"), "a  b c"); }

TEST(PrintableText, ControlCharactersAreWrittenOut) {
  EXPECT_EQ(printable_text("a\033[31mb\x7F"), "a\\x1b[31mb\\x7f");
  EXPECT_EQ(printable_text(std::string("\0\x1E\x0E", 3)), "\\x00\\x1e\\x0e");
  EXPECT_EQ(printable_text("\xC2\x9B"
                           "31m"),
            "\\xc2\\x9b31m");  // one character that begins a sequence as well
  EXPECT_EQ(printable_text("\xE2\x80\xAE"
                           "cba"),
            "\\xe2\\x80\\xaecba");  // writes from right to left
}

TEST(PrintableText, BytesThatAreNoUtf8AreWrittenOut) {
  EXPECT_EQ(printable_text("gr\xFC\xDF"), "gr\\xfc\\xdf");                         // Latin-1
  EXPECT_EQ(printable_text("\xC3"), "\\xc3");                                      // cut short
  EXPECT_EQ(printable_text("\xC0\xAF\xE0\x80\xAF"), "\\xc0\\xaf\\xe0\\x80\\xaf");  // longer than need be
  EXPECT_EQ(printable_text("\xED\xA0\x80\xF4\x90\x80\x80"), "\\xed\\xa0\\x80\\xf4\\x90\\x80\\x80");
}

}  // namespace
}  // namespace gibench::test
