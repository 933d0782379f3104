// Models as pictures of their layers: a pixel a voxel, what is transparent is empty.
//
// Two habits of the field are read and written, told apart by the file's name:
//
// strip   hut.png: all layers in one picture, one below the other, the lowest at the top, as
//         MagicaVoxel exports slices.
// stack   hut_000.png, hut_001.png, ...: a file a layer, numbered from the lowest. A name that ends
//         in three digits or more is one of a stack; with fewer it is one where there is a
//         neighbour with the next number. Any file of a stack stands for all of it, and so does a
//         folder that holds nothing else that is a PNG.
//
// Space       A picture shows its layer from above: x runs right and y up, so that the last row is
//             y = 0.
// Layers      How many a strip has is told by a text in the picture, when voxprite wrote it ("16
//             at -3 4 0": layers and the place of the lowest corner), else by the option, else they
//             are taken for squares, as wide as the picture; and if that does not come out even it
//             is one layer. A warning says which. Where a stack of voxprite's has another number
//             of files than was written a warning says so.
// Voxels      Alpha 0 is empty. Colours, with their alpha, get indices in the order in which they
//             are met, from the lowest layer's first row; more than 255 are reduced
//             (core/io/colour_reduction.h).
// Written     The first frame as it is seen, the box around its voxels. A colour of alpha 0 that
//             voxels use is written with alpha 255. Names of a stack count up from the number
//             asked for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/model/document.h"

namespace voxprite {

struct SliceReadOptions {
    // Rows of a strip that are one layer; 0: see above. What the picture itself tells wins.
    int layerRows = 0;
};

struct SlicesImport {
    Document document;
    std::vector<std::string> warnings;
};

// The pictures of a model; `first` alone for a strip, else a file a layer, from the lowest.
struct SliceFiles {
    std::vector<std::filesystem::path> files;
    bool strip = false;
};

// Which files a name or folder stands for. Fails where a number is missing, or there is none.
[[nodiscard]] Result<SliceFiles> sliceFilesOf(const std::filesystem::path& path);

// All or nothing. Pictures are bounded as in core/io/png.h, one is in memory at a time; the grid's
// blocks (8 x 8 x 8 voxels) may take 1 GiB and 32 times the files' length. At most 65,536 layers.
[[nodiscard]] Result<SlicesImport> readSlices(const std::filesystem::path& path,
                                              const SliceReadOptions& options = {});
[[nodiscard]] Result<SlicesImport> readStrip(ByteView png, const SliceReadOptions& options = {});

struct SlicePicture {
    std::string name;
    Bytes png;
};
// For a name of a stack a picture a layer, the lowest last (it is the one that was asked for), else
// one. Fails on an invalid document, where nothing is seen, and on pictures larger than a PNG can
// be (core/io/png.h).
[[nodiscard]] Result<std::vector<SlicePicture>> writeSlices(const Document& document,
                                                            const std::filesystem::path& name);
// The names of those files, without a folder.
[[nodiscard]] std::vector<std::string> sliceNames(const std::filesystem::path& name,
                                                  const Document& document);
// What is lost besides what core/io/holds.h tells.
[[nodiscard]] std::vector<std::string> sliceLosses(const Document& document);
// Fails where a stack of this many layers would lie beside files of another that go on where it
// ends: together they would be read as one.
[[nodiscard]] Status checkNeighbours(const std::filesystem::path& path, std::size_t layers);

}  // namespace voxprite
