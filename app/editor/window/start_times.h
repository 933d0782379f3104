// When the parts of the editor's start were done, as `edit --start-times` writes them:
//   [{"part": "window", "at_ms": 81234.5, "cpu_ms": 180.2}, ...]
// `at_ms` is the steady clock's, which all processes of a machine share (on Linux), so that whoever
// started the editor can subtract the moment in which it did; `cpu_ms` is the processor time of all
// threads of the editor so far.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace voxprite::editor {

class StartTimes {
  public:
    void mark(std::string part);
    [[nodiscard]] Status write(const std::filesystem::path& path) const;

  private:
    struct Mark {
        std::string part;
        double atMs, cpuMs;
    };
    std::vector<Mark> marks_;
};

}  // namespace voxprite::editor
