#include "cli/standalone_pages.h"

#include <string_view>

#include "cli/exit_status.h"
#include "cli/man_page.h"
#include "cli/print.h"
#include "cli/standalone_completion.h"

namespace gsim::apps {

namespace {

std::optional<std::string> make_completion(std::string_view shell, const CommandLine& line) {
    if (shell == "bash") return standalone_bash_completion(line);
    if (shell == "zsh") return standalone_zsh_completion(line);
    if (shell == "fish") return standalone_fish_completion(line);
    return std::nullopt;
}

}  // namespace

std::optional<int> print_standalone_pages(const CommandLine& line, std::span<const std::string> words,
                                          std::span<const std::string> others) {
    if (words.size() == 1 && words.front() == "manual") {
        print(man_page(line, others));
        return kSuccess;
    }
    if (words.size() != 2 || words.front() != "completion") return std::nullopt;
    const auto script = make_completion(words.back(), line);
    if (!script) return std::nullopt;
    print(*script);
    return kSuccess;
}

}  // namespace gsim::apps
