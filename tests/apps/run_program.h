#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace gsim::apps {

/// Result of a run of a program.
struct Ended {
    int status = -1;  ///< Its exit status; -1 if a signal ended it.
    std::string out;
    std::string err;
};

/// Runs a program with its arguments in a folder, with that text on standard input.
Ended run_program(const std::string& program, const std::vector<std::string>& arguments,
                  const std::filesystem::path& folder, const std::string& input = {});

/// A folder for each test, with the programs at hand; gone at the end.
class Apps : public testing::Test {
  protected:
    Apps();
    ~Apps() override;

    Ended gcode2lua(const std::vector<std::string>& arguments, const std::string& input = {}) const;
    Ended gsim_run(const std::vector<std::string>& arguments, const std::string& input = {}) const;
    Ended gsim_data(const std::vector<std::string>& arguments) const;
    /// Writes a file into the folder and returns its name.
    std::string write(const std::string& name, const std::string& text) const;
    std::string read(const std::string& name) const;
    bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
    /// Returns the number of files, to check that no file was left.
    std::size_t files() const;

    std::filesystem::path folder_;
};

inline bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace gsim::apps
