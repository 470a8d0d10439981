#include "codegen/flow/control_flow.h"

#include <algorithm>

#include <fmt/format.h>

#include "codegen/flow/lua_limits.h"

namespace gsim::codegen {

using grammar::Block;
using lexer::DiagnosticKind;
using lexer::Location;

namespace {

constexpr std::size_t kMaxLabels = 32000;  // Lua: SHRT_MAX, labels of ours included
constexpr std::size_t kMaxJumps = 32000;   // Lua: SHRT_MAX jumps waiting for their label

}  // namespace

void ControlFlow::begin_program(const ProgramJumps& jumps) {
    jumps_ = &jumps;
    loops_.clear();
    labels_.clear();
    open_jumps_.clear();
    reachable_.clear();
    weight_ = 0;
    lost_ = false;
    too_many_labels_ = false;
    too_many_jumps_ = false;
}

std::vector<std::uint32_t> ControlFlow::path() const {
    std::vector<std::uint32_t> instances;
    for (const Loop& loop : loops_) instances.push_back(loop.instance);
    return instances;
}

bool ControlFlow::open_loop(const Block& block) {
    const Location location = block.text->at(block.loop_column);
    for (const Loop& loop : loops_) {
        if (loop.number == block.loop) {
            diagnostics_.error(
                location, DiagnosticKind::structure,
                fmt::format("DO {} is already open since line {}; nested loops must have different numbers",
                            block.loop, loop.location.line));
            return false;
        }
    }
    loops_.push_back({block.loop, next_instance_++, weight_, location});
    return true;
}

bool ControlFlow::close_loop(const Block& block) {
    const Location location = block.text->at(block.loop_column);
    if (lost_) {
        if (!loops_.empty()) loops_.pop_back();
        return false;
    }
    if (loops_.empty()) {
        diagnostics_.error(location, DiagnosticKind::structure,
                           fmt::format("END {} has no WHILE", block.loop));
        return false;
    }
    const Loop& loop = loops_.back();
    if (loop.number != block.loop) {
        diagnostics_.error(location, DiagnosticKind::structure,
                           fmt::format("END {} closes DO {}, which is open since line {}", block.loop,
                                       loop.number, loop.location.line));
        return false;
    }
    const bool too_long = weight_ - loop.weight > kMaxJumpWeight;
    if (too_long)
        diagnostics_.error(
            loop.location, DiagnosticKind::too_large,
            fmt::format("the loop up to line {} is too long for Lua; move its body to a subprogram",
                        location.line));
    loops_.pop_back();
    return !too_long;
}

void ControlFlow::add_jump(std::uint32_t target, const Location& location) {
    if (open_jumps_.size() == kMaxJumps) {
        if (!too_many_jumps_)
            diagnostics_.error(
                location, DiagnosticKind::too_large,
                fmt::format("the program has more than {} GOTOs, which exceeds the limit of one Lua function",
                            kMaxJumps));
        too_many_jumps_ = true;
        return;
    }
    open_jumps_.push_back({target, path(), weight_, location});
}

/// Returns the Lua label that finds the block of a computed jump, by the number of loops around it.
std::string ControlFlow::dispatch_label(std::size_t depth) const {
    return depth == 0 ? "computed" : fmt::format("computed{}", loops_[depth - 1].instance);
}

std::string ControlFlow::add_computed_jump() {
    for (Loop& loop : loops_) loop.has_computed_jumps = true;
    return dispatch_label(loops_.size());
}

std::optional<ControlFlow::LoopTargets> ControlFlow::loop_targets() const {
    if (loops_.empty() || !loops_.back().has_computed_jumps) return std::nullopt;
    const Loop& loop = loops_.back();
    return LoopTargets{dispatch_label(loops_.size()), dispatch_label(loops_.size() - 1),
                       fmt::format("pass{}", loop.instance), loop.numbers};
}

// Only blocks that a jump may target get a label: Lua counts labels in 16 bits.
bool ControlFlow::add_sequence(std::uint32_t number, const Location& location) {
    if (!computed() && !jumps_->targets.contains(number)) return false;
    if (labels_.size() == kMaxLabels) {
        if (!too_many_labels_)
            diagnostics_.error(location, DiagnosticKind::too_large,
                               fmt::format("the program has more than {} blocks that a GOTO may target, "
                                           "which exceeds the limit of one Lua function",
                                           kMaxLabels));
        too_many_labels_ = true;
        return false;
    }
    if (!labels_.try_emplace(number, Label{path(), weight_}).second) {
        diagnostics_.error(
            location, DiagnosticKind::jump,
            fmt::format("N{} is defined twice in this program, and a GOTO jumps to it", number));
        return false;
    }
    (loops_.empty() ? reachable_ : loops_.back().numbers).push_back(number);
    return true;
}

// Lua jumps out of loops and not into them, like the 9/Series; and over 2^24 instructions at most.
void ControlFlow::check(const Jump& jump) {
    const auto found = labels_.find(jump.target);
    if (found == labels_.end()) {
        diagnostics_.error(
            jump.location, DiagnosticKind::jump,
            fmt::format("GOTO {}: N{} does not exist in this program", jump.target, jump.target));
        return;
    }
    const Label& label = found->second;
    const bool inside = label.path.size() <= jump.path.size() &&
                        std::equal(label.path.begin(), label.path.end(), jump.path.begin());
    if (!inside) {
        diagnostics_.error(jump.location, DiagnosticKind::jump,
                           fmt::format("GOTO {} jumps into a WHILE loop from outside", jump.target));
    } else if (std::max(label.weight, jump.weight) - std::min(label.weight, jump.weight) > kMaxJumpWeight) {
        diagnostics_.error(
            jump.location, DiagnosticKind::too_large,
            fmt::format("GOTO {} jumps too far for Lua; move the skipped blocks to a subprogram",
                        jump.target));
    }
}

void ControlFlow::end_program() {
    for (const Loop& loop : loops_) {
        if (!lost_)
            diagnostics_.error(loop.location, DiagnosticKind::structure,
                               fmt::format("WHILE has no END {}", loop.number));
    }
    if (!too_many_labels_) {
        for (const Jump& jump : open_jumps_) check(jump);
    }
    loops_.clear();
    open_jumps_.clear();
}

}  // namespace gsim::codegen
