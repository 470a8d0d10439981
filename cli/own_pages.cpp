#include "cli/own_pages.h"

#include <string_view>

#include "cli/exit_status.h"
#include "cli/man_page.h"
#include "cli/own_completion.h"
#include "cli/print.h"

namespace gsim::apps {

namespace {

std::optional<std::string> completion_of(std::string_view shell, const CommandLine& line) {
    if (shell == "bash") return own_bash_completion(line);
    if (shell == "zsh") return own_zsh_completion(line);
    if (shell == "fish") return own_fish_completion(line);
    return std::nullopt;
}

}  // namespace

std::optional<int> print_own_pages(const CommandLine& line, std::span<const std::string> words,
                                   std::span<const std::string> others) {
    if (words.size() == 1 && words.front() == "manual") {
        print(man_page(line, others));
        return kDone;
    }
    if (words.size() != 2 || words.front() != "completion") return std::nullopt;
    const auto script = completion_of(words.back(), line);
    if (!script) return std::nullopt;
    print(*script);
    return kDone;
}

}  // namespace gsim::apps
