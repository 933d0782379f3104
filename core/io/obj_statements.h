// The statements of an .obj that are read, checked, and as plain as tinyobjloader needs them: it
// takes what is no number for 0, tells no place, trusts the counts of statements that are not read
// here, and ends the names of files and materials at a blank. Private to core/io.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"

namespace voxprite {

struct ObjStatements {
    // "v" and "vt" of finite numbers, "f" of indices that are there, counted from 1, as "1" or
    // "1/2", and "usemtl 3" for materials[3].
    std::string text;
    std::vector<std::string> libraries;  // what follows each mtllib, as it stands
    std::vector<std::string> materials;  // what follows usemtl, each once
};

// Errors tell line and column. Lines end in any of the usual ways.
[[nodiscard]] Result<ObjStatements> objStatements(ByteView file);

// The file as text, without a byte order mark at its start.
[[nodiscard]] std::string_view textWithoutMark(ByteView file);
// Without the blanks and tabs around it.
[[nodiscard]] std::string_view withoutBlanks(std::string_view text);

}  // namespace voxprite
