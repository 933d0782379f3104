// A program that is compiled when it is first used: a window is there sooner, and who never needs
// the program never waits for it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "render/gl/program.h"

namespace voxprite::gl {

class LazyProgram {
  public:
    LazyProgram(std::string vertex, std::string fragment, std::vector<std::string> defines = {})
        : vertex_(std::move(vertex)),
          fragment_(std::move(fragment)),
          defines_(std::move(defines)) {}

    // Makes it the current program. One that does not compile fails every time, and leaves none
    // current: nothing is drawn with another's program.
    [[nodiscard]] Status use();
    // The same, where nobody can be told: the reason goes to stderr, once.
    void useOrSay();

  private:
    std::string vertex_, fragment_;
    std::vector<std::string> defines_;
    Program program_;
    bool said_ = false;
};

}  // namespace voxprite::gl
