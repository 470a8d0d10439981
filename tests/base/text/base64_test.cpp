#include "base/text/base64.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::text {
namespace {

std::string encoded(const std::vector<std::string>& chunks) {
    Base64 base64;
    std::string text;
    for (const std::string& chunk : chunks) base64.add(chunk, text);
    base64.end(text);
    return text;
}

TEST(Base64, MatchesTestVectorsOfRfc4648) {  // RFC 4648, section 10
    EXPECT_EQ(encoded({""}), "");
    EXPECT_EQ(encoded({"f"}), "Zg==");
    EXPECT_EQ(encoded({"fo"}), "Zm8=");
    EXPECT_EQ(encoded({"foo"}), "Zm9v");
    EXPECT_EQ(encoded({"foob"}), "Zm9vYg==");
    EXPECT_EQ(encoded({"fooba"}), "Zm9vYmE=");
    EXPECT_EQ(encoded({"foobar"}), "Zm9vYmFy");
    EXPECT_EQ(encoded({std::string("\xff\xfe\xfd\x00", 4)}), "//79AA==");
}

TEST(Base64, IsIndependentOfChunkBorders) {
    const std::string bytes = "a program is looked at in pieces";
    const std::string full = encoded({bytes});
    for (std::size_t first = 0; first <= bytes.size(); ++first) {
        for (std::size_t second = first; second <= bytes.size(); ++second) {
            EXPECT_EQ(
                encoded({bytes.substr(0, first), bytes.substr(first, second - first), bytes.substr(second)}),
                full);
        }
    }
}

}  // namespace
}  // namespace gsim::text
