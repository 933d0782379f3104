#include "render/gl/lazy_program.h"

#include <glad/gl.h>

#include <cstdio>

namespace voxprite::gl {

Status LazyProgram::use() {
    if (!program_) {
        Result<Program> compiled = compileProgram(vertex_, fragment_, defines_);
        if (!compiled) {
            glUseProgram(0);
            return tl::unexpected(compiled.error());
        }
        program_ = std::move(*compiled);
    }
    useProgram(program_);
    return {};
}

void LazyProgram::useOrSay() {
    if (const Status used = use(); !used && !std::exchange(said_, true)) {
        std::fprintf(stderr, "%s\n", used.error().describe().c_str());
    }
}

}  // namespace voxprite::gl
