#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "studio/server/studio_server.h"
#include "tests/studio/server/memory_stream.h"

namespace gsim::studio {

namespace fs = std::filesystem;

/// Server over a folder, with a shell as its engine.
class StudioServerTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "served-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
        std::ofstream(folder_ / "part.nc") << "G1 X1\n";
    }
    void TearDown() override {
        server_.reset();
        fs::remove_all(folder_);
    }
    void begin(const std::string& engine = "cat") {
        server_ = std::make_unique<StudioServer>(
            ServerContent{.folder = *os::RootedDirectory::open(folder_),
                          .page = "<p><!-- server --></p>",
                          .page_data = {{"folder", "</script>"}},
                          .engine = {"/bin/sh", "-c", engine},
                          .log = [this](const std::string& line) { log_ += line + "\n"; }});
        port_ = server_->bind(0);
        ASSERT_GT(port_, 0);
        const std::string address = server_->address();
        token_ = address.substr(address.size() - 33, 32);
    }
    /// Returns the response to the words of a request after the token.
    std::string handle_request(const std::string& method, const std::string& path,
                               const std::string& body = "", const std::string& headers = "") const {
        return raw(method + " /" + token_ + "/" + path +
                   " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n" + headers +
                   (body.empty() ? "" : "Content-Length: " + std::to_string(body.size()) + "\r\n") + "\r\n" +
                   body);
    }
    std::string head(const std::string& method, const std::string& path, const std::string& headers) const {
        return method + " /" + token_ + "/" + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) +
               "\r\n" + headers + "\r\n";
    }
    std::string raw(const std::string& sent) const {
        MemoryStream stream(sent);
        server_->handle_stream(stream, [] {});
        return stream.answered();
    }
    std::string content(const std::string& name) const {
        std::ifstream file(folder_ / name);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    fs::path folder_;
    std::unique_ptr<StudioServer> server_;
    int port_ = 0;
    std::string token_, log_;
};

}  // namespace gsim::studio
