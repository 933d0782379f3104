#include <functional>
#include <limits>

#include "core/svo/octree.h"
#include "samples/runtime/generator/cases.h"
#include "samples/runtime/generator/svo_parts.h"

namespace voxprite::samples {
namespace {

using U32 = std::uint32_t;
using U64 = std::uint64_t;

// Of livelyFile(): entry i of the section table is section i of the order that writeSvo uses.
constexpr std::size_t kNodeEntry = 64 + 32;

class BrokenCases {
  public:
    std::vector<Case> take() {
        header();
        table();
        models();
        octrees();
        texts();
        clips();
        values();
        entities();
        return std::move(cases_);
    }

  private:
    void add(const char* name, const char* why, Bytes bytes) {
        cases_.push_back({name, why, false, std::move(bytes)});
    }
    // Bytes of the file changed as they lie there; header and table are sealed again.
    void addBytes(const char* name, const char* why, const std::function<void(Bytes&)>& change) {
        Bytes bytes = lively_;
        change(bytes);
        add(name, why, SvoParts::sealed(std::move(bytes)));
    }
    // Sections changed; all checksums are right.
    void addParts(const char* name, const char* why, const std::function<void(SvoParts&)>& change) {
        addParts(lively_, name, why, change);
    }
    void addParts(const Bytes& file, const char* name, const char* why,
                  const std::function<void(SvoParts&)>& change) {
        SvoParts parts(file);
        change(parts);
        add(name, why, parts.file());
    }
    template <class T>
    void addValue(const char* name, const char* why, const char* tag, std::size_t at, T value) {
        addParts(name, why, [&](SvoParts& parts) { setValueAt(parts[tag], at, value); });
    }
    // One octree by itself.
    void addOctree(const char* name, const char* why, Octree octree) {
        SvoFile file;
        file.models = {{"", Octree{{0}, {}, 1, {0, 0, 0}, {0, 0, 0}}}};
        SvoParts parts(written(file));
        Bytes& model = parts["MODL"];
        setValueAt(model, 8, static_cast<U32>(octree.maxDepth));
        for (int axis = 0; axis < 3; ++axis) {
            setValueAt(model, static_cast<std::size_t>(12 + 4 * axis),
                       static_cast<U32>(octree.size[axis]));
        }
        setValueAt(model, 24, static_cast<U32>(octree.nodes.size()));
        setValueAt(model, 28, static_cast<U32>(octree.payloads.size()));
        const ByteView nodes = asBytes(octree.nodes);
        const ByteView payloads = asBytes(octree.payloads);
        parts["NODE"].assign(nodes.begin(), nodes.end());
        parts["PAYL"].assign(payloads.begin(), payloads.end());
        add(name, why, parts.file());
    }

    void header() {
        add("nothing", "no bytes at all", {});
        add("cut-header", "cut off within the header",
            Bytes(lively_.begin(), lively_.begin() + 40));
        Bytes cut = lively_;
        cut.pop_back();
        add("cut-end", "the last byte is missing", cut);
        Bytes longer = lively_;
        longer.push_back(0);
        add("longer", "a byte too many at the end", longer);
        addBytes("magic", "line ends were changed on the way", [](Bytes& b) {
            b[4] = '\n';
            b[5] = 0x1A;
        });
        addBytes("major", "a later major version",
                 [](Bytes& b) { setValueAt(b, 8, std::uint16_t{2}); });
        Bytes many = lively_;
        setValueAt(many, 12, std::numeric_limits<U32>::max());
        add("section-count", "a section table longer than the file", many);
        Bytes damaged = lively_;
        damaged[30] ^= 1;
        add("header-damaged", "a reserved byte changed, and the header's checksum is not", damaged);
        damaged = lively_;
        damaged[valueAt<U64>(lively_, kNodeEntry + 8)] ^= 0x10;
        add("section-damaged", "a bit of NODE changed, and its checksum is not", damaged);
    }

    void table() {
        const auto entry = [&](const char* name, const char* why, std::size_t field, U64 value) {
            addBytes(name, why, [&](Bytes& b) { setValueAt(b, kNodeEntry + field, value); });
        };
        entry("section-in-table", "a section that lies in the section table", 8, 64);
        entry("section-unaligned", "a section whose offset is no multiple of 64", 8,
              valueAt<U64>(lively_, kNodeEntry + 8) + 4);
        entry("section-beyond", "a section that begins beyond the end", 8, ~U64{63});
        entry("section-long", "a section that ends beyond the end", 16, ~U64{0});
        entry("section-overlap", "a section that reaches into the next", 16, 4 * 64);
        addParts("section-twice", "MODL occurs twice",
                 [](SvoParts& p) { p.parts.push_back(p.parts.front()); });
        addParts("section-unknown", "a section that must be known and is not", [](SvoParts& p) {
            p.parts.push_back({"NEWS", 1, Bytes(4, 0)});
        });
        for (const char* tag : {"MODL", "NODE", "PALT", "STRS"}) {
            const std::string name = std::string("without-") + tag;
            addParts(name.c_str(), "a required section is missing",
                     [&](SvoParts& p) { p.remove(tag); });
        }
        addParts("without-SPOS", "of SOCK and SPOS there is only one",
                 [](SvoParts& p) { p.remove("SPOS"); });
        addParts("part-of-a-record", "MODL is no whole number of records",
                 [](SvoParts& p) { p["MODL"].pop_back(); });
        addParts("palette-short", "PALT has 255 colours",
                 [](SvoParts& p) { p["PALT"].resize(1020); });
    }

    void models() {
        addParts("no-model", "MODL is empty", [](SvoParts& p) {
            for (const char* tag : {"MODL", "NODE", "PAYL", "CLIP", "FRAM"}) p[tag].clear();
            p.remove("SOCK");
            p.remove("SPOS");
        });
        addValue("model-gap", "the first model's nodes do not begin at 0", "MODL", 0, U32{1});
        addValue("model-long", "a model's nodes end beyond NODE", "MODL", 24, ~U32{0});
        addValue("model-payloads", "a model's payloads end beyond PAYL", "MODL", 28, ~U32{0});
        addValue("depth-0", "MaxDepth is 0", "MODL", 8, U32{0});
        addValue("depth-off", "MaxDepth is one more than the size needs", "MODL", 8, U32{4});
        addValue("depth-17", "MaxDepth is 17", "MODL", 8, U32{17});
        addValue("too-wide", "65,537 voxels along x", "MODL", 12, U32{65537});
        addValue("flat", "a size of 0 along y alone", "MODL", 16, U32{0});
        addValue("too-far", "an origin beyond 2^24", "MODL", 32, std::int32_t{1 << 25});
        addParts("orphan-nodes", "nodes that belong to no model",
                 [](SvoParts& p) { p["NODE"].resize(p["NODE"].size() + 8); });
        addParts("orphan-payloads", "payloads that belong to no model",
                 [](SvoParts& p) { p["PAYL"].resize(p["PAYL"].size() + 8); });
        addOctree("too-many-voxels", "5 nodes, and more than 2^40 solid voxels",
                  {{0x5}, {}, 14, glm::ivec3(1 << 14), glm::ivec3(0)});
    }

    // Sizes of 4 x 4 x 4 and MaxDepth 2 unless said otherwise.
    void octrees() {
        const glm::ivec3 four(4);
        const glm::ivec3 zero(0);
        const U32 brick = node::kBrick;
        const U64 pair = 0x0201;
        addOctree("cycle", "a node that is its own child",
                  {{node::internal(0, 1), brick}, {pair}, 2, four, zero});
        addOctree("twice", "two nodes that share their children",
                  {{node::internal(1, 3), node::internal(3, 1), node::internal(3, 1), brick},
                   {pair},
                   3,
                   glm::ivec3(8),
                   zero});
        addOctree("child-beyond", "children beyond the end of the nodes",
                  {{node::internal(1, 7), brick}, {pair}, 2, four, zero});
        addOctree("child-base-beyond", "the largest childBase there is",
                  {{node::internal(0x7FFFFF, 1), brick}, {pair}, 2, four, zero});
        addOctree("no-children", "an internal node with a childMask of 0",
                  {{node::internal(1, 0)}, {}, 2, four, zero});
        addOctree("stored-empty", "an empty child that is stored",
                  {{node::internal(1, 3), brick, 0}, {pair}, 2, four, zero});
        addOctree("stray-bits", "a uniform leaf with bits above its material",
                  {{node::internal(1, 3), brick, 0x1234}, {pair}, 2, four, zero});
        addOctree("payload-beyond", "a payload beyond the end",
                  {{node::internal(1, 1), node::brick(1)}, {pair}, 2, four, zero});
        addOctree("payload-order", "two payloads in exchanged order",
                  {{node::internal(1, 3), node::brick(1), node::brick(0)},
                   {pair, 0x0403},
                   2,
                   four,
                   zero});
        addOctree("payload-unused", "a payload that no node has",
                  {{node::internal(1, 1), brick}, {pair, pair}, 2, four, zero});
        addOctree("brick-high", "a brick above the last level", {{brick}, {pair}, 2, four, zero});
        addOctree("too-deep", "children below the last level",
                  {{node::internal(1, 1), node::internal(2, 1), brick}, {pair}, 2, four, zero});
        addOctree("brick-uniform", "a brick of eight equal materials",
                  {{node::internal(1, 1), brick}, {0x0505050505050505}, 2, four, zero});
        addOctree("brick-empty", "a brick of nothing", {{brick}, {0}, 1, glm::ivec3(2), zero});
        addOctree("not-collapsed", "eight equal uniform children",
                  {{node::internal(1, 255), 9, 9, 9, 9, 9, 9, 9, 9}, {}, 2, four, zero});
        addOctree("depth-first", "children laid out depth first",
                  {{node::internal(1, 3), node::internal(2, 1), brick, 7},
                   {pair},
                   3,
                   glm::ivec3(8),
                   zero});
        addOctree("solid-outside", "a uniform leaf that reaches beyond the size",
                  {{node::internal(1, 3), 3, 4}, {}, 2, {3, 4, 4}, zero});
        addOctree("voxel-outside", "a brick with a voxel beyond the size",
                  {{brick}, {pair}, 1, {1, 2, 2}, zero});
        addOctree("unused-node", "a node after the last child",
                  {{node::internal(1, 1), brick, 5}, {pair}, 2, four, zero});
        addOctree("empty-solid", "a model of size 0 with a voxel",
                  {{brick}, {pair}, 1, zero, zero});
    }

    void texts() {
        addParts("text-beyond", "a name that ends beyond STRS",
                 [](SvoParts& p) { setValueAt(p["MODL"], 48, ~U32{15}); });
        addParts("text-shared", "names that share all bytes", [](SvoParts& p) {
            const auto all = static_cast<U32>(p["STRS"].size());
            for (std::size_t i = 0; i < 256; ++i) {
                setValueAt(p["CNAM"], 8 * i, U32{0});
                setValueAt(p["CNAM"], 8 * i + 4, all);
            }
        });
        const auto text = [&](const char* name, const char* why, const char* bytes) {
            addParts(name, why, [&](SvoParts& p) { std::memcpy(p["STRS"].data(), bytes, 3); });
        };
        text("text-latin1", "a name that is Latin-1 and not UTF-8", "\xE4ng");
        text("text-overlong", "a name with an overlong form", "\xE0\x80\x80");
        text("text-surrogate", "a name with a surrogate", "\xED\xA0\x80");
        addParts("text-cut", "a name that ends within a character", [](SvoParts& p) {
            p["STRS"].at(valueAt<U32>(p["MODL"], 44) + valueAt<U32>(p["MODL"], 48) - 1) = 0xC3;
        });
    }

    void clips() {
        addValue("clip-gap", "a clip's frames do not begin where they should", "CLIP", 8, U32{1});
        addValue("clip-none", "a clip without frames", "CLIP", 12, U32{0});
        addValue("clip-long", "a clip's frames end beyond FRAM", "CLIP", 12, ~U32{0});
        addValue("clip-model", "a frame shows a model that is not there", "FRAM", 0, U32{3});
        addValue("clip-sizes", "a clip of models of different sizes", "FRAM", 8, U32{2});
        addValue("frame-0-ms", "a frame of 0 ms", "FRAM", 4, U32{0});
        addValue("frame-long", "a frame of more than 1,000,000 ms", "FRAM", 4, U32{1000001});
        addParts("orphan-frames", "frames that belong to no clip",
                 [](SvoParts& p) { p["FRAM"].resize(p["FRAM"].size() + 8, 1); });
        addValue("socket-gap", "a socket's positions do not begin where they should", "SOCK", 8,
                 U32{1});
        addValue("socket-none", "a socket without positions", "SOCK", 12, U32{0});
        addValue("socket-nan", "a socket at no number", "SPOS", 8,
                 std::numeric_limits<double>::quiet_NaN());
        addParts("socket-two", "two positions where there are four frames", [](SvoParts& p) {
            setValueAt(p["SOCK"], 16 + 12, U32{2});
            p["SPOS"].resize(3 * 24);
        });
        addParts("orphan-positions", "positions that belong to no socket",
                 [](SvoParts& p) { p["SPOS"].resize(p["SPOS"].size() + 24); });
    }

    void values() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        addValue("voxel-size-0", "a VoxelSize of 0", "AUTH", 0, 0.0);
        addValue("sigma-nan", "sigma is no number", "AUTH", 8, nan);
        addValue("sigma-65", "sigma is 65", "AUTH", 8, 65.0);
        addValue("anchor-far", "an anchor a thousand million voxels away", "AUTH", 16, 1e9);
        addValue("outline-alpha", "an outline that can be seen through", "AUTH", 47,
                 std::uint8_t{128});
        addValue("palette-0", "a colour for what is empty", "PALT", 0, U32{0xFF000000});
    }

    // Of livelySet(): the second entity has three models, two clips and two sockets.
    void entities() {
        const auto add = [&](const char* name, const char* why,
                             const std::function<void(SvoParts&)>& change) {
            addParts(set_, name, why, change);
        };
        const auto value = [&](const char* name, const char* why, std::size_t at, U32 number) {
            add(name, why, [=](SvoParts& p) { setValueAt(p["ENTY"], at, number); });
        };
        value("entity-gap", "an entity's models do not begin where they should", 32, U32{2});
        value("entity-models", "an entity's models end beyond MODL", 64 + 4, ~U32{0});
        value("entity-empty", "an entity without models", 4, U32{0});
        value("entity-clips", "an entity's clips end beyond CLIP", 32 + 12, U32{3});
        value("entity-sockets", "an entity's sockets begin before the file's", 32 + 16, ~U32{0});
        add("entity-orphans", "models that belong to no entity", [](SvoParts& p) {
            for (const char* tag : {"PALT", "CNAM", "AUTH", "ENTY"}) {
                p[tag].resize(p[tag].size() / 3 * 2);
            }
        });
        add("entity-frame", "a clip that shows another entity's model",
            [](SvoParts& p) { setValueAt(p["FRAM"], 0, U32{0}); });
        add("entity-later", "a clip that shows a later entity's model",
            [](SvoParts& p) { setValueAt(p["FRAM"], 3 * 8, U32{4}); });
        add("entity-palette", "a palette too few", [](SvoParts& p) { p["PALT"].resize(2 * 1024); });
        add("entity-colour", "a colour for what is empty in a later palette",
            [](SvoParts& p) { setValueAt(p["PALT"], 2 * 1024, U32{0xFF000000}); });
        add("entity-author", "two records of AUTH for three entities",
            [](SvoParts& p) { p["AUTH"].resize(2 * 64); });
        add("entity-sigma", "sigma of a later entity is 65",
            [](SvoParts& p) { setValueAt(p["AUTH"], 2 * 64 + 8, 65.0); });
        add("entity-none", "a set of no entities", [](SvoParts& p) { p["ENTY"].clear(); });
        add("entity-unmarked", "three palettes, and no word of entities",
            [](SvoParts& p) { p.remove("ENTY"); });
        addParts("entity-single", "a set of one entity", [](SvoParts& p) {
            Bytes record(32, 0);
            setValueAt(record, 4, U32{3});
            setValueAt(record, 12, U32{2});
            setValueAt(record, 20, U32{2});
            p.parts.push_back({"ENTY", 1, record});
        });
    }

    Bytes lively_ = written(livelyFile());
    Bytes set_ = written(livelySet());
    std::vector<Case> cases_;
};

}  // namespace

std::vector<Case> brokenCases() {
    return BrokenCases().take();
}

}  // namespace voxprite::samples
