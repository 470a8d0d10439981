// When preloaded into a program, it counts the program's system calls from the first line of main() on, and
// lets one call fail (see fault.h). Allocations are caught by their names. Calls inside the C library, such
// as the writes of stdio, have no name that could be caught. There a filter of system calls sends a signal,
// and its handler does the call, or does not.

#include <bit>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include <dlfcn.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <ucontext.h>
#include <unistd.h>

#include "tests/faults/fault.h"

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace gsim::faults {

namespace {

struct InjectedFault {
    Kind kind = Kind::count;
    std::uint64_t which = 0;
    int error = kShort;
    bool repeated = false;
};

// A preloaded library receives no arguments: its state can only be here.
Tally* tally = nullptr;
InjectedFault injected_fault;

// Returns how this call fails, if it does.
std::optional<int> next_call(Kind kind) {
    if (tally == nullptr) return std::nullopt;
    const std::uint64_t number = ++tally->calls[static_cast<std::size_t>(kind)];
    if (kind != injected_fault.kind || injected_fault.which == 0 || number < injected_fault.which ||
        (number > injected_fault.which && !injected_fault.repeated))
        return std::nullopt;
    ++tally->struck;
    return injected_fault.error;
}

bool refused_memory() {
    const bool rejected = next_call(Kind::allocation).has_value();
    if (rejected) errno = ENOMEM;
    return rejected;
}

struct Call {
    long number;
    Kind kind;
};

constexpr Call kCalls[] = {
    {SYS_write, Kind::write},     {SYS_writev, Kind::write},     {SYS_pwrite64, Kind::write},
    {SYS_read, Kind::read},       {SYS_readv, Kind::read},       {SYS_pread64, Kind::read},
    {SYS_openat, Kind::open},     {SYS_close, Kind::close},      {SYS_fsync, Kind::fsync},
    {SYS_fdatasync, Kind::fsync}, {SYS_renameat2, Kind::rename}, {SYS_fchmod, Kind::mode},
    {SYS_flock, Kind::lock},      {SYS_dup, Kind::copy},         {SYS_memfd_create, Kind::memory},
    {SYS_ftruncate, Kind::size},  {SYS_newfstatat, Kind::look},  {SYS_fstat, Kind::look},
    {SYS_readlinkat, Kind::look}, {SYS_faccessat, Kind::look},   {SYS_faccessat2, Kind::look},
    {SYS_unlinkat, Kind::remove},
#ifdef SYS_open  // the older half, which some systems do without
    {SYS_open, Kind::open},       {SYS_rename, Kind::rename},    {SYS_renameat, Kind::rename},
    {SYS_stat, Kind::look},       {SYS_lstat, Kind::look},       {SYS_readlink, Kind::look},
    {SYS_access, Kind::look},     {SYS_unlink, Kind::remove},
#endif
};
constexpr std::size_t kCallCount = std::size(kCalls);

// Sixth argument of calls that the handler makes; none of our other calls has it.
constexpr long kOurs = 0x67736d66;

struct Arguments {
    long values[5];
};

#if defined(__x86_64__)
constexpr unsigned kMachine = AUDIT_ARCH_X86_64;
Arguments call_arguments(const mcontext_t& at) {
    return {{at.gregs[REG_RDI], at.gregs[REG_RSI], at.gregs[REG_RDX], at.gregs[REG_R10], at.gregs[REG_R8]}};
}
void set_result(mcontext_t& at, long value) {
    at.gregs[REG_RAX] = value;
}
#elif defined(__aarch64__)
constexpr unsigned kMachine = AUDIT_ARCH_AARCH64;
Arguments call_arguments(const mcontext_t& at) {
    Arguments found{};
    for (std::size_t i = 0; i < std::size(found.values); ++i) found.values[i] = static_cast<long>(at.regs[i]);
    return found;
}
void set_result(mcontext_t& at, long value) {
    at.regs[0] = static_cast<unsigned long long>(value);
}
#else
#error "the registers of this machine are not known here"
#endif

// The value as the kernel gives it: errors are negative.
long done(long number, const Arguments& given) {
    const long* const values = given.values;
    const long value = ::syscall(number, values[0], values[1], values[2], values[3], values[4], kOurs);
    return value < 0 ? -errno : value;
}

long half(long size) {
    return size > 1 ? size / 2 : size;
}

// Writes or reads half of the data; of several parts, half of the first that is not empty.
long done_in_part(long number, Arguments given) {
    long* const values = given.values;
    if (number == SYS_writev || number == SYS_readv) {
        const auto* io_vector = std::bit_cast<const iovec*>(values[1]);
        for (long remaining = values[2]; remaining > 1 && io_vector->iov_len == 0; --remaining) ++io_vector;
        values[1] = reinterpret_cast<long>(io_vector->iov_base);
        values[2] = static_cast<long>(io_vector->iov_len);
        number = number == SYS_writev ? SYS_write : SYS_read;
    }
    values[2] = half(values[2]);
    return done(number, given);
}

Kind fault_kind(long number) {
    for (const Call& call : kCalls) {
        if (call.number == number) return call.kind;
    }
    return Kind::count;
}

long handle_request(long number, const Arguments& given) {
    const Kind kind = fault_kind(number);
    const std::optional<int> error = next_call(kind);
    if (!error) return done(number, given);
    if (*error < 0) {
        ::kill(::getpid(), -*error);
        return done(number, given);
    }
    if (*error == kShort) return done_in_part(number, given);
    // Linux has closed a file even if it reports an error for it.
    if (kind == Kind::close) static_cast<void>(done(number, given));
    return -*error;
}

extern "C" void handle_call(int, siginfo_t* info, void* context) {
    const int error = errno;
    mcontext_t& at = static_cast<ucontext_t*>(context)->uc_mcontext;
    set_result(at, handle_request(info->si_syscall, call_arguments(at)));
    errno = error;
}

constexpr auto kSixthArgument =
    static_cast<unsigned>(offsetof(seccomp_data, args) + 5 * sizeof(std::uint64_t));

bool filter_calls() {
    struct sigaction action {};
    action.sa_sigaction = handle_call;
    action.sa_flags = SA_SIGINFO | SA_NODEFER;
    sigemptyset(&action.sa_mask);
    if (::sigaction(SIGSYS, &action, nullptr) != 0) return false;
    sock_filter program[kCallCount + 8] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, arch)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kMachine, 0, kCallCount + 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, kSixthArgument),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kOurs, kCallCount + 1, 0),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
    };
    std::size_t length = 5;
    for (std::size_t i = 0; i < kCallCount; ++i) {
        program[length++] = BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(kCalls[i].number),
                                     static_cast<unsigned char>(kCallCount - i), 0);
    }
    program[length++] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW);
    program[length++] = BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_TRAP);
    const sock_fprog full{static_cast<unsigned short>(length), program};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &full) == 0;
}

InjectedFault fault_asked_for() {
    const char* const requested = std::getenv(kFaultVariable);
    unsigned kind = 0;
    unsigned long which = 0;
    int error = 0;
    int repeated = 0;
    if (requested == nullptr || std::sscanf(requested, "%u %lu %d %d", &kind, &which, &error, &repeated) != 4)
        return {};
    return {static_cast<Kind>(kind), which, error, repeated != 0};
}

Tally* map_tally(const char* name) {
    const int file = ::open(name, O_RDWR | O_CLOEXEC);
    if (file < 0) return nullptr;
    void* const mapped = ::mmap(nullptr, sizeof(Tally), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    ::close(file);
    return mapped == MAP_FAILED ? nullptr : static_cast<Tally*>(mapped);
}

// Status 125: the program did not start.
constexpr int kNotStarted = 125;

void begin() {
    const char* const name = std::getenv(kTallyVariable);
    if (name == nullptr) return;
    injected_fault = fault_asked_for();
    Tally* const mapped = map_tally(name);
    // Programs that this one runs are run as they are.
    for (const char* variable : {kTallyVariable, kFaultVariable, "LD_PRELOAD"}) ::unsetenv(variable);
    if (mapped == nullptr) ::_exit(kNotStarted);
    if (injected_fault.kind != Kind::allocation && !filter_calls()) ::_exit(kNotStarted);
    tally = mapped;
}

using Main = int (*)(int, char**, char**);

Main& program_main() {
    static Main found = nullptr;
    return found;
}

int main_with_faults(int count, char** arguments, char** environment) {
    begin();
    return program_main()(count, arguments, environment);
}

}  // namespace

}  // namespace gsim::faults

#define GSIM_SHOWN extern "C" [[gnu::visibility("default")]]

GSIM_SHOWN void* malloc(std::size_t size) {
    return gsim::faults::refused_memory() ? nullptr : __libc_malloc(size);
}

GSIM_SHOWN void* calloc(std::size_t count, std::size_t size) {
    return gsim::faults::refused_memory() ? nullptr : __libc_calloc(count, size);
}

GSIM_SHOWN void* realloc(void* old, std::size_t size) {
    return gsim::faults::refused_memory() ? nullptr : __libc_realloc(old, size);
}

GSIM_SHOWN void* memalign(std::size_t alignment, std::size_t size) {
    return gsim::faults::refused_memory() ? nullptr : __libc_memalign(alignment, size);
}

GSIM_SHOWN void* aligned_alloc(std::size_t alignment, std::size_t size) {
    return memalign(alignment, size);
}

GSIM_SHOWN int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
    void* const got = memalign(alignment, size);
    if (got == nullptr) return ENOMEM;
    *result = got;
    return 0;
}

GSIM_SHOWN int __libc_start_main(gsim::faults::Main main, int count, char** arguments, void (*begin)(),
                                 void (*end)(), void (*unload)(), void* stack_end) {
    using Start = int (*)(gsim::faults::Main, int, char**, void (*)(), void (*)(), void (*)(), void*);
    const auto start = reinterpret_cast<Start>(::dlsym(RTLD_NEXT, "__libc_start_main"));
    gsim::faults::program_main() = main;
    return start(gsim::faults::main_with_faults, count, arguments, begin, end, unload, stack_end);
}
