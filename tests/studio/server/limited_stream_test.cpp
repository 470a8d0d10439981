#include "studio/server/limited_stream.h"

#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

namespace gsim::studio {
namespace {

using std::chrono::milliseconds;

/// Both ends of a connection.
class LimitedStreamTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0); }
    void TearDown() override {
        for (const int end : ends_) ::close(end);
    }
    void send(const std::string& text) const {
        ASSERT_EQ(::send(ends_[1], text.data(), text.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(text.size()));
    }
    /// All bytes until the stream ends them.
    static std::size_t drain(LimitedStream& stream) {
        std::size_t all = 0;
        std::array<char, 1000> bytes{};
        for (ssize_t got = 0; (got = stream.read(bytes.data(), bytes.size())) > 0;)
            all += static_cast<std::size_t>(got);
        return all;
    }

    std::array<int, 2> ends_{};
};

TEST_F(LimitedStreamTest, DetectsEndOfHead) {
    for (const std::string& head :
         std::vector<std::string>{"GET / HTTP/1.1\r\nHost: x\r\n\r\n", "GET / HTTP/1.1\n\n"}) {
        LimitedStream stream(ends_[0]);
        send(head);
        std::string bytes(head.size(), ' ');
        ASSERT_EQ(stream.read(bytes.data(), head.size() - 1), static_cast<ssize_t>(head.size()) - 1);
        EXPECT_FALSE(stream.has_head());
        ASSERT_EQ(stream.read(bytes.data(), 1), 1);
        EXPECT_TRUE(stream.has_head());
    }
}

TEST_F(LimitedStreamTest, EndsHeadAboveSizeLimit) {
    LimitedStream stream(ends_[0], {.head_bytes = 5000});
    send(std::string(20'000, 'a'));
    EXPECT_LE(drain(stream), 6000U);
}

TEST_F(LimitedStreamTest, EndsSlowHead) {
    LimitedStream stream(ends_[0], {.head = milliseconds(300), .pause = milliseconds(200)});
    constexpr std::size_t kDrops = 600;  // half a minute, a hundred times as long as a head may take
    std::atomic<bool> is_over = false;
    std::thread dripping([&] {
        for (std::size_t i = 0; i < kDrops && !is_over; ++i) {
            ::send(ends_[1], "a", 1, MSG_NOSIGNAL);
            std::this_thread::sleep_for(milliseconds(50));
        }
    });
    EXPECT_LT(drain(stream), kDrops) << "it ends, though the bytes do not";
    is_over = true;
    dripping.join();
}

TEST_F(LimitedStreamTest, PauseEndsBody) {
    LimitedStream stream(ends_[0], {.pause = milliseconds(50)});
    send("POST / HTTP/1.1\r\n\r\nhalf of it");
    EXPECT_EQ(drain(stream), 29U);
    EXPECT_TRUE(stream.has_head());
}

TEST_F(LimitedStreamTest, WriteFailsIfClientDoesNotRead) {
    LimitedStream stream(ends_[0], {.pause = milliseconds(50)});
    const std::string chunk(100'000, 'a');
    ssize_t sent = 0;
    for (int i = 0; i < 100 && sent >= 0; ++i) sent = stream.write(chunk.data(), chunk.size());
    EXPECT_EQ(sent, -1);
}

TEST_F(LimitedStreamTest, DetectsClosedPeer) {
    const LimitedStream stream(ends_[0]);
    EXPECT_TRUE(stream.is_writable());
    ::shutdown(ends_[1], SHUT_RDWR);
    EXPECT_FALSE(stream.is_writable());
}

}  // namespace
}  // namespace gsim::studio
