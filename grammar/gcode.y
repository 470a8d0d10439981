/* The grammar of G-code, over complete programs. The parser passes a block on as soon as it is complete.
 *
 * A letter can mean several things, and only the remainder of its block decides: in `X5 F200 G04` X is the time of a
 * dwell, in `X5 F200` an axis; P is a time, a program (M98) or a parameter. The grammar has one list for each kind of
 * block. All readings continue in parallel, and those that do not fit the remainder of the block die (GLR).
 *
 * The parser knows only Parser (grammar/parser.h); an action is one call. Values are indices because they are copied
 * while several readings are open. Actions wait until one reading is left.
 */
%glr-parser
%define api.prefix {gcode_}
%define api.pure
%define api.value.type {gsim::lexer::Value}
%param {gsim::grammar::Parser& parser}

/* Each family of conflicts is one token with several readings, left to GLR on purpose.
 * Reduce/reduce, 40 in all: X or U (axis, dwell time) and P (parameter, dwell time, program) before a token that fits several
 *   kinds of block. Such tokens are another X or U, P, a common word, an axis word, and what begins a setting of
 *   RS274/NGC (#1, #<name>, #[..).
 * Shift/reduce, 7 in all:
 *   1: ATAN[a] / [b], the angle of two sides, against a quotient of ATAN[a] by something else; the token after '/' decides.
 *   6: #1, #<name> or # at the start of a block or after THEN begins assignments (9/Series) or words with a setting among
 *      them (RS274/NGC); '=' and SET decide. */
%expect 7
%expect-rr 40

%code requires {
#include "lexer/token.h"
namespace gsim::grammar { class Parser; }
}
%code {
#include "grammar/parser.h"
#include "lexer/checked_memory.h"

using gsim::grammar::BlockKind;
using gsim::grammar::NodeKind;
using gsim::grammar::Operator;
using gsim::lexer::Role;

// Token values are trivially copyable, so the parser's stack may grow (up to what the scanner's bounds need).
#define YYSTACKEXPANDABLE 1
#define YYMALLOC gsim::lexer::checked_malloc
#define YYREALLOC gsim::lexer::checked_realloc
#define YYMAXDEPTH 100000

// The numbers of the tokens depend on their order, so it must be that of the scanner's list.
#define GSIM_TOKEN(token, in_grammar) static_assert(static_cast<int>(in_grammar) == gsim::lexer::token);
#include "lexer/tokens.def"
#undef GSIM_TOKEN

static int gcode_lex(gsim::lexer::Value* value, gsim::grammar::Parser& parser) { return parser.scan(*value); }
static void gcode_error(gsim::grammar::Parser& parser, const char*) { parser.syntax_error(); }
static Operator token_operator(gsim::lexer::Value token) { return static_cast<Operator>(token.index); }
}

/* In the order of lexer/tokens.def. */
%token EOB
%token TAPE
%token SKIP
%token SEQUENCE
%token PROGRAM
%token AXIS
%token AXIS_OR_TIME
%token P
%token OTHER
%token DWELL
%token CALL
%token AXIS_LETTER
%token AXIS_OR_TIME_LETTER
%token P_LETTER
%token OTHER_LETTER
%token VARIABLE
%token HASH
%token NUMBER
%token FUNCTION
%token ATAN
%token RELATION
%token SUM_WORD
%token PRODUCT_WORD
%token IF
%token THEN
%token WHILE
%token DO
%token END_LOOP
%token GOTO
%token FLOW_NAME
%token FLOW_LETTER
%token FLOW
%token NAMED_VARIABLE
%token POWER
%token LOGIC_WORD
%token EXISTS
%token COMPARISON
%token PRINT
%token SET

%left LOGIC_WORD

%nonassoc RELATION
%left COMPARISON
%left '+' '-' SUM_WORD

%%

program: %empty | program block ;

block:
    TAPE                            { parser.finish_tape(); }
  | prefix content EOB              { parser.finish_block(); }
  | prefix title words EOB          { parser.finish_block(); }
  | prefix flow EOB                 { parser.finish_block(); }
  | error EOB                       { yyerrok; parser.finish_bad_block(); }
  ;

prefix: %empty | prefix SKIP        { parser.set_skip($2); }
  | prefix SEQUENCE                 { parser.set_sequence($2); }
  ;

title: PROGRAM                      { parser.set_program($1.column); } ;

content:
    words
  | assignments                     { parser.set_kind(BlockKind::assignments); }
  | IF condition GOTO target        { parser.set_kind(BlockKind::if_goto); }
  | IF condition THEN words         { parser.set_kind(BlockKind::if_then); }
  | IF condition THEN assignments   { parser.set_kind(BlockKind::if_then); }
  | WHILE condition DO loop         { parser.set_kind(BlockKind::while_do); }
  | END_LOOP loop                   { parser.set_kind(BlockKind::end_loop); }
  | PRINT                           { parser.set_print($1.index); }
  | GOTO target                     { parser.set_kind(BlockKind::jump); }
  ;

/* RS274/NGC: an O-word, by itself or with a keyword. */
flow: flow_name                     { parser.set_flow_program(); }
  | flow_name FLOW arguments        { parser.set_flow($2); }
  ;
flow_name: FLOW_NAME                { parser.set_flow_name($1.column); }
  | FLOW_LETTER reference           { parser.set_flow_name($2.column, $2.index); }
  | FLOW_LETTER '[' expression ']'  { parser.set_flow_name($3.column, $3.index); }
  ;
arguments: %empty
  | arguments reference             { parser.add_argument($2.index); }
  | arguments '[' expression ']'    { parser.add_argument($3.index); }
  ;

condition: '[' expression ']'       { parser.set_condition($2.index); } ;
loop: NUMBER                        { parser.set_loop($1); } ;
target: NUMBER                      { $$ = {parser.add_number($1), $1.column}; parser.set_target($$); }
  | reference                       { parser.set_target($1); }
  | '[' expression ']'              { parser.set_target($2); }
  ;

/* The kinds of blocks made of words. */
words: common_words | axis_words | parameter_words | call_words | dwell_words ;

common_words: %empty | common_words common ;

axis_words: common_words axis | axis_words axis | axis_words common ;

parameter_words: common_words parameter | axis_words parameter
  | parameter_words parameter | parameter_words axis | parameter_words common ;

call_words: common_words CALL | axis_words CALL | before_call CALL
  | call_words program_number | call_words axis | call_words common ;
before_call: common_words program_number | axis_words program_number
  | before_call program_number | before_call axis | before_call common ;

dwell_words: common_words DWELL | before_dwell DWELL
  | dwell_words time | dwell_words common ;
before_dwell: common_words time | before_dwell time | before_dwell common ;

axis: axis_word | axis_or_time      { parser.set_role($1.index, Role::axis); } ;
time: axis_or_time                  { parser.set_role($1.index, Role::time); }
  | p                               { parser.set_role($1.index, Role::time); } ;
parameter: p                        { parser.set_role($1.index, Role::parameter); } ;
program_number: p                   { parser.set_role($1.index, Role::program); } ;

common: OTHER | OTHER_LETTER value  { parser.set_expression($1.index, $2.index); }
  | reference SET any_value         { parser.add_assignment($1.index, $3.index); }
  ;
/* RS274/NGC: settings are among the words, with one value each. */
any_value: value                    { $$ = $1; }
  | NUMBER                          { $$ = {parser.add_number($1), $1.column}; }
  ;
axis_word: AXIS | AXIS_LETTER value { parser.set_expression($1.index, $2.index); } ;
axis_or_time: AXIS_OR_TIME          { $$ = $1; }
  | AXIS_OR_TIME_LETTER value       { parser.set_expression($1.index, $2.index); $$ = $1; } ;
p: P                                { $$ = $1; }
  | P_LETTER value                  { parser.set_expression($1.index, $2.index); $$ = $1; } ;

/* An expression after a letter is in brackets, or is a variable. Signs may follow each other; a number without or
 * with one sign is part of the letter's token. */
value: reference                    { $$ = $1; }
  | '[' expression ']'              { $$ = $2; }
  | signed_value                    { $$ = $1; }
  ;
signed_value: '-' any_value                   { $$ = {parser.add_node(NodeKind::negate, Operator::subtract, $2), $1.column}; }
  | '+' any_value                   { $$ = $2; }
  | function                        { $$ = $1; }
  ;

reference: VARIABLE                 { $$ = {parser.add_variable($1), $1.column}; }
  | HASH reference                  { $$ = {parser.add_node(NodeKind::indirect, Operator::add, $2), $1.column}; }
  | HASH '[' expression ']'         { $$ = {parser.add_node(NodeKind::indirect, Operator::add, $3), $1.column}; }
  | HASH signed_value               { $$ = {parser.add_unbracketed_index($2), $1.column}; }
  | NAMED_VARIABLE                  { $$ = {parser.add_named($1), $1.column}; }
  ;

assignments: assignment | assignments assignment | assignments ',' assignment ;
assignment: reference '=' expression { parser.add_assignment($1.index, $3.index); } ;

expression: product                 { $$ = $1; }
  | expression '+' expression       { $$ = {parser.add_node(NodeKind::binary, Operator::add, $1, $3), $1.column}; }
  | expression '-' expression       { $$ = {parser.add_node(NodeKind::binary, Operator::subtract, $1, $3), $1.column}; }
  | expression SUM_WORD expression  { $$ = {parser.add_node(NodeKind::binary, token_operator($2), $1, $3), $1.column}; }
  | expression LOGIC_WORD expression { $$ = {parser.add_node(NodeKind::binary, token_operator($2), $1, $3), $1.column}; }
  | expression COMPARISON expression { $$ = {parser.add_node(NodeKind::binary, token_operator($2), $1, $3), $1.column}; }
  | expression RELATION expression  { $$ = {parser.add_node(NodeKind::binary, token_operator($2), $1, $3), $1.column}; }
  ;

/* ATAN[a] / [b] is one angle: if a product ends in an ATAN of one side, '/' '[' does not make it a quotient. */
product: plain_product              { $$ = $1; }
  | atan_product                    { $$ = $1; }
  ;
plain_product: power                { $$ = $1; }
  | product times power             { $$ = {parser.add_node(NodeKind::binary, token_operator($2), $1, $3), $1.column}; }
  | plain_product '/' power         { $$ = {parser.add_node(NodeKind::binary, Operator::divide, $1, $3), $1.column}; }
  | atan_product '/' factor         { $$ = {parser.add_node(NodeKind::binary, Operator::divide, $1, $3), $1.column}; }
  ;
atan_product: signed_atan           { $$ = $1; }
  | product times signed_atan       { $$ = {parser.add_node(NodeKind::binary, token_operator($2), $1, $3), $1.column}; }
  | plain_product '/' signed_atan   { $$ = {parser.add_node(NodeKind::binary, Operator::divide, $1, $3), $1.column}; }
  | atan_product '/' signed_atan    { $$ = {parser.add_node(NodeKind::binary, Operator::divide, $1, $3), $1.column}; }
  ;
times: '*'                          { $$ = $1; }
  | PRODUCT_WORD                    { $$ = $1; }
  ;

power: operand                      { $$ = $1; }
  | power POWER operand             { $$ = {parser.add_node(NodeKind::binary, Operator::power, $1, $3), $1.column}; }
  ;
operand: factor                     { $$ = $1; }
  | bracketed                       { $$ = $1; }
  ;
factor: primary                     { $$ = $1; }
  | '-' operand                     { $$ = {parser.add_node(NodeKind::negate, Operator::subtract, $2), $1.column}; }
  | '+' operand                     { $$ = $2; }
  ;
signed_atan: atan                   { $$ = $1; }
  | '-' signed_atan                 { $$ = {parser.add_node(NodeKind::negate, Operator::subtract, $2), $1.column}; }
  | '+' signed_atan                 { $$ = $2; }
  ;

primary: NUMBER                     { $$ = {parser.add_number($1), $1.column}; }
  | reference                       { $$ = $1; }
  | function                        { $$ = $1; }
  ;
function: FUNCTION '[' expression ']'
                                    { $$ = {parser.add_node(NodeKind::call, token_operator($1), $3), $1.column}; }
  | ATAN '[' expression ']' '/' '[' expression ']'
                                    { $$ = {parser.add_node(NodeKind::call, Operator::atan, $3, $7), $1.column}; }
  | EXISTS '[' reference ']'        { $$ = {parser.add_node(NodeKind::exists, Operator::exists, $3), $1.column}; }
  ;
bracketed: '[' expression ']'       { $$ = $2; } ;
atan: ATAN '[' expression ']'       { $$ = {parser.add_node(NodeKind::call, Operator::atan, $3), $1.column}; } ;

%%
