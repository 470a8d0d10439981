// Rejected bodies: a client that sends one still gets its answer, and holds no resources for long.

#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include "base/os/descriptor.h"
#include "studio/server/buffered_body_stream.h"
#include "studio/server/connections.h"
#include "studio/server/lingering_close.h"
#include "tests/studio/server/studio_server_fixture.h"
#include "tests/support/soon.h"

namespace gsim::studio {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr std::size_t kPiece = std::size_t{1} << 20U;

/// One end of a connection to a server on this machine.
class Client {
  public:
    explicit Client(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(static_cast<std::uint16_t>(port));
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(socket_.number(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        const timeval longest{20, 0};
        ::setsockopt(socket_.number(), SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
    }
    /// Returns true if all of it was sent.
    bool send(std::string_view bytes) const {
        while (!bytes.empty()) {
            const ssize_t sent = ::send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
            if (sent <= 0) return false;
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        }
        return true;
    }
    /// Returns the next data; empty: the end, or no data for long.
    std::string chunk() const {
        std::string bytes(kPiece, '\0');
        bytes.resize(static_cast<std::size_t>(
            std::max<ssize_t>(::recv(socket_.number(), bytes.data(), bytes.size(), 0), 0)));
        return bytes;
    }
    std::string all() const {
        std::string all;
        for (std::string next = chunk(); !next.empty(); next = chunk()) all += next;
        return all;
    }

  private:
    os::Descriptor socket_;
};

class RequestBodyTest : public StudioServerTest {
  protected:
    void SetUp() override {
        StudioServerTest::SetUp();
        begin();
        serving_ = std::thread([this] { server_->serve(); });
    }
    void TearDown() override {
        server_->stop_serving();
        serving_.join();
        StudioServerTest::TearDown();
    }

    std::thread serving_;
};

TEST_F(RequestBodyTest, ClientReceivesStatusOfRejectedBody) {
    struct Refused {
        const char *method, *path, *headers, *status;
    };
    for (const Refused& each : {Refused{"PUT", "file/part.nc", "", "428"},
                                Refused{"PUT", "file/part.nc", "If-Match: \"1-2-3\"\r\n", "412"},
                                Refused{"PUT", "file/.hidden", "If-None-Match: *\r\n", "403"},
                                Refused{"PUT", "file/part.nc", "Origin: http://evil.example\r\n", "403"},
                                Refused{"PUT", "other", "", "404"}, Refused{"POST", "other", "", "404"}}) {
        const Client client(port_);
        const std::string body(kPiece, 'a');
        EXPECT_TRUE(client.send(
            head(each.method, each.path, each.headers + std::string("Content-Length: 4194304\r\n"))));
        EXPECT_TRUE(client.send(body));
        std::this_thread::sleep_for(milliseconds(500));  // a browser that has other things to do
        for (int i = 1; i < 4; ++i) EXPECT_TRUE(client.send(body)) << each.path << " " << each.status;
        EXPECT_THAT(client.all(), StartsWith(std::string("HTTP/1.1 ") + each.status)) << each.path;
    }
    EXPECT_EQ(content("part.nc"), "G1 X1\n");
}

TEST_F(RequestBodyTest, RejectsTooLargeBodyBeforeTransfer) {
    const Client client(port_);
    EXPECT_TRUE(
        client.send(head("PUT", "file/new.nc", "If-None-Match: *\r\nContent-Length: 1073741824\r\n")));
    EXPECT_THAT(client.chunk(), StartsWith("HTTP/1.1 413")) << "no byte of it has been sent";
    for (int i = 0; i < 8; ++i)
        EXPECT_TRUE(client.send(std::string(kPiece, 'a'))) << "it was closed in between";
    EXPECT_FALSE(fs::exists(folder_ / "new.nc"));
}

TEST_F(RequestBodyTest, AnswersExpectContinue) {
    const std::string headers = "If-None-Match: *\r\nExpect: 100-continue\r\nContent-Length: 3\r\n";
    const Client client(port_);
    EXPECT_TRUE(client.send(head("PUT", "file/new.nc", headers)));
    EXPECT_EQ(client.chunk(), "HTTP/1.1 100 Continue\r\n\r\n");
    EXPECT_TRUE(client.send("G0\n"));
    EXPECT_THAT(client.all(), StartsWith("HTTP/1.1 200"));
    EXPECT_EQ(content("new.nc"), "G0\n");
    const Client stranger(port_);
    EXPECT_TRUE(stranger.send(head("PUT", "file/other.nc", headers + "Origin: http://evil.example\r\n")));
    EXPECT_THAT(stranger.chunk(), StartsWith("HTTP/1.1 403"));
}

TEST_F(StudioServerTest, RejectsUnknownRequestWithoutReadingBody) {
    begin();
    MemoryStream stream(head("POST", "other", "Transfer-Encoding: chunked\r\n") + "100000\r\n" +
                        std::string(kPiece, 'a') + "\r\n0\r\n\r\n");
    server_->handle_stream(stream, [] {});
    EXPECT_THAT(stream.answered(), StartsWith("HTTP/1.1 404"));
    EXPECT_TRUE(stream.is_readable());
}

TEST(BufferedBodyStreamTest, ReadsRemainingBodyBeforeResponse) {
    for (const bool sets_all_rotary_axes : {true, false}) {
        MemoryStream stream(sets_all_rotary_axes ? "0123456789next" : "0123");
        BufferedBodyStream full(stream);
        full.expect_body(10);
        std::array<char, 2> bytes{};
        EXPECT_EQ(full.read(bytes.data(), bytes.size()), 2);
        full.write("answer", 6);
        EXPECT_EQ(stream.answered(), "answer");
        EXPECT_EQ(stream.is_readable(), sets_all_rotary_axes) << "what follows the body stays";
    }
}

/// Both ends of a connection.
class ConnectionTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends_.data()), 0); }
    void TearDown() override {
        for (const int end : ends_) ::close(end);
    }
    bool is_ended() const {
        pollfd requested{ends_[1], POLLRDHUP, 0};
        return ::poll(&requested, 1, 0) > 0;
    }

    std::array<int, 2> ends_{};
};

TEST_F(ConnectionTest, LingeringCloseEndsSlowSender) {
    constexpr int kAll = 1000;
    std::atomic<int> sent{0};
    std::thread dripping([&] {
        for (; sent < kAll && ::send(ends_[1], "a", 1, MSG_NOSIGNAL) == 1; ++sent)
            std::this_thread::sleep_for(milliseconds(20));
    });
    lingering_close(ends_[0], {.time = milliseconds(200), .pause = milliseconds(100)});
    EXPECT_LT(sent, kAll);
    EXPECT_TRUE(is_ended());
    ::shutdown(ends_[0], SHUT_RDWR);
    dripping.join();
}

TEST_F(ConnectionTest, LingeringCloseStopsAtByteLimit) {
    const std::string sent(100'000, 'a');
    ASSERT_EQ(::send(ends_[1], sent.data(), sent.size(), MSG_NOSIGNAL), 100'000);
    lingering_close(ends_[0], {.bytes = 1000, .time = milliseconds(20'000), .pause = milliseconds(10'000)});
    int left = 0;
    ASSERT_EQ(::ioctl(ends_[0], FIONREAD, &left), 0);
    EXPECT_GT(left, 0);
}

TEST_F(ConnectionTest, FinishedConnectionFreesCapacity) {
    Connections all(1);
    all.on_open();
    Connections::Entry entry(all, ends_[0]);
    entry.accept_request();
    std::thread coming([&] { all.wait_for_capacity(); });
    std::this_thread::sleep_for(milliseconds(300));
    EXPECT_FALSE(is_ended()) << "it is being answered";
    entry.finish();
    EXPECT_TRUE(tests::soon([&] { return is_ended(); }));
    all.on_close();
    coming.join();
}

}  // namespace
}  // namespace gsim::studio
