#include "base/text/printable.h"

#include <gtest/gtest.h>

namespace gsim::text {
namespace {

TEST(Printable, KeepsReadableText) {
    for (const char* text : {"", "G1 X10\n\tY2\n", "Größe 5 µm, 日本, 🛠", "\\x1b"})
        EXPECT_EQ(printable(text), text);
}

TEST(Printable, EscapesControlCharacters) {
    EXPECT_EQ(printable("\x1b[2Jgone"), "\\u001b[2Jgone");
    EXPECT_EQ(printable("a\rb\x7f"), "a\\u000db\\u007f");
    EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\u0000b");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\u009b31m")
        << "a control character of two bytes";
    EXPECT_EQ(printable("\xe2\x80\xae"
                        "cn.trap"),
              "\\u202ecn.trap")
        << "right to left";
}

TEST(Printable, EscapesInvalidUtf8) {
    EXPECT_EQ(printable("caf\xe9"), "caf\\xe9");
    EXPECT_EQ(printable("\xc0\x9b"), "\\xc0\\x9b") << "longer than it need be";
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "half of a pair";
    EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond the last character";
    EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82") << "ends too early";
}

}  // namespace
}  // namespace gsim::text
