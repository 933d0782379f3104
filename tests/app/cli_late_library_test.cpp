// Starting costs no more than what a command needs: OpenVDB's library comes when it is asked for.
#include <filesystem>

#include "tests/app/cli_program.h"

namespace voxprite::test {
namespace {

namespace fs = std::filesystem;

class CliLateLibrary : public CommandLine {
  protected:
    // The program without what lies beside it.
    void SetUp() override {
        fs::create_directory(file("alone"));
        program_ = file("alone/voxprite");
        fs::copy_file(VOXPRITE_PROGRAM, program_);
    }
    [[nodiscard]] ProgramResult convertTo(const std::string& name) const {
        return run({"convert", VOXPRITE_SOURCE_DIR "/samples/knight.vox", "-o", file(name)}, "",
                   program_);
    }
    void bring() const {
        const char* const library = "libvoxprite_openvdb.so";
        fs::copy_file(fs::path(VOXPRITE_PROGRAM).parent_path() / library,
                      file(std::string("alone/") + library));
    }

  private:
    std::string program_;
};

TEST_F(CliLateLibrary, WhatNeedsNoOpenVdbRunsWithoutIt) {
    const ProgramResult made = convertTo("knight.qb");
    EXPECT_EQ(made.status, 0) << made.err;
}

TEST_F(CliLateLibrary, WhatNeedsItSaysThatItIsMissing) {
    const ProgramResult made = convertTo("knight.vdb");
    EXPECT_NE(made.status, 0);
    EXPECT_NE(made.err.find("libvoxprite_openvdb.so, a part of this program, cannot be loaded"),
              std::string::npos)
        << made.err;
    EXPECT_FALSE(fs::exists(file("knight.vdb")));
}

TEST_F(CliLateLibrary, ItIsFoundBesideTheProgram) {
    bring();
    const ProgramResult made = convertTo("knight.vdb");
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_TRUE(fs::exists(file("knight.vdb")));
}

}  // namespace
}  // namespace voxprite::test
