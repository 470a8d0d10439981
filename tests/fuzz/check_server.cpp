#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "studio/server/studio_server.h"
#include "tests/fuzz/checks.h"
#include "tests/studio/server/memory_stream.h"

namespace gsim::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSecret = "not to be read";
constexpr int kMaxFiles = 20;

std::string content_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Server over a folder with a link out of it; its engine cannot be started, so that no processes are.
class Served {
  public:
    Served() {
        std::string name = (fs::temp_directory_path() / "fuzz-served-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw fs::filesystem_error(name, std::error_code(errno, std::generic_category()));
        around_ = name;
        std::ofstream(around_ / "secret.txt") << kSecret;
        refresh();
        server_ = std::make_unique<studio::StudioServer>(
            studio::ServerContent{.folder = *os::RootedDirectory::open(folder()),
                                  .page = "<!-- server -->",
                                  .engine = {(around_ / "no engine").string()},
                                  .log = [this](const std::string& line) { log_ = line; }});
        port_ = server_->bind(0);
        server_->stop_serving();  // what does not end by itself ends at once
        token_ = server_->address().substr(server_->address().size() - 33, 32);
    }
    ~Served() {
        server_.reset();
        std::error_code ignored;
        fs::remove_all(around_, ignored);
    }

    /// In the request @T represents the token and @P the port, which no input can know.
    std::string handle_request(std::string_view sent) {
        std::string known;
        for (std::size_t i = 0; i < sent.size(); ++i) {
            const std::string_view two = sent.substr(i, 2);
            if (two == "@T" || two == "@P") {
                known += two == "@T" ? token_ : std::to_string(port_);
                ++i;
            } else {
                known += sent[i];
            }
        }
        studio::MemoryStream stream(known);
        log_.clear();
        server_->handle_stream(stream, [] {});
        return stream.answered();
    }
    const std::string& token() const { return token_; }
    const std::string& log() const { return log_; }

    /// Returns true if the outside is unchanged.
    bool untouched() const {
        return content_of(around_ / "secret.txt") == kSecret &&
               std::distance(fs::directory_iterator(around_), {}) == 2;
    }
    void tidy() {
        if (std::distance(fs::recursive_directory_iterator(folder()), {}) > kMaxFiles) refresh();
    }

  private:
    fs::path folder() const { return around_ / "served"; }
    // The folder itself stays: the server has it open.
    void refresh() const {
        fs::create_directories(folder());
        for (const auto& entry : fs::directory_iterator(folder())) fs::remove_all(entry);
        fs::create_directories(folder() / "sub");
        std::ofstream(folder() / "part.nc") << "G0\n";
        fs::create_symlink(around_ / "secret.txt", folder() / "link.nc");
        fs::create_directory_symlink(around_, folder() / "up");
    }

    fs::path around_;
    std::unique_ptr<studio::StudioServer> server_;
    int port_ = 0;
    std::string token_, log_;
};

}  // namespace

Outcome check_server_request(std::string_view sent) {
    static Served served;
    const std::string answered = served.handle_request(sent);
    if (!answered.empty() && answered.rfind("HTTP/1.1 ", 0) != 0) return broken("an answer is no HTTP");
    const bool guessed = sent.find(kSecret) != std::string_view::npos;  // and repeated in an error
    if (!guessed && answered.find(kSecret) != std::string::npos)
        return broken("a file outside of the folder was read");
    if (!served.untouched()) return broken("something outside of the folder was written");
    if (served.log().find(served.token()) != std::string::npos) return broken("the log has the token");
    const bool done = answered.rfind("HTTP/1.1 200", 0) == 0;
    if (done && sent.find("@T") == std::string_view::npos) return broken("it was answered without the token");
    served.tidy();
    return done ? accepted() : rejected();
}

}  // namespace gsim::fuzz
