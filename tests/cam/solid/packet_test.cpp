#include "geometry/mesh/packet.h"

#include <gtest/gtest.h>

namespace gsim::solid::packet_test {

namespace {

std::string packet() {
    PacketWriter writer;
    writer.put(2.5);
    writer.put_text(std::string_view("a\0b", 3));
    writer.put_all(std::vector<int>{1, 2, 3});
    writer.put_all(std::vector<int>{});
    writer.put_flag(true);
    return writer.bytes();
}

TEST(Packet, GivesBackWhatWasPutIn) {
    const std::string bytes = packet();
    PacketReader reader(bytes);
    EXPECT_EQ(reader.get<double>(), 2.5);
    EXPECT_EQ(reader.get_text(), std::string_view("a\0b", 3));
    EXPECT_EQ(reader.get_all<int>(), (std::vector<int>{1, 2, 3}));
    EXPECT_TRUE(reader.get_all<int>().empty());
    EXPECT_TRUE(reader.get_flag());
    EXPECT_TRUE(reader.is_whole());
}

TEST(Packet, KnowsWhenItWasCutOff) {
    const std::string bytes = packet();
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        PacketReader reader(std::string_view(bytes).substr(0, length));
        reader.get<double>();
        reader.get_text();
        reader.get_all<int>();
        reader.get_all<int>();
        reader.get_flag();
        EXPECT_FALSE(reader.is_whole()) << length;
    }
    PacketWriter writer;
    writer.put(~std::uint64_t{0});
    PacketReader endless(writer.bytes());
    EXPECT_TRUE(endless.get_all<double>().empty());
    EXPECT_FALSE(endless.is_whole());
}

// Any other byte in a bool would be undefined behaviour.
TEST(Packet, AnyByteIsAFlag) {
    PacketWriter writer;
    for (const int byte : {0, 1, 0xf0}) writer.put(static_cast<std::uint8_t>(byte));
    PacketReader reader(writer.bytes());
    EXPECT_FALSE(reader.get_flag());
    EXPECT_TRUE(reader.get_flag());
    EXPECT_TRUE(reader.get_flag());
}

}  // namespace

}  // namespace gsim::solid::packet_test
