#include "studio/server/access_check.h"

#include <set>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::studio {
namespace {

constexpr int kPort = 4242;
const std::string kToken = "0123456789abcdef0123456789abcdef";

class AccessCheckTest : public testing::Test {
  protected:
    AccessCheckTest() {
        request_.method = "POST";
        request_.path = request_.target = "/" + kToken + "/ask";
        request_.headers.emplace("Host", "127.0.0.1:4242");
    }
    void set(const std::string& name, const std::string& value) {
        request_.headers.erase(name);
        request_.headers.emplace(name, value);
    }
    int status() const {
        const auto rejection = guard_.reject(request_);
        return rejection ? rejection->status : 200;
    }

    AccessCheck guard_{kPort, kToken};
    httplib::Request request_;
};

TEST_F(AccessCheckTest, AcceptsRequestsOfPage) {
    EXPECT_EQ(status(), 200);
    set("Origin", "http://127.0.0.1:4242");
    set("Sec-Fetch-Site", "same-origin");
    EXPECT_EQ(status(), 200);
    set("Host", "localhost:4242");
    set("Origin", "http://localhost:4242");
    EXPECT_EQ(status(), 200);
}

TEST_F(AccessCheckTest, RejectsOtherHosts) {
    for (const char* host :
         {"evil.example:4242", "127.0.0.1", "127.0.0.1:4243", "127.0.0.1:4242.evil.example", ""}) {
        set("Host", host);
        EXPECT_EQ(status(), 403) << host;
    }
    request_.headers.erase("Host");
    EXPECT_EQ(status(), 403);
    request_.headers.emplace("Host", "127.0.0.1:4242");
    request_.headers.emplace("Host", "127.0.0.1:4242");
    EXPECT_EQ(status(), 403) << "twice";
}

TEST_F(AccessCheckTest, RejectsOtherOrigins) {
    for (const char* origin :
         {"http://evil.example", "null", "", "https://127.0.0.1:4242", "http://127.0.0.1:80",
          "http://127.0.0.1:4242.evil.example", "http://127.0.0.1:4242/"}) {
        set("Origin", origin);
        EXPECT_EQ(status(), 403) << origin;
    }
}

TEST_F(AccessCheckTest, OtherSitesMayOnlyLinkToPage) {
    for (const char* site : {"cross-site", "same-site"}) {
        set("Sec-Fetch-Site", site);
        request_.method = "GET";
        request_.path = "/" + kToken + "/";
        EXPECT_EQ(status(), 200) << site;
        request_.path += "files";
        EXPECT_EQ(status(), 403) << site;
    }
}

TEST_F(AccessCheckTest, RejectsMissingOrWrongToken) {
    for (const std::string& path : std::vector<std::string>{
             "/", "/ask", "/" + kToken, "//" + kToken + "/ask", "/" + kToken.substr(1) + "/ask",
             "/" + kToken + "0/ask", "/../" + kToken + "/ask", "*", ""}) {
        request_.path = path;
        EXPECT_EQ(status(), 403) << path;
        const auto rejection = guard_.reject(request_);
        EXPECT_EQ(rejection->message.find(kToken), std::string::npos) << "the log does not have it";
    }
}

TEST_F(AccessCheckTest, RejectsOtherMethodsAndLongUrls) {
    for (const char* method : {"DELETE", "OPTIONS", "PATCH", "CONNECT", "TRACE", "HEAD"}) {
        request_.method = method;
        EXPECT_EQ(status(), 405) << method;
    }
    request_.method = "GET";
    request_.target += std::string(5000, 'a');
    EXPECT_EQ(status(), 414);
}

TEST(RandomTokenTest, TokensAreUnique) {
    std::set<std::string> all;
    for (int i = 0; i < 1000; ++i) {
        const std::string token = random_token();
        EXPECT_EQ(token.size(), 32U);
        EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
        all.insert(token);
    }
    EXPECT_EQ(all.size(), 1000U);
}

}  // namespace
}  // namespace gsim::studio
