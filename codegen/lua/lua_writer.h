#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "codegen/blocks/block_plan.h"
#include "codegen/blocks/block_values.h"
#include "codegen/flow/control_flow.h"
#include "codegen/flow/jump_scan.h"
#include "codegen/flow/oword_flow.h"
#include "codegen/flow/program_names.h"
#include "codegen/lua/function_writer.h"
#include "codegen/lua/lua_spool.h"
#include "grammar/parser.h"

namespace gsim::codegen {

/// Writer that turns blocks into lines of Lua: line n of the source becomes line n+1. A line is built in two
/// buffers, statements and the comment that follows them, and written when the source's line ends.
class LuaWriter : public grammar::BlockSink {
  public:
    struct Options {
        bool annotate = false;         ///< The complete source block follows its Lua.
        bool warn_of_unknown = false;  ///< Codes that the dialect does not have are left out, with a warning.
        bool inch = false;             ///< The unit in force at the start.
    };

    LuaWriter(const grammar::Dialect& dialect, const FileScan& scan, lexer::Lexer& lexer,
              lexer::Diagnostics& diagnostics, LuaSpool& spool, Options options);

    /// Writes the first line; to be called before any block.
    void begin_file(std::string_view source_name);
    void on_block(const grammar::Block& block) override;
    /// Closes the last program; to be called after all blocks. Reports calls of programs that are not in the
    /// file.
    void end_file();

    const ProgramMap& map() const { return parts_.map(); }

  private:
    static bool is_plain(const grammar::Block& block);
    void write_block(const grammar::Block& block);
    void record_bad_block(const grammar::Block& block);
    void write_statements(const grammar::Block& block);
    int nesting_levels_around(const grammar::Block& block) const;
    void write_comment_action(const grammar::Block& block, std::string& out);
    void write_body(const grammar::Block& block);
    void write_content(const grammar::Block& block);
    void write_values_first(const grammar::Block& block);
    void write_calls(const grammar::Block& block, const BlockValues& values);
    void write_message(const grammar::Block& block);
    bool write_return_goto(const grammar::Block& block, const Call& call);
    std::optional<std::uint32_t> block_number(const grammar::Block& block, lexer::Slice digits,
                                              std::uint32_t column);
    void declare_jump(std::string& line) const;
    void write_goto(const grammar::Block& block);
    void record_call(const grammar::Block& block, const Call& call);
    void open_program(const grammar::Block& block);
    void report_duplicate_program(const grammar::Block& block, std::string_view name);
    bool is_empty_block(const grammar::Block& block);
    void begin_function(const grammar::Block& block);
    void write_flow(const grammar::Block& block);
    void open_sub(const grammar::Block& block);
    void close_program();
    bool ends_pass(const grammar::Block& block, std::uint32_t target) const;
    void write_jump_to(const grammar::Block& block, std::uint32_t target, std::uint32_t column);
    void write_computed_jump();
    void write_number_dispatch(std::span<const std::uint32_t> numbers);
    void write_dispatcher();
    void write_loop_dispatcher();
    void add_comment(const grammar::Block& block);
    void end_line();
    void check_skip(const grammar::Block& block);

    const FileScan& scan_;
    lexer::BlockErrors& errors_;
    lexer::ProgramExtent& extent_;
    lexer::Diagnostics& diagnostics_;
    LuaSpool& spool_;
    Options options_;
    UnknownCodes unknown_;
    UnknownCodes deferred_codes_;
    BlockPlan plan_;
    ControlFlow flow_;
    OWordFlow oword_flow_;
    FunctionWriter parts_;
    std::string code_;
    std::string comment_;
    bool is_plain_line_ = true;  ///< For the blocks of the line that is being built.
    std::size_t next_ordinal_ = 0;
    bool main_ended_ = false;   ///< By M2 or M30: only subroutines may follow.
    int bare_label_count_ = 0;  ///< Labels since the last statement.
    ProgramNames names_;
};

}  // namespace gsim::codegen
