#include "tests/faults/job.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/build_files/build_files.h"

extern char** environ;

namespace gsim::faults {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds kHang(60);
constexpr std::chrono::milliseconds kPause(1);

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> found;
    found.reserve(texts.size() + 1);
    for (std::string& text : texts) found.push_back(text.data());
    found.push_back(nullptr);
    return found;
}

std::string variable_name(const std::string& variable) {
    return variable.substr(0, variable.find('=') + 1);
}

std::vector<std::string> environment_with(const std::vector<std::string>& changed) {
    std::vector<std::string> all = changed;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string text = *variable;
        if (std::none_of(changed.begin(), changed.end(),
                         [&](const std::string& each) { return variable_name(each) == variable_name(text); }))
            all.push_back(text);
    }
    return all;
}

// The tally of a run, mapped.
class MappedTally {
  public:
    explicit MappedTally(const fs::path& file) {
        std::ofstream(file) << std::string(sizeof(Tally), '\0');
        const int opened = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
        void* const mapped = ::mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED, opened, 0);
        ::close(opened);
        if (mapped == MAP_FAILED) throw std::runtime_error("no tally");
        tally_ = static_cast<Tally*>(mapped);
    }
    ~MappedTally() { ::munmap(tally_, sizeof(Tally)); }
    MappedTally(const MappedTally&) = delete;
    MappedTally& operator=(const MappedTally&) = delete;
    const Tally& operator*() const { return *tally_; }

  private:
    Tally* tally_;
};

Start start_state(const Job& job, const Conditions& conditions, const fs::path& folder) {
    Start start{.command = job.command, .environment = conditions.environment, .folder = folder / "work"};
    start.command.front() = program_path(job.command.front());
    start.in = folder / "in";
    start.out = folder / "out";
    start.err = folder / "err";
    if (conditions.kind == Kind::count) return start;
    start.environment.push_back(
        fmt::format("LD_PRELOAD={}", tests::build_path("lib/test_modules/libgsim_faults.so")));
    // A sanitizer wants to be loaded first; the preloaded library does not conflict with it.
    start.environment.emplace_back("ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0");
    start.environment.push_back(fmt::format("{}={}", kTallyVariable, (folder / "tally").string()));
    start.environment.push_back(fmt::format("{}={} {} {} {}", kFaultVariable,
                                            static_cast<int>(conditions.kind), conditions.which,
                                            conditions.error, conditions.repeated ? 1 : 0));
    return start;
}

}  // namespace

std::string program_path(const std::string& name) {
    return tests::build_path("bin/") + name;
}

std::string read_file(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

Files read_files(const fs::path& folder) {
    Files files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file())
            files[fs::relative(entry.path(), folder).string()] = read_file(entry.path());
    }
    return files;
}

void write_files(const fs::path& folder, const Files& files) {
    for (const auto& [name, text] : files) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << text;
    }
}

Folder::Folder() {
    static std::atomic<int> count = 0;
    path_ = fs::temp_directory_path() / fmt::format("gsim_faults_{:07}_{:07}", ::getpid(), ++count);
    fs::create_directories(path_);
}

Folder::~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

int start(const Start& start) {
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, start.in.c_str(), O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, start.out.c_str(), O_WRONLY | O_CREAT, 0666);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, start.err.c_str(), O_WRONLY | O_CREAT, 0666);
    ::posix_spawn_file_actions_addchdir_np(&actions, start.folder.c_str());
    // The caller of the tests may ignore signals (nohup), and that is inherited.
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t all;
    ::sigfillset(&all);
    ::posix_spawnattr_setsigdefault(&attributes, &all);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    std::vector<std::string> command = start.command;
    std::vector<std::string> environment = environment_with(start.environment);
    pid_t process = 0;
    const int error = ::posix_spawn(&process, command.front().c_str(), &actions, &attributes,
                                    pointers(command).data(), pointers(environment).data());
    ::posix_spawnattr_destroy(&attributes);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0) throw std::runtime_error("cannot run " + command.front());
    return process;
}

Ended wait_for(int process) {
    const auto end = std::chrono::steady_clock::now() + kHang;
    int state = 0;
    bool hung = false;
    while (::waitpid(process, &state, WNOHANG) == 0) {
        std::this_thread::sleep_for(kPause);
        if (hung || std::chrono::steady_clock::now() < end) continue;
        ::kill(process, SIGKILL);
        hung = true;
    }
    if (hung) return {-1, "a hang"};
    if (WIFEXITED(state)) return {WEXITSTATUS(state), {}};
    return {-1, fmt::format("signal {}", WTERMSIG(state))};
}

Outcome run(const Job& job, const Conditions& conditions) {
    const Folder folder;
    fs::create_directory(folder.path() / "work");
    write_files(folder.path() / "work", job.files);
    write_files(folder.path(), {{"in", job.input}});
    const MappedTally tally(folder.path() / "tally");
    const Ended ended = wait_for(start(start_state(job, conditions, folder.path())));
    Outcome outcome{.status = ended.status, .ended_by = ended.by};
    outcome.out = read_file(folder.path() / "out");
    outcome.err = read_file(folder.path() / "err");
    outcome.files = read_files(folder.path() / "work");
    for (const auto& calls : (*tally).calls) outcome.calls.push_back(calls.load());
    outcome.struck = (*tally).struck.load();
    return outcome;
}

}  // namespace gsim::faults
