#pragma once

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include <unistd.h>

#include "lua_lib/embedded_lua.h"
#include "tests/lua_lib/run.h"

namespace gsim::script {

/// Copy of the library in Lua in a folder of its own, removed at the end.
class LibraryFolder : public testing::Test {
  protected:
    LibraryFolder() {
        folder_ = std::filesystem::temp_directory_path() /
                  ("gsim_library_" + std::to_string(::getpid()) + "_" +
                   testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder_);
        for (const auto& [name, text] : embedded::embedded_lua()) write(std::string(name), std::string(text));
    }
    ~LibraryFolder() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) {
        const std::filesystem::path file = folder_ / name;
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << text;
    }
    void erase(const std::string& name) { std::filesystem::remove(folder_ / name); }
    std::string read(const std::string& name) { return Library(folder_).read(name).value(); }
    /// Writes lines of Lua in front of a text of a file.
    void insert(const std::string& name, const std::string& lines, const std::string& in_front_of) {
        std::string text = read(name);
        const std::size_t location = text.find(in_front_of);
        ASSERT_NE(location, std::string::npos) << name;
        write(name, text.insert(location, lines));
    }
    /// Removes one line from a file.
    void remove(const std::string& name, const std::string& line) {
        std::string text = read(name);
        const std::size_t location = text.find(line + "\n");
        ASSERT_NE(location, std::string::npos) << name;
        write(name, text.erase(location, line.size() + 1));
    }
    Library library() const { return Library(folder_); }
    Outcome run_here(const std::string& lua) {
        Conditions conditions;
        conditions.options.library = library();
        conditions.options.limits.steps = 1'000'000;
        return run_lua(lua, conditions);
    }
    /// Returns the error if the library cannot be loaded.
    std::string error_text() {
        try {
            run_here("G0{x=1}");
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "none";
    }

  private:
    std::filesystem::path folder_;
};

}  // namespace gsim::script
