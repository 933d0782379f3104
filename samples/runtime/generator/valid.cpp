#include <algorithm>
#include <stdexcept>

#include "core/svo/bake.h"
#include "samples/runtime/generator/cases.h"
#include "samples/runtime/generator/svo_parts.h"

namespace voxprite::samples {
namespace {

Octree baked(const VoxelGrid& voxels, const IBox& bounds) {
    Result<Octree> octree = bake(voxels, bounds);
    if (!octree) throw std::runtime_error(octree.error().describe());
    return std::move(*octree);
}

SvoFile fileOf(const VoxelGrid& voxels, const std::string& name) {
    SvoFile file;
    file.name = name;
    file.models = {{name, baked(voxels, voxels.bounds())}};
    for (int i = 1; i < 256; ++i) {
        file.palette[static_cast<std::size_t>(i)] = Rgba8(i, 255 - i, (i * 7) & 255, 255);
    }
    return file;
}

VoxelGrid voxelsAt(std::initializer_list<std::pair<glm::ivec3, int>> voxels) {
    VoxelGrid grid;
    for (const auto& [at, material] : voxels) grid.set(at, static_cast<std::uint8_t>(material));
    return grid;
}

VoxelGrid boxOf(glm::ivec3 size, std::uint8_t material) {
    VoxelGrid grid;
    grid.fill({glm::ivec3(0), size}, material);
    return grid;
}

// One corner in each octant at every level, and uniform leaves beside bricks.
VoxelGrid mixture() {
    VoxelGrid grid = boxOf({4, 4, 4}, 9);
    grid.set({5, 0, 0}, 1);
    grid.set({4, 6, 1}, 2);
    grid.set({0, 5, 3}, 3);
    grid.set({2, 1, 5}, 4);
    grid.set({3, 3, 3}, 255);
    grid.fill({{4, 4, 4}, {6, 6, 6}}, 17);
    return grid;
}

}  // namespace

Bytes written(const SvoFile& file) {
    Result<Bytes> bytes = writeSvo(file);
    if (!bytes) throw std::runtime_error(bytes.error().describe());
    return std::move(*bytes);
}

Bytes written(const std::vector<SvoFile>& set) {
    Result<Bytes> bytes = writeSvoSet(set);
    if (!bytes) throw std::runtime_error(bytes.error().describe());
    return std::move(*bytes);
}

SvoFile exampleFile() {
    SvoFile file;
    file.name = "step";
    file.models = {
        {"step", baked(voxelsAt({{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{2, 0, 0}, 2}, {{2, 0, 1}, 2}}),
                       {{0, 0, 0}, {3, 1, 2}})}};
    file.palette[1] = {0x8A, 0x6F, 0x4D, 255};
    file.palette[2] = {0x5C, 0x9E, 0x58, 255};
    file.colourNames[2] = "moss";
    file.anchor = {1.5, 0.5, 0.0};
    return file;
}

SvoFile livelyFile() {
    SvoFile file = fileOf(mixture(), "lively");
    const IBox bounds = mixture().bounds();
    VoxelGrid other = mixture();
    other.set({5, 0, 0}, 0);
    other.set({0, 0, 5}, 40);
    file.models[0].octree.origin = {-3, 2, 0};
    file.models.push_back({"zw\xC3\xB6lf", baked(other, bounds)});
    file.models[1].octree.origin = {-3, 2, 0};
    file.models.push_back({"", baked(boxOf({2, 2, 2}, 5), {{0, 0, 0}, {2, 2, 2}})});
    file.clips = {{"walk", {0, 1, 0}, {125, 250, 1}, true},
                  {"\xE8\xA6\x8B\xE3\x82\x8B", {2}, {1000000}, false}};
    file.sockets = {{"hand", {{1.5, -2.0, 0.25}}},
                    {"head", {{0, 0, 6}, {0, 0, 7}, {0, 0, 6}, {1, 1, 2}}}};
    file.colourNames[9] = "amber glass";
    file.sigma = 2.5;
    file.voxelSizeMetres = 0.25;
    file.anchor = {3.0, 3.5, 0.0};
    file.outline.colour = {20, 10, 40, 255};
    return file;
}

std::vector<SvoFile> livelySet() {
    SvoFile last = fileOf(voxelsAt({{{9, 9, 9}, 7}}), "one");
    last.palette[7] = {1, 2, 3, 4};
    last.sockets = {{"top", {{0.5, 0.5, 1.0}}}};
    return {exampleFile(), livelyFile(), std::move(last)};
}

std::vector<Case> validCases() {
    std::vector<Case> cases;
    const auto add = [&](const char* name, const char* shows, const Bytes& bytes) {
        cases.push_back({name, shows, true, bytes});
    };
    const auto addFile = [&](const char* name, const char* shows, const SvoFile& file) {
        add(name, shows, written(file));
    };
    addFile("example", "the file whose bytes SVO.md explains", exampleFile());
    addFile("one-voxel", "the least model: MaxDepth is 1, the root is a brick",
            fileOf(voxelsAt({{{0, 0, 0}, 7}}), "one"));
    addFile("row", "three voxels in a row: a root of two bricks",
            fileOf(voxelsAt({{{-7, 0, 0}, 1}, {{-6, 0, 0}, 2}, {{-5, 0, 0}, 3}}), "row"));
    addFile("solid-2", "eight equal voxels: the root is a uniform leaf",
            fileOf(boxOf({2, 2, 2}, 200), "solid"));
    addFile("solid-4", "collapsed at every level into one uniform root",
            fileOf(boxOf({4, 4, 4}, 255), "solid"));
    addFile("solid-5", "the same outgrown by one: uniform leaves at two levels",
            fileOf(boxOf({5, 5, 5}, 3), "solid"));
    addFile("mixture", "bricks beside uniform leaves, children in each octant",
            fileOf(mixture(), "mixture"));
    addFile("far-corners", "two voxels 65,536 apart: the deepest octree, MaxDepth 16",
            fileOf(voxelsAt({{{0, 0, 0}, 1}, {{65535, 65535, 65535}, 2}}), "far"));
    SvoFile empty;
    empty.models = {{"", baked(VoxelGrid{}, IBox{glm::ivec3(0), glm::ivec3(0)})}};
    addFile("empty", "a model without voxels: size 0, 0, 0 and an empty root", empty);
    SvoFile plain = livelyFile();
    plain.sockets.clear();
    addFile("clips", "three models in two clips; node and payload offsets; texts in three scripts",
            plain);
    addFile("sockets", "version 1.1: sockets that hold always and for each frame", livelyFile());
    add("set", "version 1.2: three unlike entities, with palettes, anchors and clips of their own",
        written(livelySet()));

    SvoParts parts(written(livelyFile()));
    std::reverse(parts.parts.begin(), parts.parts.end());
    add("reversed", "the sections in another order", parts.file());
    parts = SvoParts(written(livelySet()));
    std::reverse(parts.parts.begin(), parts.parts.end());
    add("set-reversed", "a set with its sections in another order", parts.file());
    parts = SvoParts(written(plain));
    parts.minor = 7;
    parts.parts.insert(parts.parts.begin() + 2, {"LODS", 0, Bytes(100, 7)});
    parts.parts.push_back({"XTRA", 0xFFFFFFFEu, {}});
    add("later-minor", "a later minor version with unknown sections, which are skipped",
        parts.file());
    Bytes reserved = written(plain);
    for (std::size_t at = 24; at < 60; ++at) reserved[at] = static_cast<std::uint8_t>(at);
    add("reserved", "reserved bytes that are not 0, which are ignored", SvoParts::sealed(reserved));
    return cases;
}

}  // namespace voxprite::samples
