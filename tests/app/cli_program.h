// Runs the program that was built, as a script would.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/file_content.h"
#include "tests/support/temporary_folder.h"

namespace voxprite::test {

struct ProgramResult {
    int status = -1;  // exit status; -1 when it crashed
    std::string out;
    std::string err;

    // The whole of stdout as JSON; fails the test when it is anything else.
    [[nodiscard]] nlohmann::json json() const {
        nlohmann::json parsed = nlohmann::json::parse(out, nullptr, false);
        EXPECT_FALSE(parsed.is_discarded()) << "stdout is not one JSON value:\n" << out << err;
        return parsed;
    }
    [[nodiscard]] std::ptrdiff_t errorLines() const {
        return std::count(err.begin(), err.end(), '\n');
    }
};

class CommandLine : public testing::Test {
  protected:
    // Redirections of the shell ("2>&-") come after those to files.
    ProgramResult run(const std::vector<std::string>& arguments,
                      const std::string& redirections = "",
                      const std::string& program = VOXPRITE_PROGRAM) const {
        const std::string out = file("stdout");
        const std::string err = file("stderr");
        std::string command = quoted(program);
        for (const std::string& argument : arguments) command += " " + quoted(argument);
        command += " >" + quoted(out) + " 2>" + quoted(err) + " </dev/null " + redirections;
        const int status = std::system(command.c_str());
        return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(out), contentOf(err)};
    }
    // A path in this test's own folder.
    [[nodiscard]] std::string file(const std::string& name) const {
        return (folder_ / name).string();
    }

  private:
    static std::string quoted(const std::string& text) {
        std::string quoted = "'";
        for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        return quoted + "'";
    }
    TemporaryFolder folder_;
};

}  // namespace voxprite::test
