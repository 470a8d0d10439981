#include "studio/server/studio_server.h"

#include <future>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/studio/server/studio_server_fixture.h"
#include "tests/support/soon.h"

namespace gsim::studio {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST_F(StudioServerTest, ServesPageWithData) {
    begin();
    const std::string page = handle_request("GET", "");
    EXPECT_THAT(page, StartsWith("HTTP/1.1 200"));
    EXPECT_THAT(page, EndsWith(R"(<p>{"folder":"\u003c/script>"}</p>)"));
    EXPECT_THAT(page, HasSubstr("X-Frame-Options: DENY"));
    EXPECT_THAT(page, Not(HasSubstr("Access-Control")));
}

TEST_F(StudioServerTest, ListsReadsAndSavesFiles) {
    begin();
    EXPECT_THAT(handle_request("GET", "files"), HasSubstr(R"("name":"part.nc","bytes":6)"));
    const std::string read = handle_request("GET", "file/part.nc");
    EXPECT_THAT(read, EndsWith("G1 X1\n"));
    const std::size_t at = read.find("ETag: ") + 6;
    const std::string match = "If-Match: " + read.substr(at, read.find('\r', at) - at) + "\r\n";
    EXPECT_THAT(handle_request("PUT", "file/part.nc", "G1 X2\n", match), StartsWith("HTTP/1.1 200"));
    EXPECT_EQ(content("part.nc"), "G1 X2\n");
    const std::string late = handle_request("PUT", "file/part.nc", "G1 X3\n", match);
    EXPECT_THAT(late, StartsWith("HTTP/1.1 412"));
    EXPECT_THAT(late, HasSubstr(R"("tag":")"));
    EXPECT_EQ(content("part.nc"), "G1 X2\n");
    EXPECT_THAT(handle_request("PUT", "file/new%20one.nc", "G0\n", "If-None-Match: *\r\n"),
                StartsWith("HTTP/1.1 200"));
    EXPECT_EQ(content("new one.nc"), "G0\n");
    EXPECT_THAT(handle_request("PUT", "file/part.nc", "G1\n"), StartsWith("HTTP/1.1 428"));
    EXPECT_EQ(content("part.nc"), "G1 X2\n");
}

TEST_F(StudioServerTest, IncompleteBodySavesNothing) {
    begin();
    const std::string head = "PUT /" + token_ +
                             "/file/cut.nc HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) +
                             "\r\nIf-None-Match: *\r\n";
    EXPECT_THAT(raw(head + "Content-Length: 100\r\n\r\nG0\n"), Not(StartsWith("HTTP/1.1 200")));
    EXPECT_THAT(raw(head + "Transfer-Encoding: chunked\r\n\r\n3\r\nG0\n\r\nzz\r\n"),
                Not(StartsWith("HTTP/1.1 200")));
    EXPECT_FALSE(fs::exists(folder_ / "cut.nc"));
    EXPECT_THAT(raw(head + "Transfer-Encoding: chunked\r\n\r\n3\r\nG0\n\r\n0\r\n\r\n"),
                StartsWith("HTTP/1.1 200"));
    EXPECT_EQ(content("cut.nc"), "G0\n");
}

TEST_F(StudioServerTest, RejectsFilesOutsideFolder) {
    begin();
    const fs::path outside = folder_.string() + "-outside";
    std::ofstream(outside) << "secret";
    fs::create_symlink(outside, folder_ / "link.nc");
    const std::string up = outside.filename().string();
    for (const std::string& name : std::vector<std::string>{
             "../" + up, "%2e%2e/" + up, "%2e%2e%2f" + up, "..%5c" + up, "/" + outside.string(),
             "%2f" + outside.string(), std::string("link.nc"), "a/../../" + up, "%252e%252e/" + up,
             "part.nc%00/../" + up, std::string(".hidden")}) {
        EXPECT_THAT(handle_request("GET", "file/" + name), Not(HasSubstr("secret"))) << name;
        EXPECT_THAT(handle_request("GET", "file/" + name), Not(StartsWith("HTTP/1.1 200"))) << name;
        for (const char* version : {"If-None-Match: *\r\n", "If-Match: \"1-2-3\"\r\n"})
            handle_request("PUT", "file/" + name, "written", version);
    }
    std::ifstream file(outside);
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "secret");
    fs::remove(outside);
}

TEST_F(StudioServerTest, ForwardsEngineOutput) {
    begin("printf 'head '; cat");
    EXPECT_THAT(handle_request("POST", "ask", R"({"request":1})"), HasSubstr(R"({"request":1})"));
}

TEST_F(StudioServerTest, ReportsCrashOfEngine) {
    begin("kill -SEGV $$");
    EXPECT_THAT(handle_request("POST", "ask", "{}"),
                HasSubstr(R"("message":"the engine was terminated by signal 11")"));
    EXPECT_THAT(log_, HasSubstr("signal 11"));
}

TEST_F(StudioServerTest, ReturnsStoredMessagesByNumber) {
    // Two messages: eight bytes, and sixteen.
    begin(R"(printf '\010\000\000\000AAAA\020\000\000\000BBBBBBBBBBBB' >&3; echo "$0" "$1" said)");
    EXPECT_THAT(handle_request("POST", "ask", "{}", "Run: 0123456789abcdef\r\nWhole: 7\r\n"),
                HasSubstr("--keep-behind 7 said"));
    EXPECT_THAT(handle_request("GET", "laws/0123456789abcdef/0"), EndsWith("AAAA"));
    EXPECT_THAT(handle_request("GET", "laws/0123456789abcdef/1"), EndsWith("BBBBBBBBBBBB"));
    EXPECT_THAT(handle_request("GET", "laws/0123456789abcdef/2"), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(handle_request("GET", "laws/0000000000000000/0"), StartsWith("HTTP/1.1 404"));
    EXPECT_THAT(handle_request("GET", "laws/0123456789abcdef/-1"), StartsWith("HTTP/1.1 404"));
}

TEST_F(StudioServerTest, CancelledRunDeletesStoredMessages) {
    // Until the page has gone it is there.
    begin(R"(printf '\010\000\000\000AAAA' >&3; printf said; exec sleep 60)");
    std::thread serving([this] { server_->serve(); });
    const std::string ours = "/" + token_;
    const auto laws_status = [&] {
        const auto got = httplib::Client("127.0.0.1", port_).Get(ours + "/laws/0123456789abcdef/0");
        return got ? got->status : 0;
    };
    int meanwhile = 0;
    httplib::Request request;
    request.method = "POST";
    request.path = ours + "/ask";
    request.headers = {{"Run", "0123456789abcdef"}, {"Whole", "7"}, {"Content-Type", "application/json"}};
    request.body = "{}";
    request.content_receiver = [&](const char*, std::size_t, std::uint64_t, std::uint64_t) {
        meanwhile = laws_status();
        return false;
    };
    httplib::Client client("127.0.0.1", port_);
    client.send(request);
    client.stop();
    int behind = 200;
    tests::soon([&] { return (behind = laws_status()) != 200; });
    server_->stop_serving();
    serving.join();
    EXPECT_EQ(meanwhile, 200);
    EXPECT_EQ(behind, 404);
}

TEST_F(StudioServerTest, RejectsInvalidJsonBeforeEngine) {
    begin("echo reached");
    for (const std::string& body : std::vector<std::string>{std::string("{"), std::string(200'000, '['),
                                                            std::string("\xff\xfe"), std::string("1 2")}) {
        const std::string answered = handle_request("POST", "ask", body);
        EXPECT_THAT(answered, StartsWith("HTTP/1.1 400")) << body.substr(0, 10);
        EXPECT_THAT(answered, Not(HasSubstr("reached")));
    }
}

TEST_F(StudioServerTest, RejectsOtherClientsAndLogsWithoutToken) {
    begin();
    const std::string host = "127.0.0.1:" + std::to_string(port_);
    EXPECT_THAT(raw("GET / HTTP/1.1\r\nHost: " + host + "\r\n\r\n"), StartsWith("HTTP/1.1 403"));
    EXPECT_THAT(handle_request("GET", "files", "", "Origin: http://evil.example\r\n"),
                StartsWith("HTTP/1.1 403"));
    EXPECT_THAT(handle_request("DELETE", "file/part.nc"), StartsWith("HTTP/1.1 405"));
    EXPECT_EQ(content("part.nc"), "G1 X1\n");
    EXPECT_THAT(log_, HasSubstr("the origin 'http://evil.example' is not this server"));
    EXPECT_THAT(log_, Not(HasSubstr(token_)));
}

TEST_F(StudioServerTest, DoesNotServeAfterEarlyStop) {
    begin();
    server_->stop_serving();
    auto serving = std::async(std::launch::async, [this] { server_->serve(); });
    EXPECT_EQ(serving.wait_for(std::chrono::seconds(10)), std::future_status::ready);
    server_->stop_serving();
}

TEST_F(StudioServerTest, ServesLocallyUntilStopped) {
    begin("exec sleep 60");
    std::thread serving([this] { server_->serve(); });
    httplib::Client client("127.0.0.1", port_);
    client.set_read_timeout(20);
    std::thread asking([&] { client.Post("/" + token_ + "/ask", "{}", "application/json"); });
    httplib::Result page(nullptr, httplib::Error::Unknown);
    ASSERT_TRUE(tests::soon([&] {
        page = httplib::Client("127.0.0.1", port_).Get("/" + token_ + "/");
        return static_cast<bool>(page);
    }));
    EXPECT_EQ(page->status, 200);
    EXPECT_EQ(page->get_header_value("Connection"), "close");
    const auto before = std::chrono::steady_clock::now();
    server_->stop_serving();
    serving.join();
    asking.join();
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(40))
        << "the engine sleeps for 60 s";
    EXPECT_FALSE(httplib::Client("127.0.0.1", port_).Get("/" + token_ + "/"));
}

}  // namespace
}  // namespace gsim::studio
