#include "tests/accuracy/table.h"

#include <gtest/gtest.h>

namespace gsim::accuracy::table_test {
namespace {

const std::vector<Column> kColumns{{"name", Align::left}, {"s", Align::right}, {"mark", Align::left}};
const std::vector<Row> kRows{{"a|b", "10.5", "good"}, {"longer", "7", ""}};

TEST(Table, AlignsColumns) {
    EXPECT_EQ(plain_table(kColumns, kRows),
              "name       s  mark\n"
              "a|b     10.5  good\n"
              "longer     7\n");
}

TEST(Table, IsAlsoWrittenAsMarkdown) {
    EXPECT_EQ(markdown_table(kColumns, kRows),
              "| name | s | mark |\n"
              "| --- | ---: | --- |\n"
              "| a\\|b | 10.5 | good |\n"
              "| longer | 7 |  |\n");
}

}  // namespace
}  // namespace gsim::accuracy::table_test
