// The samples as `voxprite export` writes them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/io/formats.h"
#include "core/io/svo_file.h"
#include "tests/support/must.h"

namespace voxprite::test {

struct ExportedSample {
    std::string name;
    Document document;
    Bytes bytes;
};

inline std::vector<ExportedSample> exportedSamples() {
    std::vector<ExportedSample> samples;
    for (const char* name : {"knight.vox", "oak.vox", "cottage.vox", "truck.vox", "letters.vox",
                             "walk.voxprite", "village.voxprite"}) {
        const auto path = std::filesystem::path(VOXPRITE_SOURCE_DIR) / "samples" / name;
        Document document = must(loadDocument(path)).document;
        Bytes bytes = must(writeSvo(must(bakeForExport(document, GameProfile{}))));
        samples.push_back({name, std::move(document), std::move(bytes)});
    }
    return samples;
}

}  // namespace voxprite::test
