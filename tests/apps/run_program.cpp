#include "tests/apps/run_program.h"

#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/build_files/build_files.h"

namespace gsim::apps {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

// Files and not pipes, so that no amount of text can make the two wait for each other.
TemporaryFile temporary_file(const std::string& text = {}) {
    TemporaryFile file(std::tmpfile());
    if (file == nullptr) throw std::runtime_error("no temporary file");
    std::fwrite(text.data(), 1, text.size(), file.get());
    std::rewind(file.get());
    return file;
}

std::string read_file_text(std::FILE* file) {
    std::string text;
    std::rewind(file);
    for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text += static_cast<char>(c);
    return text;
}

}  // namespace

Ended run_program(const std::string& program, const std::vector<std::string>& arguments,
                  const fs::path& folder, const std::string& input) {
    const TemporaryFile in = temporary_file(input), out = temporary_file(), err = temporary_file();
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        ::dup2(::fileno(in.get()), 0);
        ::dup2(::fileno(out.get()), 1);
        ::dup2(::fileno(err.get()), 2);
        if (::chdir(folder.c_str()) == 0) ::execv(program.c_str(), argv.data());
        ::_exit(127);
    }
    int state = 0;
    ::waitpid(child, &state, 0);
    Ended ended;
    if (WIFEXITED(state)) ended.status = WEXITSTATUS(state);
    ended.out = read_file_text(out.get());
    ended.err = read_file_text(err.get());
    return ended;
}

Apps::Apps()
    : folder_(fs::temp_directory_path() / ("gsim_apps_" + std::to_string(::getpid()) + "_" +
                                           testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(folder_);
}

Apps::~Apps() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

Ended Apps::gcode2lua(const std::vector<std::string>& arguments, const std::string& input) const {
    return run_program(tests::program_path("gcode2lua"), arguments, folder_, input);
}

Ended Apps::gsim_run(const std::vector<std::string>& arguments, const std::string& input) const {
    return run_program(tests::program_path("gsim-run"), arguments, folder_, input);
}

Ended Apps::gsim_data(const std::vector<std::string>& arguments) const {
    return run_program(tests::program_path("gsim-data"), arguments, folder_);
}

std::string Apps::write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return name;
}

std::string Apps::read(const std::string& name) const {
    std::ifstream file(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t Apps::files() const {
    return static_cast<std::size_t>(
        std::distance(fs::recursive_directory_iterator(folder_), fs::recursive_directory_iterator()));
}

}  // namespace gsim::apps
