// The conformance set of .svo: small files that every reader must accept, and read right, or
// refuse.
#pragma once

#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/io/svo_file.h"

namespace voxprite::samples {

struct Case {
    std::string name;   // of the file, without ending
    std::string shows;  // what is special about it
    bool valid = false;
    Bytes bytes;
};

// The file whose hexadecimal dump stands in SVO.md.
[[nodiscard]] SvoFile exampleFile();
// Clips, sockets, texts, several models: what the broken files are made from.
[[nodiscard]] SvoFile livelyFile();
// Three entities, unlike in size, palette, anchor and clips.
[[nodiscard]] std::vector<SvoFile> livelySet();
// Throws where the writer refuses: the set is at fault then.
[[nodiscard]] Bytes written(const SvoFile& file);
[[nodiscard]] Bytes written(const std::vector<SvoFile>& set);

[[nodiscard]] std::vector<Case> validCases();
[[nodiscard]] std::vector<Case> brokenCases();

}  // namespace voxprite::samples
