// gsim-run --save-machine-data: the tables of the control after a run, in the file that was read.

#include <fmt/format.h>

#include "tests/apps/run_program.h"

namespace gsim::apps::saved_data_test {
namespace {

class SavedData : public Apps {
  protected:
    /// The file after a run that read it and saved it.
    std::string after(const std::string& data, const std::string& program,
                      const std::string& dialect = "ab9") {
        write("d.txt", data);
        const Ended e = gsim_run({"--quiet", "--dialect", dialect, "--machine-data", "d.txt",
                                  "--save-machine-data", "d.txt", write("part.nc", program)});
        EXPECT_EQ(e.status, 0) << e.err;
        return read("d.txt");
    }
};

const std::string kData =
    "; shop 3\r\nNCFILE\r\nOFFSET\r\n54   10.00  0  0 # left\r\n55   1  0  0  inch\r\nTOOL\r\n"
    "1 50.8 10 JET  LENGTH_WEAR=0.1\r\n2 1 2 inch\r\nVARIABLE\r\n100 1\r\n500 7 # parts\r\n501 3\r\nENDFILE";

std::string changed(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

TEST_F(SavedData, KeepsEachByteIfNothingChanged) {
    for (const char* dialect : {"ab9", "rs274ngc"}) {
        EXPECT_EQ(after(kData, "G54 G0 X1\nG55 X1\nG21 G43 H1\nM2\n", dialect), kData) << dialect;
        EXPECT_EQ(after(kData, "M2\n", dialect), kData) << dialect;
    }
}

TEST_F(SavedData, HasG10AndSystemVariablesOfAb9) {
    std::string expected_value = changed(kData, "10.00 ", "12.5  ");
    expected_value = changed(expected_value, "1  0  0  inch", "2  0  0  inch");
    expected_value = changed(expected_value, "inch\r\nT", "inch\r\n505  0  0  3\r\nT");
    expected_value = changed(expected_value, "50.8 10 JET  LENGTH_WEAR=0.1", "50.8 11 JET  LENGTH_WEAR=0.25");
    expected_value = changed(expected_value, "2 1 2 inch\r\n", "2 1 2 inch\r\n7  5  0\r\n");
    expected_value = changed(expected_value, "500 7", "500 8");
    expected_value = changed(expected_value, "501 3\r\n", "502  9\r\n5203  -4\r\n");
    EXPECT_EQ(after(kData,
                    "G10 L2 P1 X12.5\nG20 G10 L2 P2 X2\nG21 G10 L20 P5 Z3\nG10 L12 P1 R11\n#2201=0.25\n"
                    "#2007=5\n#100=2\n#500=#500+1\n#501=#0\n#502=9\n#5203=-4\nM2\n"),
              expected_value);
}

TEST_F(SavedData, IsActiveInNextRun) {
    const std::string data = after(kData, "#5201=-4\n#5221=20\n#2001=1\nM2\n");
    const std::string test =
        "IF[#5201 NE -4]THEN #3000=1\nIF[#5221 NE 20]THEN #3000=2\n"
        "IF[#2001 NE 1]THEN #3000=3\nIF[#2201 NE 0.1]THEN #3000=4\nG54 G0 X1\n"
        "IF[#5021 NE 17]THEN #3000=5\nM2\n";
    EXPECT_EQ(after(data, test), data);
}

TEST_F(SavedData, HasG10OfRs274ngc) {
    std::string expected_value = changed(kData, "10.00 ", "12.7  ");
    expected_value = changed(expected_value, "2 1 2 inch", "2 1.5 2  X=0.25 inch");
    expected_value = changed(expected_value, "500 7", "500 8");
    expected_value = changed(expected_value, "501 3\r\n", "501 3\r\n5230  30\r\n");
    EXPECT_EQ(after(kData, "G20 G10 L2 P1 X0.5 R30\nG10 L1 P2 Z1.5 X0.25\n#500=8\n#600=1\nM2\n", "rs274ngc"),
              expected_value);
}

TEST_F(SavedData, CreatesFileIfNoneWasRead) {
    const Ended e = gsim_run(
        {"--quiet", "--save-machine-data", "n.txt", write("part.nc", "G10 L2 P1 X5\n#500=1\nG0 X-9999\n")});
    EXPECT_EQ(e.status, 1) << "an alarm, and the tables are kept";
    EXPECT_EQ(read("n.txt"), "NCFILE\nOFFSET\n54  5  0  0\nVARIABLE\n500  1\nENDFILE\n");
}

TEST_F(SavedData, WritesVariablesToBothFiles) {
    write("kept.var", "501\t4\n");
    write("d.txt", "NCFILE\nVARIABLE\n500 1\nENDFILE\n");
    const Ended e = gsim_run({"--quiet", "--variables", "kept.var", "--machine-data", "d.txt",
                              "--save-machine-data", "d.txt", write("part.nc", "#500=2\nM2\n")});
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(read("kept.var"), "500\t2\n501\t4\n");
    EXPECT_EQ(read("d.txt"), "NCFILE\nVARIABLE\n500 2\n501  4\nENDFILE\n");
}

TEST_F(SavedData, KeepsTablesOfStoppedRun) {
    write("d.txt", kData);
    const Ended e = gsim_run({"--quiet", "--max-steps", "100000", "--variables", "kept.var", "--machine-data",
                              "d.txt", "--save-machine-data", "d.txt",
                              write("part.nc", "#500=8\nWHILE[1 EQ 1]DO1\n#1=2\nEND1\nM2\n")});
    EXPECT_EQ(e.status, 1) << e.err;
    EXPECT_EQ(read("d.txt"), changed(kData, "500 7", "500 8"));
    EXPECT_EQ(read("kept.var"), "500\t8\n501\t3\n");
}

TEST_F(SavedData, RejectsValueOutOfRange) {
    write("d.txt", kData);
    const Ended e = gsim_run({"--quiet", "--machine-data", "d.txt", "--save-machine-data", "d.txt",
                              write("part.nc", "#500=1000000*1000000\nM2\n")});
    EXPECT_EQ(e.status, 2);
    EXPECT_EQ(e.err, "gsim-run: d.txt is not written: 1000000000000 must be between -1e9 and 1e9\n");
    EXPECT_EQ(read("d.txt"), kData);
    EXPECT_EQ(gsim_run({"--quiet", "--save-machine-data", "no/such/d.txt", "part.nc"}).status, 2);
}

}  // namespace
}  // namespace gsim::apps::saved_data_test
