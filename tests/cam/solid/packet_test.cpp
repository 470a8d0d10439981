#include "geometry/mesh/packet.h"

#include <gtest/gtest.h>

namespace gsim::solid::packet_test {

namespace {

std::string packet() {
    PacketWriter writer;
    writer.write(2.5);
    writer.write_text(std::string_view("a\0b", 3));
    writer.write_all(std::vector<int>{1, 2, 3});
    writer.write_all(std::vector<int>{});
    writer.write_flag(true);
    return writer.bytes();
}

TEST(Packet, ReturnsWrittenValues) {
    const std::string bytes = packet();
    PacketReader reader(bytes);
    EXPECT_EQ(reader.read<double>(), 2.5);
    EXPECT_EQ(reader.read_text(), std::string_view("a\0b", 3));
    EXPECT_EQ(reader.read_all<int>(), (std::vector<int>{1, 2, 3}));
    EXPECT_TRUE(reader.read_all<int>().empty());
    EXPECT_TRUE(reader.read_flag());
    EXPECT_TRUE(reader.is_complete());
}

TEST(Packet, DetectsTruncation) {
    const std::string bytes = packet();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        PacketReader reader(std::string_view(bytes).substr(0, length));
        reader.read<double>();
        reader.read_text();
        reader.read_all<int>();
        reader.read_all<int>();
        reader.read_flag();
        EXPECT_FALSE(reader.is_complete()) << length;
    }
    PacketWriter writer;
    writer.write(~std::uint64_t{0});
    PacketReader endless(writer.bytes());
    EXPECT_TRUE(endless.read_all<double>().empty());
    EXPECT_FALSE(endless.is_complete());
}

// Any other byte in a bool would be undefined behaviour.
TEST(Packet, ReadsAnyNonzeroByteAsTrue) {
    PacketWriter writer;
    for (const int byte : {0, 1, 0xf0}) writer.write(static_cast<std::uint8_t>(byte));
    PacketReader reader(writer.bytes());
    EXPECT_FALSE(reader.read_flag());
    EXPECT_TRUE(reader.read_flag());
    EXPECT_TRUE(reader.read_flag());
}

}  // namespace

}  // namespace gsim::solid::packet_test
