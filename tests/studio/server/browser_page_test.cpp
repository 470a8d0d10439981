#include "studio/server/browser_page.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/soon.h"

namespace gsim::studio {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Variable of the environment, until this object is destroyed.
class Variable {
  public:
    Variable(const char* name, const std::string& value) : name_(name) {
        if (const char* const before = std::getenv(name)) before_ = before;
        ::setenv(name, value.c_str(), 1);
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    ~Variable() { before_ ? ::setenv(name_, before_->c_str(), 1) : ::unsetenv(name_); }

  private:
    const char* name_;
    std::optional<std::string> before_;
};

std::string content_of(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(BrowserPageTest, BrowserGetsPrivateFileAndSeparateProcessGroup) {
    std::string name = (fs::temp_directory_path() / "browser-XXXXXX").string();
    const fs::path folder = ::mkdtemp(name.data());
    const fs::path said = folder / "said";
    std::ofstream(folder / "xdg-open") << "#!/bin/sh\n{ cut -d ' ' -f 5 /proc/$$/stat; cat \"$1\"; } > '" +
                                              said.string() + ".part'\nmv '" + said.string() + ".part' '" +
                                              said.string() + "'\n";
    fs::permissions(folder / "xdg-open", fs::perms::owner_all);
    {
        const Variable path("PATH", folder.string() + ":" + std::getenv("PATH"));
        const Variable own("XDG_RUNTIME_DIR", folder.string());
        const auto page = BrowserPage::open("http://127.0.0.1:1/token/");
        ASSERT_TRUE(page);
        EXPECT_TRUE(tests::soon([&] { return fs::exists(said); }));
        int status = 0;
        const pid_t browser = ::wait(&status);
        EXPECT_EQ(content_of(said).substr(0, content_of(said).find('\n')), std::to_string(browser));
        EXPECT_THAT(content_of(said), HasSubstr("url=http://127.0.0.1:1/token/"));
        struct stat file {};
        EXPECT_EQ(::stat((folder / ("gsim-studio-" + std::to_string(::getpid()) + ".html")).c_str(), &file),
                  0);
        EXPECT_EQ(file.st_mode & 0777U, 0600U);
    }
    EXPECT_FALSE(fs::exists(folder / ("gsim-studio-" + std::to_string(::getpid()) + ".html")));
    fs::remove_all(folder);
}

}  // namespace
}  // namespace gsim::studio
